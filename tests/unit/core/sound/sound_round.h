/* sound_round.h -- plays a round of bots and collects the sounds of each tick, for the tests and
 * the benchmark of the sound. */
#ifndef KINGYO_TESTS_UNIT_CORE_SOUND_SOUND_ROUND_H
#define KINGYO_TESTS_UNIT_CORE_SOUND_SOUND_ROUND_H

#include <stdint.h>
#include <string.h>

#include "core/core.h"

#define SOUND_ROUND_EVENTS_MAX 8192u
#define SOUND_ROUND_S 60u
/* The recording continues after the round, and contains the beginning of the result. */
#define SOUND_ROUND_TICKS_MAX ((SOUND_ROUND_S + 12u) * CORE_TICK_HZ)

struct sound_round_event {
    uint32_t tick; /* Number of ticks since the recording began. */
    struct sound_event event;
};

/* All sounds of one round, from READY to the result. */
struct sound_round {
    uint32_t count, ticks;
    uint8_t phase[SOUND_ROUND_TICKS_MAX]; /* Phase of the game in each tick. */
    struct sound_round_event events[SOUND_ROUND_EVENTS_MAX];
};

/* Plays a festival round of 60 s with `players` bots. Returns 0, or -1 if the core refused the
 * configuration. */
static inline int sound_round_play(struct sound_round *round, uint32_t players, uint32_t seed)
{
    static struct core core;
    static struct input input;
    static struct output output;
    struct core_config config = { .seed = seed,
                                  .players = (uint8_t)players,
                                  .round_s = SOUND_ROUND_S };
    memset(round, 0, sizeof *round);
    memset(&input, 0, sizeof input);
    memset(&output, 0, sizeof output);
    if (core_init(&core, &config) != CORE_OK) {
        return -1;
    }
    for (uint32_t tick = 0; round->ticks < SOUND_ROUND_TICKS_MAX && tick < 15000u; tick++) {
        const int idle = output.phase == PHASE_ATTRACT || output.phase == PHASE_MODE_SELECT;
        input.pressed = idle && round->ticks == 0 && tick % CORE_TICK_HZ == 0 ? INPUT_START : 0;
        for (uint32_t i = 0; i < players; i++) {
            input.poi[i].link = POI_SOURCE_BOT;
        }
        output.sound_count = 0;
        if (core_tick(&core, &input, &output) != CORE_OK) {
            return -1;
        }
        if (round->ticks == 0 && output.phase != PHASE_READY) {
            continue;
        }
        for (uint32_t i = 0; i < output.sound_count && round->count < SOUND_ROUND_EVENTS_MAX; i++) {
            round->events[round->count++] =
                (struct sound_round_event){ round->ticks, output.sounds[i] };
        }
        round->phase[round->ticks++] = output.phase;
    }
    return 0;
}

#endif
