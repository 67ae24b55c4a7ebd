/* table_setup.h -- functions that prepare the table for a game: open the tank, place a bowl for
 * each player, and supply fresh paper. */
#pragma once

#include <stdint.h>

#include "core/game/control/control_state.h"

struct game;
struct world;
struct core_config;

/* Series of paper seeds, one for each use of paper: rounds, the bot in attract mode, and
 * replacements of torn paper. */
enum game_series { GAME_SERIES_ROUND = 0, GAME_SERIES_ATTRACT = 1, GAME_SERIES_SPARE = 2 };

/* Returns the random seed for the paper of a new poi. The poi is number `number` of the series
 * `series` that player `index` receives. `seed` is the seed of the configuration. */
uint32_t game_poi_seed(uint32_t seed, uint32_t index, uint32_t number, enum game_series series);

/* table_setup_modes() returns a bit mask of the modes that players can choose (1 << enum game_mode
 * or 1 << CHOICE_LAB). table_setup_first_mode() returns the first of these modes, or the festival
 * mode if only the lab can be chosen. */
uint8_t table_setup_modes(const struct core_config *config);
uint8_t table_setup_first_mode(const struct core_config *config);

/* table_setup_preset() returns the tank preset (enum tank_preset_id) of `mode`, table_setup_grade()
 * the paper grade, and table_setup_round_s() the round length in seconds. The values come from the
 * mode's rules and the configuration. */
uint8_t table_setup_preset(const struct core_config *config, uint8_t mode);
uint8_t table_setup_grade(const struct core_config *config, uint8_t mode);
uint32_t table_setup_round_s(const struct core_config *config, uint8_t mode);

/* Sets up the configured tank, bowls and pois when the core is initialized. */
void table_setup_open(struct control control[POI_MAX], const struct game *game, struct world *world,
                      const struct core_config *config);

/* Ensures that the tank of `preset` is open with the configured number of fish and players. If a
 * different tank is open, the new tank replaces the open tank, the bowls are empty, and each poi
 * starts from its rest position. The seed of the new fish depends on the configuration and on the
 * number of rounds. */
void table_setup_prepare(struct control control[POI_MAX], const struct game *game,
                         struct world *world, const struct core_config *config, uint8_t preset);

/* Returns the place (enum bowl_place) of the bowl of a player who plays alone, by SET_SIDE.
 * `is_turned` is true on a portrait screen. `dip_m` is the place of the dip that ended attract mode
 * in the player's axes; a zero vector means that there was no dip. A dip in the left third of the
 * tank, as the player sees it, chooses the left side. Under the rules of formats before 10, the
 * bowl is on the right, and before 12, a portrait screen makes no difference. */
uint8_t table_setup_bowl_place(const struct world *world, const struct core_config *config,
                               bool is_turned, vec3 dip_m);

/* Sets the home position of the bowl of a player who plays alone to the chosen place. The mooring
 * then pulls the bowl there in a few seconds. The bowls of several players keep their places. */
void table_setup_moor_bowl(const struct game *game, struct world *world,
                           const struct core_config *config);

/* Replaces the paper of poi `index` while the poi stays in place. Fish on the old paper fall. The
 * new paper has the grade of the current mode. */
void table_setup_replace_poi(const struct game *game, struct world *world,
                             const struct core_config *config, uint32_t index, uint32_t number,
                             enum game_series series);

/* Moves the fish of every bowl back into the tank. */
void table_setup_empty_bowls(struct world *world);
