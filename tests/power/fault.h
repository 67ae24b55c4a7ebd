/* fault.h -- makes file calls of libc fail according to plans: single calls, bursts, or all calls
 * from a certain call on. tape.c checks the plans before each call. */
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

/* Draws a random plan. The failing calls are one kind of call (6 of 8 plans), both kinds of sync (1
 * of 8) or all kinds (1 of 8). The plan is a single call, a burst of 1 to 8 calls, or permanent.
 * Equal `seed` and `index` give an equal plan. */
struct fault_plan fault_draw(uint64_t seed, uint32_t index);

/* Replaces all plans and restarts the count of calls at 0. `count` is at most FAULT_PLANS_MAX; 0
 * means that no call fails. */
void fault_begin(const struct fault_plan *plans, uint32_t count);

/* Returns the errno with which this call must fail, or 0. The function is not thread-safe: the
 * caller must hold a lock. */
int fault_strikes(enum fault_call call);

/* Number of failed calls of each kind (`fault_failed`), and the names of the kinds (`fault_names`).
 * A program may set `fault_failed` to an array of its own, for example in shared memory. */
extern uint64_t *fault_failed;
extern const char *const fault_names[FAULT_CALL_COUNT];

#endif
