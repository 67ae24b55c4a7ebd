/* credit.h -- what was paid: coins become credits, and a credit buys the tank a round.
 *
 * One credit plays for everybody who has a poi in hand: it is the tank that is hired. It is taken
 * when what was chosen begins, not when START is pressed: who only looks at the choice and leaves
 * has paid nothing. It comes back when that round ends because the pois' controllers went and
 * nobody came again, or because the operator opened the menu; such a round wins no tickets and is
 * neither a score nor a record.
 * All of it is in memory only: a kiosk that is switched off forgets what was not played. */
#ifndef KINGYO_CORE_GAME_CREDIT_H
#define KINGYO_CORE_GAME_CREDIT_H

#include <stdint.h>

#include "core/input.h"
#include "core/output.h"
#include "core/scene.h"

#define CREDIT_COINS_MAX 20u       /* A round that costs more is paid with banknotes. */
#define CREDIT_TICKET_FISH_MAX 20u /* More than most people catch. */
#define CREDIT_MAX 99u /* Two digits on the plate. From there on coins are sent back; one that falls
                          all the same waits until a credit is played. */
#define CREDIT_TILT_TICKS (3u * CORE_TICK_HZ) /* So long a shake is held against the cabinet. */

/* What is not so, to be told to whoever stands there; a bit each. */
enum credit_warning {
    WARN_TILT = 1u << 0,   /* It was shaken or leant: nothing is lost by it, but coins are sent back
                              while it may be shaken to make the mechanism count. */
    WARN_DOOR = 1u << 1,   /* It stands open. A round that runs is not the door's concern. */
    WARN_NO_POI = 1u << 2, /* No seat has a controller: who paid could not play. */
};

struct credit {
    uint8_t is_paid;     /* What runs now took a credit. */
    uint8_t came_back;   /* The last round's did. */
    uint8_t warnings;    /* enum credit_warning */
    uint32_t coins;      /* Towards the next credit. */
    uint32_t credits;    /* Not yet played, .. CREDIT_MAX */
    uint32_t metered;    /* Coins since the start, */
    uint32_t services;   /* credits that SERVICE gave, counted apart, */
    uint32_t refunds;    /* credits that came back, */
    uint32_t tilts;      /* shakes, */
    uint32_t tickets;    /* and what was won. */
    uint32_t coin_tick;  /* When the last coin fell; */
    uint32_t tilt_tick;  /* when it was shaken last; 0: never. */
    uint32_t asked_tick; /* When somebody wanted to play and had not paid; 0: never. */
};

struct core;

/* What coins, SERVICE, TILT and DOOR say, before the phase's own tick. In the operator's menu TILT
 * and SERVICE mean nothing here. A coin that falls there all the same is money, but on the page
 * that tries the lines, where it is only metered. */
void credit_tick(struct core *core, const struct input *input, struct output *output);

/* What of it is wanted of the world: lockout, meter, tickets. After the phase's tick. */
void credit_show_outputs(const struct core *core, struct output *output);

/* Whether a round may begin: it is free, or paid for. */
int credit_can_play(const struct core *core);

/* Somebody wants to play who may not: the stall asks for a coin more loudly for a moment. */
void credit_ask(struct core *core);

/* Takes one for what begins now. To be called only when credit_can_play(). */
void credit_take(struct core *core);

/* What runs now ends, and not as it should: its credit comes back, if it took one. */
void credit_give_back(struct core *core);

/* The round is over and was not given back: tickets for what each player caught, none for a bot. */
void credit_hand_out_tickets(struct core *core);

/* What there is to see of it. */
void credit_show(const struct core *core, struct scene_credit *out);

uint64_t credit_hash(uint64_t hash, const struct credit *credit);

#endif
