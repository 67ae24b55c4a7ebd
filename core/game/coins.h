/* coins.h -- from pulses of coin lines to units, and from units to credits.
 *
 * Within core/game only. What falls is written down at once, or as soon as there is room for an
 * entry; until then it waits here and in purse.untold. */
#ifndef KINGYO_CORE_GAME_COINS_H
#define KINGYO_CORE_GAME_COINS_H

#include <stdint.h>

#include "core/input.h"
#include "core/output.h"

struct core;

/* Pulses of each line, each worth what the settings say. */
void coins_fall(struct core *core, const struct input *input, struct output *output);

/* The same in the operator's menu: metered, and nobody's money. */
void coins_test(struct core *core, const struct input *input, struct output *output);

/* Moves the units of coins that no entry reported before the last power cut into the purse. */
void coins_fold_untold(struct core *core);

/* Writes down what waits, and makes credits of units while there are fewer than SET_CREDIT_MAX; the
 * bonus comes on top of that. */
void coins_settle(struct core *core, struct output *output);

/* Credits and units that nobody touched for SET_CREDIT_EXPIRY_MIN lapse, in attract alone and never
 * while anything waits to be written. */
void coins_expire(struct core *core, struct output *output);

#endif
