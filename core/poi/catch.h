/* catch.h -- fish and paper: who is on the poi, who slips off, who falls through, who is caught. */
#ifndef KINGYO_CORE_POI_CATCH_H
#define KINGYO_CORE_POI_CATCH_H

#include "core/output.h"
#include "core/poi/bowl.h"
#include "core/poi/poi.h"
#include "core/tank/tank.h"

struct catch_result {
    uint32_t landed; /* Fish that came into the bowl this tick. */
};

/* One tick of one poi against all fish, after they moved: carries, slides and drops the fish that it
 * holds, takes up new ones, and tears the paper under them. */
struct catch_result catch_tick(struct poi *poi, uint32_t poi_index, struct tank *tank,
                               struct bowl *bowl, uint32_t tick, struct output *output);

#endif
