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

struct catch_result {
    uint32_t landed; /* Fish that came into the bowl this tick. */
};

/* One tick of one poi against all fish, after they moved: carries, slides and drops the fish that
 * it holds, takes up new ones, and gathers their loads for the next tick's paper. A fish that is
 * held by this poi without being among its riders (its poi was renewed) goes back to the water. */
struct catch_result catch_tick(struct poi *poi, uint32_t poi_index, struct tank *tank,
                               struct bowl *bowl, uint32_t tick, struct output *output);

#endif
