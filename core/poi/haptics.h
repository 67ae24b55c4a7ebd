/* haptics.h -- what the hand that holds the poi feels, by the same physics that moves the ring.
 *
 * A ring that moves freely pulls at the hand with its drag, added mass, weight, meniscus and fish;
 * one that walls, floor, bowl or fish hold up pulls with the spring that the hand stretches. The
 * torque about the grip adds where each of them acts. A blow of a tail that catch_tick() gathers in
 * one tick loads the paper, moves the ring and is felt in the next. */
#ifndef KINGYO_CORE_POI_HAPTICS_H
#define KINGYO_CORE_POI_HAPTICS_H

#include "core/output.h"
#include "core/poi/poi.h"

#define POI_GRIP_M 0.130f /* Ring centre to the hand, along the handle. */
#define POI_SLAP_N_FULL 0.15f /* The hardest blow of a 5 cm fish in air. */
#define POI_TEAR_CELLS_FULL 10.0f

/* After poi_give_way(): the reaction on the hand, within the bounds that output.h gives. */
void haptics_feel(const struct poi *poi, struct poi_force *force);

#endif
