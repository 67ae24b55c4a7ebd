/* table_setup.h -- table setup: the tank, a bowl for each player, and fresh paper. */
#ifndef KINGYO_CORE_GAME_TABLE_SETUP_H
#define KINGYO_CORE_GAME_TABLE_SETUP_H

#include <stdint.h>

struct game;
struct world;
struct core_config;
struct input;
struct poi_target;

/* Series of paper seeds: for rounds, for the bot in attract mode, and for replacements of torn
 * paper. */
enum game_series { GAME_SERIES_ROUND = 0, GAME_SERIES_ATTRACT = 1, GAME_SERIES_SPARE = 2 };

/* Returns the seed of the poi that player `index` receives as number `number` of a series. */
uint32_t game_poi_seed(uint32_t seed, uint32_t index, uint32_t number, enum game_series series);

/* Return the modes on offer (one bit each, 1 << enum game_mode or 1 << CHOICE_LAB), and the first
 * of these modes. The first mode is the festival if only the lab is on offer. */
uint8_t table_setup_modes(const struct core_config *config);
uint8_t table_setup_first_mode(const struct core_config *config);

/* Return the tank, paper grade and round length of a mode, from its rules and the configuration. */
uint8_t table_setup_preset(const struct core_config *config,
                           uint8_t mode); /* enum tank_preset_id */
uint8_t table_setup_grade(const struct core_config *config, uint8_t mode);
uint32_t table_setup_round_s(const struct core_config *config, uint8_t mode);

/* Sets up the configured tank, bowls and pois at the start of a session. */
void table_setup_open(struct game *game, struct world *world, const struct core_config *config);

/* Ensures that the tank of `preset` is open with the configured fish and slots. If a different tank
 * is open, the tank is replaced, with new fish and empty bowls, and each poi starts from its rest
 * position. The seed depends on the configuration and on the number of rounds. */
void table_setup_prepare(struct game *game, struct world *world, const struct core_config *config,
                         uint8_t preset);

/* Replaces the paper of a poi in place. Fish on the old paper fall. The grade is that of the
 * current mode. */
void table_setup_replace_poi(const struct game *game, struct world *world,
                             const struct core_config *config, uint32_t index, uint32_t number,
                             enum game_series series);

/* Empties every bowl into the tank. */
void table_setup_empty_bowls(struct world *world);

#endif
