/* credit.h -- payment: units become credits, and one credit buys one round at the tank.
 *
 * A credit pays for every player with a poi. The credit is taken when the selected round starts,
 * not when START is pressed, so leaving the mode selection is free. The credit is refunded if the
 * round ends because all controllers were lost, because the operator opened the menu, or because
 * the kiosk stopped. A refunded round wins no tickets and produces no score and no record.
 *
 * After two thirds of a round the credit is not refunded, and a refunded credit is not refunded a
 * second time. A round that is not refunded keeps its score and its tickets
 * (core/game/accounting/round_standing.h). A refunded credit is used before all other credits. One
 * flag in the balance therefore identifies the refunded credit, even after a power cut.
 *
 * The balance is stored in the ledger (core/ledger.h) and survives a power cut. A credit that is
 * not on disk yet is displayed but cannot be played. While the ledger cannot be written, the coin
 * slot is closed. Coins that are inserted into the closed slot are kept in `pending_coins`
 * (coins.h). */
#ifndef KINGYO_CORE_GAME_ACCOUNTING_CREDIT_H
#define KINGYO_CORE_GAME_ACCOUNTING_CREDIT_H

#include <stdint.h>

#include "core/input.h"
#include "core/ledger.h"
#include "core/output.h"
#include "core/scene.h"

/* Highest price of a round in units. A more expensive round would be paid with banknotes. */
#define CREDIT_COINS_MAX 20u
/* Highest setting for the number of fish per ticket, more fish than most players catch. */
#define CREDIT_TICKET_FISH_MAX 20u
/* Time for which the coin slot stays closed after a tilt. */
#define CREDIT_TILT_TICKS (3u * CORE_TICK_HZ)
/* Time for which a START press waits for the coin to reach the disk. */
#define CREDIT_AWAIT_TICKS (3u * CORE_TICK_HZ)

/* Bit flags of conditions that close the coin slot and are displayed as warnings. */
enum credit_warning {
    WARN_TILT = 1u << 0,   /* The cabinet was shaken or tilted. The balance does not change. Coins
                              are returned, because shaking can trigger the coin mechanism. */
    WARN_DOOR = 1u << 1,   /* The door is open. A running round continues. */
    WARN_NO_POI = 1u << 2, /* No slot has a controller, so a player who pays could not play. */
    WARN_STORE = 1u << 3,  /* The store is not safe, so a payment could be lost in a power cut. */
};

/* Coins that no ledger entry contains yet. */
struct pending_coins {
    uint32_t pulses;
    uint32_t units; /* Value of the pulses in units. */
    uint32_t owed;  /* Units that must be added to the balance. Coins inserted during free play add
                       nothing to `owed`. */
};

struct credit {
    uint8_t came_back; /* 1 if the credit of the last round was refunded, otherwise 0. */
    uint8_t warnings;  /* Current warnings (bit mask of enum credit_warning). */
    struct pending_coins pending_coins[COIN_LINE_COUNT];
    uint32_t metered;    /* Number of coins counted since the kiosk started. */
    uint32_t shakes;     /* Number of tilt events since the kiosk started. */
    uint32_t tickets;    /* Number of pulses requested from the ticket dispenser since the kiosk
                            started. */
    uint32_t coin_tick;  /* Tick of the last coin. */
    uint32_t tilt_tick;  /* Tick of the last tilt; 0 means never. */
    uint32_t asked_tick; /* Tick of the last start attempt without a credit; 0 means never. */
    uint32_t await_tick; /* Tick of the last start attempt whose credit was not on disk yet; 0 means
                            never. */
    uint32_t act_tick;   /* Tick at which a person last changed the balance. */
    uint32_t stand_id;   /* Id of the newest LEDGER_STAND of the open round; 0 means none. */
    struct ledger_stand stand; /* Fields of the newest LEDGER_STAND. */
    uint32_t ticket_id; /* Id of the LEDGER_TICKET that must reach the disk before its pulse starts;
                           0 means none. */
};

struct game;
struct accounts;
struct ledger;
struct world;
struct core_config;

/* Handles coins, SERVICE, TILT and DOOR. Call before the tick function of the phase. In the
 * operator's menu a coin is a test, and TILT and SERVICE do not change the balance. */
void credit_tick(struct game *game, const struct world *world, const struct core_config *config,
                 const struct input *input, struct output *output);

/* Writes the coin lockout and the counts for the coin meter and the ticket dispenser to `output`.
 * Call after the tick function of the phase. */
void credit_show_outputs(const struct game *game, const struct core_config *config,
                         struct output *output);

/* Returns the price of a credit in units; 0 means free play. */
uint32_t credit_price(const struct core_config *config);

/* Returns 1 if a round may start, because play is free or a credit on disk pays for the round;
 * otherwise 0. */
int credit_can_play(const struct ledger *ledger, const struct core_config *config);

/* Returns the number of credits that are not on disk yet. */
uint32_t credit_coming(const struct ledger *ledger);

/* Handles a start attempt without a playable credit. If a credit is not on disk yet, the attempt
 * waits for the credit (credit_is_awaited()). Otherwise the display highlights the request for a
 * coin for a moment. */
void credit_ask(struct accounts *accounts, uint32_t tick, struct output *output);

/* Returns 1 if a start attempt that waited for its credit can now start a game, otherwise 0. */
int credit_is_awaited(const struct accounts *accounts, const struct core_config *config,
                      uint32_t tick);

/* Takes one credit for the game `what` (enum game_mode, or CHOICE_LAB), which starts in this tick.
 * The caller must check credit_can_play() before. */
void credit_take(struct game *game, const struct core_config *config, uint8_t what,
                 struct output *output);

/* Ends the running round early. The credit is refunded if one was taken and stand_is_spent() is 0.
 * Otherwise the balance keeps its open round, which the caller must close. A free round that lost
 * its pois counts as a normal round. */
void credit_refund(struct game *game, const struct core_config *config, enum refund_cause cause,
                   struct output *output);

/* Returns the tickets that the round has won so far, computed from each player's catch; 0 if the
 * bot played. */
uint32_t credit_tickets_won(const struct game *game, const struct core_config *config);

/* Adds the tickets of a finished round that was not refunded to the balance. Returns the number of
 * tickets. */
uint32_t credit_award_tickets(struct game *game, const struct core_config *config);

/* Fills `out` with the visible state of the credits. */
void credit_show(const struct accounts *accounts, const struct core_config *config, uint32_t tick,
                 struct scene_credit *out);

uint64_t credit_hash(uint64_t hash, const struct credit *credit);

#endif
