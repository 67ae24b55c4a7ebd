/* wall_following.c -- attraction by walls: it turns headings, so that a wandering fish drifts to
 * the walls and along them.
 *
 * With the constants below the density of a single fish falls to 1 / e over 7 cm
 * (test_wall_following.c). */
#include "core/tank/behavior/wall_following.h"

#define FALL_OFF_M 0.09f /* Distance from a wall over which the attraction falls to 1 / e. */
/* A fish nearer than this is beside the wall and is not attracted further. */
#define BESIDE_LENGTHS 0.8f
/* Turning rate of a heading across the attraction, at the wall and at full strength. */
#define TURN_PER_S 6.0f

float wall_pull(float gap_m, float length_m)
{
    const float off_m = gap_m - BESIDE_LENGTHS * length_m;
    return off_m <= 0.0f || gap_m > WALL_RANGE_M ? 0.0f : f_exp(-off_m / FALL_OFF_M);
}

/* Returns the signed attraction along one axis, from both walls on that axis. */
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
    /* The component across the heading turns the fish; the component along the heading has no
     * effect. */
    const float s = f_sin(fish->heading_rad), c = f_cos(fish->heading_rad);
    const float left = -x * c + z * s;
    fish->heading_rad += around->wall_follow * TURN_PER_S * left * around->dt_s;
}
