/* wall_following.c -- attraction by walls. The attraction turns headings, so that a wandering fish
 * drifts to the walls and then swims along them.
 *
 * With the constants in this file, the density of a single fish falls to 1 / e within 7 cm of a
 * wall (test_wall_following.c). */
#include "core/tank/behavior/wall_following.h"

#define FALL_OFF_M 0.09f /* Distance over which the attraction of a wall falls to 1 / e. */
/* Distance from a wall, in body lengths, within which the wall no longer attracts the fish. */
#define BESIDE_LENGTHS 0.8f
/* Turning rate of a fish at a wall, rad/s, if its heading is perpendicular to the attraction and
 * `wall_follow` is 1. */
#define TURN_PER_S 6.0f

float wall_pull(float gap_m, float length_m)
{
    const float off_m = gap_m - BESIDE_LENGTHS * length_m;
    return off_m <= 0.0f || gap_m > WALL_RANGE_M ? 0.0f : f_exp(-off_m / FALL_OFF_M);
}

/* Returns the sum of the attractions of both walls of one axis. A result > 0 points in the positive
 * direction of the axis. */
static float pull_along(float at_m, float half_m, float length_m)
{
    return wall_pull(half_m - at_m, length_m) - wall_pull(half_m + at_m, length_m);
}

void wall_follow(struct fish *fish, const struct perception *around)
{
    if (around->wall_follow <= 0.0f || (fish->gait != GAIT_SWIM && fish->gait != GAIT_BURST)) {
        return;
    }
    const float length_m = fish->length_m;
    const float x = pull_along(fish->position_m.x, 0.5f * around->size_m.x, length_m);
    const float z = pull_along(fish->position_m.z, 0.5f * around->size_m.z, length_m);
    /* Only the component of the attraction perpendicular to the heading turns the fish. */
    const float s = f_sin(fish->heading_rad), c = f_cos(fish->heading_rad);
    const float left = -x * c + z * s;
    fish->heading_rad += around->wall_follow * TURN_PER_S * left * around->dt_s;
}
