/* kiosk_tape.h -- the recorded file operations of a real kiosk (the tape, see tape.h), in a file
 * that is mapped into memory.
 *
 * The library in the kiosk (preload.c) and the check (kiosk_check.c) both map this file. The
 * recorded operations therefore survive when the kiosk is killed. */
#ifndef KINGYO_TESTS_POWER_KIOSK_TAPE_H
#define KINGYO_TESTS_POWER_KIOSK_TAPE_H

#include "tests/power/fault.h"
#include "tests/power/tape.h"

/* Largest number of operations and of bytes that one kiosk run may record. The file is sparse, so
 * only its written parts use disk space. */
#define KIOSK_OPS_MAX 65536u
#define KIOSK_BYTES_MAX (192u << 20)

struct kiosk_tape {
    /* The recorded file operations. The two pointers in `tape` are valid only in the process that
     * has set them. */
    struct tape tape;
    uint64_t failed[FAULT_CALL_COUNT];
    uint32_t coins;    /* Number of coins that preload.c inserted. */
    uint32_t refusals; /* Number of status files in which the kiosk reported a fault of the
                          store. */
    struct tape_op ops[KIOSK_OPS_MAX];
    uint8_t bytes[KIOSK_BYTES_MAX];
};

/* Maps the file at `path`, and creates the file if it does not exist. Returns null and sets errno
 * on failure. The function calls no function of tape.c. */
struct kiosk_tape *kiosk_tape_map(const char *path);

#endif
