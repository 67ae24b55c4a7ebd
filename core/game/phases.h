/* phases.h -- attract, choose, ready, round, result, album: how each begins, and what a tick of it
 * does. name.h and board.h, between result and album, say so themselves.
 *
 * Within core/game only: game.c asks for the phase's tick, and a phase begins the next one. What
 * is begun in a tick has its first own tick in the next. */
#ifndef KINGYO_CORE_GAME_PHASES_H
#define KINGYO_CORE_GAME_PHASES_H

#include "core/input.h"
#include "core/output.h"

struct core;

/* From now on it is `phase` (enum scene_phase). */
void phase_enter(struct core *core, uint8_t phase);

/* Who wants to play, dips: a live poi with a bowl goes down through GAME_DIP_Y_M in this tick.
 * Returns its player's index, or POI_MAX when none does. */
uint32_t phase_dipped(const struct core *core, const struct input *input);

/* The stall's own tank, played in by its bot. */
void attract_begin(struct core *core);
void attract_tick(struct core *core, const struct input *input, struct output *output);

/* Somebody wants to play. Nobody has paid: all stays as it is. Else, where several modes are
 * offered, which? Where there is nothing to choose it is READY at once. */
void choose_begin(struct core *core, struct output *output);
void choose_tick(struct core *core, const struct input *input, struct output *output);

/* A new round of the mode pointed at: its tank, empty bowls, nobody has caught anything. */
void ready_begin(struct core *core, struct output *output);
void ready_tick(struct core *core, struct output *output);

void round_begin(struct core *core, struct output *output);
void round_tick(struct core *core, struct output *output);

/* The round is over: it is weighed and told. */
void result_begin(struct core *core, struct output *output);
/* Ends a round that counts without showing its result: the operator's menu opens. */
void result_skip(struct core *core, struct output *output);
void result_tick(struct core *core, const struct input *input, struct output *output);

#endif
