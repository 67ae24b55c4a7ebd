/* credit.h -- what was paid: units become credits, and a credit buys the tank a round.
 *
 * One credit plays for everybody who has a poi in hand: it is the tank that is hired. It is taken
 * when what was chosen begins, not when START is pressed: who only looks at the choice and leaves
 * has paid nothing. It comes back when that round ends because the pois' controllers went and
 * nobody came again, because the operator opened the menu, or because the kiosk itself stopped in
 * it; such a round wins no tickets and is neither a score nor a record. No credit comes back after
 * two thirds of the round, and none comes back twice: such a round keeps its score and its tickets
 * (core/game/stand.h). A credit that came back is played before all others, so that one flag in the
 * purse tells it apart, across power cuts too.
 * The purse is the ledger's (core/ledger.h) and outlives the plug. A credit that is not on disk yet
 * is on its way: it is shown, and may not be played. While nothing can be written the slot is
 * closed; a coin that falls all the same waits (coins.h). */
#ifndef KINGYO_CORE_GAME_CREDIT_H
#define KINGYO_CORE_GAME_CREDIT_H

#include <stdint.h>

#include "core/input.h"
#include "core/ledger.h"
#include "core/output.h"
#include "core/scene.h"

#define CREDIT_COINS_MAX 20u       /* A round that costs more units is paid with banknotes. */
#define CREDIT_TICKET_FISH_MAX 20u /* More than most people catch. */
#define CREDIT_TILT_TICKS (3u * CORE_TICK_HZ) /* So long a shake is held against the cabinet. */
#define CREDIT_AWAIT_TICKS (3u * CORE_TICK_HZ) /* Who pressed START with the coin waits so long. */

/* What is not so, to be told to whoever stands there; a bit each. */
enum credit_warning {
    WARN_TILT = 1u << 0,   /* It was shaken or leant: nothing is lost by it, but coins are sent back
                              while it may be shaken to make the mechanism count. */
    WARN_DOOR = 1u << 1,   /* It stands open. A round that runs is not the door's concern. */
    WARN_NO_POI = 1u << 2, /* No seat has a controller: who paid could not play. */
    WARN_STORE = 1u << 3,  /* What is paid now would not outlive the plug. */
};

/* Coins that no entry tells of yet. */
struct untold {
    uint32_t pulses;
    uint32_t units; /* What they are worth; */
    uint32_t owed;  /* those of them that somebody has a right to. */
};

struct credit {
    uint8_t came_back;   /* What the last round cost did. */
    uint8_t warnings;    /* enum credit_warning */
    struct untold untold[COIN_LINE_COUNT];
    uint32_t metered;    /* Coins since the start, */
    uint32_t shakes;     /* how often it was shaken, */
    uint32_t tickets;    /* and the pulses that the dispenser was asked for. */
    uint32_t coin_tick;  /* When the last coin fell; */
    uint32_t tilt_tick;  /* when it was shaken last; 0: never. */
    uint32_t asked_tick; /* When somebody wanted to play and had not paid; 0: never. */
    uint32_t await_tick; /* When somebody wanted to play whose credit was on its way; 0: never. */
    uint32_t act_tick;   /* When anybody last had to do with the purse. */
    uint32_t stand_id;   /* Entry of the newest LEDGER_STAND of the open round; 0: none yet. */
    struct ledger_stand stand; /* What that entry reports. */
    uint32_t ticket_id;  /* LEDGER_TICKET whose pulse waits for the disk; 0: none does. */
};

struct core;

/* What coins, SERVICE, TILT and DOOR say, before the phase's own tick. In the operator's menu a
 * coin is a test, and TILT and SERVICE mean nothing here. */
void credit_tick(struct core *core, const struct input *input, struct output *output);

/* What of it is wanted of the world: lockout, meter, tickets. After the phase's tick. */
void credit_show_outputs(const struct core *core, struct output *output);

/* What a credit costs, in units; 0: nothing. */
uint32_t credit_price(const struct core *core);

/* Whether a round may begin: it is free, or a credit that is on disk pays for it. */
int credit_can_play(const struct core *core);

/* Credits that may not be played yet. */
uint32_t credit_coming(const struct core *core);

/* Somebody wants to play who may not. Where his credit is on its way he has only to wait for it
 * (credit_is_awaited()); else the stall asks for a coin more loudly for a moment. */
void credit_ask(struct core *core, struct output *output);

/* Whether what somebody asked for in vain is possible now. */
int credit_is_awaited(const struct core *core);

/* Takes one for `what` (enum game_mode, or CHOICE_LAB), which begins now. To be called only when
 * credit_can_play(). */
void credit_take(struct core *core, uint8_t what, struct output *output);

/* What runs now ends, and not as it should: its credit comes back, if it took one and
 * stand_is_spent() does not hold; else the purse stays open for the caller to close. A free round
 * whose pois went is a round all the same. */
void credit_give_back(struct core *core, enum refund_cause cause, struct output *output);

/* Returns the tickets that the round has won so far: for what each player caught, none for a
 * bot. */
uint32_t credit_tickets_won(const struct core *core);

/* The round is over and was not given back: its tickets are owed from now on. Returns how many. */
uint32_t credit_hand_out_tickets(struct core *core);

/* What there is to see of it. */
void credit_show(const struct core *core, struct scene_credit *out);

uint64_t credit_hash(uint64_t hash, const struct credit *credit);

#endif
