/* failsafe.h -- failsafe motion: moves a poi without valid input out of the water, and later back
 * to the controller's pose.
 *
 * Both motions are slow enough that wet paper of any grade survives them, even broadside. During
 * both motions `damage_immune` of the poi is 1, so that a broken cable never damages a player's
 * paper. */
#ifndef KINGYO_CORE_GAME_CONTROL_FAILSAFE_H
#define KINGYO_CORE_GAME_CONTROL_FAILSAFE_H

#include "core/poi/poi.h"

/* Height at which the poi waits. At this height the poi's lowest edge is above the water. */
#define FAILSAFE_HOVER_M 0.060f
/* Shortest duration of the return to the controller's pose, 0.4 s. */
#define FAILSAFE_RETURN_TICKS_MIN 48u
/* Longest damage immunity of one return, 3 s. After that time the poi moves faster, because the
 * controller may keep moving away. */
#define FAILSAFE_IMMUNITY_TICKS_MAX 360u

/* Returns the target pose for the first tick after an input loss. The target is the ring's actual
 * position, independent of the last input. */
struct poi_target failsafe_begin(const struct poi *poi, struct poi_target hand);

/* Returns the next target pose of a poi without input; `hand` is its current target pose. A moving
 * poi first decelerates to rest. A poi with fish turns level and rises straight up. A poi without
 * fish tilts and leaves the water along its own plane, toward the middle of the tank. */
struct poi_target failsafe_withdraw(const struct poi *poi, struct poi_target hand);

/* Returns the next target pose of a poi that returns to the controller's pose `wanted`. `hand` is
 * the poi's current target pose, and `ticks` is the time since the start of the return. */
struct poi_target failsafe_return(struct poi_target hand, struct poi_target wanted, uint32_t ticks);

/* Returns 1 if the return is complete, so the controller's pose becomes the target pose; otherwise
 * 0. */
int failsafe_is_returned(struct poi_target hand, struct poi_target wanted, uint32_t ticks);

#endif
