/* hour.h -- a busy hour of a festival: coins fall, SERVICE is pressed, rounds are played and named,
 * the operator turns a setting, and all of it goes to a store as the kiosk sends it there.
 *
 * It is the real core that is played, by inputs; only the fish come into the bowl by order. */
#ifndef KINGYO_TESTS_POWER_HOUR_H
#define KINGYO_TESTS_POWER_HOUR_H

#include "core/core.h"
#include "platform/hal.h"

#define HOUR_PULSE_TICKS 30u /* A ticket takes a quarter of a second. */
#define HOUR_ENTRIES_MAX 20000u
#define HOUR_REPLAY_MAX 12288u

struct hour {
    struct core core;
    struct input input;
    struct output output;
    uint32_t seed;
    uint32_t kept_id, acked_id;           /* Handed over, and known to be safe. */
    uint32_t replay_id, replay_acked_id;  /* Of rounds. */
    uint32_t named_id;                    /* The last round whose player has a name. */
    uint32_t pulse_ticks;                 /* Left of the dispenser's pulse; 0: it rests. */
    uint32_t coins, services, rounds;     /* That the world gave, to be found again. */
    uint32_t replay_taken_id;             /* That the store has. */
    uint32_t haste;                       /* Coins, SERVICE, START so many times as often; 0: 1. */
    uint32_t edit_each_s;                 /* A graph is saved once in so many seconds; 0: none. */
    uint32_t edit_number, edit_acked;     /* Of graphs: number 1 and on. */
    uint32_t edit_first;                  /* The number of the store's graph 1, less 1. */
    uint8_t replay[HOUR_REPLAY_MAX];
    struct ledger_entry entries[HOUR_ENTRIES_MAX]; /* By their id. */
};

/* `store` is open. What it remembers is gone on from; 0, or -1 where the core refuses it. */
int hour_open(struct hour *hour, uint32_t seed, struct hal_storage store);

/* One frame: two ticks, and the store is told and asked. */
void hour_frame(struct hour *hour, struct hal_storage store);

/* Graph `number`, as it is saved. */
struct edit_record hour_edit(uint32_t number);

/* The bytes that stand for the replay of a round; returns how many. */
size_t hour_replay(uint32_t round_id, uint8_t out[HOUR_REPLAY_MAX]);

#endif
