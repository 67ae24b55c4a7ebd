/* recorder.h -- writes what the core is told and what it makes of it, as the game is played.
 *
 * It is handed each input before the tick: when that tick panics, the recording ends with the very
 * input, and showing it again panics again at the same place. */
#ifndef KINGYO_PLATFORM_KIOSK_RECORDER_H
#define KINGYO_PLATFORM_KIOSK_RECORDER_H

#include <stdatomic.h>

#include "platform/kiosk/kiosk.h"
#include "platform/replay.h"

/* Rounds, catches and fouls after the last tick, to see them rise. */
struct recorder_tally {
    uint32_t rounds, caught[POI_MAX], fouls[POI_MAX];
};

struct recorder {
    struct replay_writer writer;
    struct replay_totals totals;
    struct recorder_tally tally;
    const struct core *core;  /* Hashed once more for the last, begun second. */
    struct input begun;       /* Input of the running tick; valid while is_in_tick is 1. */
    atomic_uchar is_in_tick;  /* 1 while core_tick() runs. */
    atomic_uchar is_adding;   /* 1 while the tap changes `totals` and `writer`. */
};

/* Counts rounds begun, fish caught and fouls up to and with this tick, and who played what. A count
 * that fell began anew. */
void recorder_count(struct replay_totals *totals, struct recorder_tally *tally,
                    const struct core *core);

/* Begins a recording of `core`, which is fresh and outlives it. 0 or a negative errno. */
int recorder_begin(struct recorder *recorder, const char *path, const struct core *core);

/* What the frame loop calls with each tick. */
struct kiosk_tap recorder_tap(struct recorder *recorder);

/* Writes the begun second. 0 or the negative errno that the recording ended with, now or before. */
int recorder_end(struct recorder *recorder);

/* Ends the recording in a panic, on the thread that ticks the core or while that thread stands
 * still. A tick that was interrupted is written with its input and REPLAY_HASH_NONE, because its
 * state is incomplete. Returns as recorder_end() does, or -EINTR if the panic interrupted a write:
 * the file then ends with its last whole second. */
int recorder_end_in_panic(struct recorder *recorder);

#endif
