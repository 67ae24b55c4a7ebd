/* contact.h -- paper against fish under water. */
#ifndef KINGYO_CORE_POI_CONTACT_H
#define KINGYO_CORE_POI_CONTACT_H

#include "core/poi/poi.h"
#include "core/tank/tank.h"

/* Keeps the whole body of a fish within walls and floor, and as deep as the surface allows. */
void contact_stay_in_tank(struct fish *fish, const struct tank *tank);

/* Keeps a swimming fish on its side of the paper and pushes it along. Returns whether it touches
 * the upper side, so that the poi may take it up. Fish near the ring but not over paper pass
 * freely. Walls, floor and surface have the last word: a fish that ring and wall leave no room
 * keeps its side all the same, for the poi remembers it. `axes` are the poi's. */
int contact_fish(struct poi *poi, const struct basis *axes, uint32_t index, struct tank *tank);

#endif
