/* fault.h -- makes calls of libc's file functions fail as planned: single calls, bursts, or all
 * from some call on. tape.c asks before each call. */
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

/* Calls of the kinds in `calls`, counted together from 0: `count` of them fail from `first` on. */
struct fault_plan {
    uint32_t calls; /* Bit `1u << enum fault_call` each. */
    uint32_t first, count;
    int error;      /* errno: EIO or ENOSPC. */
};

/* Draws a plan: one kind of call in six cases of eight, both syncs in one, all kinds in one; a
 * single call, a burst of 1 to 8, or permanent; EIO or ENOSPC; the place. Equal `seed` and `index`,
 * equal plan. */
struct fault_plan fault_draw(uint64_t seed, uint32_t index);

/* Replaces all plans; `count` at most FAULT_PLANS_MAX, 0: no call fails. Counts from 0 again. */
void fault_begin(const struct fault_plan *plans, uint32_t count);

/* The errno with which this call has to fail, or 0. Not thread-safe: the caller holds a lock. */
int fault_strikes(enum fault_call call);

/* Calls that failed so far, by kind; a program may put other FAULT_CALL_COUNT numbers in their
 * place. And the names of the kinds. */
extern uint64_t *fault_failed;
extern const char *const fault_names[FAULT_CALL_COUNT];

#endif
