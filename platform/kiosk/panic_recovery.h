/* panic_recovery.h -- writes the evidence of a panic to the data folder, and handles it at the next
 * start.
 *
 * A panic writes the running session (session_recorder.h), up to the newest input, as panic-N.kgr,
 * N from 0 to 9; the oldest file is replaced. `kingyoctl replay verify` plays it again. A panic
 * inside the core then occurs at the same tick; for any other panic the last state is equal. The
 * file's mode is 0600 because inputs and settings may contain the operator's PIN. panic_count.h
 * counts the panics. */
#ifndef KINGYO_PLATFORM_KIOSK_PANIC_RECOVERY_H
#define KINGYO_PLATFORM_KIOSK_PANIC_RECOVERY_H

#include <stdatomic.h>
#include <stdint.h>
#include <sys/types.h>

#include "platform/kiosk/session_recorder.h"
#include "platform/panic_count.h"

/* State of the panic handler. The caller owns the structure and clears it. The address must not
 * change. */
struct evidence {
    int folder;                        /* Descriptor of the data folder + 1; 0: none. */
    const char *data;                  /* Path of the data folder, for messages. */
    struct session_recorder *chapters; /* Null: no session is recorded. */
    const struct core *core;
    pid_t thread; /* Id of the thread that runs the core's ticks. */
    uint64_t boot;
    uint32_t begun_s;          /* Start time in the units of panics_up_s(). */
    struct panics panics;      /* Content of the file. */
    atomic_uchar has_frame;    /* 1: the first frame was shown. */
    atomic_uchar has_panicked; /* 1: evidence_write() has begun and owns `panics`. */
    atomic_uchar is_clearing;  /* 1: a thread clears `panics` after a run without panics. */
};

/* Opens the data folder and reads the count. Call on the thread that will run the ticks, before the
 * store is opened. After three panics within ten minutes, or one before the first frame, a part of
 * the stored data is left out (platform/store/sqlite/ledger_omit.h), which is logged. If that
 * fails, the next start tries again, unless this process runs for ten minutes; then a thread clears
 * the count.
 * Without a folder panics are only reported. */
void evidence_open(struct evidence *evidence, const char *data, struct session_recorder *chapters,
                   const struct core *core);

/* Call after the first frame. */
void evidence_note_frame(struct evidence *evidence);

/* Handles a panic: stops the thread that runs the ticks, writes the replay and the count, and
 * reports both with `reason` in one line. Returns 1, or 0 if that thread may still change the core
 * and its recordings, or if such a change was interrupted. Async-signal-safe. */
int evidence_write(struct evidence *evidence, const char *reason);

#endif
