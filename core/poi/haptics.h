/* haptics.h -- computes the force feedback: the force and the torque on the hand that holds the poi
 * (the paper scoop).
 *
 * The force comes from the same physics that moves the ring. A freely moving ring pulls at the hand
 * with its drag, added mass, weight, meniscus force and fish. If walls, floor, a bowl or fish block
 * the ring, the stretched hand spring pulls at the hand. The torque about the grip depends on the
 * point at which each force acts. catch_tick() collects the slaps of the fish in one tick. In the
 * next tick, each slap loads the paper, moves the ring and acts on the hand. */
#ifndef KINGYO_CORE_POI_HAPTICS_H
#define KINGYO_CORE_POI_HAPTICS_H

#include "core/output.h"
#include "core/poi/poi.h"

#define POI_GRIP_M 0.130f /* Distance from the ring's centre to the grip, along the handle. */
/* Slap force at which the slap feedback has its full strength. The value is the force of the
 * strongest slap of a 5 cm fish in air. */
#define POI_SLAP_N_FULL 0.15f
#define POI_TEAR_CELLS_FULL 10.0f

/* Writes the force feedback of this tick to `force`, limited to the ranges in output.h. The caller
 * must have called poi_apply_reaction() in this tick. */
void haptics_feel(const struct poi *poi, struct poi_force *force);

#endif
