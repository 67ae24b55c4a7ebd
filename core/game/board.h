/* board.h -- the wall with the best names on it: after a round with who was ranked, and by turns
 * while nobody plays. */
#ifndef KINGYO_CORE_GAME_BOARD_H
#define KINGYO_CORE_GAME_BOARD_H

#include <stdint.h>

#include "core/game/ranking.h"
#include "core/input.h"
#include "core/output.h"
#include "core/scene.h"

#define BOARD_TICKS (9u * CORE_TICK_HZ)        /* Ten rows are read in so long; ... */
#define BOARD_EVERY_TICKS (30u * CORE_TICK_HZ) /* ... so often in attract, which shows the tank. */

/* How proud somebody may be: the period in which he stands highest, of two the longer. */
struct board_place {
    uint8_t period; /* enum rank_period */
    uint8_t place;  /* From 1; 0: he stands nowhere. */
};

struct core;

struct board_place board_best_place(const struct ranking *ranking, uint8_t mode, uint32_t round_id,
                                    uint8_t seat);

/* The board of the round that was named last. START or a dip plays on, OK turns it over. */
void board_begin(struct core *core);
void board_tick(struct core *core, const struct input *input, struct output *output);

/* What there is to see of it, in attract too. */
void board_show(const struct core *core, struct scene_board *out);

#endif
