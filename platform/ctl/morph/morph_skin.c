/* morph_skin.c -- tests whether points are inside a closed triangle surface, and computes their
 * distances from the surface. */
#include "platform/ctl/morph/morph_survey.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "core/base/panic.h"

static uint32_t bin_of(float x, float low, float high, uint32_t count)
{
    const float at = (x - low) / (high - low) * (float)count;
    return (uint32_t)f_clamp(at, 0.0f, (float)(count - 1u));
}

static uint32_t row_of(const struct morph_skin *skin, float y)
{
    return bin_of(y, skin->low_y, skin->high_y, MORPH_SKIN_ROWS);
}

static uint32_t column_of(const struct morph_skin *skin, float z)
{
    return bin_of(z, skin->low_z, skin->high_z, MORPH_SKIN_COLUMNS);
}

static float least(float a, float b, float c)
{
    return f_min(f_min(a, b), c);
}

static float most(float a, float b, float c)
{
    return f_max(f_max(a, b), c);
}

/* Sorts the triangles into bins. If `fill` is false, only counts the triangles of each bin. If
 * `fill` is true, writes the triangle indices to `binned`. */
static void walk_bins(struct morph_skin *skin, bool fill)
{
    for (uint32_t i = 0; i < skin->triangle_count; i++) {
        const vec3 *c = skin->corner[i];
        const uint32_t bottom = row_of(skin, least(c[0].y, c[1].y, c[2].y));
        const uint32_t top = row_of(skin, most(c[0].y, c[1].y, c[2].y));
        const uint32_t front = column_of(skin, least(c[0].z, c[1].z, c[2].z));
        const uint32_t rear = column_of(skin, most(c[0].z, c[1].z, c[2].z));
        for (uint32_t row = bottom; row <= top; row++) {
            for (uint32_t column = front; column <= rear; column++) {
                uint32_t *end = &skin->bin_first[row * MORPH_SKIN_COLUMNS + column + 1u];
                if (fill) {
                    skin->binned[*end] = (uint16_t)i;
                }
                (*end)++;
            }
        }
    }
}

void morph_skin_build(struct morph_skin *skin, const struct species_mesh *mesh,
                      const vec3 *positions, enum species_part part, enum species_side side)
{
    CORE_ASSERT(mesh->index_count <= MESH_INDEX_MAX);
    CORE_ASSERT(mesh->vertex_count <= MESH_VERTEX_MAX);
    skin->triangle_count = 0;
    skin->low_y = skin->low_z = FLT_MAX;
    skin->high_y = skin->high_z = -FLT_MAX;
    for (uint32_t i = 0; i + 2 < mesh->index_count; i += 3) {
        const struct species_vertex *vertex = &mesh->vertices[mesh->indices[i]];
        if (vertex->part != part || (side != SIDE_MIDDLE && vertex->side != side)) {
            continue;
        }
        for (int k = 0; k < 3; k++) {
            const vec3 p = positions[mesh->indices[i + (uint32_t)k]];
            skin->corner[skin->triangle_count][k] = p;
            skin->low_y = f_min(skin->low_y, p.y);
            skin->low_z = f_min(skin->low_z, p.z);
            skin->high_y = f_max(skin->high_y, p.y);
            skin->high_z = f_max(skin->high_z, p.z);
        }
        skin->triangle_count++;
    }
    skin->high_y += 1e-6f; /* Gives a flat surface a positive height, so that the division by the
                              height in bin_of() is valid. */
    skin->high_z += 1e-6f;
    memset(skin->bin_first, 0, sizeof skin->bin_first);
    walk_bins(skin, false);
    for (uint32_t bin = 1; bin <= MORPH_SKIN_BINS; bin++) {
        skin->bin_first[bin] += skin->bin_first[bin - 1];
    }
    /* bin_first[bin] is now the start of each bin in `binned`. The move copies the start to
     * bin_first[bin + 1]. The second call of walk_bins() then writes the triangles, and advances
     * bin_first[bin + 1] to the end of the bin. */
    memmove(&skin->bin_first[1], &skin->bin_first[0], MORPH_SKIN_BINS * sizeof skin->bin_first[0]);
    walk_bins(skin, true);
}

static vec3 triangle_area_vector(const vec3 corner[3])
{
    return v3_scale(v3_cross(v3_sub(corner[1], corner[0]), v3_sub(corner[2], corner[0])), 0.5f);
}

bool morph_skin_is_closed(const struct morph_skin *skin)
{
    vec3 sum = { 0.0f, 0.0f, 0.0f };
    float whole = 0.0f;
    for (uint32_t i = 0; i < skin->triangle_count; i++) {
        const vec3 a = triangle_area_vector(skin->corner[i]);
        sum = v3_add(sum, a);
        whole += v3_length(a);
    }
    return whole > 0.0f && v3_length(sum) < 1e-3f * whole;
}

float morph_skin_volume(const struct morph_skin *skin)
{
    double volume = 0.0;
    for (uint32_t i = 0; i < skin->triangle_count; i++) {
        const vec3 *c = skin->corner[i];
        volume += (double)v3_dot(c[0], v3_cross(c[1], c[2])) / 6.0;
    }
    return (float)volume;
}

/* Returns a value whose sign states on which side of the line from `a` to `b` the point `p` lies,
 * seen from the right.
 *
 * The value is computed in the same order for both triangles that share the edge, so that the
 * results agree in every bit. A ray through the shared edge therefore crosses exactly one of the
 * two triangles. */
static double morph_skin_side_of(vec3 a, vec3 b, vec3 p)
{
    const bool swap = b.y < a.y || (b.y == a.y && b.z < a.z);
    const vec3 from = swap ? b : a, to = swap ? a : b;
    const double y = (double)to.y - (double)from.y, z = (double)to.z - (double)from.z;
    const double side = y * ((double)p.z - (double)from.z) - z * ((double)p.y - (double)from.y);
    const double never_on_it = side >= 0.0 ? fmax(side, DBL_MIN) : side;
    return swap ? -never_on_it : never_on_it;
}

/* Returns true if a ray from `p` to the right crosses the triangle. */
static bool lies_right(const vec3 c[3], vec3 p)
{
    const double d0 = morph_skin_side_of(c[0], c[1], p), d1 = morph_skin_side_of(c[1], c[2], p);
    const double d2 = morph_skin_side_of(c[2], c[0], p), sum = d0 + d1 + d2;
    if ((d0 < 0.0) != (d1 < 0.0) || (d1 < 0.0) != (d2 < 0.0)) {
        return false;
    }
    return (d1 * (double)c[0].x + d2 * (double)c[1].x + d0 * (double)c[2].x) / sum > (double)p.x;
}

bool morph_skin_has(const struct morph_skin *skin, vec3 p)
{
    CORE_ASSERT(skin->triangle_count <= MESH_INDEX_MAX / 3);
    if (skin->triangle_count == 0 || p.y < skin->low_y || p.y > skin->high_y || p.z < skin->low_z ||
        p.z > skin->high_z) {
        return false;
    }
    const uint32_t bin = row_of(skin, p.y) * MORPH_SKIN_COLUMNS + column_of(skin, p.z);
    bool inside = false;
    for (uint32_t i = skin->bin_first[bin]; i < skin->bin_first[bin + 1u]; i++) {
        inside ^= lies_right(skin->corner[skin->binned[i]], p);
    }
    return inside;
}

static float to_triangle(vec3 p, const vec3 c[3])
{
    const vec3 normal = v3_normalize_or(triangle_area_vector(c), v3(0.0f, 0.0f, 0.0f));
    bool above = v3_dot(normal, normal) > 0.0f;
    float nearest = FLT_MAX;
    for (int k = 0; k < 3; k++) {
        const vec3 a = c[k], b = c[(k + 1) % 3];
        above = above && v3_dot(v3_cross(normal, v3_sub(b, a)), v3_sub(p, a)) >= 0.0f;
        const vec3 along = v3_sub(b, a);
        const float square = v3_dot(along, along);
        const float part = square > 0.0f ? v3_dot(v3_sub(p, a), along) / square : 0.0f;
        nearest =
            f_min(nearest, v3_length(v3_sub(p, v3_muladd(a, along, f_clamp(part, 0.0f, 1.0f)))));
    }
    return above ? f_min(nearest, fabsf(v3_dot(normal, v3_sub(p, c[0])))) : nearest;
}

static float to_span(float x, float a, float b, float c)
{
    return most(least(a, b, c) - x, x - most(a, b, c), 0.0f);
}

float morph_skin_distance(const struct morph_skin *skin, vec3 point)
{
    CORE_ASSERT(skin->triangle_count <= MESH_INDEX_MAX / 3);
    float nearest = FLT_MAX;
    for (uint32_t i = 0; i < skin->triangle_count; i++) {
        /* `box` is the vector from the point to the bounding box of the triangle. Its length is a
         * lower bound for the distance to the triangle. */
        const vec3 *c = skin->corner[i];
        const vec3 box =
            v3(to_span(point.x, c[0].x, c[1].x, c[2].x), to_span(point.y, c[0].y, c[1].y, c[2].y),
               to_span(point.z, c[0].z, c[1].z, c[2].z));
        if (v3_length(box) < nearest) {
            nearest = f_min(nearest, to_triangle(point, c));
        }
    }
    return nearest;
}

/* Returns the distance along the ray from `p` in the direction `way` to the triangle. Returns a
 * negative value if the ray does not meet the triangle. */
static float crossing(vec3 p, vec3 way, const vec3 c[3])
{
    const vec3 e1 = v3_sub(c[1], c[0]), e2 = v3_sub(c[2], c[0]), from = v3_sub(p, c[0]);
    const vec3 h = v3_cross(way, e2), q = v3_cross(from, e1);
    const float scale = v3_dot(e1, h);
    if (scale == 0.0f) {
        return -1.0f;
    }
    const float u = v3_dot(from, h) / scale, v = v3_dot(way, q) / scale;
    return u < 0.0f || v < 0.0f || u + v > 1.0f ? -1.0f : v3_dot(e2, q) / scale;
}

float morph_skin_way_out(const struct morph_skin *skin, vec3 point, vec3 way)
{
    float nearest = FLT_MAX;
    for (uint32_t i = 0; i < skin->triangle_count; i++) {
        const float far = crossing(point, way, skin->corner[i]);
        nearest = far > 0.0f ? f_min(nearest, far) : nearest;
    }
    return nearest < FLT_MAX ? nearest : 0.0f;
}
