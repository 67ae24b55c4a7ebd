/* credit.h -- payment: units become credits, and one credit buys one round at the tank.
 *
 * A credit pays for every player with a poi. The credit is taken when the selected round starts,
 * not when START is pressed, so leaving the selection screen is free. The credit is refunded if the
 * round ends because all controllers were lost, because the operator opened the menu, or because
 * the kiosk stopped. Such a round wins no tickets and produces no score and no record.
 *
 * No credit is refunded after two thirds of the round, and none is refunded twice. Such a round
 * keeps its score and its tickets (core/game/accounting/round_standing.h). A refunded credit is
 * used before all others, so that one flag in the balance identifies it, even after a power cut.
 *
 * The balance is stored in the ledger (core/ledger.h) and survives a power cut. A credit that is
 * not on disk yet is displayed but cannot be played. While the ledger cannot be written, the coin
 * slot is closed; coins that are inserted anyway are kept pending (coins.h). */
#ifndef KINGYO_CORE_GAME_ACCOUNTING_CREDIT_H
#define KINGYO_CORE_GAME_ACCOUNTING_CREDIT_H

#include <stdint.h>

#include "core/input.h"
#include "core/ledger.h"
#include "core/output.h"
#include "core/scene.h"

/* Highest price of a round; a more expensive round is paid with banknotes. */
#define CREDIT_COINS_MAX 20u
#define CREDIT_TICKET_FISH_MAX 20u /* More fish than most players catch. */
/* Time for which a tilt keeps the coin slot closed. */
#define CREDIT_TILT_TICKS (3u * CORE_TICK_HZ)
/* Time for which a START press waits for the coin to reach the disk. */
#define CREDIT_AWAIT_TICKS (3u * CORE_TICK_HZ)

/* Conditions that close the coin slot and are displayed as warnings, as bit flags. */
enum credit_warning {
    WARN_TILT = 1u << 0,   /* The cabinet was shaken or tilted. Nothing is lost, but coins are
                              returned, because shaking can make the coin mechanism count. */
    WARN_DOOR = 1u << 1,   /* The door is open. A running round continues. */
    WARN_NO_POI = 1u << 2, /* No slot has a controller, so a paying player could not play. */
    WARN_STORE = 1u << 3,  /* The store is not safe: a payment now would not survive a power cut. */
};

/* Coins that no ledger entry contains yet. */
struct pending_coins {
    uint32_t pulses;
    uint32_t units; /* Value of the pulses in units. */
    uint32_t owed;  /* Units that must be added to the balance; 0 for coins inserted during free
                       play. */
};

struct credit {
    uint8_t came_back; /* 1: the credit of the last round was refunded. */
    uint8_t warnings;  /* enum credit_warning */
    struct pending_coins pending_coins[COIN_LINE_COUNT];
    uint32_t metered;    /* Coins counted since the start. */
    uint32_t shakes;     /* Tilt events since the start. */
    uint32_t tickets;    /* Pulses requested from the ticket dispenser since the start. */
    uint32_t coin_tick;  /* Tick of the last coin. */
    uint32_t tilt_tick;  /* Tick of the last tilt; 0: never. */
    uint32_t asked_tick; /* Tick of the last start attempt without a credit; 0: never. */
    uint32_t await_tick; /* Tick of the last start attempt with a credit that was not on disk yet;
                            0: never. */
    uint32_t act_tick;   /* Tick of the last change to the balance by a person. */
    uint32_t stand_id;   /* Id of the newest LEDGER_STAND of the open round; 0: none yet. */
    struct ledger_stand stand; /* Content of the newest LEDGER_STAND. */
    uint32_t ticket_id; /* Id of the LEDGER_TICKET whose pulse waits for the disk; 0: none. */
};

struct game;
struct accounts;
struct ledger;
struct world;
struct core_config;

/* Handles coins, SERVICE, TILT and DOOR, before the tick of the phase. In the operator's menu a
 * coin is a test, and TILT and SERVICE have no effect here. */
void credit_tick(struct game *game, const struct world *world, const struct core_config *config,
                 const struct input *input, struct output *output);

/* Writes coin lockout, meter and ticket counts to `output`, after the tick of the phase. */
void credit_show_outputs(const struct game *game, const struct core_config *config,
                         struct output *output);

/* Returns the price of a credit in units; 0: free play. */
uint32_t credit_price(const struct core_config *config);

/* Returns 1 if a round may start: play is free, or a credit on disk pays for the round. */
int credit_can_play(const struct ledger *ledger, const struct core_config *config);

/* Returns the number of credits that are not on disk yet. */
uint32_t credit_coming(const struct ledger *ledger);

/* Handles a start attempt without a playable credit. If a credit is not on disk yet, the attempt
 * waits for the credit (credit_is_awaited()). Otherwise the display highlights the request for a
 * coin for a moment. */
void credit_ask(struct accounts *accounts, uint32_t tick, struct output *output);

/* Returns 1 if a waiting start attempt is now possible. */
int credit_is_awaited(const struct accounts *accounts, const struct core_config *config,
                      uint32_t tick);

/* Takes one credit for `what` (enum game_mode, or CHOICE_LAB), which starts now. Call only if
 * credit_can_play(). */
void credit_take(struct game *game, const struct core_config *config, uint8_t what,
                 struct output *output);

/* Ends the running round early. The credit is refunded if one was taken and stand_is_spent() is 0;
 * otherwise the balance stays open for the caller to close. A free round that lost its pois counts
 * as a normal round. */
void credit_refund(struct game *game, const struct core_config *config, enum refund_cause cause,
                   struct output *output);

/* Returns the tickets that the round has won so far, computed from each player's catch; 0 if the
 * bot played. */
uint32_t credit_tickets_won(const struct game *game, const struct core_config *config);

/* Adds the tickets of a finished, not refunded round to the balance. Returns the number of
 * tickets. */
uint32_t credit_award_tickets(struct game *game, const struct core_config *config);

/* Fills `out` with the visible state of the credits. */
void credit_show(const struct accounts *accounts, const struct core_config *config, uint32_t tick,
                 struct scene_credit *out);

uint64_t credit_hash(uint64_t hash, const struct credit *credit);

#endif
