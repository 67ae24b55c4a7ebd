/* haptics.h -- the force on the hand that holds the poi, from the same physics that moves the ring.
 *
 * A freely moving ring pulls at the hand with its drag, added mass, weight, meniscus and fish. A
 * ring blocked by walls, floor, bowl or fish pulls with the stretched hand spring. The torque about
 * the grip adds the point of action of each force. A slap gathered by catch_tick() in one tick
 * loads the paper, moves the ring and acts on the hand in the next tick. */
#ifndef KINGYO_CORE_POI_HAPTICS_H
#define KINGYO_CORE_POI_HAPTICS_H

#include "core/output.h"
#include "core/poi/poi.h"

#define POI_GRIP_M 0.130f     /* Distance from the ring's centre to the hand, along the handle. */
#define POI_SLAP_N_FULL 0.15f /* The hardest slap of a 5 cm fish in air. */
#define POI_TEAR_CELLS_FULL 10.0f

/* Writes the reaction on the hand, within the limits of output.h. Called after
 * poi_apply_reaction(). */
void haptics_feel(const struct poi *poi, struct poi_force *force);

#endif
