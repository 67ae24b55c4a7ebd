/* parking.h -- parking: an unused poi moves to a rest position on the tank's rim, beside its own
 * bowl.
 *
 * The pois of players who are out are parked, and so are the bot's pois between games. A parked poi
 * takes no damage, its shadow fades, and fish on it fall. Out of the water a parked poi is no
 * obstacle. The next controller takes the poi over from its rest position. */
#ifndef KINGYO_CORE_GAME_CONTROL_PARKING_H
#define KINGYO_CORE_GAME_CONTROL_PARKING_H

#include "core/input.h"

struct game;
struct world;

/* Delay of one second before parking when a player is out, so that the player sees the reason. */
#define PARKING_LINGER_TICKS 120u

/* Returns the rest position of player `index`: on the open tank's rim beside the player's bowl,
 * with the handle toward the player. The position is completely visible, and different for each
 * player. */
struct poi_target parking_place(const struct world *world, uint32_t index);

/* Counts the ticks for which player `index` has not used the poi. Returns 1 if the poi is parked
 * now. */
int parking_tick(struct game *game, const struct world *world, uint32_t index);

/* Returns 1 if the poi is parked, so that no controller moves it. */
int parking_is_parked(const struct game *game, uint32_t index);

/* Returns the next target pose of a parked poi, whose target pose is `hand`. The path leads up out
 * of the water, over all rims, and down to the rest position. */
struct poi_target parking_path(const struct game *game, const struct world *world, uint32_t index,
                               struct poi_target hand);

/* Return 1 if fish and other pois still collide with the poi, and the share of its shadow that is
 * left, [0, 1]. */
int parking_collides(const struct game *game, const struct world *world, uint32_t index);
float parking_shade(const struct game *game, uint32_t index);

#endif
