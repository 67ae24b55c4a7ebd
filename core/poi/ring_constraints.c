/* ring_constraints.c -- keeps a ring out of bowl, floor and walls and within the reach of the arm,
 * and separates two rings that touch.
 *
 * The constraints of a ring are applied in the order bowl, floor, walls and reach of the arm. Two
 * rings are flat discs. The functions test the discs for overlap, find the direction of least
 * overlap, and separate the discs. */
#include "core/poi/poi.h"

#include "core/base/panic.h"

/* Distance beyond the tank walls to which a player's arm reaches over the rim of the tank. */
#define REACH_SIDE_M 0.15f
#define REACH_HEIGHT_M 0.30f
/* Highest speed at which a ring slides sideways off the hull of a bowl or off another ring. */
#define ASIDE_M_S 0.6f
/* Gap between the ring and the floor of the tank. The gap keeps the paper from being pressed
 * between a thick ring and the floor. */
#define FLOOR_GAP_M 0.003f

/* Clamps a coordinate to [low, high]. If the coordinate was beyond a limit, also removes the speed
 * in this direction. */
static void clamp_coordinate(float *place, float *speed, float low, float high)
{
    CORE_ASSERT(low <= high);
    if (*place < low) {
        *place = low;
        *speed = f_max(*speed, 0.0f);
    } else if (*place > high) {
        *place = high;
        *speed = f_min(*speed, 0.0f);
    }
}

/* Applies the tank walls. A ring inside the walls stays inside, unless its lowest edge is above the
 * rim of the tank. A ring beyond the walls or across the rim rests on the rim. The ring's position
 * at the start of the tick decides which case applies. The ring's angles have no influence, because
 * a rotation must never move the ring over a wall. */
static void constrain_to_walls(struct poi *poi, const struct tank *tank, vec3 up)
{
    const vec3 before_m = poi->before_m;
    const float low = poi_half_extent_m(poi, up.y);
    const float rim = tank->wall_height_m - tank->size_m.y;
    const float room_x = 0.5f * tank->size_m.x - poi_half_extent_m(poi, up.x);
    const float room_z = 0.5f * tank->size_m.z - poi_half_extent_m(poi, up.z);
    vec3 *at = &poi->position_m, *speed = &poi->velocity_m_s;
    if (at->y - low >= rim) {
        return;
    }
    /* Horizontal distances by which the ring's centre was outside the tank (`outside`) and outside
     * the region in which the ring touches no wall (`aside`). */
    const float far_x = f_abs(before_m.x), far_z = f_abs(before_m.z);
    const float outside = f_max(far_x - 0.5f * tank->size_m.x, far_z - 0.5f * tank->size_m.z);
    const float aside = f_max(0.0f, f_max(far_x - room_x, far_z - room_z));
    const float under = rim + low - before_m.y;
    if (outside > 0.0f || (aside > 1e-4f && under < aside)) {
        clamp_coordinate(&at->y, &speed->y, rim + low, REACH_HEIGHT_M);
    } else {
        clamp_coordinate(&at->x, &speed->x, -room_x, room_x);
        clamp_coordinate(&at->z, &speed->z, -room_z, room_z);
    }
}

/* Applies a bowl as a constraint. A ring that comes from above rests on the bowl's mouth. A ring
 * that comes from below stops under the hull. A ring that comes from the side slides around the
 * hull. */
static void constrain_to_bowl(struct poi *poi, const struct bowl *bowl, vec3 up)
{
    const vec3 before_m = poi->before_m;
    const float low = poi_half_extent_m(poi, up.y);
    const float mouth = bowl->position_m.y, bottom = mouth - BOWL_DEPTH_M;
    vec3 *at = &poi->position_m, *speed = &poi->velocity_m_s;
    const vec3 away = v3_flat(v3_sub(*at, bowl->position_m));
    const vec3 out = v3_normalize_or(away, v3(-1.0f, 0.0f, 0.0f));
    const float apart = bowl_hull_radius_m(mouth - at->y) + poi_half_extent_m(poi, v3_dot(up, out));
    if (!bowl->present || v3_length(away) >= apart || at->y - low >= mouth ||
        at->y + low <= bottom) {
        return;
    }
    if (before_m.y - low >= mouth - 1e-3f) {
        clamp_coordinate(&at->y, &speed->y, mouth + low, REACH_HEIGHT_M);
    } else if (before_m.y + low <= bottom + 1e-3f) {
        clamp_coordinate(&at->y, &speed->y, -10.0f, bottom - low);
    } else {
        const float came_m =
            at->y < mouth ? f_max(0.0f, -v3_dot(v3_sub(*at, before_m), out)) : 0.0f;
        const float step = f_min(apart - v3_length(away), came_m + ASIDE_M_S * CORE_TICK_S);
        const float inward = f_min(v3_dot(*speed, out), 0.0f);
        *at = v3_muladd(*at, out, step);
        *speed = v3_muladd(*speed, out, -inward);
    }
}

void poi_constrain(struct poi *poi, const struct tank *tank, const struct bowl *bowl)
{
    CORE_ASSERT(tank->size_m.x > 0.0f && tank->size_m.y > 0.0f && tank->size_m.z > 0.0f);
    const vec3 up = vec_basis_from_angles(poi->angles).up;
    vec3 *at = &poi->position_m, *speed = &poi->velocity_m_s;
    const float reach_x = 0.5f * tank->size_m.x + REACH_SIDE_M;
    const float reach_z = 0.5f * tank->size_m.z + REACH_SIDE_M;
    const float floor = poi_half_extent_m(poi, up.y) + FLOOR_GAP_M - tank->size_m.y;
    constrain_to_bowl(poi, bowl, up);
    clamp_coordinate(&at->y, &speed->y, floor, REACH_HEIGHT_M);
    constrain_to_walls(poi, tank, up);
    clamp_coordinate(&at->x, &speed->x, -reach_x, reach_x);
    clamp_coordinate(&at->z, &speed->z, -reach_z, reach_z);
}

void poi_constrain_to_bowl(struct poi *poi, const struct bowl *bowl)
{
    const vec3 free_m = poi->position_m;
    constrain_to_bowl(poi, bowl, vec_basis_from_angles(poi->angles).up);
    const vec3 off_m = v3_sub(poi->position_m, free_m);
    poi->stopped |= v3_dot(off_m, off_m) > 0.0f;
}

/* ---- Contact of two rings -------------------------------------------------------------------- */

/* Squared sine of the angle between two normals below which the normals count as parallel. */
#define PARALLEL 1e-4f
#define GAP_M 0.0002f /* Gap between two rings after their separation. */

/* Geometry of two rings in one tick. */
struct rings {
    const struct poi *a, *b;
    vec3 up_a, up_b;        /* Unit normals of ring a and ring b. */
    vec3 apart_m, before_m; /* Vectors from the centre of ring a to the centre of ring b: `apart_m`
                               at the end of the tick and `before_m` at its start. */
};

static float extents_m(const struct rings *rings, vec3 axis)
{
    return poi_half_extent_m(rings->a, v3_dot(rings->up_a, axis)) +
           poi_half_extent_m(rings->b, v3_dot(rings->up_b, axis));
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

/* Returns true if one of the candidate axes separates the two rings (separating axis theorem for
 * two discs). */
static bool are_apart(const struct rings *rings)
{
    const vec3 edge = v3_cross(rings->up_a, rings->up_b), apart_m = rings->apart_m;
    const vec3 normals[] = { rings->up_a, rings->up_b };
    for (int i = 0; i < 2; i++) {
        /* `along` is the projection of `apart_m` onto the plane of ring i. Its direction is a
         * candidate axis. */
        const vec3 along = v3_muladd(apart_m, normals[i], -v3_dot(apart_m, normals[i]));
        if (shared_m(rings, v3_normalize_or(along, normals[i])) <= 0.0f) {
            return true;
        }
    }
    return shared_m(rings, v3_normalize_or(apart_m, rings->up_a)) <= 0.0f ||
           (v3_dot(edge, edge) > PARALLEL &&
            shared_m(rings, v3_normalize_or(edge, rings->up_a)) <= 0.0f);
}

/* Moves a ring by `way_m` along the unit vector `out`, and removes the part of its velocity that
 * points against `out`. */
static void push_ring(struct poi *poi, vec3 out, float way_m)
{
    const float inward_m_s = f_min(v3_dot(poi->velocity_m_s, out), 0.0f);
    poi->position_m = v3_muladd(poi->position_m, out, way_m);
    poi->velocity_m_s = v3_muladd(poi->velocity_m_s, out, -inward_m_s);
    poi->stopped = true;
}

/* Moves a ring sideways along `out` by at most `need_m`. The step cancels the motion of the ring
 * against `out` in this tick and adds a motion with at most the speed ASIDE_M_S. Therefore a ring
 * cannot block a ring below it forever. */
static void slide(struct poi *poi, vec3 out, float need_m)
{
    const float came_m = f_max(0.0f, -v3_dot(v3_sub(poi->position_m, poi->before_m), out));
    push_ring(poi, out, f_min(need_m, came_m + ASIDE_M_S * CORE_TICK_S));
}

bool ring_pairs_separate(struct poi *a, struct poi *b)
{
    CORE_ASSERT(a != b);
    const struct rings rings = {
        .a = a,
        .b = b,
        .up_a = vec_basis_from_angles(a->angles).up,
        .up_b = vec_basis_from_angles(b->angles).up,
        .apart_m = v3_sub(b->position_m, a->position_m),
        .before_m = v3_sub(b->before_m, a->before_m),
    };
    vec3 normal = rings.up_a, other = rings.up_b;
    const float through_m = shared_through_m(&rings, &normal);
    const float other_m = shared_through_m(&rings, &other);
    if (through_m <= 0.0f || other_m <= 0.0f || are_apart(&rings)) {
        return false;
    }
    const vec3 aside = v3_normalize_or(v3_flat(rings.apart_m), v3(1.0f, 0.0f, 0.0f));
    const float need_m = shared_m(&rings, aside) + GAP_M;
    const float least_m = f_min(through_m, other_m) + GAP_M;
    slide(a, v3_scale(aside, -1.0f), 0.5f * need_m);
    slide(b, aside, 0.5f * need_m);
    if (least_m < need_m) {
        const vec3 way = through_m < other_m ? normal : other;
        push_ring(a, v3_scale(way, -1.0f), 0.5f * least_m);
        push_ring(b, way, 0.5f * least_m);
    }
    return true;
}
