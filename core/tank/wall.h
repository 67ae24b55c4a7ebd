/* wall.h -- thigmotaxis: how a wall draws a fish that is alone to it.
 *
 * The 2013 thesis, section 2.2 and figure 2.3, after Sato: in a tank of 60 x 30 cm a lone goldfish
 * keeps to the walls; its density falls off exponentially from them, their pull is felt to 20 cm. A
 * crowd masks that, so every preset has it off (`wall_follow` 0).
 */
#ifndef KINGYO_CORE_TANK_WALL_H
#define KINGYO_CORE_TANK_WALL_H

#include "core/tank/fish.h"
#include "core/tank/surroundings.h"

#define WALL_RANGE_M 0.20f

/* How strongly a wall at `gap_m` >= 0 from the fish's middle draws it, [0, 1]: falls off
 * exponentially, and is 0 beyond the range and where the fish is beside the wall already. */
float wall_pull(float gap_m, float length_m);

/* `around->dt_s` of it: turns the heading of a fish that swims or bursts. */
void wall_follow(struct fish *fish, const struct surroundings *around);

#endif
