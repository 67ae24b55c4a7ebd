/* phases.h -- the functions that begin the phases attract, mode selection, ready, round and result,
 * and run their ticks. The phases after the result have headers of their own: album.h, name.h and
 * leaderboard.h.
 *
 * Internal to core/game. game.c calls the tick function of the current phase, and a phase begins
 * the next phase. A new phase has its first tick in the following tick. */
#ifndef KINGYO_CORE_GAME_PHASES_H
#define KINGYO_CORE_GAME_PHASES_H

#include "core/input.h"
#include "core/output.h"

struct game;
struct world;
struct core_config;

/* Switches the game to `phase` (enum scene_phase). */
void game_enter_phase(struct game *game, uint8_t phase);

/* Returns the player whose poi moves down through GAME_DIP_Y_M in this tick, or POI_MAX if no poi
 * does. Only a live poi with a bowl counts. A downward crossing is a request to play. */
uint32_t game_dipped_player(const struct game *game, const struct world *world,
                            const struct input *input);

/* Attract mode: begins and runs the demonstration between games, in which the bot plays at the
 * configured tank. */
void attract_begin(struct game *game, struct world *world, const struct core_config *config);
void attract_tick(struct game *game, struct world *world, const struct core_config *config,
                  const struct input *input, struct output *output);

/* Handles a request to play. Without a credit the state stays unchanged. If players can choose
 * between several modes, the mode selection starts; otherwise READY starts immediately. */
void mode_select_begin(struct game *game, struct world *world, const struct core_config *config,
                       struct output *output);
void mode_select_tick(struct game *game, struct world *world, const struct core_config *config,
                      const struct input *input, struct output *output);

/* Starts a new round of the selected mode, with its tank, empty bowls and zero scores. */
void ready_begin(struct game *game, struct world *world, const struct core_config *config,
                 struct output *output);
void ready_tick(struct game *game, struct world *world, const struct core_config *config,
                struct output *output);

/* Begins the round after READY and starts its clock. */
void round_begin(struct game *game, struct world *world, struct output *output);
void round_tick(struct game *game, struct world *world, const struct core_config *config,
                struct output *output);

/* Ends the round, logs its result and shows the result. */
void result_begin(struct game *game, struct world *world, const struct core_config *config,
                  struct output *output);
/* Ends a round whose credit is not refundable, because the operator's menu opens. The result is
 * logged but not shown. */
void result_skip(struct game *game, const struct world *world, const struct core_config *config,
                 struct output *output);
void result_tick(struct game *game, struct world *world, const struct core_config *config,
                 const struct input *input, struct output *output);

#endif
