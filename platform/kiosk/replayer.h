/* replayer.h -- plays a recording in the core and compares the states with the recorded
 * checksums. */
#ifndef KINGYO_PLATFORM_KIOSK_REPLAYER_H
#define KINGYO_PLATFORM_KIOSK_REPLAYER_H

#include "platform/config/options.h"
#include "platform/kiosk/kiosk.h"
#include "platform/kiosk/recorder.h"
#include "platform/replay/replay.h"

/* First tick whose digest, or whose second's hash, differs from the recording. */
struct replay_difference {
    uint8_t found;
    uint8_t is_full; /* 1: the digest was equal, but the full hash or a count was not. */
    uint32_t tick;   /* Counted from 0. */
    uint64_t recorded, computed;
};

struct replayer {
    struct replay_reader reader;
    struct replay_totals totals; /* Totals computed so far. */
    struct recorder_tally tally;
    struct replay_difference difference;
    uint8_t damaged; /* 1: the file is invalid; see reader.problem. */
};

/* Opens a recording and sets `config` to its initial state. Returns 0, or -1 with
 * reader.problem. */
int replayer_begin(struct replayer *replayer, const char *path, struct core_config *config);

/* Opens a recording in the caller's memory, which must outlive the replay. */
int replayer_begin_in(struct replayer *replayer, const uint8_t *bytes, size_t size,
                      struct core_config *config);

/* Return the input source for the frame loop, and the callbacks that compare each tick. */
struct kiosk_source replayer_source(struct replayer *replayer);
struct kiosk_tap replayer_tap(struct replayer *replayer);

/* Returns 1 if a panic interrupted the newest tick, so that no state was recorded after it. */
int replayer_is_interrupted(const struct replayer *replayer);

/* Closes the recording. */
void replayer_end(struct replayer *replayer);

/* Writes one line to standard error, "SPEAKER: PATH: byte N: ...". Returns the matching exit
 * code. */
enum exit_code replayer_print_problem(const char *speaker, const char *path,
                                      const struct replay_problem *problem);

#endif
