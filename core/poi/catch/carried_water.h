/* carried_water.h -- the water that a poi (paper scoop) carries out of the tank, and its drainage.
 *
 * A film clings to both faces of the paper. A pool lies in the sag of the paper. On an upside-down
 * poi, the pool lies in the ring, which is 3 mm high. Only the tank supplies water. The mass of the
 * carried water therefore never rises in air. */
#ifndef KINGYO_CORE_POI_CATCH_CARRIED_WATER_H
#define KINGYO_CORE_POI_CATCH_CARRIED_WATER_H

#include "core/poi/poi.h"

/* Returns the capacity of the pool: about 3 g in the sag of a level poi, 15 g on an upside-down
 * poi, and nothing on a steep poi. `up_y` is the vertical component of the poi's unit normal. */
float carried_water_room_kg(const struct poi *poi, float up_y);

/* Updates film, pool and drops for one tick (1/120 s). Under water, film and pool fill up. In air,
 * the water drains over the rim with a time constant of 0.15 s divided by the sine of the tilt,
 * through holes, and slowly through wet paper. `up_y` is the vertical component of the poi's unit
 * normal. */
void carried_water_tick(struct poi *poi, float up_y);

#endif
