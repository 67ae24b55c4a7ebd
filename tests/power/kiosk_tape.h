/* kiosk_tape.h -- the tape of a real kiosk, in a file that both the library that is loaded into it
 * (preload.c) and the judge (judge.c) map, so that the tape outlives SIGKILL. */
#ifndef KINGYO_TESTS_POWER_KIOSK_TAPE_H
#define KINGYO_TESTS_POWER_KIOSK_TAPE_H

#include "tests/power/fault.h"
#include "tests/power/tape.h"

/* Of one life. A file with holes: only what is written takes room. */
#define KIOSK_OPS_MAX 65536u
#define KIOSK_BYTES_MAX (192u << 20)

struct kiosk_tape {
    struct tape tape; /* Its two pointers are each process's own. */
    uint64_t failed[FAULT_CALL_COUNT];
    uint32_t coins;   /* That were dropped. */
    uint32_t refusals; /* Statuses that said that the store is not well. */
    struct tape_op ops[KIOSK_OPS_MAX];
    uint8_t bytes[KIOSK_BYTES_MAX];
};

/* Maps it, and makes the file where there is none. Null: errno. Calls no function of tape.c. */
struct kiosk_tape *kiosk_tape_map(const char *path);

#endif
