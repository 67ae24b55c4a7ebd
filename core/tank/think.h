/* think.h -- a fish makes up its mind: fright, gait, whims, walls, depth.
 *
 * A fish thinks about thirty times a second, the fish of a tank in turn, and every tick while
 * something presses. What it resolves on stands in struct fish as orders, which swim_move() carries
 * out in every tick. Everything that it knows is in its surroundings. */
#ifndef KINGYO_CORE_TANK_THINK_H
#define KINGYO_CORE_TANK_THINK_H

#include "core/tank/fish.h"
#include "core/tank/surroundings.h"

#define THINK_TICKS 4u /* 33 ms: what a goldfish takes to see and act when nothing presses. */

/* Whether the fish is to think in this tick: it is its turn, or it flees, falls, or something that
 * may frighten it is near (a C-start comes 8 to 15 ms after its cause). */
int think_due(const struct fish *fish, uint32_t index, const struct surroundings *around);

/* The time since it last thought: 1 to THINK_TICKS ticks. For `around->dt_s`. */
float think_dt_s(const struct fish *fish, uint32_t tick);

/* Ends in orders. A fish in the air falls instead (`falls`), and swim_move() leaves it alone. */
void think(struct fish *fish, uint32_t index, const struct surroundings *around);

#endif
