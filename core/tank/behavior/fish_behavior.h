/* fish_behavior.h -- fish behavior: the decision of a fish from startle, gait, walls, shade and
 * depth.
 *
 * A fish decides about thirty times per second, the fish of a tank in turn, and in every tick if it
 * is startled, falls or escapes. The results are goals in struct fish, which swim_move() executes
 * in every tick. struct perception holds everything that a decision may use. */
#ifndef KINGYO_CORE_TANK_BEHAVIOR_FISH_BEHAVIOR_H
#define KINGYO_CORE_TANK_BEHAVIOR_FISH_BEHAVIOR_H

#include "core/tank/behavior/perception.h"
#include "core/tank/fish.h"

#define FISH_BEHAVIOR_TICKS 4u /* 33 ms: the reaction time of an undisturbed goldfish. */

/* Returns 1 if the fish decides in this tick: in its turn, while it escapes or falls, or if a
 * startling object is near (a C-start follows its cause after 8 to 15 ms). */
int fish_behavior_is_due(const struct fish *fish, uint32_t index, const struct perception *around);

/* Returns the time since the last decision, 1 to FISH_BEHAVIOR_TICKS ticks, for `around->dt_s`. */
float fish_behavior_dt_s(const struct fish *fish, uint32_t tick);

/* Makes the decision of a fish and sets its goals. A fish in the air falls instead (`falls`), and
 * swim_move() ignores it. */
void fish_behavior_tick(struct fish *fish, uint32_t index, const struct perception *around);

#endif
