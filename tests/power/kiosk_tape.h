/* kiosk_tape.h -- the recorded file operations (the tape of tape.h) of a real kiosk, in a
 * memory-mapped file.
 *
 * The preloaded library (preload.c) and the check (kiosk_check.c) both map this file, so that the
 * tape survives SIGKILL. */
#ifndef KINGYO_TESTS_POWER_KIOSK_TAPE_H
#define KINGYO_TESTS_POWER_KIOSK_TAPE_H

#include "tests/power/fault.h"
#include "tests/power/tape.h"

/* Largest number of operations and bytes that one kiosk run may record. The file is sparse, so that
 * only written parts use disk space. */
#define KIOSK_OPS_MAX 65536u
#define KIOSK_BYTES_MAX (192u << 20)

struct kiosk_tape {
    /* The recorded file operations. The two pointers of `tape` are valid only in the process that
     * set them. */
    struct tape tape;
    uint64_t failed[FAULT_CALL_COUNT];
    uint32_t coins;    /* Number of coins that preload.c inserted. */
    uint32_t refusals; /* Number of status files that reported a store fault. */
    struct tape_op ops[KIOSK_OPS_MAX];
    uint8_t bytes[KIOSK_BYTES_MAX];
};

/* Maps the file at `path` and creates it if it does not exist. Returns null and sets errno on
 * failure. Calls no function of tape.c. */
struct kiosk_tape *kiosk_tape_map(const char *path);

#endif
