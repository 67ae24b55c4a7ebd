/* replayer.h -- plays a recording in the core and compares the states with the recorded
 * checksums. */
#ifndef KINGYO_PLATFORM_KIOSK_REPLAYER_H
#define KINGYO_PLATFORM_KIOSK_REPLAYER_H

#include "platform/config/options.h"
#include "platform/kiosk/kiosk.h"
#include "platform/kiosk/recorder.h"
#include "platform/replay/replay.h"

/* First difference between the simulation and the recording. */
struct replay_difference {
    uint8_t found;
    /* 1 if the difference is in the full hash or in a count, which are compared at the end of each
     * recorded second. 0 if the difference is in the short digest, which is compared at each
     * tick. */
    uint8_t is_full;
    uint32_t tick; /* Tick of the difference, counted from 0. */
    uint64_t recorded, computed;
};

struct replayer {
    struct replay_reader reader;
    struct replay_totals totals; /* Totals of the simulation so far. */
    struct recorder_tally tally;
    struct replay_difference difference;
    uint8_t damaged; /* 1 if the file is invalid; see reader.problem. */
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

/* Returns 1 if a panic interrupted the newest tick, so that the recording has no state after it.
 * Otherwise returns 0. */
int replayer_is_interrupted(const struct replayer *replayer);

/* Closes the recording. */
void replayer_end(struct replayer *replayer);

/* Writes one line to standard error: "SPEAKER: PATH: byte N: ...". Returns the exit code for the
 * problem. */
enum exit_code replayer_print_problem(const char *speaker, const char *path,
                                      const struct replay_problem *problem);

#endif
