/* output.h -- everything the core asks of the world. The core appends and never reads it back.
 *
 * The frame loop clears the sounds once a frame, lets the ticks append, then serves them. */
#ifndef KINGYO_CORE_OUTPUT_H
#define KINGYO_CORE_OUTPUT_H

#include <stdint.h>

#include "core/input.h"

#define OUTPUT_SOUND_MAX 16u /* A frame's worth; more in one frame could not be told apart. */

enum sound {
    SOUND_NONE = 0,
    SOUND_DIP,     /* The ring enters the water. */
    SOUND_LIFT,    /* The ring leaves it, dripping. */
    SOUND_CATCH,   /* A fish lands in the bowl. */
    SOUND_SLAP,    /* A tail hits the paper. */
    SOUND_TEAR,    /* A hole opens. */
    SOUND_GONE,    /* The paper can hold nothing any more. */
    SOUND_START,   /* A round begins. */
    SOUND_TICK,    /* Each of the last seconds. */
    SOUND_RESULT,  /* The round is over. */
    SOUND_COUNT,
};

struct sound_event {
    uint8_t sound; /* enum sound */
    float gain;    /* (0, 1] */
    float pan;     /* -1 left .. 1 right */
};

/* The reaction on the hand that holds the poi, in the world's axes. */
struct poi_force {
    vec3 force_n;
    vec3 torque_n_m;
};

/* What the operator's store keeps of a finished round. `id` rises by one with each record. */
struct round_record {
    uint32_t id; /* 0: nothing to save. */
    uint32_t seed;
    uint32_t start_tick, end_tick;
    uint32_t caught;
    uint8_t by_bot; /* A demonstration is not a score. */
};

struct output {
    uint32_t sound_count; /* <= OUTPUT_SOUND_MAX; further sounds of the frame are not heard. */
    struct sound_event sounds[OUTPUT_SOUND_MAX];
    struct poi_force poi[POI_MAX];
    uint8_t start_lamp; /* Level. */
    struct round_record record; /* The newest; stays until the next, for a store that is busy. */
};

/* Appends one sound, or drops it when the frame already has OUTPUT_SOUND_MAX. */
static inline void output_sound(struct output *output, enum sound sound, float gain, float pan)
{
    if (output->sound_count < OUTPUT_SOUND_MAX) {
        output->sounds[output->sound_count++] =
            (struct sound_event){ .sound = (uint8_t)sound, .gain = gain, .pan = pan };
    }
}

#endif
