/* carried_load.h -- the loads that carried fish exert on the paper of a poi (paper scoop). */
#ifndef KINGYO_CORE_POI_CATCH_CARRIED_LOAD_H
#define KINGYO_CORE_POI_CATCH_CARRIED_LOAD_H

#include "core/poi/poi.h"

/* Returns the share [0, 1] of a carried fish's weight that water does not support. */
float carried_load_dryness(const struct poi *poi, const struct basis *axes,
                           const struct carried_fish *carried, const struct fish *fish);

/* Writes `loads`, `load_count`, `slap_count` and `carried_kg` of the poi for the next tick of the
 * paper. A body acts on a patch of 20 mm. A slap acts at the tail on a patch of 2 to 5 mm if there
 * is paper under the tail. A tail beyond the paper slaps the air, and the force acts at the body
 * instead, on 16 to 100 times the area. `pull_m_s2` is the component along the poi's up axis of
 * gravity minus the poi's own acceleration. `fish` is the tank's array of fish. */
void carried_load_gather(struct poi *poi, const struct basis *axes, float pull_m_s2,
                         const struct fish *fish);

#endif
