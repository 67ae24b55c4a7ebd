/* accounts.h -- the kiosk's accounts: the ledger, the credits, the coins, the tickets and the state
 * of an open round.
 *
 * The ledger is the append-only list of money events. ledger_write() also adds each entry to the
 * audits (audits.h), which are the operator's statistics, and to the leaderboards (ranking.h). A
 * function that writes an entry therefore takes `struct accounts`. A function that works on one
 * account takes only that account. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/game/accounting/audits.h"
#include "core/game/ranking/ranking.h"
#include "core/input.h"
#include "core/ledger.h"
#include "core/output.h"
#include "core/scene.h"

struct game;
struct world;
struct core_config;
struct persistent_state;
struct game_session;

/* Longest time for which the core waits for an entry to reach the disk. After this time the store
 * counts as not responding. A working SD card needs a tenth of this time; a broken card never
 * responds. */
#define LEDGER_WAIT_TICKS_MAX (2u * CORE_TICK_HZ)

struct ledger {
    uint32_t last_id;  /* Id of the newest ledger entry. */
    uint32_t saved_id; /* Id of the newest ledger entry that is on disk. */
    uint32_t boot;
    /* Number of entries that were dropped because the ledger had no room for them. Payments are
     * never dropped. */
    uint32_t uncommitted;
    /* Number of ticks for which unsaved entries have waited for the disk since the last entry was
     * saved. */
    uint32_t wait_ticks;
    uint16_t day, minute;
    /* 1 if the store was healthy according to the last input, otherwise 0. */
    uint8_t is_healthy;
    /* 1 if the kiosk started without a store (`boot` 0) and a store became healthy since the start,
     * otherwise 0. */
    uint8_t store_came_late;
    struct balance balance;   /* Current balance. */
    struct balance committed; /* Balance after the newest ledger entry that is on disk. */
    /* Balance after each entry that is not on disk. Entry n uses index n % LEDGER_RING. */
    struct balance after[LEDGER_RING];
};

/* Largest allowed price of a round, in coin units. A more expensive round would be paid with
 * banknotes. */
#define CREDIT_COINS_MAX 20u
/* Largest allowed value of the setting "fish per prize ticket". Most players catch fewer fish, so
 * they would win no ticket at a larger value. */
#define CREDIT_TICKET_FISH_MAX 20u
/* Time for which the coin slot stays closed after the cabinet was shaken or tilted. */
#define CREDIT_TILT_TICKS (3u * CORE_TICK_HZ)
/* Longest time for which a START press waits until the paid credit is on disk. */
#define CREDIT_AWAIT_TICKS (3u * CORE_TICK_HZ)

/* Conditions that close the coin slot and are displayed as warnings. Each condition has one bit. */
enum credit_warning {
    /* The cabinet was shaken or tilted. The balance does not change. Coins are returned, because
     * shaking can trigger the coin mechanism. */
    WARN_TILT = 1u << 0,
    WARN_DOOR = 1u << 1,   /* The door of the cabinet is open. A running round continues. */
    WARN_NO_POI = 1u << 2, /* No slot has a controller, so a player who pays could not play. */
    WARN_STORE = 1u << 3,  /* The store is not safe, so a payment could be lost in a power cut. */
};

/* Coins that no ledger entry contains yet. */
struct pending_coins {
    uint32_t pulses;
    uint32_t units; /* Value of the pending pulses in coin units. */
    /* Units of the pending coins that must be added to the balance. Coins inserted during free play
     * add nothing to `owed`. */
    uint32_t owed;
};

struct credit {
    uint8_t came_back; /* 1 if the credit of the last round was refunded, otherwise 0. */
    uint8_t warnings;  /* Current warnings (bit mask of enum credit_warning). */
    struct pending_coins pending_coins[COIN_LINE_COUNT];
    /* Number of coins that the coin meter has counted since the kiosk started. */
    uint32_t metered;
    /* Number of times that the cabinet was tilted or shaken since the kiosk started. */
    uint32_t shakes;
    /* Number of pulses requested from the ticket dispenser since the kiosk started. */
    uint32_t tickets;
    uint32_t coin_tick; /* Tick at which the last coin was inserted. */
    uint32_t tilt_tick; /* Tick at which the cabinet was last tilted or shaken; 0 means never. */
    /* Tick of the last attempt to start a game without a credit; 0 means never. */
    uint32_t request_tick;
    /* Tick of the last start attempt that had to wait because its credit was not on disk yet; 0
     * means never. */
    uint32_t await_tick;
    uint32_t act_tick; /* Tick of the last action of a person that changed the balance. */
    /* Id of the newest LEDGER_STAND entry (state of an open round); 0 means none. */
    uint32_t stand_id;
    /* Fields of the newest LEDGER_STAND entry (state of an open round). */
    struct ledger_stand stand;
    /* Id of the entry LEDGER_TICKET that must reach the disk before the ticket dispenser gets its
     * pulse; 0 means none. */
    uint32_t ticket_id;
};

struct accounts {
    struct ledger ledger;
    struct credit credit;
    struct audits audits;
    struct ranking ranking;
};

/* ---- Ledger (ledger_writer.c) ---------------------------------------------------------------
 *
 * The core keeps the balance after each entry until the store reports the entry as saved. The core
 * can therefore compute the balance that would remain after a power cut in this tick: the field
 * `committed`. Credits that were added after `committed` cannot be played yet. Credits that were
 * spent after `committed` cannot be played again. */

/* Initializes `ledger` from the state that the store loaded at startup. */
void ledger_init(struct ledger *ledger, const struct ledger_start *start);

/* Reads from `input` which entries the store has saved on disk. Call before any entry of the tick
 * is written. */
void ledger_tick(struct ledger *ledger, const struct core_config *config,
                 const struct input *input);

/* Returns true if the ledger's ring buffer has room for one more entry of kind `kind` (enum
 * ledger_kind). */
bool ledger_has_room(const struct ledger *ledger, uint8_t kind);

/* Returns true if ledger_write() would write an entry of kind `kind` (enum ledger_kind). An entry
 * is written if the ledger's ring buffer has room. A kiosk that has had no store since its start
 * overwrites the oldest entry. */
bool ledger_may_write(const struct ledger *ledger, uint8_t kind);

/* Writes an entry. The function sets id, boot, tick, day, minute and balance; the caller supplies
 * the other fields in `what`. Audits and leaderboards are updated immediately. Returns the id of
 * the entry. If the ledger's ring buffer has no room, counts the dropped entry and returns 0. */
uint32_t ledger_write(struct accounts *accounts, uint32_t tick, const struct ledger_entry *what,
                      struct output *output);

/* Returns true if the entry `id` is on disk. */
bool ledger_is_saved(const struct ledger *ledger, uint32_t id);

/* Returns true if every entry of the ledger is on disk, or if the kiosk has had no store since its
 * start. */
bool ledger_is_flushed(const struct ledger *ledger);

/* Returns true if a payment in this tick will soon be on disk, because the store is healthy,
 * responds, and has room. */
bool ledger_is_safe(const struct ledger *ledger);

/* Returns true if a new entry is necessary to save the current balance, because the balance differs
 * from the balance on disk and no unsaved entry contains it. Such a difference arises if the store
 * became available after the start, or if the ledger had no room when the balance changed. */
bool ledger_needs_sync(const struct ledger *ledger);

/* Numbers of paid credits and of service credits that are on disk and not spent. Only these credits
 * can be played. */
struct ledger_credits {
    uint32_t paid, service;
};
struct ledger_credits ledger_committed_credits(const struct ledger *ledger);

/* ---- Validation of stored records (ledger_writer.c) ------------------------------------------
 *
 * Each field of a stored record must be in the range that this core writes. A checksum proves only
 * that a record is unchanged, not that Kingyo wrote the record. Out-of-range values would index
 * beyond tables or wrap counters. Each reader (database, tail, backup, replay) and core_init()
 * therefore reject out-of-range values. */

/* Returns true if every field of the ledger entry `entry` is in its valid range. */
bool ledger_entry_is_valid(const struct ledger_entry *entry);

/* Returns true if the ids, the balance, the open round and the leaderboards in `memory` are in
 * their valid ranges. Settings are not checked, because settings_sanitize() corrects invalid
 * settings. Any value of an audit counter is allowed. */
bool ledger_state_is_valid(const struct persistent_state *memory);

/* Returns true if every field of `session`, the state that the core carries over when it
 * reinitializes itself, is in its valid range. */
bool ledger_session_is_valid(const struct game_session *session);

/* ---- Coins, buttons and tickets (coins.c) -----------------------------------------------------
 *
 * Coin pulses become units, and units become credits. Each coin is logged in the ledger
 * immediately, or as soon as the ledger has room. Until then the coin is counted in
 * credit.pending_coins and in balance.unlogged. The balance is stored in the ledger and survives a
 * power cut. While the ledger cannot be written, the coin slot is closed.
 *
 * A ticket has a value, so owed and dispensed tickets must survive a power cut. The balance in a
 * round's LEDGER_ROUND contains the round's tickets.
 *
 * The first ticket starts when that entry is on disk. Each ticket has a LEDGER_TICKET that removes
 * the ticket from the balance. The dispenser's pulse starts when the LEDGER_TICKET is on disk. The
 * entry of the next ticket waits until the pulse has ended.
 *
 * After a power cut the balance therefore contains every ticket whose LEDGER_TICKET is not on disk.
 * An interrupted ticket counts as dispensed, because the dispenser has no sensor. At most one
 * ticket is lost, and no ticket is dispensed twice.
 *
 * Other outputs and power cuts:
 * - The credit of a round has a value too. A credit can be played only when it is on disk
 *   (ledger_committed_credits()), and is refunded at most once (round_standing.c).
 * - The pulses of the coin meter have no value for a player. Each coin is counted once, and never
 *   again after a restart. A power cut may lose unfinished pulses of the meter.
 * - The coin slot opens only while an entry will soon be on disk (ledger_is_safe()).
 * - The START lamp, sounds and the forces in the poi have no value. */

/* Handles inserted coins, the inputs SERVICE, TILT and DOOR, and the tickets that the kiosk owes.
 * Call before the tick function of the phase. In the operator's menu a coin is a test, and TILT and
 * SERVICE do not change the balance. */
void coins_tick(struct accounts *accounts, const struct game *game, const struct world *world,
                const struct core_config *config, const struct input *input, struct output *output);

/* Adds coin units that were not logged before the last power cut (`balance.unlogged`) to the
 * balance. In recordings of the older format 7 the units count towards a bonus even if no bonus is
 * configured. */
void coins_convert_pending(struct ledger *ledger, const struct core_config *config);

/* ---- Credits (credit.c) ------------------------------------------------------------------------
 *
 * One credit buys one round at the tank. A credit pays for every player with a poi. The credit is
 * taken when the selected round starts, not when START is pressed, so leaving the mode selection is
 * free. The credit is refunded if the round ends because all controllers were lost, because the
 * operator opened the menu, or because the kiosk stopped. A refunded round wins no tickets and
 * produces no score and no record.
 *
 * After two thirds of a round the credit is not refunded, and a refunded credit is not refunded a
 * second time. A round that is not refunded keeps its score and its tickets (round_standing.c). A
 * refunded credit is used before all other credits. One flag in the balance therefore identifies
 * the refunded credit, even after a power cut. A credit that is not on disk yet is displayed but
 * cannot be played. */

/* Returns true if a round may start, because play is free or a credit on disk pays for the
 * round. */
bool credit_can_play(const struct ledger *ledger, const struct core_config *config);

/* Handles a start attempt without a playable credit. If a credit exists but is not on disk yet, the
 * attempt waits for that credit (credit_is_awaited()). Otherwise the screen briefly highlights the
 * request for a coin. */
void credit_request(struct accounts *accounts, uint32_t tick, struct output *output);

/* Returns true if a start attempt that waited for its credit can now start a game. */
bool credit_is_awaited(const struct accounts *accounts, const struct core_config *config,
                       uint32_t tick);

/* Takes one credit from the balance for the game `what` (enum game_mode, or CHOICE_LAB), which
 * starts in this tick. The caller must check credit_can_play() before. No game may be open. */
void credit_take(struct accounts *accounts, const struct game *game,
                 const struct core_config *config, uint8_t what, struct output *output);

/* Ends the running round early. If round_standing_is_spent() returns false, the function refunds
 * the credit, if one was taken, and closes the round. If round_standing_is_spent() returns true,
 * `balance.open` stays set, and the caller must close the round. `balance.open` also stays set in
 * free play if the round ends because all controllers were lost, because the caller then logs the
 * round with its result. */
void credit_refund(struct accounts *accounts, const struct game *game,
                   const struct core_config *config, enum refund_cause cause,
                   struct output *output);

/* Returns the number of tickets that the round has won so far, computed from each player's catch.
 * Returns 0 if the bot played. */
uint32_t credit_tickets_won(const struct game *game, const struct core_config *config);

/* Adds `count` tickets that the kiosk owes to the balance, up to BALANCE_TICKETS_MAX. Returns the
 * number of added tickets, which the caller writes to the entry that contains the balance. In a
 * recording of the older format 7 all pulses of the dispenser are requested immediately instead. */
uint32_t credit_add_tickets(struct accounts *accounts, const struct core_config *config,
                            uint32_t count);

/* Adds tickets to the balance: the tickets that the players won in a finished round that was not
 * refunded. Returns the number of added tickets, which is lower than the number of won tickets if
 * the balance has reached BALANCE_TICKETS_MAX. */
uint32_t credit_award_tickets(struct accounts *accounts, const struct game *game,
                              const struct core_config *config);

/* Fills `out` with the visible state of the credits. */
void credit_show(const struct accounts *accounts, const struct core_config *config, uint32_t tick,
                 struct scene_credit *out);

/* ---- State of an open round (round_standing.c) -------------------------------------------------
 *
 * Logs the state of an open round whose credit is not refundable any more.
 *
 * The credit is not refundable after two thirds of a round, or if the round was paid with a
 * refunded credit. A power cut must then not remove the score or the tickets of the round.
 * Therefore each change of the score or the tickets is logged while the round runs (LEDGER_STAND).
 *
 * After a power cut, the next start writes the missing LEDGER_ROUND from the last LEDGER_STAND. A
 * LEDGER_STAND is written only when the LEDGER_STAND before it is on disk. A change that was still
 * waiting at the power cut is therefore missing in the LEDGER_ROUND. */

/* Share of the round's length, as a fraction, after which the credit of the round is not
 * refundable: two thirds. */
#define STAND_SHARE_NUMERATOR 2u
#define STAND_SHARE_DENOMINATOR 3u

/* Returns true if the credit of the running round is not refundable. In recordings of the older
 * format 7 every credit is refundable. */
bool round_standing_is_spent(const struct game *game, const struct core_config *config);

/* Logs the state of the open round (LEDGER_STAND) if the state changed, the previous entry is on
 * disk, and the ledger has room. Call once per tick of the round. */
void round_standing_tick(struct accounts *accounts, const struct game *game,
                         const struct core_config *config, struct output *output);

/* Finishes a round that was open at startup and whose credit is not refundable. Writes the round's
 * LEDGER_ROUND from config->persistent.ledger.stand and closes the balance. Returns false without
 * an entry if no player had joined the round, otherwise true. */
bool round_standing_finish(struct accounts *accounts, const struct core_config *config,
                           uint32_t tick, struct output *output);

/* Returns the state of the open round after the ledger entry `entry`, if `before` was the state
 * before this entry. For a LEDGER_STAND, the result is the content of `entry`. For another entry of
 * the same round, the result is `before`. Otherwise all fields of the result are 0. */
struct ledger_stand round_standing_after(struct ledger_stand before,
                                         const struct ledger_entry *entry);

/* Returns true if every value that is packed into the fields of `stand` is in its range. */
bool round_standing_is_good(const struct ledger_stand *stand);
