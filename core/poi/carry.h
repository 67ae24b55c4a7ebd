/* carry.h -- the water that a poi carries out of the tank, and how it loses it.
 *
 * A film clings to both faces; a pool lies in the paper's belly, or, upside down, in the ring,
 * which is 3 mm high. Water comes out of the tank alone: in air the mass never rises. */
#ifndef KINGYO_CORE_POI_CARRY_H
#define KINGYO_CORE_POI_CARRY_H

#include "core/poi/poi.h"

/* What a pool may hold as the ring lies, `up_y` the upward part of its unit normal: about 3 g in a
 * level belly, 15 g upside down, nothing when steep. */
float carry_room_kg(const struct poi *poi, float up_y);

/* One tick: under water it fills up; in air it runs over the rim (0.15 s / sine of the tilt),
 * through holes, and slowly through wet paper. */
void carry_tick(struct poi *poi, float up_y);

#endif
