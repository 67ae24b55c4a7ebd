/* keeper.h -- what the keeper sets up: the tank, a bowl for each player, fresh paper. */
#ifndef KINGYO_CORE_GAME_KEEPER_H
#define KINGYO_CORE_GAME_KEEPER_H

#include <stdint.h>

struct core;
struct core_config;
struct input;
struct poi_target;

/* Which papers a seed is for: those of rounds, those that the bot wears out in attract, and those
 * that are handed out in place of torn ones. */
enum game_series { GAME_SERIES_ROUND = 0, GAME_SERIES_ATTRACT = 1, GAME_SERIES_SPARE = 2 };

/* The seed of the poi that player `index` gets as the `number`th of a series. */
uint32_t game_poi_seed(uint32_t seed, uint32_t index, uint32_t number, enum game_series series);

/* Which modes are offered, a bit (1 << enum game_mode, or CHOICE_LAB) each; and which mode comes
 * first: the festival where only the lab is offered. */
uint8_t keeper_modes(const struct core_config *config);
uint8_t keeper_first_mode(const struct core_config *config);

/* What a mode is played in and with at this stall, by its rules and the stall's own ways. */
uint8_t keeper_preset(const struct core_config *config, uint8_t mode); /* enum tank_preset_id */
uint8_t keeper_grade(const struct core_config *config, uint8_t mode);
uint32_t keeper_round_s(const struct core_config *config, uint8_t mode);

/* The stall's own tank, bowls and pois, as they are at the very start; `core->config` is set. */
void keeper_open(struct core *core);

/* Sees to it that the tank of this preset is open, with the fish and the seats that are asked for:
 * when another one is, its fish are taken out and this one is set up anew, with its own fish, empty
 * bowls, and each hand drawing its poi over from its place on the rim. Draws on the seed and on how
 * many rounds there were. */
void keeper_set_up(struct core *core, uint8_t preset);

/* A new poi in the same place; fish that lay on the old one fall through where it was. Its grade is
 * that of the mode that is played. */
void keeper_hand_out(struct core *core, uint32_t index, uint32_t number, enum game_series series);

/* Every bowl is emptied into the tank. */
void keeper_pour_back(struct core *core);

#endif
