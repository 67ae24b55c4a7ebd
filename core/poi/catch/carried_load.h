/* carried_load.h -- computes the loads of the carried fish on the paper of a poi (paper scoop). */
#ifndef KINGYO_CORE_POI_CATCH_CARRIED_LOAD_H
#define KINGYO_CORE_POI_CATCH_CARRIED_LOAD_H

#include "core/poi/poi.h"

/* Returns the fraction [0, 1] of a carried fish's weight that water does not support. */
float carried_load_dryness(const struct poi *poi, const struct basis *axes,
                           const struct carried_fish *carried, const struct fish *fish);

/* Writes `loads`, `load_count`, `slap_count` and `carried_kg` of the poi for the next tick of the
 * paper.
 *
 * The body of a fish acts on a patch 20 mm in diameter. A slap acts at the tail on a patch 2 to
 * 5 mm in diameter if there is paper under the tail. Otherwise the force of the slap acts at the
 * body, on a patch whose area is 16 to 100 times larger.
 *
 * `pull_m_s2` is gravity minus the poi's own acceleration, along the poi's up axis. `fish` is the
 * tank's array of fish. */
void carried_load_gather(struct poi *poi, const struct basis *axes, float pull_m_s2,
                         const struct fish *fish);

#endif
