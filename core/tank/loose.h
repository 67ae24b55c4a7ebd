/* loose.h -- a fish that comes back into the water, until it is clear of all that is there.
 *
 * Dropped from a poi, floated off it or poured from a bowl it may come down where others are. It is
 * GAIT_HELD by FISH_HOLDER_WATER then: it drifts, is pushed off whom it is in, asks them to make
 * room, and swims as soon as nobody is in it. Whom that does not free in 0.13 s makes for the
 * nearest gap, and after 0.4 s it is put there: nobody stays loose for half a second, unless
 * nothing within 5 cm is free. */
#ifndef KINGYO_CORE_TANK_LOOSE_H
#define KINGYO_CORE_TANK_LOOSE_H

#include "core/tank/tank.h"

/* Hands a fish to the water where it is, inside the walls and under the surface, level, with what
 * is left of its speed. Once it is clear it bursts away when its alarm is high, else it swims. */
void loose_begin(struct tank *tank, struct fish *fish, vec3 velocity_m_s);

/* One tick of all that are loose, after the others have parted. */
void loose_tick(struct tank *tank, const struct obstacle *obstacles, uint32_t obstacle_count);

#endif
