/* obstacle.c -- ring, hull and sidestep. */
#include "core/tank/obstacle.h"

#include "core/input.h"

#define SIDESTEP_RANGE_M 0.05f
#define SIDESTEP_M_S 0.012f
#define SHOVE_M 0.01f   /* Other bodies may shove one so far in a tick. */
#define STILL_M_S 0.01f /* A disc slower than this is a leaf. */
#define AXIS_STEPS 4
#define AXIS_SAMPLES 5 /* Points along a fish that are tried against a curved hull. */

static vec3 axis_point(const struct box *box, int sample)
{
    const float t = 2.0f * (float)sample / (float)(AXIS_SAMPLES - 1) - 1.0f;
    return v3_mad(box->centre_m, box->axes.back, 0.9f * t * box->half_m.z);
}

static vec3 nearest_on_ring(const struct obstacle *ring, vec3 point_m, float middle_m)
{
    const vec3 d = v3_sub(point_m, ring->centre_m);
    const vec3 flat = v3_mad(d, ring->normal, -v3_dot(d, ring->normal));
    const vec3 side = v3_cross(ring->normal, v3(0.0f, 0.0f, 1.0f)); /* Only for the very centre. */
    const vec3 out = v3_normalize_or(flat, v3_normalize_or(side, v3(1.0f, 0.0f, 0.0f)));
    return v3_mad(ring->centre_m, out, middle_m);
}

/* The ring's point that is nearest to the fish's axis: the best of some samples, then drawn closer
 * by projecting from ring to axis and back. */
static vec3 nearest_to_axis(const struct obstacle *ring, const struct box *box, float middle_m)
{
    vec3 nearest = { 0.0f, 0.0f, 0.0f };
    float best = 1e9f;
    for (int sample = 0; sample < AXIS_SAMPLES; sample++) {
        const vec3 on_axis = axis_point(box, sample);
        const vec3 on_ring = nearest_on_ring(ring, on_axis, middle_m);
        const float distance = v3_length(v3_sub(on_ring, on_axis));
        if (distance < best) {
            best = distance;
            nearest = on_ring;
        }
    }
    for (int step = 0; step < AXIS_STEPS; step++) {
        const float along = v3_dot(v3_sub(nearest, box->centre_m), box->axes.back);
        const float on = f_clamp(along, -box->half_m.z, box->half_m.z);
        nearest = nearest_on_ring(ring, v3_mad(box->centre_m, box->axes.back, on), middle_m);
    }
    return nearest;
}

static vec3 clear_ring(const struct obstacle *ring, const struct box *box)
{
    const float tube_m = RING_TUBE_PER_RADIUS * ring->radius_m;
    const vec3 nearest = nearest_to_axis(ring, box, ring->radius_m - tube_m);
    const vec3 out = v3_normalize_or(v3_sub(nearest, ring->centre_m), v3(1.0f, 0.0f, 0.0f));
    const vec3 reach = v3_sub(box->centre_m, nearest);
    if (v3_dot(reach, reach) > (box->half_m.z + SHOVE_M) * (box->half_m.z + SHOVE_M)) {
        return v3(0.0f, 0.0f, 0.0f); /* The rod goes on for ever, the ring does not. */
    }
    return box_clear_rod(box, nearest, v3_cross(ring->normal, out), tube_m);
}

/* The first-order distance to an ellipsoid, (k - 1) k / |gradient|, is good near its skin. */
static vec3 clear_hull(const struct obstacle *bowl, const struct box *box)
{
    const float wide = 1.0f / (bowl->radius_m * bowl->radius_m),
                deep = 1.0f / (bowl->depth_m * bowl->depth_m);
    vec3 move = { 0.0f, 0.0f, 0.0f };
    for (int sample = 0; sample < AXIS_SAMPLES; sample++) {
        const vec3 p = v3_sub(v3_add(axis_point(box, sample), move), bowl->centre_m);
        const vec3 gradient = v3(p.x * wide, p.y * deep, p.z * wide);
        const float k = f_sqrt(f_max(v3_dot(p, gradient), 1e-6f));
        const float steep = v3_length(gradient);
        const vec3 out = v3_normalize_or(gradient, v3(0.0f, -1.0f, 0.0f));
        const float thick = f_abs(v3_dot(box->axes.right, out)) * box->half_m.x +
                            f_abs(v3_dot(box->axes.up, out)) * box->half_m.y;
        const float distance = (k - 1.0f) * k / f_max(steep, 1e-6f);
        if (p.y < 0.0f && distance < thick) {
            move = v3_mad(move, out, thick - distance);
        }
    }
    return move;
}

int obstacle_in_reach(const struct obstacle *obstacle, const struct box *box)
{
    const vec3 d = v3_sub(box->centre_m, obstacle->centre_m);
    const float reach_m = obstacle->radius_m + 1.1f * box->half_m.z + SHOVE_M;
    return v3_dot(d, d) < reach_m * reach_m;
}

vec3 obstacle_clear(const struct obstacle *obstacle, const struct box *box)
{
    return obstacle->kind == OBSTACLE_DISC ? clear_ring(obstacle, box) : clear_hull(obstacle, box);
}

float obstacle_disc_distance_m(const struct obstacle *disc, vec3 point_m)
{
    const vec3 d = v3_sub(point_m, disc->centre_m);
    const float above_m = v3_dot(d, disc->normal);
    const float out_m = v3_length(v3_mad(d, disc->normal, -above_m)) - disc->radius_m;
    return out_m <= 0.0f ? f_abs(above_m) : f_sqrt(above_m * above_m + out_m * out_m);
}

vec3 obstacle_sidestep_m_s(const struct obstacle *disc, vec3 position_m)
{
    const vec3 none = { 0.0f, 0.0f, 0.0f };
    const vec3 d = v3(position_m.x - disc->centre_m.x, 0.0f, position_m.z - disc->centre_m.z);
    const float out_m = v3_length(d) - disc->radius_m;
    const float below_m = f_abs(position_m.y - disc->centre_m.y);
    if (disc->kind != OBSTACLE_DISC || out_m < 0.0f || out_m > SIDESTEP_RANGE_M ||
        below_m > SIDESTEP_RANGE_M || v3_length(disc->velocity_m_s) < STILL_M_S) {
        return none;
    }
    const float near = 1.0f - out_m / SIDESTEP_RANGE_M;
    return v3_scale(v3_normalize_or(d, none), SIDESTEP_M_S * near);
}
