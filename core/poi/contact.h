/* contact.h -- paper against fish under water. */
#ifndef KINGYO_CORE_POI_CONTACT_H
#define KINGYO_CORE_POI_CONTACT_H

#include "core/poi/poi.h"
#include "core/tank/tank.h"

/* Keeps a swimming fish on its side of the paper and pushes it along. Returns whether it touches
 * the upper side, so that the poi may take it up. Fish near the ring but not over paper pass
 * freely. */
int contact_fish(struct poi *poi, const struct basis *axes, uint32_t index, struct tank *tank);

#endif
