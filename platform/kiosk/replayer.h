/* replayer.h -- plays a recording to the core and holds the outcome against what was recorded. */
#ifndef KINGYO_PLATFORM_KIOSK_REPLAYER_H
#define KINGYO_PLATFORM_KIOSK_REPLAYER_H

#include "platform/kiosk/kiosk.h"
#include "platform/kiosk/options.h"
#include "platform/kiosk/recorder.h"
#include "platform/replay.h"

/* The first tick whose digest, or whose second's hash, is not the recorded one. */
struct replay_difference {
    uint8_t found;
    uint8_t is_full;             /* The digest agreed and the full hash or a count did not. */
    uint32_t tick;               /* From 0. */
    uint64_t recorded, computed;
};

struct replayer {
    struct replay_reader reader;
    struct replay_totals totals; /* As computed so far. */
    struct recorder_tally tally;
    struct replay_difference difference;
    uint8_t damaged;             /* The file ended in an error: reader.problem. */
};

/* Opens a recording; `config` gets what its core began with. 0, or -1 with reader.problem. */
int replayer_begin(struct replayer *replayer, const char *path, struct core_config *config);

/* The same of one in the caller's memory, which outlives the play. */
int replayer_begin_in(struct replayer *replayer, const uint8_t *bytes, size_t size,
                      struct core_config *config);

/* In place of the devices, and after each tick. */
struct kiosk_source replayer_source(struct replayer *replayer);
struct kiosk_tap replayer_tap(struct replayer *replayer);

/* Returns whether a panic interrupted the newest tick, so that no state was recorded after it. */
int replayer_is_interrupted(const struct replayer *replayer);

void replayer_end(struct replayer *replayer);

/* One line on standard error, "SPEAKER: PATH: byte N: ...". Returns the exit code that fits. */
enum exit_code replayer_tell_problem(const char *speaker, const char *path,
                                     const struct replay_problem *problem);

#endif
