/* reentry.h -- reentry: a fish that comes back into the water, until it is clear of all others.
 *
 * A fish dropped from a poi, floated off it or poured from a bowl may overlap other fish. Meanwhile
 * the fish is GAIT_HELD by FISH_HOLDER_WATER. In this state the fish drifts, is pushed out of other
 * fish, pushes them aside, and swims as soon as it overlaps none. A fish that is not free after
 * 0.13 s makes for the nearest gap. After 0.4 s it is placed into that gap. Reentry therefore ends
 * within half a second, unless nothing within 5 cm is free. */
#ifndef KINGYO_CORE_TANK_COLLISION_REENTRY_H
#define KINGYO_CORE_TANK_COLLISION_REENTRY_H

#include "core/tank/tank.h"

/* Releases a fish into the water at its place, inside the walls, under the surface and level, with
 * the rest of its speed. Once clear, it bursts away if its alarm is high; otherwise it swims. */
void reentry_begin(struct tank *tank, struct fish *fish, vec3 velocity_m_s);

/* Advances all fish in reentry by one tick, after the contact solver has run. */
void reentry_tick(struct tank *tank, const struct obstacle *obstacles, uint32_t obstacle_count);

#endif
