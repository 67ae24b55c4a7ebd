/* fault.h -- makes file calls of libc fail as planned: single calls, bursts, or all calls from a
 * certain call on. tape.c checks the plans before each call. */
#ifndef KINGYO_TESTS_POWER_FAULT_H
#define KINGYO_TESTS_POWER_FAULT_H

#include <stdint.h>

enum fault_call {
    FAULT_FSYNC = 0,
    FAULT_FDATASYNC,
    FAULT_WRITE,
    FAULT_PWRITE,
    FAULT_FTRUNCATE,
    FAULT_RENAME,
    FAULT_CALL_COUNT,
};

#define FAULT_PLANS_MAX 4u
#define FAULT_FOR_EVER UINT32_MAX

/* Plan of failing calls. The plan counts all calls of the kinds in `calls` together, from 0. The
 * calls number `first` to `first` + `count` - 1 fail. */
struct fault_plan {
    uint32_t calls; /* Kinds of calls as a bit set of `1u << enum fault_call`. */
    uint32_t first, count;
    int error; /* errno of the failing calls: EIO or ENOSPC. */
};

/* Draws a plan. In six of eight cases one kind of call fails, in one case both kinds of sync, in
 * one case all kinds. The plan is a single call, a burst of 1 to 8 calls, or permanent. The error
 * is EIO or ENOSPC. Equal `seed` and `index` give an equal plan. */
struct fault_plan fault_draw(uint64_t seed, uint32_t index);

/* Replaces all plans and restarts the count of calls at 0. `count` is at most FAULT_PLANS_MAX; 0
 * means that no call fails. */
void fault_begin(const struct fault_plan *plans, uint32_t count);

/* Returns the errno with which this call must fail, or 0. The function is not thread-safe: the
 * caller must hold a lock. */
int fault_strikes(enum fault_call call);

/* `fault_failed` counts the failed calls by kind. A program may set it to other FAULT_CALL_COUNT
 * counters. `fault_names` has the names of the kinds. */
extern uint64_t *fault_failed;
extern const char *const fault_names[FAULT_CALL_COUNT];

#endif
