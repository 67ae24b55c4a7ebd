/* evidence.h -- what a panic leaves in the data folder, and what the next start makes of it.
 *
 * A panic writes the chapter that runs (chapters.h), up to the newest input, as panic-N.kgr, N from
 * 0 to 9: the oldest is replaced. `kingyoctl replay verify` plays it again: a panic inside the core
 * comes again at the same tick, and of any other the last state agrees. The file's mode is 0600,
 * because inputs and settings in it may hold the operator's PIN. panics.h counts the panics. */
#ifndef KINGYO_PLATFORM_KIOSK_EVIDENCE_H
#define KINGYO_PLATFORM_KIOSK_EVIDENCE_H

#include <stdatomic.h>
#include <stdint.h>
#include <sys/types.h>

#include "platform/kiosk/chapters.h"
#include "platform/panics.h"

/* The caller owns it and leaves it zero. It stays at its address. */
struct evidence {
    int folder;              /* The data folder's descriptor + 1; 0: there is none. */
    const char *data;        /* Path of the data folder, for messages. */
    struct chapters *chapters; /* Null: nothing is recorded. */
    const struct core *core;
    pid_t thread;            /* Id of the thread that ticks the core. */
    uint64_t boot;
    uint32_t begun_s;        /* As panics_up_s(). */
    struct panics panics;    /* As the file says. */
    atomic_uchar has_frame;  /* The first frame was shown. */
    atomic_uchar has_panicked; /* evidence_write() has begun: `panics` is its own. */
    atomic_uchar is_clearing;  /* A thread clears `panics` after a good run. */
};

/* Opens the data folder and reads the count, on the thread that will tick the core and before the
 * store is opened. After three panics within ten minutes, or one before the first frame, it leaves
 * out a part of what the store remembers (store/ledger_leave.h) and reports that in the log. If
 * that fails, the next start tries again, unless this one runs for ten minutes: then a thread
 * clears the count. Without a folder panics are only reported. */
void evidence_open(struct evidence *evidence, const char *data, struct chapters *chapters,
                   const struct core *core);

/* After the first frame. */
void evidence_note_frame(struct evidence *evidence);

/* In a panic: stops the thread that ticks the core, writes the replay and the count, and reports
 * both with `reason` in one line. Returns 1, or 0 if that thread may still change the core and its
 * recordings, or if such a change was interrupted. Async-signal-safe. */
int evidence_write(struct evidence *evidence, const char *reason);

#endif
