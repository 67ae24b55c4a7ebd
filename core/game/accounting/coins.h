/* coins.h -- conversion of coin pulses to units, and of units to credits.
 *
 * Internal to core/game. Each coin is logged in the ledger at once, or as soon as the ledger has
 * room. Before that the coin is counted here and in purse.untold. */
#ifndef KINGYO_CORE_GAME_ACCOUNTING_COINS_H
#define KINGYO_CORE_GAME_ACCOUNTING_COINS_H

#include <stdint.h>

#include "core/input.h"
#include "core/output.h"

struct game;
struct accounts;
struct ledger;
struct core_config;
struct settings;

/* Adds the pulses of each coin line, with the value per pulse from the settings. */
void coins_insert(struct accounts *accounts, const struct core_config *config, uint32_t tick,
                  const struct input *input, struct output *output);

/* Logs coins inserted in the operator's menu: the meter counts them, but the balance does not
 * change. */
void coins_test(struct accounts *accounts, uint32_t tick, const struct input *input,
                struct output *output);

/* Adds the units that were not logged before the last power cut to the balance. */
void coins_convert_pending(struct ledger *ledger, const struct core_config *config);

/* Logs pending coins, and converts units to credits while the balance has fewer than
 * SET_CREDIT_MAX. Bonus credits may exceed that limit. */
void coins_convert(struct accounts *accounts, const struct core_config *config, uint32_t tick,
                   struct output *output);

/* Expires credits and units after SET_CREDIT_EXPIRY_MIN without activity. Expiry happens only in
 * attract mode and only when nothing is waiting to be written. */
void coins_expire(struct game *game, const struct settings *settings, struct output *output);

#endif
