/* catch.h -- fish and paper: who is on the poi, who slips off, who falls through, who is caught.
 *
 * Under water paper is a wall that fish feel: it pushes them, and none passes through. Where a fish
 * above it no longer has water enough to stand in, it becomes a rider and the poi carries it. */
#ifndef KINGYO_CORE_POI_CATCH_H
#define KINGYO_CORE_POI_CATCH_H

#include "core/output.h"
#include "core/poi/bowl.h"
#include "core/poi/poi.h"
#include "core/tank/tank.h"

/* Fish that came into a bowl in this tick, and how: each is in exactly one of the three, of one
 * player. A fish belongs to the bowl that it lies in, whoever dropped it there: `landed` is the
 * bowl's. A foul is the hand's that did it: `poured` and `walled` are the poi's. */
struct catch_result {
    uint32_t landed; /* From a poi whose rim was wholly above the water with the fish on it. */
    uint32_t poured; /* From a ring that had not been clear of the water: washed in. */
    uint32_t walled; /* As `landed`, but taken up where the ring pressed it against a wall. */
    uint32_t bowled; /* Any of these, whoever's poi it was: it lies in this one's bowl. */
};

/* Whether a fish is among those that lie on the poi or fall off it. */
int catch_has_rider(const struct poi *poi, uint32_t fish);

/* Counts a fish that fell off poi `poi` into bowl `bowl`, both < POI_MAX. */
void catch_count(const struct rider *rider, uint32_t poi, uint32_t bowl,
                 struct catch_result results[POI_MAX]);

/* One tick of one poi against all fish, after they moved: carries, slides and drops the fish that
 * it holds, takes up new ones, and gathers their loads for the next tick's paper. A fish that is
 * held by this poi without being among its riders (its poi was renewed) goes back to the water.
 * What came into a bowl is added to `results`. `poi_index` < POI_MAX. */
void catch_tick(struct poi *poi, uint32_t poi_index, const struct stall *stall, uint32_t tick,
                struct output *output, struct catch_result results[POI_MAX]);

#endif
