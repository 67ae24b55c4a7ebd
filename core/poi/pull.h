/* pull.h -- the hand's pull at the ring, against water and weight. */
#ifndef KINGYO_CORE_POI_PULL_H
#define KINGYO_CORE_POI_PULL_H

#include "core/poi/poi.h"

/* The ring's speed a tick later, drawn to `target_m` by a spring of at most 20 N, with as much of
 * it as `immersed` in the water. Notes what of water and weight it met; the place stays. */
void pull_ring(struct poi *poi, vec3 target_m, const struct basis *axes, float immersed);

/* What the hand does to the ring, world: its spring and damper at the place and speed that the ring
 * has, so that it is right for a ring that something holds back. */
vec3 pull_hand_n(const struct poi *poi, const struct basis *axes);

/* Along `axes`: what it takes to move the ring with its burden and the water that goes along. */
vec3 pull_mass_kg(const struct poi *poi);

#endif
