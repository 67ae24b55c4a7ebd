/* replayer.h -- records the core's inputs to a file while the game runs, plays a recording in the
 * core, and compares the states with the recorded checksums.
 *
 * The frame loop (kiosk.h) calls the recorder and the replayer through two callbacks. */
#pragma once

#include <stdatomic.h>
#include <stdbool.h>

#include "core/core.h"
#include "platform/config/options.h"
#include "platform/replay/replay.h"

/* ---- Callbacks of the frame loop ----------------------------------------------------------- */

/* Callbacks for a recorder. `before` gets the input before each tick; `tick` gets the input and the
 * core's state after each tick. The callbacks must not change their arguments. */
struct kiosk_tap {
    /* Callback before each tick. May be null. */
    void (*before)(void *self, const struct input *input);
    void (*tick)(void *self, const struct input *input, const struct core *core);
    void *self;
};

/* Callback that provides each tick's input in place of the devices. Used to play a recording
 * (replayer_source()). */
struct kiosk_source {
    /* Writes the input of the next tick. Returns 1, or 0 at the end of the recording. */
    int (*next)(void *self, struct input *out);
    void *self;
};

/* ---- Recording to a file ------------------------------------------------------------------- */

/* Writes the core's inputs and checksums of the core's states to a file while the game runs.
 *
 * The recorder gets each input before the tick. If the tick panics, the recording ends with the
 * input of that tick. Replaying the recording panics at the same tick. */

/* Numbers of rounds, catches and fouls after the previous tick, used to detect increases. */
struct recorder_tally {
    uint32_t rounds, caught[POI_MAX], fouls[POI_MAX];
};

struct recorder {
    struct replay_writer writer;
    struct replay_totals totals;
    struct recorder_tally tally;
    /* Core that is recorded. recorder_end() writes the last, incomplete second with the hash of the
     * core's state. */
    const struct core *core;
    struct input begun;     /* Input of the current tick. Valid while is_in_tick is true. */
    atomic_bool is_in_tick; /* True while core_tick() runs. */
    atomic_bool is_adding;  /* True while recorder_tick() changes `totals` and `writer`. */
};

/* Updates `totals` after a tick: the numbers of ticks, rounds, caught fish and fouls, and the modes
 * and players. If a count is lower than in `tally`, the count has restarted at 0. */
void recorder_count(struct replay_totals *totals, struct recorder_tally *tally,
                    const struct core *core);

/* Calls recorder_count() after a tick of `core`, and adds the tick's input and digest to the
 * recording. */
void recorder_add_tick(struct replay_writer *writer, struct replay_totals *totals,
                       struct recorder_tally *tally, const struct input *input,
                       const struct core *core);

/* Starts a recording of `core`. The core must not have run a tick and must outlive the recording.
 * Returns 0 or a negative errno. */
int recorder_begin(struct recorder *recorder, const char *path, const struct core *core);

/* Returns the recorder's callbacks for the frame loop. */
struct kiosk_tap recorder_tap(struct recorder *recorder);

/* Writes the last, incomplete second and closes the file. Returns 0, or the negative errno of the
 * first failure of the recording. */
int recorder_end(struct recorder *recorder);

/* Ends the recording during a panic. Call on the thread that runs the ticks, or while that thread
 * is stopped. A tick that the panic interrupted is written with its input and REPLAY_HASH_NONE,
 * because the state after the tick is incomplete. If the panic interrupted a write, returns -EINTR,
 * and the file ends with its last complete second. Otherwise returns 0 or a negative errno as
 * recorder_end() does. */
int recorder_end_in_panic(struct recorder *recorder);

/* ---- Playing a recording ------------------------------------------------------------------- */

/* First difference between the simulation and the recording. */
struct replay_difference {
    bool found;
    /* True if the difference is in the full hash or in a count, which are compared at the end of
     * each recorded second. False if the difference is in the short digest, which is compared at
     * each tick. */
    bool is_full;
    /* Tick at which the simulation first differs from the recording, counted from 0. */
    uint32_t tick;
    uint64_t recorded, computed;
};

struct replayer {
    struct replay_reader reader;
    struct replay_totals totals; /* Totals of the simulation so far. */
    struct recorder_tally tally;
    struct replay_difference difference;
    bool damaged; /* True if the recording's file is invalid; see reader.problem. */
};

/* Opens the recording `path` and writes its initial state to `config`. Returns 0, or -1 and sets
 * reader.problem. */
int replayer_begin(struct replayer *replayer, const char *path, struct core_config *config);

/* Opens a recording that is stored in the `size` bytes at `bytes`. Works like replayer_begin() in
 * all other respects. `bytes` must remain valid until the replay ends. */
int replayer_begin_in(struct replayer *replayer, const uint8_t *bytes, size_t size,
                      struct core_config *config);

/* replayer_source() returns the input source for the frame loop. replayer_tap() returns the
 * callbacks that compare each tick. */
struct kiosk_source replayer_source(struct replayer *replayer);
struct kiosk_tap replayer_tap(struct replayer *replayer);

/* Returns true if a panic interrupted the newest tick of the recording. The recording then contains
 * no state after this tick. */
bool replayer_is_interrupted(const struct replayer *replayer);

/* Closes the recording. */
void replayer_end(struct replayer *replayer);

/* Writes one line to standard error: "SPEAKER: PATH: byte N: ...". Returns the exit code for the
 * problem. */
enum exit_code replayer_print_problem(const char *prefix, const char *path,
                                      const struct replay_problem *problem);
