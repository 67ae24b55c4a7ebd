/* let_go.h -- what lay on a poi that is no longer there falls; nothing hangs in the air.
 *
 * A poi goes when its controller is taken away in a round, and when it is exchanged. */
#ifndef KINGYO_CORE_GAME_LET_GO_H
#define KINGYO_CORE_GAME_LET_GO_H

#include <stdint.h>

#include "core/poi/catch.h"

/* Every rider begins to fall, at the speed that it had, up to that of a calm hand. */
void let_go_all(struct poi *poi, const struct tank *tank);

/* One tick of the fish of a poi that nobody plays with, instead of catch_tick: all that it held are
 * in the water or a bowl soon. What came into a bowl is added to `results`. */
void let_go_tick(struct poi *poi, uint32_t poi_index, const struct stall *stall,
                 struct catch_result results[POI_MAX]);

#endif
