/* reentry.h -- reentry: the state of a fish that came back into the water, until it overlaps no
 * other fish.
 *
 * A fish that dropped or floated off a poi (the paper scoop), or was poured from a bowl, may
 * overlap other fish. During reentry its gait is GAIT_HELD and its holder FISH_HOLDER_WATER. The
 * fish drifts, is pushed out of other fish and pushes them aside. The fish swims as soon as it
 * overlaps no other fish. After 0.13 s of overlap the fish moves toward the nearest gap, and after
 * 0.4 s it is placed into the gap. Therefore reentry ends within half a second unless no place
 * within 5 cm is free. */
#ifndef KINGYO_CORE_TANK_COLLISION_REENTRY_H
#define KINGYO_CORE_TANK_COLLISION_REENTRY_H

#include "core/tank/tank.h"

/* Begins the reentry of a fish at its present place. Sets the fish's pitch and roll to 0, keeps the
 * fish within the walls, and sets its velocity to `velocity_m_s`, limited to 0.5 m/s. At the end of
 * reentry the fish bursts away if its alarm is high; otherwise it swims. */
void reentry_begin(struct tank *tank, struct fish *fish, vec3 velocity_m_s);

/* Advances all fish in reentry by one tick; called after the contact solver. */
void reentry_tick(struct tank *tank, const struct obstacle *obstacles, uint32_t obstacle_count);

#endif
