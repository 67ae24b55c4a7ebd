/* carried_water.h -- the water that a poi carries out of the tank, and its drainage.
 *
 * A film clings to both faces. A pool lies in the sag of the paper or, upside down, in the ring,
 * which is 3 mm high. Only the tank supplies water: in air the mass never rises. */
#ifndef KINGYO_CORE_POI_CATCH_CARRIED_WATER_H
#define KINGYO_CORE_POI_CATCH_CARRIED_WATER_H

#include "core/poi/poi.h"

/* Returns the capacity of a pool at the ring's tilt: about 3 g in a level sag, 15 g upside down,
 * none when steep. `up_y` is the upward component of the unit normal. */
float carried_water_room_kg(const struct poi *poi, float up_y);

/* Advances one tick. Under water the poi fills up. In air the water drains over the rim (0.15 s /
 * sine of the tilt), through holes, and slowly through wet paper. */
void carried_water_tick(struct poi *poi, float up_y);

#endif
