/* hour.h -- simulates a busy hour of a kiosk at a festival.
 *
 * Coins are inserted, SERVICE is pressed, rounds are played, players enter names, and the operator
 * changes a setting. The real core plays with simulated inputs, and all its data go to a store, as
 * in the kiosk. Only the number of caught fish is set directly. */
#ifndef KINGYO_TESTS_POWER_HOUR_H
#define KINGYO_TESTS_POWER_HOUR_H

#include "core/core.h"
#include "platform/hal.h"

#define HOUR_PULSE_TICKS 30u /* Duration of a dispenser pulse in ticks: a quarter of a second. */
#define HOUR_ENTRIES_MAX 20000u
#define HOUR_REPLAY_MAX 12288u

struct hour {
    struct core core;
    struct input input;
    struct output output;
    uint32_t seed;
    /* Id of the newest ledger entry that was passed to the store, and of the newest entry that the
     * store reported as committed. */
    uint32_t kept_id, acked_id;
    uint32_t replay_id, replay_acked_id; /* Id of the newest round with a replay for the store, and
                                            of the newest round whose replay is committed. */
    uint32_t named_id;                   /* Id of the newest round whose player has entered a
                                            name. */
    uint32_t pulse_ticks;                /* Ticks until the current dispenser pulse ends. 0 means
                                            that the dispenser is idle. */
    uint32_t coins, services, rounds;    /* Number of coins, SERVICE presses and rounds that were
                                            generated. The store must have the same numbers. */
    uint32_t replay_taken_id;            /* Id of the newest round whose replay the store has
                                            accepted. */
    /* Factor by which coins, SERVICE presses and START presses are more frequent. 0 means 1. */
    uint32_t haste;
    /* Mean number of seconds between two stored morph graphs. 0 means that no graph is stored. */
    uint32_t edit_each_s;
    /* Number of the newest morph graph that was passed to the store, and of the newest committed
     * graph. Graphs are numbered from 1. */
    uint32_t edit_number, edit_acked;
    /* Number of graphs before the store was opened. Graph 1 of the store is graph `edit_first` + 1
     * of the test. */
    uint32_t edit_first;
    uint8_t replay[HOUR_REPLAY_MAX];
    struct ledger_entry entries[HOUR_ENTRIES_MAX]; /* All ledger entries, indexed by their id. */
};

/* Starts the hour with the state that `store` loads. `store` must be open. Returns 0, or -1 if the
 * core rejects the state. */
int hour_open(struct hour *hour, uint32_t seed, struct hal_storage store);

/* Runs one frame: simulates two ticks, passes their data to `store`, and reads what the store has
 * committed. */
void hour_frame(struct hour *hour, struct hal_storage store);

/* Returns morph graph number `number` as a record for the store. */
struct graph_edit_record hour_edit(uint32_t number);

/* Writes bytes to `out` that replace the replay of a round in this test. Returns the number of
 * bytes. */
size_t hour_replay(uint32_t round_id, uint8_t out[HOUR_REPLAY_MAX]);

#endif
