/* session_recorder.h -- records the running session (core/game/session.h) in memory.
 *
 * Gives the store the replay of each ranked round, and writes the session to a file in a panic. A
 * session's recording begins with the configuration of its first state, so that memory always holds
 * a snapshot and every later input. The caller owns `struct session_recorder` (20 MiB: static
 * storage) and clears it.
 *
 * A ranked round has no replay in three cases, which are counted. The session has grown beyond
 * SESSION_RECORDER_SIZE. The store is still writing an earlier replay. Or digits of the PIN were
 * typed during the session. A session that grows beyond SESSION_RECORDER_MEMORY ends its recording;
 * a panic then writes the session up to that point. */
#ifndef KINGYO_PLATFORM_KIOSK_SESSION_RECORDER_H
#define KINGYO_PLATFORM_KIOSK_SESSION_RECORDER_H

#include <stdatomic.h>

#include "platform/hal.h"
#include "platform/kiosk/recorder.h"
#include "platform/replay/replay.h"

/* Largest replay in bytes. Ten minutes of attract take 0.1 MB. After that, a six-axis controller
 * that changes at each tick writes 3.4 KB a second: a quarter of an hour for one player, four
 * minutes for four. */
#define SESSION_RECORDER_SIZE (3u * 1024u * 1024u)

/* Memory for a recording in bytes. Ten minutes in which every field of every input changes at each
 * tick take 16 MiB. Four six-axis controllers write 13 KB a second, which gives twenty minutes:
 * attract and the longest round with its pauses. Pages that no session has reached take no physical
 * memory. */
#define SESSION_RECORDER_MEMORY (17u * 1024u * 1024u)
#define SESSION_RECORDER_SECOND_MAX (REPLAY_CHUNK_HEAD_SIZE + REPLAY_PAYLOAD_MAX + REPLAY_SUM_SIZE)
_Static_assert(REPLAY_HEADER_MAX + 600u * SESSION_RECORDER_SECOND_MAX + REPLAY_END_SIZE <=
                   SESSION_RECORDER_MEMORY,
               "ten minutes of any input fit");

struct session_recorder {
    struct core_config start; /* Start of the session with its PIN withheld (core/pin.h), which
                                 replaces the true start in each replay that the store keeps. */
    struct replay_writer writer;
    struct replay_totals totals;
    struct recorder_tally tally;
    uint32_t seen_id;  /* Newest ledger entry that was examined. */
    uint32_t round_id; /* Round of the replay in `replay`; 0: none. */
    uint8_t is_lent;   /* 1: the store uses `replay`. */
    uint8_t is_sealed; /* 1: the checksums of `replay` are updated. */
    struct replay_seal seal;
    uint8_t has_pin; /* 1: digits of a PIN were typed in this session, so that no replay of it is
                        kept. */
    size_t replay_size;
    uint32_t missed;         /* Ranked rounds whose replay could not be kept. */
    struct input begun;      /* Input of the running tick; valid while is_in_tick is 1. */
    atomic_uchar is_in_tick; /* 1 while core_tick() runs. */
    atomic_uchar
        is_busy; /* From session_recorder_before() to the end of session_recorder_tick(). */
    atomic_uchar is_frozen; /* 1: a panic reads the recording. The thread that runs the ticks blocks
                               before any further change. */
    uint8_t memory[SESSION_RECORDER_MEMORY];
    uint8_t replay[SESSION_RECORDER_SIZE];
};

/* Starts the recording. Call before the first tick of a new core. */
void session_recorder_begin(struct session_recorder *chapters, const struct core *core);

/* Call before each tick, with its input. */
void session_recorder_before(struct session_recorder *chapters, const struct input *input);

/* Call after each tick. */
void session_recorder_tick(struct session_recorder *chapters, const struct input *input,
                           const struct core *core, const struct output *output);

/* Bytes of a replay whose checksums one frame updates, which takes 0.2 ms. SESSION_RECORDER_SIZE
 * bytes take 4 ms and are spread over 24 frames. */
#define SESSION_RECORDER_SEAL_SIZE (128u * 1024u)

/* Updates checksums of the waiting replay, SESSION_RECORDER_SEAL_SIZE at a time, and then passes
 * the replay to the store once its round is on disk. Call once a frame. Returns 1 if the store
 * failed. */
int session_recorder_offer(struct session_recorder *chapters, const struct hal_storage *storage);

/* ---- The PIN in a recording ------------------------------------------------------------------ */

/* Withholds the PIN (core/pin.h) in the start of a recording without a change of the game. Each
 * pair of setting and logged value stays equal or different, because the core writes an entry if
 * they differ. `told` is the logged value of a running core, or null. */
void session_recorder_withhold_pin(struct core_config *config, int32_t *told);

/* Returns 1 if the start of a recording contains a PIN. */
int session_recorder_start_has_pin(const struct core_config *config);

/* Returns 1 if digits of a PIN are being typed, so that the inputs of the recording contain
 * them. */
int session_recorder_types_pin(const struct core *core);

/* ---- In a panic: async-signal-safe ---------------------------------------------------------- */

/* Stops further changes. `is_own`: the caller is the thread that runs the ticks. Another thread
 * waits for the end of a running tick, SESSION_RECORDER_FREEZE_MS at most. Returns 1, or 0 if a
 * change was interrupted. */
#define SESSION_RECORDER_FREEZE_MS 200
int session_recorder_freeze(struct session_recorder *chapters, int is_own);

/* Returns 1 if there is a session to write. */
int session_recorder_has_begun(const struct session_recorder *chapters);

/* Writes the session. `is_sound` is the return value of session_recorder_freeze(), which must be
 * called before. A tick that was interrupted is written with its input and REPLAY_HASH_NONE.
 * Returns 0 or a negative errno. */
int session_recorder_dump(struct session_recorder *chapters, const struct core *core, int is_sound,
                          int fd);

#endif
