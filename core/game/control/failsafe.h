/* failsafe.h -- failsafe motion: moves a poi without valid input out of the water, and later back
 * to the controller's pose.
 *
 * Both motions are slow enough that wet paper of any grade survives them, even broadside. The poi
 * is also marked as `damage_immune` (immune to damage), so that a broken cable never damages a
 * player's paper. */
#ifndef KINGYO_CORE_GAME_CONTROL_FAILSAFE_H
#define KINGYO_CORE_GAME_CONTROL_FAILSAFE_H

#include "core/poi/poi.h"

/* Height at which the poi waits: its lowest edge is clear of the water. */
#define FAILSAFE_HOVER_M 0.060f
#define FAILSAFE_RETURN_TICKS_MIN 48u /* Shortest duration of the return, 0.4 s. */
/* Longest damage immunity of one return, 3 s. After that the return speeds up, in case the
 * controller keeps moving away. */
#define FAILSAFE_IMMUNITY_TICKS_MAX 360u

/* Returns the target pose for the first tick after an input loss: at the ring, independent of the
 * last input. */
struct poi_target failsafe_begin(const struct poi *poi, struct poi_target hand);

/* Returns the next target pose of a poi without input, whose target pose is `hand`. A moving poi
 * first coasts to rest. With fish on it the ring turns level and rises straight up. Without fish it
 * tilts and leaves the water along its own plane, toward the middle of the tank. */
struct poi_target failsafe_withdraw(const struct poi *poi, struct poi_target hand);

/* Returns the next target pose of a poi that returns to the controller's pose `wanted`, `ticks`
 * after the start of the return. */
struct poi_target failsafe_return(struct poi_target hand, struct poi_target wanted, uint32_t ticks);

/* Returns 1 if the return is complete, so that the controller takes over. */
int failsafe_is_returned(struct poi_target hand, struct poi_target wanted, uint32_t ticks);

#endif
