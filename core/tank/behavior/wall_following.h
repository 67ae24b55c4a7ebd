/* wall_following.h -- thigmotaxis: the attraction of a single fish to walls.
 *
 * Implements section 2.2 and figure 2.3 of the 2013 thesis, after Sato: in a tank of 60 x 30 cm a
 * single goldfish keeps to the walls. The density falls off exponentially from the walls, and the
 * attraction reaches 20 cm. A crowd masks the effect, so every preset disables it (`wall_follow`
 * 0). */
#ifndef KINGYO_CORE_TANK_BEHAVIOR_WALL_FOLLOWING_H
#define KINGYO_CORE_TANK_BEHAVIOR_WALL_FOLLOWING_H

#include "core/tank/behavior/perception.h"
#include "core/tank/fish.h"

#define WALL_RANGE_M 0.20f

/* Returns the attraction of a wall at `gap_m` >= 0 from the fish's centre, [0, 1]. The value falls
 * off exponentially; it is 0 beyond the range and for a fish that is already beside the wall. */
float wall_pull(float gap_m, float length_m);

/* Turns the heading of a swimming or bursting fish for `around->dt_s`. */
void wall_follow(struct fish *fish, const struct perception *around);

#endif
