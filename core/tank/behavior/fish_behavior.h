/* fish_behavior.h -- decides how a fish swims. The decision depends on startle, gait (burst, swim
 * or rest), walls, shades on the water and depth.
 *
 * A fish normally decides in every fourth tick (a tick is 1/120 s), and in each tick a quarter of
 * the fish decide. A fish decides in every tick while it is startled, falls or escapes. The results
 * are goals in struct fish, which swim_move() follows in every tick. struct perception holds all
 * input of a decision.
 *
 * Walls can attract fish (thigmotaxis), as section 2.2 and figure 2.3 of the 2013 thesis on
 * goldfish behavior describe for a single goldfish. The strength of the attraction is
 * `wall_follow`. Its value is 0 in every preset, because the attraction is not visible in a tank
 * with many fish. */
#pragma once

#include "core/tank/behavior_params.h"
#include "core/tank/fish.h"

/* Returns true if the fish decides in this tick. A fish decides in every FISH_BEHAVIOR_TICKS-th
 * tick. A fish decides in every tick at the surface, while it escapes or falls, and near an object
 * that can startle it. A C-start (escape) must begin 8 to 15 ms after its cause, so a startled fish
 * cannot wait up to 33 ms for its next decision. */
bool fish_behavior_is_due(const struct fish *fish, uint32_t index, const struct perception *around);

/* Returns the time since the fish's last decision, 1 to FISH_BEHAVIOR_TICKS ticks, in seconds. The
 * caller stores the result in `around->dt_s`. */
float fish_behavior_dt_s(const struct fish *fish, uint32_t tick);

/* Makes one decision of the fish and sets its goals. A fish in the air only falls: `falls` is set
 * and swim_move() is not called for the fish. */
void fish_behavior_tick(struct fish *fish, uint32_t index, const struct perception *around);

#define WALL_RANGE_M 0.20f

/* Returns the attraction [0, 1] of a wall at distance `gap_m` >= 0 from the fish's centre. The
 * attraction decreases exponentially. Returns 0 beyond WALL_RANGE_M, and for a fish that is already
 * beside the wall. */
float behavior_wall_pull(float gap_m, float length_m);

/* Turns the heading of a swimming or bursting fish by the attraction of walls during
 * `around->dt_s`. */
void behavior_wall_follow(struct fish *fish, const struct perception *around);
