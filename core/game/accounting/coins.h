/* coins.h -- converts coin pulses to units, and units to credits.
 *
 * Internal to core/game. Each coin is logged in the ledger immediately, or as soon as the ledger
 * has room. Until then the coin is counted in credit.pending_coins and in balance.unlogged. */
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

/* Adds the pulses of each coin line to the account, and logs the pulses. The settings contain the
 * value of a pulse. */
void coins_insert(struct accounts *accounts, const struct core_config *config, uint32_t tick,
                  const struct input *input, struct output *output);

/* Logs coins inserted in the operator's menu. The coin meter counts the coins, but the balance does
 * not change. */
void coins_test(struct accounts *accounts, uint32_t tick, const struct input *input,
                struct output *output);

/* Adds units to the balance that were not logged before the last power cut (`unlogged`). */
void coins_convert_pending(struct ledger *ledger, const struct core_config *config);

/* Logs pending coins, and converts units to credits while the balance has fewer than SET_CREDIT_MAX
 * credits. Bonus credits may exceed that limit. */
void coins_convert(struct accounts *accounts, const struct core_config *config, uint32_t tick,
                   struct output *output);

/* Removes credits and units after SET_CREDIT_EXPIRY_MIN without activity. Credits expire only in
 * attract mode and only when the ledger has no entry that is not on disk. */
void coins_expire(struct game *game, const struct settings *settings, struct output *output);

#endif
