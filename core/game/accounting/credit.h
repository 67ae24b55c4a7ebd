/* credit.h -- payment: units become credits, and one credit buys one round at the tank.
 *
 * A credit pays for every player with a poi. The credit is taken when the selected round starts,
 * not when START is pressed, so leaving the mode selection is free. The credit is refunded if the
 * round ends because all controllers were lost, because the operator opened the menu, or because
 * the kiosk stopped. A refunded round wins no tickets and produces no score and no record.
 *
 * After two thirds of a round the credit is not refunded, and a refunded credit is not refunded a
 * second time. A round that is not refunded keeps its score and its tickets
 * (round_standing.c). A refunded credit is used before all other credits. One
 * flag in the balance therefore identifies the refunded credit, even after a power cut.
 *
 * The balance is stored in the ledger (core/ledger.h) and survives a power cut. A credit that is
 * not on disk yet is displayed but cannot be played. While the ledger cannot be written, the coin
 * slot is closed. Coins that are inserted into the closed slot are kept in `pending_coins`
 * (coins.c). */
#ifndef KINGYO_CORE_GAME_ACCOUNTING_CREDIT_H
#define KINGYO_CORE_GAME_ACCOUNTING_CREDIT_H

#include <stdint.h>

#include "core/game/accounting/accounts.h"
#include "core/output.h"
#include "core/scene.h"

struct game;
struct world;
struct core_config;
struct settings;

/* Handles coins, SERVICE, TILT and DOOR. Call before the tick function of the phase. In the
 * operator's menu a coin is a test, and TILT and SERVICE do not change the balance. */
void credit_tick(struct game *game, const struct world *world, const struct core_config *config,
                 const struct input *input, struct output *output);

/* Returns 1 if a round may start, because play is free or a credit on disk pays for the round;
 * otherwise 0. */
int credit_can_play(const struct ledger *ledger, const struct core_config *config);

/* Returns the number of credits that are not on disk yet. */
uint32_t credit_coming(const struct ledger *ledger);

/* Handles a start attempt without a playable credit. If a credit is not on disk yet, the attempt
 * waits for the credit (credit_is_awaited()). Otherwise the screen briefly highlights the request
 * for a coin. */
void credit_ask(struct accounts *accounts, uint32_t tick, struct output *output);

/* Returns 1 if a start attempt that waited for its credit can now start a game, otherwise 0. */
int credit_is_awaited(const struct accounts *accounts, const struct core_config *config,
                      uint32_t tick);

/* Takes one credit for the game `what` (enum game_mode, or CHOICE_LAB), which starts in this tick.
 * The caller must check credit_can_play() before. */
void credit_take(struct game *game, const struct core_config *config, uint8_t what,
                 struct output *output);

/* Ends the running round early. The credit is refunded if one was taken and
 * round_standing_is_spent() is 0. Otherwise `balance.open` stays set, and the caller must close the
 * round. A free round in which all controllers were lost counts as a normal round. */
void credit_refund(struct game *game, const struct core_config *config, enum refund_cause cause,
                   struct output *output);

/* Returns the number of tickets that the round has won so far, computed from each player's catch.
 * Returns 0 if the bot played. */
uint32_t credit_tickets_won(const struct game *game, const struct core_config *config);

/* Adds the tickets of a finished round that was not refunded to the balance. Returns the number of
 * tickets. */
uint32_t credit_award_tickets(struct game *game, const struct core_config *config);

/* Fills `out` with the visible state of the credits. */
void credit_show(const struct accounts *accounts, const struct core_config *config, uint32_t tick,
                 struct scene_credit *out);

uint64_t credit_hash(uint64_t hash, const struct credit *credit);

/* ---- Coins ----------------------------------------------------------------------------------- */

/* Converts coin pulses to units, and units to credits.
 *
 * Internal to core/game. Each coin is logged in the ledger immediately, or as soon as the ledger
 * has room. Until then the coin is counted in credit.pending_coins and in balance.unlogged. */

/* Adds the pulses of each coin line to the account, and logs the pulses. The settings contain the
 * value of a pulse. */
void coins_insert(struct accounts *accounts, const struct core_config *config, uint32_t tick,
                  const struct input *input, struct output *output);

/* Logs coins inserted in the operator's menu. The coin meter counts the coins, but the balance does
 * not change. */
void coins_test(struct accounts *accounts, uint32_t tick, const struct input *input,
                struct output *output);

/* Adds units that were not logged before the last power cut (`balance.unlogged`) to the balance. */
void coins_convert_pending(struct ledger *ledger, const struct core_config *config);

/* Logs pending coins, and converts units to credits while the balance has fewer than SET_CREDIT_MAX
 * credits. Bonus credits may exceed that limit. */
void coins_convert(struct accounts *accounts, const struct core_config *config, uint32_t tick,
                   struct output *output);

/* Removes credits and units after SET_CREDIT_EXPIRY_MIN without activity. Credits expire only in
 * attract mode and only when the ledger has no entry that is not on disk. */
void coins_expire(struct game *game, const struct settings *settings, struct output *output);

/* ---- Tickets --------------------------------------------------------------------------------- */

/* Outputs owed tickets to the dispenser, one at a time. Each ticket is logged on disk first.
 *
 * A ticket has a value, so owed and dispensed tickets must survive a power cut. The balance in a
 * round's LEDGER_ROUND contains the round's tickets. The first ticket starts when that entry is on
 * disk. Each ticket has a LEDGER_TICKET that removes the ticket from the balance. The dispenser's
 * pulse starts when the LEDGER_TICKET is on disk. The entry of the next ticket waits until the
 * pulse has ended. After a power cut the balance therefore contains every ticket whose
 * LEDGER_TICKET is not on disk. An interrupted ticket counts as dispensed, because the dispenser
 * has no sensor. At most one ticket is lost, and no ticket is dispensed twice.
 *
 * Other outputs and power cuts:
 * - The credit of a round has a value too. A credit can be played only when it is on disk
 * (ledger_committed_credits()), and is refunded at most once (round_standing.c).
 * - The pulses of the coin meter have no value for a player. Each coin is counted once, and never
 * again after a restart. A power cut may lose unfinished pulses of the meter.
 * - The coin slot opens only while an entry will soon be on disk (ledger_is_safe()).
 * - The START lamp, sounds and the forces in the poi have no value. */

/* Adds `count` tickets to the balance, up to BALANCE_TICKETS_MAX. The caller writes the entry that
 * contains the balance. In a recording of format 7 all pulses are requested immediately instead. */
void credit_owe_tickets(struct accounts *accounts, const struct core_config *config,
                        uint32_t count);

/* ---- State of an open round ------------------------------------------------------------------ */

/* Logs the state of an open round whose credit is not refundable any more.
 *
 * The credit is not refundable after two thirds of a round, or if the round was paid with a
 * refunded credit. The round then counts, and a power cut must not remove its score or its
 * tickets. Each change of the score or the tickets is therefore logged while the round runs
 * (LEDGER_STAND). After a power cut, the next start writes the missing LEDGER_ROUND. Changes are
 * missing from that LEDGER_ROUND if the store was still writing an earlier entry when they
 * occurred. */

/* Fraction of the round after which its credit is not refundable. */
#define STAND_SHARE_NUMERATOR 2u
#define STAND_SHARE_DENOMINATOR 3u

/* Returns 1 if the credit of the running round is not refundable, otherwise 0. In recordings of
 * format 7 every credit is refundable. */
int round_standing_is_spent(const struct game *game, const struct core_config *config);

/* Logs the state of the round if it changed, the previous entry is on disk, and the ledger has
 * room. Call once per tick of the round. */
void round_standing_tick(struct game *game, const struct core_config *config,
                         struct output *output);

/* Finishes a round that was open at startup and whose credit is not refundable. Writes the round's
 * LEDGER_ROUND from config->persistent.ledger.stand and closes the balance. Returns 1, or 0 without
 * an entry if no player had joined the round. */
int round_standing_finish(struct accounts *accounts, const struct core_config *config,
                          uint32_t tick, struct output *output);

#endif
