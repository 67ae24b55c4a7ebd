/* obstacle.c -- contact of fish with the rings of pois and the hulls of bowls, and the sidestep of
 * fish beside a poi. */
#include "core/tank/collision/obstacle.h"

#include "core/input.h"

#define SIDESTEP_RANGE_M 0.05f
#define SIDESTEP_M_S 0.012f
#define STILL_M_S 0.01f /* Speed of a disc below which fish do not step aside. */

struct touch obstacle_touch(const struct obstacle *obstacle, const struct box *box)
{
    if (obstacle->kind == OBSTACLE_BOWL) {
        const struct hull hull = { obstacle->centre_m, obstacle->radius_m, obstacle->depth_m };
        return shape_touch_hull(&hull, box);
    }
    const float tube_m = RING_TUBE_PER_RADIUS * obstacle->radius_m;
    const struct ring ring = { obstacle->centre_m, obstacle->normal, obstacle->radius_m - tube_m,
                               tube_m };
    return shape_touch_ring(&ring, box);
}

vec3 obstacle_clear(const struct obstacle *obstacle, const struct box *box)
{
    const struct touch touch = obstacle_touch(obstacle, box);
    return v3_scale(touch.out, f_max(0.0f, -touch.gap_m));
}

int obstacle_in_reach(const struct obstacle *obstacle, const struct box *box)
{
    const vec3 d = v3_sub(box->centre_m, obstacle->centre_m);
    const float reach_m = obstacle->radius_m + v3_length(box->half_m) + OBSTACLE_REACH_M;
    return v3_dot(d, d) < reach_m * reach_m;
}

float obstacle_disc_distance_m(const struct obstacle *disc, vec3 point_m)
{
    const vec3 d = v3_sub(point_m, disc->centre_m);
    const float above_m = v3_dot(d, disc->normal);
    const float out_m = v3_length(v3_muladd(d, disc->normal, -above_m)) - disc->radius_m;
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
