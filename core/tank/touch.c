/* touch.c -- distances from boxes to curved things, by walking along what is curved. */
#include "core/tank/touch.h"

#define RING_POINTS 64  /* 4 mm apart on a poi's ring: no corner of a fish slips between two ... */
#define RING_HALVINGS 8 /* ... and from there to a fiftieth of a millimetre. */
#define HULL_SWEEPS 8   /* Coordinate descent over three coordinates; a fish's box needs five. */

static float sign_of(float value)
{
    return value < 0.0f ? -1.0f : 1.0f;
}

/* Which face of a box is the nearest to a point inside it; `q` is how far inside each (<= 0). */
static vec3 nearest_face(vec3 p, vec3 q)
{
    if (q.x >= q.y && q.x >= q.z) {
        return v3(sign_of(p.x), 0.0f, 0.0f);
    }
    return q.y >= q.z ? v3(0.0f, sign_of(p.y), 0.0f) : v3(0.0f, 0.0f, sign_of(p.z));
}

float touch_point_m(const struct box *box, vec3 point_m, vec3 *out)
{
    const vec3 p = basis_to_body(&box->axes, v3_sub(point_m, box->centre_m));
    const vec3 q =
        v3(f_abs(p.x) - box->half_m.x, f_abs(p.y) - box->half_m.y, f_abs(p.z) - box->half_m.z);
    const vec3 beyond = v3(sign_of(p.x) * f_max(q.x, 0.0f), sign_of(p.y) * f_max(q.y, 0.0f),
                           sign_of(p.z) * f_max(q.z, 0.0f));
    const float outside_m = v3_length(beyond);
    const float inside_m = f_min(f_max(q.x, f_max(q.y, q.z)), 0.0f);
    const vec3 way = outside_m > 0.0f ? v3_scale(beyond, 1.0f / outside_m) : nearest_face(p, q);
    *out = basis_to_world(&box->axes, way);
    return outside_m + inside_m;
}

/* The circle as points by angle. */
struct circle {
    const struct ring *ring;
    vec3 east, north; /* Unit, in its plane, square to each other. */
};

static struct circle circle_of(const struct ring *ring)
{
    const vec3 n = ring->normal;
    const vec3 other = f_abs(n.x) < 0.7f ? v3(1.0f, 0.0f, 0.0f) : v3(0.0f, 0.0f, 1.0f);
    const vec3 east = v3_normalize_or(v3_cross(n, other), v3(1.0f, 0.0f, 0.0f));
    return (struct circle){ ring, east, v3_cross(n, east) };
}

static vec3 circle_point(const struct circle *circle, float angle_rad)
{
    const vec3 away = v3_add(v3_scale(circle->east, f_cos(angle_rad)),
                             v3_scale(circle->north, f_sin(angle_rad)));
    return v3_mad(circle->ring->centre_m, away, circle->ring->middle_m);
}

struct nearest {
    float angle_rad, distance_m;
    vec3 out; /* From the box to the ring. */
};

static void try_angle(struct nearest *best, const struct circle *circle, const struct box *box,
                      float angle_rad)
{
    vec3 out;
    const float distance_m = touch_point_m(box, circle_point(circle, angle_rad), &out);
    if (distance_m < best->distance_m) {
        *best = (struct nearest){ angle_rad, distance_m, out };
    }
}

/* Closes in on the least distance by halving steps about the best angle so far. */
static struct nearest close_in(struct nearest best, const struct circle *circle,
                               const struct box *box)
{
    float step_rad = 0.5f * F_TAU / (float)RING_POINTS;
    for (int k = 0; k < RING_HALVINGS; k++, step_rad *= 0.5f) {
        const float about_rad = best.angle_rad;
        try_angle(&best, circle, box, about_rad - step_rad);
        try_angle(&best, circle, box, about_rad + step_rad);
    }
    return best;
}

/* A ring that runs right through a box has no nearest face: only a move square to the ring clears
 * it, and there the ring is as good as a straight rod. */
static struct touch pierced(const struct nearest *at, const struct circle *circle,
                            const struct box *box)
{
    const struct ring *ring = circle->ring;
    const vec3 point_m = circle_point(circle, at->angle_rad);
    const vec3 along = v3_cross(ring->normal, v3_scale(v3_sub(point_m, ring->centre_m),
                                                       1.0f / ring->middle_m));
    const vec3 move = box_clear_rod(box, point_m, along, ring->tube_m);
    return (struct touch){ -v3_length(move), v3_normalize_or(move, v3_scale(at->out, -1.0f)) };
}

static struct touch touch_near(const struct nearest *at, const struct circle *circle,
                               const struct box *box)
{
    if (at->distance_m < 0.0f) {
        return pierced(at, circle, box);
    }
    return (struct touch){ at->distance_m - circle->ring->tube_m, v3_scale(at->out, -1.0f) };
}

/* A box can be near two parts of the ring at once; a second dip that is not much shallower than the
 * first at the coarse points may be the deeper one. So every coarse minimum is closed in on. */
struct touch touch_ring(const struct ring *ring, const struct box *box)
{
    struct touch touch = { TOUCH_FAR_M, { 0.0f, 1.0f, 0.0f } };
    const vec3 d = v3_sub(box->centre_m, ring->centre_m);
    const float off_plane_m = v3_dot(d, ring->normal);
    const float in_plane_m = v3_length(v3_mad(d, ring->normal, -off_plane_m));
    const float aside_m = in_plane_m - ring->middle_m;
    const float reach_m = v3_length(box->half_m) + ring->tube_m;
    if (off_plane_m * off_plane_m + aside_m * aside_m > reach_m * reach_m) {
        return touch;
    }
    const struct circle circle = circle_of(ring);
    const float step_rad = F_TAU / (float)RING_POINTS;
    const float maybe_m = ring->tube_m + ring->middle_m * step_rad;
    struct nearest coarse[RING_POINTS];
    for (int k = 0; k < RING_POINTS; k++) {
        coarse[k] = (struct nearest){ 0.0f, TOUCH_FAR_M, touch.out };
        try_angle(&coarse[k], &circle, box, step_rad * (float)k);
    }
    for (int k = 0; k < RING_POINTS; k++) {
        const float before_m = coarse[(k + RING_POINTS - 1) % RING_POINTS].distance_m;
        const float after_m = coarse[(k + 1) % RING_POINTS].distance_m;
        const float here_m = coarse[k].distance_m;
        if (here_m < maybe_m && here_m <= before_m && here_m <= after_m) {
            const struct nearest fine = close_in(coarse[k], &circle, box);
            const struct touch here = touch_near(&fine, &circle, box);
            touch = here.gap_m < touch.gap_m ? here : touch;
        }
    }
    return touch;
}

/* ---- Hull ----------------------------------------------------------------------------------- */

static float part_of(vec3 v, int i)
{
    return i == 0 ? v.x : i == 1 ? v.y : v.z;
}

/* The box's point that lies deepest in an ellipsoid: there |S (c + R u)| is least, S the inverse
 * half axes, u within the half sizes. Three coordinates, each in turn set to its best. */
static vec3 deepest_point(const struct box *box, vec3 centre, vec3 inverse)
{
    const vec3 axis[3] = { box->axes.right, box->axes.up, box->axes.back };
    vec3 column[3], at = v3(centre.x * inverse.x, centre.y * inverse.y, centre.z * inverse.z);
    float u[3] = { 0.0f, 0.0f, 0.0f };
    for (int i = 0; i < 3; i++) {
        column[i] =
            v3(axis[i].x * inverse.x, axis[i].y * inverse.y, axis[i].z * inverse.z);
    }
    for (int sweep = 0; sweep < HULL_SWEEPS; sweep++) {
        for (int i = 0; i < 3; i++) {
            const float half = part_of(box->half_m, i);
            const float free = u[i] - v3_dot(column[i], at) / v3_dot(column[i], column[i]);
            const float next = f_clamp(free, -half, half);
            at = v3_mad(at, column[i], next - u[i]);
            u[i] = next;
        }
    }
    return v3_mad(v3_mad(v3_mad(centre, axis[0], u[0]), axis[1], u[1]), axis[2], u[2]);
}

/* The first-order distance to an ellipsoid, (k - 1) k / |gradient|, is good near its skin. */
struct touch touch_hull(const struct hull *hull, const struct box *box)
{
    const struct touch far = { TOUCH_FAR_M, { 0.0f, -1.0f, 0.0f } };
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
    /* Down and aside, never up into the bowl. */
    const vec3 away = v3_normalize_or(v3(out.x, f_min(out.y, 0.0f), out.z), far.out);
    return (struct touch){ steep > 0.0f ? (k - 1.0f) * k / steep : -hull->depth_m, away };
}
