/* rest.h -- where a poi lies that nobody plays with: on the rim, beside its own bowl.
 *
 * Who is out is put away, and so are the stall's own bots' pois while nothing is played. Such a poi
 * is spared, casts ever less shadow, is no obstacle once it is out of the water, and what lay on it
 * falls. Whoever plays with it next takes it over from there. */
#ifndef KINGYO_CORE_GAME_REST_H
#define KINGYO_CORE_GAME_REST_H

#include "core/input.h"

struct core;

#define REST_LINGER_TICKS 120u /* Who is out keeps the poi for a second, to see why. */

/* On the rim of the open tank, its handle toward the player, beside the bowl of player `index`:
 * wholly in the picture, and nobody else's place. */
struct poi_target rest_place(const struct core *core, uint32_t index);

/* Counts how long player `index` has had nothing to do with its poi in this tick. Returns whether
 * it is put away by now. */
int rest_tick(struct core *core, uint32_t index);

/* Whether it is put away: nobody's hand leads it. */
int rest_holds(const struct core *core, uint32_t index);

/* Where the hand of a poi that is put away is in the next tick, which is at `hand` in this one: up
 * out of the water, over all rims, and down on its place. */
struct poi_target rest_way(const struct core *core, uint32_t index, struct poi_target hand);

/* Whether fish and other pois still meet it, and [0, 1] how much of its shadow is left. */
int rest_is_met(const struct core *core, uint32_t index);
float rest_shade(const struct core *core, uint32_t index);

#endif
