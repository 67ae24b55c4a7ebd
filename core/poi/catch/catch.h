/* catch.h -- fish and poi: decides which fish lie on the poi, slip off, fall through or are caught.
 *
 * The poi is a paper scoop. Under water, the paper is a wall for fish. A fish over the paper
 * without enough water to stand in becomes a carried fish. */
#ifndef KINGYO_CORE_POI_CATCH_CATCH_H
#define KINGYO_CORE_POI_CATCH_CATCH_H

#include "core/output.h"
#include "core/poi/bowl/bowl.h"
#include "core/poi/poi.h"
#include "core/tank/tank.h"

/* Number of fish that fell into bowls in this tick, by cause. `landed` and `bowled` count for the
 * owner of the bowl, regardless of which poi dropped the fish. `poured` and `walled` are fouls and
 * count for the player of the poi. Each fish is counted in exactly one of `landed`, `poured` and
 * `walled`. */
struct catch_result {
    uint32_t landed; /* Valid catches: the rim of the poi was completely above the water with the
                        fish on it. */
    uint32_t poured; /* Fouls: the ring had not been clear of the water, so that the fish was washed
                        into the bowl. */
    uint32_t walled; /* Fouls: the ring pressed the fish against a wall when it was captured. */
    uint32_t bowled; /* All fish that now lie in this player's bowl, from any poi and for any
                        cause. */
};

/* Returns 1 if fish number `fish` lies on the poi or falls from it, otherwise 0. */
int catch_has_carried(const struct poi *poi, uint32_t fish);

/* Counts a fish that fell from poi `poi` into bowl `bowl`. Asserts that both indices are below
 * POI_MAX. */
void catch_count(const struct carried_fish *carried, uint32_t poi, uint32_t bowl,
                 struct catch_result results[POI_MAX]);

/* Advances the fish of one poi by one tick (1/120 s); called after the tick of the fish. Moves and
 * drops the carried fish, captures new fish, and gathers the loads for the paper of the next tick.
 * A fish that an earlier poi of the player held goes back to the water. Fish that fell into a bowl
 * are added to `results`. Asserts that `poi_index` < POI_MAX. */
void catch_tick(struct poi *poi, uint32_t poi_index, const struct stall *stall, uint32_t tick,
                struct output *output, struct catch_result results[POI_MAX]);

#endif
