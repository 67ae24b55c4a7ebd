/* panic_recovery.h -- writes the evidence of a panic to the data folder, and evaluates the evidence
 * at the next start.
 *
 * A panic is a failed assertion or a fatal signal. The panic handler writes the running session
 * (session_recorder.h), up to the newest input, to the file panic-N.kgr. N is the number of earlier
 * panics modulo 10, so that at most ten files exist. `kingyoctl replay verify` replays the file. If
 * the panic occurred inside the core, the replay panics at the same tick. After any other panic,
 * the replay ends in the state that the core had at the panic. If the operator opened a menu page
 * for typing the PIN during the session, the replay ends at the tick in which the page opened. The
 * file contains no PIN. Its mode is 0600 because it contains settings and audits. panics.h counts
 * the panics. */
#pragma once

#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>
#include <sys/types.h>

#include "platform/kiosk/recorder/session_recorder.h"
#include "platform/panics.h"

/* State of the panic handler. The caller owns the structure and initializes it to zero. The
 * structure must stay at its address. */
struct evidence {
    /* Descriptor of the data folder plus 1. 0 means no data folder. */
    int folder;
    const char *data; /* Path of the data folder, for messages. */
    /* Session recorder. Null means that no session is recorded. */
    struct session_recorder *sessions;
    const struct core *core;
    pid_t thread; /* Id of the thread that runs the core's ticks. */
    uint64_t boot;
    /* Time of the program start, in seconds after the machine's boot (panics_up_s()). */
    uint32_t begun_s;
    /* Count of panics. The file of panics.h stores the same count. */
    struct panics panics;
    atomic_bool has_frame; /* True if the first frame was shown. */
    /* True after panic_evidence_write() has started. From then on only panic_evidence_write() uses
     * `panics`. */
    atomic_bool has_panicked;
    /* True while a thread clears `panics` after ten minutes without a panic. */
    atomic_bool is_clearing;
};

/* Opens the data folder and reads the count of panics. Call on the thread that will run the ticks,
 * before the store is opened. After three panics within ten minutes, or one panic before the first
 * frame, the stored data may be the cause of the panics. The function then copies the database and
 * deletes a part of the stored data (ledger_leave_out() in platform/store/sqlite/ledger_backup.h).
 * The result is logged. If the deletion fails, the next program start tries again. After the
 * process has run for ten minutes, a thread clears the count of panics. Without a data folder,
 * panics are reported but not counted. */
void panic_evidence_open(struct evidence *evidence, const char *data,
                         struct session_recorder *sessions, const struct core *core);

/* Records that a frame was shown. Call after the first frame. */
void panic_evidence_note_frame(struct evidence *evidence);

/* Handles a panic: stops the thread that runs the ticks, writes the replay and the count of panics,
 * and reports `reason` and the results in one line. Returns true if the core and its recordings are
 * in a consistent state. Returns false if the thread that runs the ticks may still change the core
 * or a recording, or if the panic interrupted a change. Async-signal-safe. */
bool panic_evidence_write(struct evidence *evidence, const char *reason);
