/* carried_water.h -- simulates the water that a poi (paper scoop) carries out of the tank, and how
 * the water drains.
 *
 * A film of water covers both faces of the paper. A pool lies in the sag of the paper. On an
 * upside-down poi, the pool lies in the ring, which is 3 mm high. Only the tank supplies water.
 * Therefore the mass of the carried water never increases in air. */
#ifndef KINGYO_CORE_POI_CATCH_CARRIED_WATER_H
#define KINGYO_CORE_POI_CATCH_CARRIED_WATER_H

#include "core/poi/poi.h"

/* Returns the largest mass of the pool: about 3 g in the sag of a level poi, 15 g on an upside-down
 * poi, and 0 on a steep poi. `up_y` is the vertical component of the poi's unit normal. */
float carried_water_room_kg(const struct poi *poi, float up_y);

/* Updates the film, the pool and the drops for one tick (1/120 s). Under water, the film and the
 * pool fill up. In air, water drains in three ways. Over the rim, the time constant is 0.15 s
 * divided by the sine of the tilt. Water also drains through holes, and slowly through wet paper.
 * `up_y` is the vertical component of the poi's unit normal. */
void carried_water_tick(struct poi *poi, float up_y);

#endif
