/* twin.h -- recomputes the game of a kiosk in the guest, outside the guest, from the recording that
 * the kiosk writes.
 *
 * The core is a pure function of its inputs, so the recorded inputs give exactly the same game. The
 * digests in the recording prove this for each tick. A test thus has the complete state of the
 * kiosk, at most a second late, without test code in the kiosk. */
#ifndef KINGYO_TESTS_VM_TWIN_H
#define KINGYO_TESTS_VM_TWIN_H

#include <stdint.h>

#include "core/core.h"
#include "platform/replay/replay.h"

struct twin {
    const char *path; /* Path of the recording, which the kiosk may still extend. */
    struct replay_reader reader;
    struct core core;
    struct input input; /* Input of the newest tick. */
    struct output output;
    uint32_t ticks;      /* Number of ticks that were run so far. */
    uint32_t coins;      /* Total number of coins in all inputs. */
    uint32_t presses[9]; /* Number of presses of each button, indexed by the bit of enum
                              input_button. */
    uint32_t caught; /* Number of landed fish according to the totals stored in the recording. */
    /* Number of times that the first poi was lost after it had been present. */
    uint32_t lost_spans;
    uint32_t lost_ticks; /* Number of ticks of the newest loss of the first poi. */
    /* Number of ticks in which a round was paused because a controller was lost. */
    uint32_t paused_ticks;
    uint32_t differs_at; /* First tick whose digest differs from the kiosk's; 0 means none. */
    uint32_t start_tick; /* Tick of the first press of START. */
    /* First tick of a round in which the first poi is in the water; 0 means none. */
    uint32_t dip_tick;
    uint8_t was_live, begun;
};

/* Runs the new ticks of the recording on the twin's core. Returns 1 if there were new ticks, and 0
 * if there were none or the recording is incomplete. Returns -1 if the recording is invalid or a
 * digest differs (differs_at). Before the first call all members except `path` must be 0. */
int twin_follow(struct twin *twin);

/* Runs one tick of any core with the caller's input, to simulate a possible future. */
void twin_tick(struct core *core, const struct input *input, struct output *output);

#endif
