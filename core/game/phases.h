/* phases.h -- the phases attract, choose, ready, round, result and album: the functions that begin
 * each phase and run its tick. The phases between result and album have headers of their own,
 * name.h and leaderboard.h.
 *
 * Internal to core/game. game.c calls the tick of the current phase, and a phase begins the next
 * one. A new phase has its first tick in the following tick. */
#ifndef KINGYO_CORE_GAME_PHASES_H
#define KINGYO_CORE_GAME_PHASES_H

#include "core/input.h"
#include "core/output.h"

struct game;
struct world;
struct core_config;

/* Switches to `phase` (enum scene_phase). */
void game_enter_phase(struct game *game, uint8_t phase);

/* Returns the player whose live poi with a bowl moves down through GAME_DIP_Y_M in this tick, or
 * POI_MAX if none does. Such a dip is a request to play. */
uint32_t game_dipped_player(const struct game *game, const struct world *world,
                            const struct input *input);

/* Attract mode: the configured tank, played by the bot. */
void attract_begin(struct game *game, struct world *world, const struct core_config *config);
void attract_tick(struct game *game, struct world *world, const struct core_config *config,
                  const struct input *input, struct output *output);

/* Handles a request to play. Without a credit the state stays unchanged. With several modes on
 * offer the selection starts; otherwise READY starts at once. */
void mode_select_begin(struct game *game, struct world *world, const struct core_config *config,
                       struct output *output);
void mode_select_tick(struct game *game, struct world *world, const struct core_config *config,
                      const struct input *input, struct output *output);

/* Starts a new round of the selected mode, with its tank, empty bowls and zero scores. */
void ready_begin(struct game *game, struct world *world, const struct core_config *config,
                 struct output *output);
void ready_tick(struct game *game, struct world *world, const struct core_config *config,
                struct output *output);

/* Start the clock of a round after READY, and run one tick of the round. */
void round_begin(struct game *game, struct world *world, struct output *output);
void round_tick(struct game *game, struct world *world, const struct core_config *config,
                struct output *output);

/* Ends the round: its result is logged and shown. */
void result_begin(struct game *game, struct world *world, const struct core_config *config,
                  struct output *output);
/* Ends a round that counts without showing its result, because the operator's menu opens. */
void result_skip(struct game *game, const struct world *world, const struct core_config *config,
                 struct output *output);
void result_tick(struct game *game, struct world *world, const struct core_config *config,
                 const struct input *input, struct output *output);

#endif
