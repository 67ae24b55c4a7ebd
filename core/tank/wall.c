/* wall.c -- a pull that turns headings: wandering fish drift to the walls and along them.
 *
 * With these two figures the density of a lone fish falls to 1 / e over 7 cm (test_wall.c). */
#include "core/tank/wall.h"

#define FALL_OFF_M 0.09f    /* The pull is 1 / e of what it was so much farther from a wall. */
#define BESIDE_LENGTHS 0.8f /* Nearer than this it is beside the wall: nothing draws it nearer. */
#define TURN_PER_S 6.0f     /* Of a heading across the pull, at the wall, when fully followed. */

float wall_pull(float gap_m, float length_m)
{
    const float off_m = gap_m - BESIDE_LENGTHS * length_m;
    return off_m <= 0.0f || gap_m > WALL_RANGE_M ? 0.0f : f_exp(-off_m / FALL_OFF_M);
}

/* Along one axis, signed: both walls that face each other across it. */
static float pull_along(float at_m, float half_m, float length_m)
{
    return wall_pull(half_m - at_m, length_m) - wall_pull(half_m + at_m, length_m);
}

void wall_follow(struct fish *fish, const struct surroundings *around)
{
    if (around->wall_follow <= 0.0f || (fish->gait != GAIT_SWIM && fish->gait != GAIT_BURST)) {
        return;
    }
    const float length_m = fish->length_m;
    const float x = pull_along(fish->position_m.x, 0.5f * around->size_m.x, length_m);
    const float z = pull_along(fish->position_m.z, 0.5f * around->size_m.z, length_m);
    /* The pull across the heading turns it; what lies along it only goes on. */
    const float s = f_sin(fish->heading_rad), c = f_cos(fish->heading_rad);
    const float left = -x * c + z * s;
    fish->heading_rad += around->wall_follow * TURN_PER_S * left * around->dt_s;
}
