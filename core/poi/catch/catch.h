/* catch.h -- fish and paper: which fish lie on the poi, slip off, fall through or are caught.
 *
 * Under water paper acts on fish as a wall that pushes them and lets none pass. A fish above the
 * paper without enough water to stand in becomes a carried fish. */
#ifndef KINGYO_CORE_POI_CATCH_CATCH_H
#define KINGYO_CORE_POI_CATCH_CATCH_H

#include "core/output.h"
#include "core/poi/bowl/bowl.h"
#include "core/poi/poi.h"
#include "core/tank/tank.h"

/* Fish that came into a bowl in this tick, by cause. Each fish is counted once, for one player.
 * `landed` counts for the owner of the bowl, regardless of the poi that dropped the fish. `poured`
 * and `walled` are fouls and count for the poi that caused them. */
struct catch_result {
    uint32_t landed; /* From a poi whose rim was completely above the water with the fish on it. */
    uint32_t poured; /* From a ring that had not been clear of the water: washed in. */
    uint32_t walled; /* Like `landed`, but captured where the ring pressed the fish against a
                        wall. */
    uint32_t bowled; /* Any of these fish, from any poi, that now lie in this player's bowl. */
};

/* Returns 1 if a fish lies on the poi or falls off it. */
int catch_has_carried(const struct poi *poi, uint32_t fish);

/* Counts a fish that fell off poi `poi` into bowl `bowl`, both < POI_MAX. */
void catch_count(const struct carried_fish *carried, uint32_t poi, uint32_t bowl,
                 struct catch_result results[POI_MAX]);

/* Advances one poi by one tick against all fish, after they moved. Carries, slides and drops the
 * carried fish, captures new ones, and gathers their loads for the paper of the next tick. A fish
 * held by this poi that is not among its carried fish (the poi was replaced) goes back to the
 * water. Fish that came into a bowl are added to `results`. `poi_index` < POI_MAX. */
void catch_tick(struct poi *poi, uint32_t poi_index, const struct stall *stall, uint32_t tick,
                struct output *output, struct catch_result results[POI_MAX]);

#endif
