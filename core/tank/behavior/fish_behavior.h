/* fish_behavior.h -- the decision of a fish, which combines startle, gait, walls, shades and depth.
 *
 * Each fish decides about thirty times per second. The fish of a tank decide in turn. A fish
 * decides in every tick (1/120 s) while it is startled, falls or escapes. The results are goals in
 * struct fish, which swim_move() follows in every tick. struct perception holds all input of a
 * decision. */
#ifndef KINGYO_CORE_TANK_BEHAVIOR_FISH_BEHAVIOR_H
#define KINGYO_CORE_TANK_BEHAVIOR_FISH_BEHAVIOR_H

#include "core/tank/behavior/perception.h"
#include "core/tank/fish.h"

/* Ticks between two decisions of an undisturbed fish: 33 ms, its reaction time. */
#define FISH_BEHAVIOR_TICKS 4u

/* Returns 1 if the fish decides in this tick, otherwise 0. A fish decides in every
 * FISH_BEHAVIOR_TICKS-th tick. A fish decides in every tick at the surface, while it escapes or
 * falls, and near an object that can startle it. A C-start follows its cause after 8 to 15 ms, so a
 * startled fish cannot wait up to 33 ms for its next decision. */
int fish_behavior_is_due(const struct fish *fish, uint32_t index, const struct perception *around);

/* Returns the time since the fish's last decision, 1 to FISH_BEHAVIOR_TICKS ticks, in seconds. The
 * caller stores the result in `around->dt_s`. */
float fish_behavior_dt_s(const struct fish *fish, uint32_t tick);

/* Makes one decision of the fish and sets its goals. A fish in the air only falls: `falls` is set
 * and swim_move() is not called for it. */
void fish_behavior_tick(struct fish *fish, uint32_t index, const struct perception *around);

#endif
