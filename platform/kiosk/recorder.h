/* recorder.h -- writes the core's inputs and checksums of the core's states to a file while the
 * game runs.
 *
 * The recorder gets each input before the tick. If the tick panics, the recording ends with the
 * input of that tick. Replaying the recording panics at the same tick. */
#ifndef KINGYO_PLATFORM_KIOSK_RECORDER_H
#define KINGYO_PLATFORM_KIOSK_RECORDER_H

#include <stdatomic.h>

#include "platform/kiosk/kiosk.h"
#include "platform/replay/replay.h"

/* Number of rounds, catches and fouls after the last tick, used to detect increases. */
struct recorder_tally {
    uint32_t rounds, caught[POI_MAX], fouls[POI_MAX];
};

struct recorder {
    struct replay_writer writer;
    struct replay_totals totals;
    struct recorder_tally tally;
    const struct core *core; /* Core whose hash is written with the last, incomplete second. */
    struct input begun;      /* Input of the current tick. Valid while is_in_tick is 1. */
    atomic_uchar is_in_tick; /* 1 while core_tick() runs. */
    atomic_uchar is_adding;  /* 1 while recorder_tick() changes `totals` and `writer`. */
};

/* Updates `totals` after a tick: ticks, rounds, caught fish, fouls, modes and players. A count that
 * decreased has restarted at 0. */
void recorder_count(struct replay_totals *totals, struct recorder_tally *tally,
                    const struct core *core);

/* Starts a recording of `core`. The core must not have run a tick and must outlive the recording.
 * Returns 0 or a negative errno. */
int recorder_begin(struct recorder *recorder, const char *path, const struct core *core);

/* Returns the recorder's callbacks for the frame loop. */
struct kiosk_tap recorder_tap(struct recorder *recorder);

/* Writes the last, incomplete second and closes the file. Returns 0, or the negative errno of the
 * first failure of the recording. */
int recorder_end(struct recorder *recorder);

/* Ends the recording in a panic. Call on the thread that runs the ticks, or while that thread is
 * stopped. An interrupted tick is written with its input and REPLAY_HASH_NONE, because its state is
 * incomplete. If the panic interrupted a write, returns -EINTR, and the file ends with its last
 * complete second. Otherwise returns 0 or a negative errno as recorder_end() does. */
int recorder_end_in_panic(struct recorder *recorder);

#endif
