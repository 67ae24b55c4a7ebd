/* view.c -- computes the axes and the field of view of the pinhole camera, and the point of the
 * tank that the camera shows at a screen point. */
#include "core/view.h"

#include "core/base/panic.h"

#define RAY_LENGTH_MAX_M 4.0f /* Length at which a camera ray ends, longer than any tank. */
#define DEPTH_MIN_M 0.01f     /* Smallest distance from the eye along the axis of the camera. */

struct basis view_basis(const struct view *view)
{
    const vec3 back = v3_normalize_or(v3_sub(view->eye_m, view->target_m), v3(0.0f, 0.0f, 1.0f));
    const vec3 right = v3_normalize_or(v3_cross(v3(0.0f, 1.0f, 0.0f), back), v3(1.0f, 0.0f, 0.0f));
    return (struct basis){ .right = right, .up = v3_cross(back, right), .back = back };
}

vec3 view_project(const struct view *view, vec3 point_m)
{
    const struct basis axes = view_basis(view);
    const vec3 ray = v3_sub(point_m, view->eye_m);
    const float size = 1.0f / f_max(0.0f - v3_dot(ray, axes.back), DEPTH_MIN_M);
    return v3(v3_dot(ray, axes.right) * size, v3_dot(ray, axes.up) * size, size);
}

bool view_is_turned(const struct view *view)
{
    return view_basis(view).right.z < -0.5f;
}

float view_half_height_tan(const struct view *view, float aspect)
{
    CORE_ASSERT(aspect > 0.0f && view->half_height_tan > 0.0f);
    return view->half_height_tan * f_max(1.0f, view->aspect_min / aspect);
}

vec3 view_point_on_plane(const struct view *view, float aspect, float x, float y, float height_m)
{
    const struct basis axes = view_basis(view);
    const float tan_y = view_half_height_tan(view, aspect);
    const vec3 ray = v3_normalize_or(
        vec_basis_to_world(&axes, v3(x * tan_y * aspect, y * tan_y, -1.0f)), axes.back);
    const float drop = view->eye_m.y - height_m;
    const float reach = ray.y < -1e-4f ? f_min(drop / -ray.y, RAY_LENGTH_MAX_M) : RAY_LENGTH_MAX_M;
    return v3_muladd(view->eye_m, ray, reach);
}
