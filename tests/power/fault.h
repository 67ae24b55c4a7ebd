/* fault.h -- makes file calls of libc fail according to plans: single calls, bursts, or all calls
 * from one on. The replaced functions in tape.c check the plans before each call. */
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

/* Plan of failing calls. All calls of the kinds in `calls` are numbered together, from 0. The calls
 * `first` to `first` + `count` - 1 fail. */
struct fault_plan {
    uint32_t calls; /* Kinds of calls, as a bit set of `1u << enum fault_call`. */
    uint32_t first, count;
    int error; /* errno that a failing call sets: EIO or ENOSPC. */
};

/* Returns a random plan. In 6 of 8 plans one kind of call fails, in 1 of 8 both kinds of sync, and
 * in 1 of 8 all kinds. The failure is a single call, a burst of 1 to 8 calls, or permanent. Equal
 * `seed` and `index` give an equal plan. */
struct fault_plan fault_draw(uint64_t seed, uint32_t index);

/* Replaces all plans, and numbers the following calls from 0. `count` is at most FAULT_PLANS_MAX.
 * With a `count` of 0 no call fails. */
void fault_begin(const struct fault_plan *plans, uint32_t count);

/* Returns the errno with which this call must fail, or 0 if the call must succeed. The function is
 * not thread-safe, so the caller must hold a lock. */
int fault_strikes(enum fault_call call);

/* `fault_failed` has the number of failed calls of each kind, and `fault_names` has the names of
 * the kinds. A program may let `fault_failed` point to its own array, for example in shared
 * memory. */
extern uint64_t *fault_failed;
extern const char *const fault_names[FAULT_CALL_COUNT];

#endif
