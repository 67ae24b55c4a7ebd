/* wall_following.h -- thigmotaxis: the attraction of a single fish to walls.
 *
 * The functions implement section 2.2 and figure 2.3 of the 2013 thesis, after Sato. In a tank of
 * 60 x 30 cm a single goldfish stays near the walls. Its density decreases exponentially with the
 * distance from the walls, and the attraction reaches 20 cm. A large school hides the attraction,
 * so every preset disables it (`wall_follow` is 0). */
#ifndef KINGYO_CORE_TANK_BEHAVIOR_WALL_FOLLOWING_H
#define KINGYO_CORE_TANK_BEHAVIOR_WALL_FOLLOWING_H

#include "core/tank/behavior/perception.h"
#include "core/tank/fish.h"

#define WALL_RANGE_M 0.20f

/* Returns the attraction [0, 1] of a wall at distance `gap_m` >= 0 from the fish's centre. The
 * attraction decreases exponentially. Returns 0 beyond WALL_RANGE_M, and for a fish that is already
 * beside the wall. */
float wall_pull(float gap_m, float length_m);

/* Turns the heading of a swimming or bursting fish by the attraction of walls during
 * `around->dt_s`. */
void wall_follow(struct fish *fish, const struct perception *around);

#endif
