/* release.h -- releases fish: fish on a poi that disappears fall into the water or a bowl.
 *
 * A poi disappears when its controller is removed during a round, and when the poi is replaced. */
#ifndef KINGYO_CORE_GAME_CONTROL_RELEASE_H
#define KINGYO_CORE_GAME_CONTROL_RELEASE_H

#include <stdint.h>

#include "core/poi/catch/catch.h"

/* Releases every fish on the poi. Each fish falls with its current velocity, limited to the
 * velocity of a calm arm. */
void release_all(struct poi *poi, const struct tank *tank);

/* Advances the released fish of an unused poi by one tick. Call instead of catch_tick(). Every fish
 * soon reaches the water or a bowl. Fish that land in a bowl are added to `results`. */
void release_tick(struct poi *poi, uint32_t poi_index, const struct stall *stall,
                  struct catch_result results[POI_MAX]);

#endif
