/* session_recorder.h -- records the running session (core/game/phases.h) in memory.
 *
 * The recorder gives the store the replay of each ranked round. In a panic, the recorder writes the
 * session to a file. Each recording starts with a snapshot, which is the configuration of the
 * session's first state. The snapshot and all later inputs stay in memory until the next session
 * starts. The caller owns `struct session_recorder` (20 MiB: static storage) and initializes it to
 * zero.
 *
 * Ranked rounds without a replay are counted. A round has no replay if the session is larger than
 * SESSION_RECORDER_SIZE or if the store is still writing an earlier replay. A round after a page
 * for a PIN has no replay either, but is not counted, because this is not a fault.
 *
 * No recording contains the operator's PIN. The PIN is withheld in the snapshot. The recording of a
 * session ends in the tick in which a page for a PIN opens, before a digit can be typed. The
 * recording also ends when it exceeds SESSION_RECORDER_MEMORY. After this end, a ranked round of
 * the session has no replay, and a panic writes only the session's part before this end. */
#pragma once

#include <stdatomic.h>
#include <stdbool.h>

#include "platform/hal.h"
#include "platform/kiosk/recorder/replayer.h"
#include "platform/replay/replay.h"

/* Maximum size of a replay in bytes. Ten minutes of attract mode take 0.1 MB. A six-axis controller
 * that changes in each tick adds 3.4 KB per second. The size is therefore sufficient for a quarter
 * of an hour with one player, or four minutes with four players. */
#define SESSION_RECORDER_SIZE (3u * 1024u * 1024u)

/* Memory for a recording in bytes. Ten minutes in which every field of every input changes in each
 * tick take 16 MiB. Four six-axis controllers write 13 KB per second, so that the memory is enough
 * for twenty minutes. A session lasts for at most ten minutes and a game (core/game/phases.h).
 * Pages that no session has reached use no physical memory. */
#define SESSION_RECORDER_MEMORY (17u * 1024u * 1024u)
/* Maximum size of one recorded second in bytes. */
#define SESSION_RECORDER_SECOND_MAX (REPLAY_CHUNK_HEAD_SIZE + REPLAY_PAYLOAD_MAX + REPLAY_SUM_SIZE)
_Static_assert(REPLAY_HEADER_MAX + 600u * SESSION_RECORDER_SECOND_MAX + REPLAY_END_SIZE <=
                   SESSION_RECORDER_MEMORY,
               "ten minutes of any input fit");

struct session_recorder {
    /* Configuration at the start of the session, with the PIN withheld (core/pin.h). The recording
     * starts with this configuration. */
    struct core_config start;
    struct replay_writer writer;
    struct replay_totals totals;
    struct recorder_tally tally;
    uint32_t seen_id;  /* Id of the newest ledger entry that was examined. */
    uint32_t round_id; /* Id of the round whose replay is in `replay`. 0 means no replay. */
    bool is_lent;      /* True while the store uses `replay`. */
    size_t replay_size;
    /* Number of ranked rounds whose replay could not be stored. Excludes rounds after a page for a
     * PIN. */
    uint32_t missed;
    struct input begun;     /* Input of the current tick. Valid while is_in_tick is true. */
    atomic_bool is_in_tick; /* True while core_tick() runs. */
    /* True between the start of session_recorder_before() and the end of
     * session_recorder_tick(). */
    atomic_bool is_busy;
    /* True if the panic handler reads the recording. The thread that runs the ticks then blocks
     * before it changes the recording. */
    atomic_bool is_frozen;
    uint8_t memory[SESSION_RECORDER_MEMORY];
    uint8_t replay[SESSION_RECORDER_SIZE];
};

/* Starts the recording of a session. Call before the first tick of a new core. */
void session_recorder_begin(struct session_recorder *sessions, const struct core *core);

/* Stores the input of the next tick. Call before each tick. */
void session_recorder_before(struct session_recorder *sessions, const struct input *input);

/* Records a tick. Call after each tick. */
void session_recorder_tick(struct session_recorder *sessions, const struct input *input,
                           const struct core *core, const struct output *output);

/* Passes the finished replay to the store after its round is on disk. Call once per frame. Returns
 * true if the store failed. */
bool session_recorder_offer(struct session_recorder *sessions, const struct hal_storage *storage);

/* ---- PIN in a recording -------------------------------------------------------------------- */

/* Withholds the PIN (core/pin.h) in the initial configuration of a recording. The core writes a
 * ledger entry if the PIN and its last logged value differ. The function therefore keeps equal
 * values equal and different values different, so that the simulated game stays the same. */
void session_recorder_withhold_pin(struct core_config *config);

/* Returns true if a stored recording may contain a PIN. `reader` is the result of opening the
 * recording in memory, successful or not. A recording may contain a PIN in three cases:
 * - The format is 7 or older. Programs of that time stored the PIN in the initial state, and
 *   recorded the digits that were typed.
 * - The initial state is valid and contains a PIN.
 * - The header's checksum was not verified, because the header is damaged or a newer program has
 *   written the recording. The format is then unknown.
 * Each program that writes format 8 or newer withholds the PIN and records no digit of a PIN.
 * Therefore a recording of such a format whose initial state or later part is damaged contains no
 * PIN. */
bool session_recorder_may_contain_pin(const struct replay_reader *reader);

/* ---- Async-signal-safe functions for the panic handler ------------------------------------- */

/* Stops all changes of the recording, so that the panic handler can write the recording. `is_own`
 * is true if the calling thread is the thread that runs the ticks. If `is_own` is false, the
 * function waits for the end of the current tick, at most SESSION_RECORDER_FREEZE_MS milliseconds.
 * Returns false if a change of the recording was interrupted or is still in progress, otherwise
 * true. */
#define SESSION_RECORDER_FREEZE_MS 200
bool session_recorder_freeze(struct session_recorder *sessions, bool is_own);

/* Returns true if there is a session to write. */
bool session_recorder_has_begun(const struct session_recorder *sessions);

/* Returns the tick before which session_recorder_dump() ends. The result is `tick`, the core's
 * tick, if the recording still runs. The result is less if a page for a PIN was opened, if the
 * memory became full, or if a change of the recording was interrupted (`is_sound` is false). */
uint32_t session_recorder_end_tick(const struct session_recorder *sessions, uint32_t tick,
                                   bool is_sound);

/* Writes the session to the descriptor `fd`. session_recorder_freeze() must be called first, and
 * `is_sound` is the value that it returned. An interrupted tick is written with its input and
 * REPLAY_HASH_NONE. Returns 0 or a negative errno. */
int session_recorder_dump(struct session_recorder *sessions, const struct core *core, bool is_sound,
                          int fd);
