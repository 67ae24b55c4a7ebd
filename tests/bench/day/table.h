/* table.h -- the kiosk of a simulated day, with up to four bowls and a simulated person at each
 * bowl.
 *
 * The kiosk runs through the whole day. Each bowl has a controller that stays connected. A
 * controller that nobody holds rests over its bowl, and the core counts it as a player. The core
 * counts coins, credits and rounds, and a simulated store saves its ledger. */
#ifndef KINGYO_TESTS_BENCH_DAY_TABLE_H
#define KINGYO_TESTS_BENCH_DAY_TABLE_H

#include <stdbool.h>
#include <stdint.h>

#include "drivers/sim/storage_sim.h"
#include "platform/kiosk/kiosk.h"
#include "tests/bench/day/day.h"
#include "tests/bench/players/person.h"

/* State of the simulated kiosk. The struct is too large for a stack. */
struct table {
    struct kiosk kiosk;
    struct hal hal;
    struct clock_sim clock;
    struct storage_sim store;
    struct person persons[POI_MAX];
    bool is_held[POI_MAX]; /* True if a person holds the controller of the bowl. */
    uint32_t bowls;
    uint32_t price; /* Price of a round in units; 0 means free play. */
};

/* Starts the kiosk. Returns false if kiosk_init() failed. */
bool table_open(struct table *table, const struct day_options *options);

/* Returns the functions through which the simulated day uses the kiosk of `table`. */
struct day_kiosk table_kiosk(struct table *table);

/* Returns the sums of the core's accounts since the start. */
struct day_money table_money(const struct table *table);

#endif
