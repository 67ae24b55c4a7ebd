/* controller.h -- the sources of the pois' poses: a person's controller, the bot, or none. Computes
 * the target pose of each poi from the pose of its source. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/game/game.h"
#include "core/poi/catch/catch.h"
#include "core/poi/poi.h"

/* Returns true if the poi is in use. A poi is in use if it has a bowl and a source; a lost
 * controller counts as a source. */
bool controller_is_active(const struct world *world, uint32_t index);

/* Returns true if a poi in use has lost its controller. A controller is lost while it is
 * disconnected or its input is invalid. The poi then moves out of the water, takes no damage, and
 * waits. */
bool controller_is_lost(const struct world *world, uint32_t index);

/* Returns the player whose poi moves down through RULES_DIP_Y_M in this tick, or POI_MAX if no poi
 * does. Such a dip is a request to play. Only a poi with a bowl and a connected controller
 * counts. */
uint32_t controller_dipped_player(const struct game *game, const struct world *world,
                                  const struct input *input);

/* Writes the source of each poi in the current phase to `world`. In attract mode the built-in bot
 * controls the first poi, even if controllers are connected, and no other poi is in use. */
void controller_assign(const struct game *game, struct world *world, const struct input *input);

/* Moves each poi's target pose toward the pose of its source. The target stays within arm's reach,
 * and above the water while dips are not allowed. After a change of the source, the old and the new
 * pose are blended. An input loss moves the poi out of the water, and restored input moves the poi
 * gently back. A motion too fast for an arm or wrist is ignored for a fifteenth of a second if the
 * motion could damage paper or lose a fish. */
void controller_tick_all(struct control control[POI_MAX], struct bot bot[POI_MAX],
                         const struct game *game, struct world *world,
                         const struct core_config *config, const struct input *input,
                         struct poi_target targets[POI_MAX], uint8_t live[POI_MAX]);

/* Cancels the slow motion of a poi back to the pose of its controller after an input loss. Call
 * when the poi has a new source or a new position. */
void controller_forget_path(struct control *control);

/* ---- Failsafe motion after an input loss ----------------------------------------------------- */

/* Failsafe motion: moves a poi without valid input out of the water, and later back to the
 * controller's pose.
 *
 * Both motions are slow enough that wet paper of any grade survives them, even broadside. During
 * both motions `damage_immune` of the poi is 1, so that a broken cable never damages a player's
 * paper. */

/* Height at which a poi waits for valid input. At this height the poi's lowest edge is above the
 * water. */
#define FAILSAFE_HOVER_M 0.060f
/* Shortest duration of a poi's return to the controller's pose, 0.4 s. */
#define FAILSAFE_RETURN_TICKS_MIN 48u
/* Longest time for which the paper cannot be damaged during one return to the controller's pose, 3
 * s. After that time the poi moves faster, because the controller may keep moving away. */
#define FAILSAFE_IMMUNITY_TICKS_MAX 360u

/* Returns the target pose for the first tick after an input loss. The target is the ring's actual
 * position, independent of the last input. */
struct poi_target controller_failsafe_begin(const struct poi *poi, struct poi_target hand);

/* Failsafe motion of a poi without input: returns the next target pose. `hand` is the current
 * target pose. A moving poi first decelerates to rest. A poi with fish turns level and rises
 * straight up. A poi without fish tilts and leaves the water along its own plane, toward the middle
 * of the tank. */
struct poi_target controller_failsafe_withdraw(const struct poi *poi, struct poi_target hand);

/* Returns the next target pose of a poi that returns to the controller's pose `wanted`. `hand` is
 * the poi's current target pose, and `ticks` is the time since the start of the return. */
struct poi_target controller_failsafe_return(struct poi_target hand, struct poi_target wanted,
                                             uint32_t ticks);

/* Returns true if the return of the poi is complete: `ticks` is at least FAILSAFE_RETURN_TICKS_MIN,
 * and the poi's target pose `hand` is near the controller's pose `wanted`. The caller then lets the
 * poi follow the controller again. */
bool controller_failsafe_is_returned(struct poi_target hand, struct poi_target wanted,
                                     uint32_t ticks);

/* ---- Parking of unused pois ------------------------------------------------------------------ */

/* Parking: moves an unused poi to a rest position on the tank's rim, beside its own bowl.
 *
 * The pois of players who are out are parked, and so are the bot's pois between games. A parked poi
 * takes no damage, its shadow fades, and fish on the poi fall. Once out of the water, a parked poi
 * is no obstacle. When a controller uses the poi again, the poi starts from its rest position. */

/* Delay of one second between the end of a player's round and parking. In this second the player
 * can see why the round ended. */
#define PARKING_LINGER_TICKS 120u

/* Returns the rest position of player `index`. The position is on the open tank's rim beside the
 * player's bowl, and the handle points toward the player. The poi is completely visible there. Each
 * player has a different rest position. */
struct poi_target parking_place(const struct world *world, uint32_t index);

/* Counts in `control` the ticks for which player `index` has not used the poi. Returns true if the
 * poi is now parked. */
bool parking_tick(struct control *control, const struct game *game, const struct world *world,
                  uint32_t index);

/* Returns true if the poi is parked. No controller moves a parked poi. */
bool parking_is_parked(const struct game *game, uint32_t index);

/* Returns the next target pose of a parked poi; `hand` is its current target pose. The path leads
 * up out of the water, over all rims, and down to the rest position. */
struct poi_target parking_path(const struct game *game, const struct world *world, uint32_t index,
                               struct poi_target hand);

/* parking_collides() returns true while poi `index` is an obstacle for fish and for other pois.
 * parking_shade() returns the opacity of the poi's shadow, from 1 (complete) to 0 (faded). */
bool parking_collides(const struct game *game, const struct world *world, uint32_t index);
float parking_shade(const struct game *game, uint32_t index);

/* ---- Release of fish from pois that disappear ------------------------------------------------ */

/* Releases fish: fish on a poi that disappears fall into the water or a bowl.
 *
 * A poi disappears when its controller is removed during a round, and when the poi is replaced. */

/* Releases every fish on the poi. Each fish falls with its current velocity, limited to the
 * velocity of a calm arm. */
void parking_release_all(struct poi *poi, const struct tank *tank);

/* Advances the released fish of an unused poi by one tick. Call instead of catch_tick(). Every fish
 * soon reaches the water or a bowl. Fish that land in a bowl are added to `results`. */
void parking_release_tick(struct poi *poi, uint32_t poi_index, const struct stall *stall,
                          struct catch_result results[POI_MAX]);
