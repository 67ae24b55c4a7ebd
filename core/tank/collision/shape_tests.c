/* shape_tests.c -- distances between a box and a ring or hull, found by a search over the ring or
 * over the box. */
#include "core/tank/collision/box.h"

#include "core/base/panic.h"

/* Number of coarse points on a ring: equally spaced points at which the search for the nearest
 * point of the ring begins. The points are about 4 mm apart on the ring of a poi. Therefore each
 * place where a fish touches the ring is at most about 2 mm away from a coarse point. */
#define RING_POINTS 64
/* Number of times that the search for the nearest point of the ring halves its step along the ring.
 * The search begins with a step of 4 mm, so the last step is 4 mm / 2^7, a thirtieth of a
 * millimetre. */
#define RING_HALVINGS 7
/* Number of sweeps in the search for the point of a box that lies deepest in a hull. Each sweep
 * optimises three coordinates in turn. The box of a fish needs five sweeps. */
#define HULL_SWEEPS 8

static float sign_of(float value)
{
    return value < 0.0f ? -1.0f : 1.0f;
}

float shape_touch_point_m(const struct box *box, vec3 point_m, vec3 *out)
{
    const vec3 p = vec_basis_to_body(&box->axes, v3_sub(point_m, box->centre_m));
    const vec3 q =
        v3(f_abs(p.x) - box->half_m.x, f_abs(p.y) - box->half_m.y, f_abs(p.z) - box->half_m.z);
    const vec3 beyond = v3(sign_of(p.x) * f_max(q.x, 0.0f), sign_of(p.y) * f_max(q.y, 0.0f),
                           sign_of(p.z) * f_max(q.z, 0.0f));
    const float outside_m = v3_length(beyond);
    const float inside_m = f_min(f_max(q.x, f_max(q.y, q.z)), 0.0f);
    /* `way` is the direction from the skin of the box to the point. Inside the box, `way` is the
     * normal of the nearest face. */
    const vec3 way = outside_m > 0.0f           ? v3_scale(beyond, 1.0f / outside_m)
                     : q.x >= q.y && q.x >= q.z ? v3(sign_of(p.x), 0.0f, 0.0f)
                     : q.y >= q.z               ? v3(0.0f, sign_of(p.y), 0.0f)
                                                : v3(0.0f, 0.0f, sign_of(p.z));
    *out = vec_basis_to_world(&box->axes, way);
    return outside_m + inside_m;
}

/* ---- Contact of a box with a ring ------------------------------------------------------------ */

/* A direction in the plane of a ring, as cosine and sine of the angle from the vector `east` of
 * struct circle. The angle itself is never computed. */
struct turn {
    float cos, sin;
};

/* Cosines of the angles from 0 to half a turn. Entry k is the cosine of k / RING_POINTS of a full
 * turn. To find the sine of an angle, turn_of() looks up the cosine of a quarter turn minus that
 * angle. */
static const float ring_cos[RING_POINTS / 2 + 1] = {
    1.0f,          0.995184727f,  0.98078528f,   0.956940336f,  0.923879533f,  0.881921264f,
    0.831469612f,  0.773010453f,  0.707106781f,  0.634393284f,  0.555570233f,  0.471396737f,
    0.382683432f,  0.290284677f,  0.195090322f,  0.0980171403f, 0.0f,          -0.0980171403f,
    -0.195090322f, -0.290284677f, -0.382683432f, -0.471396737f, -0.555570233f, -0.634393284f,
    -0.707106781f, -0.773010453f, -0.831469612f, -0.881921264f, -0.923879533f, -0.956940336f,
    -0.98078528f,  -0.995184727f, -1.0f,
};

/* Cosines and sines of the angles by which the search refines a point of the ring. The angle of
 * entry k is the angle between two neighbouring coarse points, 1 / RING_POINTS of a full turn,
 * divided by 2^(k + 1). */
static const struct turn ring_halving[RING_HALVINGS] = {
    { 0.998795456f, 0.0490676743f },   { 0.999698819f, 0.0245412285f },
    { 0.999924702f, 0.0122715383f },   { 0.999981175f, 0.00613588465f },
    { 0.999995294f, 0.00306795676f },  { 0.999998823f, 0.00153398019f },
    { 0.999999706f, 0.000766990319f },
};

/* The centre line of a ring in the coordinates of the box. */
struct circle {
    vec3 centre_m;    /* Centre of the circle relative to the centre of the box, along the axes of
                         the box. */
    vec3 east, north; /* Vectors as long as the circle's radius: `east` points toward the box, and
                         `north` is perpendicular to `east`. */
    vec3 half_m;      /* Half of the size of the box along each of its axes. */
};

static vec3 circle_point(const struct circle *circle, struct turn turn)
{
    return v3_muladd(v3_muladd(circle->centre_m, circle->east, turn.cos), circle->north, turn.sin);
}

/* Returns the signed distance of a point of the circle from the box, as shape_touch_point_m()
 * does. */
static float circle_distance_m(const struct circle *circle, struct turn turn)
{
    const vec3 p = circle_point(circle, turn), half = circle->half_m;
    const vec3 q = v3(f_abs(p.x) - half.x, f_abs(p.y) - half.y, f_abs(p.z) - half.z);
    const vec3 beyond = v3(f_max(q.x, 0.0f), f_max(q.y, 0.0f), f_max(q.z, 0.0f));
    const float square = v3_dot(beyond, beyond);
    return square > 0.0f ? f_sqrt(square) : f_max(q.x, f_max(q.y, q.z));
}

/* Point of the ring that is nearest to the box, or deepest in the box if the ring penetrates the
 * box. */
struct nearest {
    struct turn turn;
    float distance_m;
};

/* Tests the point of the circle at the angle `about` + `more` if `side` is 1, or `about` - `more`
 * if `side` is -1. Stores the point in `best` if the point is nearer to the box than `best`. */
static void try_turn(struct nearest *best, const struct circle *circle, struct turn about,
                     struct turn more, float side)
{
    const struct turn turn = { about.cos * more.cos - side * about.sin * more.sin,
                               about.sin * more.cos + side * about.cos * more.sin };
    const float distance_m = circle_distance_m(circle, turn);
    if (distance_m < best->distance_m) {
        *best = (struct nearest){ turn, distance_m };
    }
}

/* Returns how many of the RING_POINTS points of a circle must be tested on each side of the
 * direction `east`. These points cover the part of the circle within `reach_m` of the box's centre.
 * `away_m` is the length of the vector from the ring's centre to the box's centre, and `in_plane_m`
 * is the component of that vector along `east`. `middle_m` is the radius of the circle. */
static int window_of(float in_plane_m, float away_m, float middle_m, float reach_m)
{
    /* By the law of cosines, the point of the circle at `angle` from `east` is within `reach_m` of
     * the box's centre if 2 * middle_m * in_plane_m * cos(angle) > least. */
    const float least = away_m * away_m + middle_m * middle_m - reach_m * reach_m;
    int steps = 1;
    while (steps < RING_POINTS / 2 && 2.0f * middle_m * in_plane_m * ring_cos[steps] > least) {
        steps++;
    }
    return steps;
}

static struct turn turn_of(int step)
{
    CORE_ASSERT(step >= -RING_POINTS / 2 && step <= RING_POINTS / 2);
    const int size = step < 0 ? -step : step;
    const int quarter = RING_POINTS / 4;
    const float sine = ring_cos[size < quarter ? quarter - size : size - quarter];
    return (struct turn){ ring_cos[size], step < 0 ? -sine : sine };
}

/* Finds the point of the ring nearest to the box. Tests equally spaced points, and refines each
 * point that is nearer to the box than its two neighbours. The box can be near two parts of the
 * ring, so the function refines all such points and compares the results. */
static struct nearest nearest_on(const struct circle *circle, int window, float maybe_m)
{
    struct nearest best = { { 1.0f, 0.0f }, SHAPE_TOUCH_FAR_M };
    const int last = window < RING_POINTS / 2 ? window : RING_POINTS / 2 - 1;
    float before_m = SHAPE_TOUCH_FAR_M;
    float here_m = circle_distance_m(circle, turn_of(-window));
    for (int step = -window; step <= last; step++) {
        const float after_m =
            step < last ? circle_distance_m(circle, turn_of(step + 1)) : SHAPE_TOUCH_FAR_M;
        if (here_m < maybe_m && here_m <= before_m && here_m <= after_m) {
            /* Refines the nearest point by a search that halves its step. The search finds the
             * minimum, because a short arc of the ring is straight to within 0.05 mm. Along a
             * straight line, the distance from a convex box has only one minimum. */
            struct nearest fine = { turn_of(step), here_m };
            for (int k = 0; k < RING_HALVINGS; k++) {
                const struct turn about = fine.turn;
                try_turn(&fine, circle, about, ring_halving[k], -1.0f);
                try_turn(&fine, circle, about, ring_halving[k], 1.0f);
            }
            best = fine.distance_m < best.distance_m ? fine : best;
        }
        before_m = here_m;
        here_m = after_m;
    }
    return best;
}

struct touch shape_touch_ring(const struct ring *ring, const struct box *box)
{
    CORE_ASSERT(ring->middle_m > 0.0f && ring->tube_m > 0.0f);
    const struct touch far = { SHAPE_TOUCH_FAR_M, { 0.0f, 1.0f, 0.0f } };
    const vec3 d = v3_sub(box->centre_m, ring->centre_m);
    const float off_plane_m = v3_dot(d, ring->normal);
    const vec3 in_plane = v3_muladd(d, ring->normal, -off_plane_m);
    const float in_plane_m = v3_length(in_plane);
    const float offset_m = in_plane_m - ring->middle_m;
    const float reach_m = v3_length(box->half_m) + ring->tube_m;
    if (off_plane_m * off_plane_m + offset_m * offset_m > reach_m * reach_m) {
        return far;
    }
    const vec3 n = ring->normal;
    const vec3 other = f_abs(n.x) < 0.7f ? v3(1.0f, 0.0f, 0.0f) : v3(0.0f, 0.0f, 1.0f);
    const vec3 east = v3_normalize_or(in_plane, v3_normalize_or(v3_cross(n, other), n));
    const float middle_m = ring->middle_m;
    const struct circle circle = {
        .centre_m = vec_basis_to_body(&box->axes, v3_scale(d, -1.0f)),
        .east = vec_basis_to_body(&box->axes, v3_scale(east, middle_m)),
        .north = vec_basis_to_body(&box->axes, v3_scale(v3_cross(n, east), middle_m)),
        .half_m = box->half_m,
    };
    const int window = window_of(in_plane_m, v3_length(d), middle_m, reach_m);
    const float maybe_m = ring->tube_m + middle_m * F_TAU / (float)RING_POINTS;
    const struct nearest at = nearest_on(&circle, window, maybe_m);
    if (at.distance_m >= SHAPE_TOUCH_FAR_M) {
        return far;
    }
    const vec3 point_m =
        v3_add(box->centre_m, vec_basis_to_world(&box->axes, circle_point(&circle, at.turn)));
    vec3 toward;
    const float gap_m = shape_touch_point_m(box, point_m, &toward) - ring->tube_m;
    const vec3 out = v3_scale(toward, -1.0f);
    if (at.distance_m >= 0.0f) {
        return (struct touch){ gap_m, out };
    }
    /* The centre line of the ring passes through the box. Only a move perpendicular to the ring
     * separates ring and box. Near the box, a straight rod approximates the ring. */
    const vec3 along = v3_cross(n, v3_scale(v3_sub(point_m, ring->centre_m), 1.0f / middle_m));
    const vec3 move = box_clear_rod(box, point_m, along, ring->tube_m);
    return (struct touch){ -v3_length(move), v3_normalize_or(move, out) };
}

/* ---- Contact of a box with a hull ------------------------------------------------------------ */

/* Returns the point of the box that lies deepest in an ellipsoid, relative to the ellipsoid's
 * centre. `centre` is the centre of the box relative to the ellipsoid's centre. `inverse` holds the
 * inverses of the ellipsoid's half axes.
 *
 * Multiplied by `inverse`, the ellipsoid becomes a ball of radius 1. The deepest point is the point
 * of the scaled box that is nearest to the centre of the ball. The function finds that point by
 * optimising its three box coordinates `u` in turn. */
static vec3 deepest_point(const struct box *box, vec3 centre, vec3 inverse)
{
    const vec3 axis[3] = { box->axes.right, box->axes.up, box->axes.back };
    vec3 column[3], at = v3(centre.x * inverse.x, centre.y * inverse.y, centre.z * inverse.z);
    float u[3] = { 0.0f, 0.0f, 0.0f };
    for (int i = 0; i < 3; i++) {
        column[i] = v3(axis[i].x * inverse.x, axis[i].y * inverse.y, axis[i].z * inverse.z);
    }
    for (int sweep = 0; sweep < HULL_SWEEPS; sweep++) {
        for (int i = 0; i < 3; i++) {
            const float half = i == 0 ? box->half_m.x : i == 1 ? box->half_m.y : box->half_m.z;
            const float free = u[i] - v3_dot(column[i], at) / v3_dot(column[i], column[i]);
            const float next = f_clamp(free, -half, half);
            at = v3_muladd(at, column[i], next - u[i]);
            u[i] = next;
        }
    }
    return v3_muladd(v3_muladd(v3_muladd(centre, axis[0], u[0]), axis[1], u[1]), axis[2], u[2]);
}

/* Computes the distance of the box from the hull by a first-order approximation. The space is
 * scaled so that the ellipsoid of the hull becomes a ball of radius 1. `k` is the scaled distance
 * of the deepest point of the box from the centre of the ball, so k - 1 is its scaled distance from
 * the skin. k - 1 divided by the change of `k` per metre is the distance in metres. The result is
 * accurate near the skin. */
struct touch shape_touch_hull(const struct hull *hull, const struct box *box)
{
    CORE_ASSERT(hull->radius_m > 0.0f && hull->depth_m > 0.0f);
    const struct touch far = { SHAPE_TOUCH_FAR_M, { 0.0f, -1.0f, 0.0f } };
    const vec3 d = v3_sub(box->centre_m, hull->mouth_m);
    const float reach_m = hull->radius_m + v3_length(box->half_m);
    if (v3_dot(d, d) > reach_m * reach_m) {
        return far;
    }
    const vec3 inverse = v3(1.0f / hull->radius_m, 1.0f / hull->depth_m, 1.0f / hull->radius_m);
    const vec3 p = deepest_point(box, d, inverse);
    const vec3 s = v3(p.x * inverse.x, p.y * inverse.y, p.z * inverse.z);
    const vec3 gradient = v3(s.x * inverse.x, s.y * inverse.y, s.z * inverse.z);
    const float k = v3_length(s), steep = v3_length(gradient);
    const vec3 out = v3_normalize_or(gradient, far.out);
    /* The box leaves the hull downward or to the side, never upward into the bowl. */
    const vec3 away = v3_normalize_or(v3(out.x, f_min(out.y, 0.0f), out.z), far.out);
    return (struct touch){ steep > 0.0f ? (k - 1.0f) * k / steep : -hull->depth_m, away };
}
