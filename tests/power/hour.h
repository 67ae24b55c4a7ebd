/* hour.h -- simulates a busy hour of a kiosk at a festival.
 *
 * Coins are inserted, SERVICE is pressed, rounds are played and their players enter names, and the
 * operator changes a setting. The real core plays from simulated inputs and all data goes to a
 * store, as in the kiosk. Only the number of caught fish is set directly. */
#ifndef KINGYO_TESTS_POWER_HOUR_H
#define KINGYO_TESTS_POWER_HOUR_H

#include "core/core.h"
#include "platform/hal.h"

#define HOUR_PULSE_TICKS 30u /* Ticks of a ticket pulse (a quarter of a second). */
#define HOUR_ENTRIES_MAX 20000u
#define HOUR_REPLAY_MAX 12288u

struct hour {
    struct core core;
    struct input input;
    struct output output;
    uint32_t seed;
    /* Newest ledger entry that was passed to the store, and newest ledger entry that the store
     * reported as committed. */
    uint32_t kept_id, acked_id;
    uint32_t replay_id, replay_acked_id; /* Newest round that has a replay for the store, and
                                            newest round whose replay is committed. */
    uint32_t named_id;                   /* Newest round whose player has entered a name. */
    uint32_t pulse_ticks;                /* Ticks left in the dispenser's pulse; 0 means that the
                                            dispenser is idle. */
    uint32_t coins, services, rounds;    /* Coins, SERVICE presses and rounds that were
                                            generated, for comparison with the store. */
    uint32_t replay_taken_id;            /* Newest round whose replay the store has accepted. */
    /* Factor by which coins, SERVICE and START come more often; 0 means 1. */
    uint32_t haste;
    /* Mean number of seconds between two saved morph graphs; 0 means that no graph is saved. */
    uint32_t edit_each_s;
    /* Newest morph graph that was passed to the store, and newest committed graph. Graphs are
     * numbered from 1. */
    uint32_t edit_number, edit_acked;
    /* Number of the last graph before the store was opened. The store's graph 1 has the number
     * after it. */
    uint32_t edit_first;
    uint8_t replay[HOUR_REPLAY_MAX];
    struct ledger_entry entries[HOUR_ENTRIES_MAX]; /* Entries indexed by their id. */
};

/* Starts the hour from the state that `store` loads. `store` must be open. Returns 0, or -1 if the
 * core rejects the state. */
int hour_open(struct hour *hour, uint32_t seed, struct hal_storage store);

/* Runs one frame: simulates two ticks, passes their data to the store and reads the store's
 * results. */
void hour_frame(struct hour *hour, struct hal_storage store);

/* Returns morph graph `number` as a record for the store. */
struct graph_edit_record hour_edit(uint32_t number);

/* Writes test bytes in place of the replay of a round. Returns the number of bytes. */
size_t hour_replay(uint32_t round_id, uint8_t out[HOUR_REPLAY_MAX]);

#endif
