/* parking.h -- parking: moves an unused poi to a rest position on the tank's rim, beside its own
 * bowl.
 *
 * The pois of players who are out are parked, and so are the bot's pois between games. A parked poi
 * takes no damage, its shadow fades, and fish on the poi fall. Once out of the water, a parked poi
 * is no obstacle. When a controller uses the poi again, the poi starts from its rest position. */
#ifndef KINGYO_CORE_GAME_CONTROL_PARKING_H
#define KINGYO_CORE_GAME_CONTROL_PARKING_H

#include "core/input.h"

struct game;
struct world;

/* Delay of one second between the end of a player's round and parking, so that the player sees the
 * reason. */
#define PARKING_LINGER_TICKS 120u

/* Returns the rest position of player `index`. The position is on the open tank's rim beside the
 * player's bowl, and the handle points toward the player. The poi is completely visible there. Each
 * player has a different rest position. */
struct poi_target parking_place(const struct world *world, uint32_t index);

/* Counts the ticks for which player `index` has not used the poi. Returns 1 if the poi is now
 * parked, otherwise 0. */
int parking_tick(struct game *game, const struct world *world, uint32_t index);

/* Returns 1 if the poi is parked, so no controller moves it; otherwise 0. */
int parking_is_parked(const struct game *game, uint32_t index);

/* Returns the next target pose of a parked poi; `hand` is its current target pose. The path leads
 * up out of the water, over all rims, and down to the rest position. */
struct poi_target parking_path(const struct game *game, const struct world *world, uint32_t index,
                               struct poi_target hand);

/* parking_collides() returns 1 while fish and other pois collide with poi `index`, otherwise 0.
 * parking_shade() returns the remaining share of the poi's shadow, [0, 1]. */
int parking_collides(const struct game *game, const struct world *world, uint32_t index);
float parking_shade(const struct game *game, uint32_t index);

#endif
