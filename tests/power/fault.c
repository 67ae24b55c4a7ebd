/* fault.c -- generates random plans that define which file calls fail. */
#include "tests/power/fault.h"

#include <errno.h>

#include "core/base/rng.h"

static uint64_t own_failed[FAULT_CALL_COUNT];
uint64_t *fault_failed = own_failed;
const char *const fault_names[FAULT_CALL_COUNT] = {
    [FAULT_FSYNC] = "fsync",   [FAULT_FDATASYNC] = "fdatasync", [FAULT_WRITE] = "write",
    [FAULT_PWRITE] = "pwrite", [FAULT_FTRUNCATE] = "ftruncate", [FAULT_RENAME] = "rename",
};

/* Approximate number of calls of each kind that a store makes in ten busy seconds. The first call
 * that fails is drawn below this number, so that most plans take effect within ten seconds. */
static const uint32_t calls_usual[FAULT_CALL_COUNT] = {
    [FAULT_FSYNC] = 24,   [FAULT_FDATASYNC] = 60, [FAULT_WRITE] = 8,
    [FAULT_PWRITE] = 320, [FAULT_FTRUNCATE] = 2,  [FAULT_RENAME] = 8,
};

static struct fault_plan running[FAULT_PLANS_MAX];
static uint32_t running_count, seen[FAULT_PLANS_MAX];

struct fault_plan fault_draw(uint64_t seed, uint32_t index)
{
    uint32_t draws[5];
    for (uint32_t i = 0; i < 5u; i++) {
        draws[i] = rng_u32((struct rng_key){ (uint32_t)seed, index, (uint32_t)(seed >> 32) ^ i,
                                             RNG_TEST }) >>
                   8;
    }
    const uint32_t which = draws[0] % 8u;
    struct fault_plan plan = { .error = draws[1] % 2u ? EIO : ENOSPC };
    plan.calls = which < FAULT_CALL_COUNT    ? 1u << which
                 : which == FAULT_CALL_COUNT ? 1u << FAULT_FSYNC | 1u << FAULT_FDATASYNC
                                             : (1u << FAULT_CALL_COUNT) - 1u;
    for (uint32_t call = 0; call < FAULT_CALL_COUNT; call++) {
        plan.first += plan.calls >> call & 1u ? calls_usual[call] : 0u;
    }
    plan.first = draws[2] % plan.first;
    plan.count = draws[3] % 10u < 2u   ? 1u
                 : draws[3] % 10u < 8u ? 1u + draws[4] % 8u
                                       : FAULT_FOR_EVER;
    return plan;
}

void fault_begin(const struct fault_plan *plans, uint32_t count)
{
    running_count = count;
    for (uint32_t i = 0; i < count; i++) {
        running[i] = plans[i];
        seen[i] = 0;
    }
}

int fault_strikes(enum fault_call call)
{
    int error = 0;
    for (uint32_t i = 0; i < running_count; i++) {
        const struct fault_plan *plan = &running[i];
        if (plan->calls >> call & 1u) {
            const uint32_t at = seen[i]++;
            error = at >= plan->first && at - plan->first < plan->count ? plan->error : error;
        }
    }
    fault_failed[call] += error != 0;
    return error;
}
