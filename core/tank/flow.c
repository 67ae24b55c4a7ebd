/* flow.c -- Lamb's flow around a disc in still water, and the flow at the edge of the ring. */
#include "core/tank/flow.h"

/* Share of the speed along the plane that the water at the ring has. */
#define EDGE_SHARE 0.16f
/* Least distance from the sharp edge in radii, because a body is larger than a point. */
#define BODY_SHARE 0.3f
#define ENTRY_HALF_M 0.005f /* A level disc submerges over twice this distance. */
#define STILL_M_S 1e-4f
#define FAR 6.0f /* In radii: a five-hundredth of the speed remains at this distance. */

/* Returns the share [0, 1] of the disc that is under water, from the heights of its lowest and
 * highest points. */
static float immersed(const struct obstacle *disc)
{
    const float slope = f_sqrt(f_max(0.0f, 1.0f - disc->normal.y * disc->normal.y));
    const float half_m = f_max(disc->radius_m * slope, ENTRY_HALF_M);
    return f_clamp(0.5f - 0.5f * disc->centre_m.y / half_m, 0.0f, 1.0f);
}

/* A point relative to a disc of radius 1: distance along the normal and distance from the axis. */
struct place {
    float along, off;
};

/* Oblate spheroidal coordinates: along = zeta mu, off = sqrt((1 + zeta^2)(1 - mu^2)). */
struct spheroidal {
    float zeta, mu;
};

static struct spheroidal spheroidal(struct place at)
{
    const float square = at.along * at.along + at.off * at.off - 1.0f;
    const float root = f_sqrt(square * square + 4.0f * at.along * at.along);
    const float zeta = f_sqrt(f_max(0.0f, 0.5f * (square + root)));
    const float mu = f_sqrt(f_clamp(0.5f * (root - square), 0.0f, 1.0f));
    return (struct spheroidal){ zeta, at.along < 0.0f ? -mu : mu };
}

/* Returns the flow of a disc of radius 1 and speed 1 along its normal. Along the axis: (2 / pi)
 * (acot zeta - zeta / (zeta^2 + mu^2)). Off the axis: (2 / pi) mu sqrt(1 - mu^2) / ((zeta^2 + mu^2)
 * sqrt(1 + zeta^2)). Both are bounded near the sharp edge, where they would be infinite. */
static struct place broadside(struct place at)
{
    const struct spheroidal s = spheroidal(at);
    const float zeta2 = s.zeta * s.zeta, mu2 = s.mu * s.mu;
    const float near = f_max(zeta2 + mu2, BODY_SHARE * BODY_SHARE);
    const float share = 2.0f / F_PI;
    return (struct place){
        .along = share * (0.5f * F_PI - f_atan2(s.zeta, 1.0f) - s.zeta / near),
        .off = share * s.mu * f_sqrt(f_max(0.0f, 1.0f - mu2)) / (near * f_sqrt(1.0f + zeta2)),
    };
}

/* Returns the flow for motion along the plane, which decays with the cube of the distance from the
 * sheet. */
static float edgewise(struct place at)
{
    const float beyond = f_max(0.0f, at.off - 1.0f);
    const float gap = f_sqrt(at.along * at.along + beyond * beyond);
    const float near = 1.0f / (1.0f + f_max(BODY_SHARE, gap));
    return EDGE_SHARE * near * near * near;
}

/* Cheap test: returns 0 only where there is no flow. */
static int stirs(const struct obstacle *disc, vec3 point_m)
{
    const vec3 off_m = v3_sub(point_m, disc->centre_m), goes_m_s = obstacle_goes_m_s(disc);
    const float reach_m = FAR * disc->radius_m;
    return disc->kind == OBSTACLE_DISC && point_m.y <= 0.0f &&
           v3_dot(off_m, off_m) < reach_m * reach_m &&
           v3_dot(goes_m_s, goes_m_s) > STILL_M_S * STILL_M_S;
}

vec3 flow_at(const struct obstacle *disc, vec3 point_m)
{
    if (!stirs(disc, point_m)) {
        return v3(0.0f, 0.0f, 0.0f);
    }
    const vec3 to = v3_scale(v3_sub(point_m, disc->centre_m), 1.0f / disc->radius_m);
    const float along = v3_dot(to, disc->normal);
    const vec3 flat = v3_muladd(to, disc->normal, -along);
    const struct place at = { along, v3_length(flat) };
    const vec3 out = v3_normalize_or(flat, v3(0.0f, 0.0f, 0.0f));
    const vec3 goes_m_s = obstacle_goes_m_s(disc);
    const float normal_m_s = v3_dot(goes_m_s, disc->normal);
    const vec3 plane_m_s = v3_muladd(goes_m_s, disc->normal, -normal_m_s);
    const float pushing_m_s = (1.0f - disc->open) * normal_m_s;
    const struct place push = broadside(at);
    const vec3 pushed = v3_add(v3_scale(disc->normal, push.along), v3_scale(out, push.off));
    const vec3 flow = v3_muladd(v3_scale(pushed, pushing_m_s), plane_m_s, edgewise(at));
    return v3_limit(v3_scale(flow, immersed(disc)), v3_length(goes_m_s));
}

float flow_push_m2_s2(const struct obstacle *disc, vec3 point_m)
{
    return v3_length(obstacle_goes_m_s(disc)) * v3_length(flow_at(disc, point_m));
}
