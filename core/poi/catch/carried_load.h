/* carried_load.h -- the load of the carried fish on the paper. */
#ifndef KINGYO_CORE_POI_CATCH_CARRIED_LOAD_H
#define KINGYO_CORE_POI_CATCH_CARRIED_LOAD_H

#include "core/poi/poi.h"

/* Returns the share [0, 1] of a carried fish's weight that water does not support. */
float carried_load_dryness(const struct poi *poi, const struct basis *axes,
                           const struct carried_fish *carried, const struct fish *fish);

/* Fills the poi's loads and its fish weight for the paper of the next tick. A body lies on a patch
 * of 20 mm. A slap acts at the tail, on 2 to 5 mm, if there is paper. A tail beyond the paper slaps
 * the air, and the body takes the reaction on 16 to 100 times the area. `pull_m_s2` is gravity
 * minus the poi's own acceleration along its up; `fish` is the tank's. */
void carried_load_gather(struct poi *poi, const struct basis *axes, float pull_m_s2,
                         const struct fish *fish);

#endif
