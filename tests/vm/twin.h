/* twin.h -- the stall in the guest, computed once more outside of it from the recording it writes.
 *
 * The core is a pure function of its inputs: what the kiosk recorded, ticked again here, is the
 * very stall that runs there, and each tick's digest proves it. So a test knows all of the kiosk's
 * mind, at most a second late, without a word of the kiosk's for tests. */
#ifndef KINGYO_TESTS_VM_TWIN_H
#define KINGYO_TESTS_VM_TWIN_H

#include <stdint.h>

#include "core/core.h"
#include "platform/replay.h"

struct twin {
    const char *path;        /* Of the recording, which may still grow. */
    struct replay_reader reader;
    struct core core;
    struct input input;      /* Of the newest tick. */
    struct output output;
    uint32_t ticks;          /* Taken so far. */
    uint32_t coins;          /* Of all inputs. */
    uint32_t presses[9];     /* Of each button, by the bit of enum input_button. */
    uint32_t caught;         /* Fish landed, by the recording's own count. */
    uint32_t lost_spans;     /* How often the first poi went away after it had been here, ... */
    uint32_t lost_ticks;     /* ... and for how long, the last time. */
    uint32_t paused_ticks;   /* In which a round waited for it. */
    uint32_t differs_at;     /* The first tick that is not the kiosk's; 0: none. */
    uint8_t was_live, begun;
};

/* Takes what the recording has by now. 1: there was more; 0: nothing new, or not whole yet; -1: it
 * is not the kiosk's play (differs_at), or none at all. A zeroed twin with a path begins. */
int twin_follow(struct twin *twin);

/* One tick of any core on a hand's own input: what would be. */
void twin_tick(struct core *core, const struct input *input, struct output *output);

#endif
