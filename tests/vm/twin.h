/* twin.h -- recomputes the game of a kiosk in the guest from the recording that the kiosk writes.
 * The program that uses this module runs outside the guest.
 *
 * The core is a pure function of its inputs, so the recorded inputs give exactly the same game. The
 * digests in the recording prove this for each tick. A test thus has the complete state of the
 * kiosk, at most a second late, without any test code in the kiosk. */
#ifndef KINGYO_TESTS_VM_TWIN_H
#define KINGYO_TESTS_VM_TWIN_H

#include <stdint.h>

#include "core/core.h"
#include "platform/replay/replay.h"

struct twin {
    const char *path; /* Path of the recording, which the kiosk may still be writing. */
    struct replay_reader reader;
    struct core core;
    struct input input; /* Input of the newest tick that was run. */
    struct output output;
    uint32_t ticks;      /* Number of ticks that the twin has run. */
    uint32_t coins;      /* Number of coins in the inputs of all ticks. */
    uint32_t presses[9]; /* Number of presses of each button, indexed by the number of its bit in
                            enum input_button. */
    uint32_t caught;     /* Number of landed fish, from the totals in the recording. */
    /* Number of times that the first poi was lost after it had been present. */
    uint32_t lost_spans;
    uint32_t lost_ticks; /* Duration of the newest loss of the first poi, in ticks. */
    /* Number of ticks in which a round paused because a controller was lost. */
    uint32_t paused_ticks;
    uint32_t differs_at; /* First tick whose digest differs from the recorded one. 0 means that no
                            digest differs. */
    uint32_t start_tick; /* Tick in which START was first pressed. */
    /* First tick of a round in which the first poi is in the water. 0 means that there is none
     * yet. */
    uint32_t dip_tick;
    uint8_t was_live, begun;
};

/* Runs the new ticks of the recording on the twin's core. Returns 1 if there were new ticks, and 0
 * if there were none or the recording is still incomplete. Returns -1 if the recording is invalid
 * or a digest differs (differs_at). Before the first call, all members except `path` must be 0. */
int twin_follow(struct twin *twin);

/* Runs one tick of any core with the input of the caller, to simulate a possible future of the
 * game. */
void twin_tick(struct core *core, const struct input *input, struct output *output);

#endif
