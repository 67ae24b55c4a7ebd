/* ring_pairs.c -- tests two flat discs for overlap, finds the direction of least overlap, and
 * separates the discs. */
#include "core/poi/ring_pairs.h"

/* Speed at which two rings slide sideways while they press against each other, equal to ASIDE_M_S
 * in ring_constraints.c. */
#define ASIDE_M_S 0.6f
/* Squared sine of the angle between two normals below which the normals count as parallel. */
#define PARALLEL 1e-4f
#define GAP_M 0.0002f /* Gap between two rings after their separation. */

/* Geometry of two rings in one tick. */
struct rings {
    vec3 up_a, up_b;        /* Unit normals of ring a and ring b. */
    vec3 apart_m, before_m; /* Vectors from the centre of ring a to the centre of ring b: `apart_m`
                               at the end of the tick and `before_m` at its start. */
};

static float extents_m(const struct rings *rings, vec3 axis)
{
    return poi_half_extent_m(v3_dot(rings->up_a, axis)) +
           poi_half_extent_m(v3_dot(rings->up_b, axis));
}

/* Returns the overlap of the two rings along the unit vector `axis`. A result of 0 or less means
 * that the rings do not overlap. */
static float shared_m(const struct rings *rings, vec3 axis)
{
    return extents_m(rings, axis) - f_abs(v3_dot(rings->apart_m, axis));
}

/* Reverses `normal` if necessary, so that it points from ring a to ring b at the start of the tick.
 * Returns the overlap of the two rings along `normal` at the end of the tick. If the rings passed
 * through each other in this tick, the overlap is larger than their thickness. */
static float shared_through_m(const struct rings *rings, vec3 *normal)
{
    const float side = v3_dot(rings->before_m, *normal) < 0.0f ? -1.0f : 1.0f;
    *normal = v3_scale(*normal, side);
    return extents_m(rings, *normal) - v3_dot(rings->apart_m, *normal);
}

/* Returns the unit vector along the projection of `apart_m` onto the plane with the given
 * normal. */
static vec3 along_plane(vec3 apart_m, vec3 normal)
{
    const vec3 along = v3_muladd(apart_m, normal, -v3_dot(apart_m, normal));
    return v3_normalize_or(along, normal);
}

/* Returns 1 if one of the candidate axes separates the two rings (separating axis theorem for two
 * discs), otherwise 0. */
static int are_apart(const struct rings *rings)
{
    const vec3 edge = v3_cross(rings->up_a, rings->up_b);
    return shared_m(rings, v3_normalize_or(rings->apart_m, rings->up_a)) <= 0.0f ||
           shared_m(rings, along_plane(rings->apart_m, rings->up_a)) <= 0.0f ||
           shared_m(rings, along_plane(rings->apart_m, rings->up_b)) <= 0.0f ||
           (v3_dot(edge, edge) > PARALLEL &&
            shared_m(rings, v3_normalize_or(edge, rings->up_a)) <= 0.0f);
}

/* Moves a ring by `way_m` along the unit vector `out`, and removes the part of its velocity that
 * points against `out`. */
static void move(struct poi *poi, vec3 out, float way_m)
{
    const float inward_m_s = f_min(v3_dot(poi->velocity_m_s, out), 0.0f);
    poi->position_m = v3_muladd(poi->position_m, out, way_m);
    poi->velocity_m_s = v3_muladd(poi->velocity_m_s, out, -inward_m_s);
    poi->stopped = 1;
}

/* Moves a ring sideways along `out` by at most `need_m`. The step cancels the motion of the ring
 * against `out` in this tick and adds a motion with at most the speed ASIDE_M_S. Therefore a ring
 * cannot block a ring below it forever. */
static void slide(struct poi *poi, vec3 out, float need_m)
{
    const float came_m = f_max(0.0f, -v3_dot(v3_sub(poi->position_m, poi->before_m), out));
    move(poi, out, f_min(need_m, came_m + ASIDE_M_S * CORE_TICK_S));
}

int ring_pairs_separate(struct poi *a, struct poi *b)
{
    const struct rings rings = {
        .up_a = vec_basis_from_angles(a->angles).up,
        .up_b = vec_basis_from_angles(b->angles).up,
        .apart_m = v3_sub(b->position_m, a->position_m),
        .before_m = v3_sub(b->before_m, a->before_m),
    };
    vec3 normal = rings.up_a, other = rings.up_b;
    const float through_m = shared_through_m(&rings, &normal);
    const float other_m = shared_through_m(&rings, &other);
    if (through_m <= 0.0f || other_m <= 0.0f || are_apart(&rings)) {
        return 0;
    }
    const vec3 flat_m = v3(rings.apart_m.x, 0.0f, rings.apart_m.z);
    const vec3 aside = v3_normalize_or(flat_m, v3(1.0f, 0.0f, 0.0f));
    const float need_m = shared_m(&rings, aside) + GAP_M;
    const float least_m = f_min(through_m, other_m) + GAP_M;
    slide(a, v3_scale(aside, -1.0f), 0.5f * need_m);
    slide(b, aside, 0.5f * need_m);
    if (least_m < need_m) {
        const vec3 way = through_m < other_m ? normal : other;
        move(a, v3_scale(way, -1.0f), 0.5f * least_m);
        move(b, way, 0.5f * least_m);
    }
    return 1;
}
