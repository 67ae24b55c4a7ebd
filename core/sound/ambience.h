/* ambience.h -- the sounds around the stall: the murmur of a crowd, cicadas, the bubbles of the air
 * pump, and the water at the rim of the tank. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/sound/tone.h"
#include "core/sound/vocal.h"

#define AMBIENCE_TALKERS 5u
#define AMBIENCE_CICADAS 2u
#define AMBIENCE_BUBBLES 8u

/* A person in the crowd, who speaks words of random syllables. */
struct ambience_talker {
    struct vocal vocal;
    struct vocal_phone phone; /* Present sound of the speech. */
    uint32_t left_blocks;     /* Blocks until the next sound. */
    uint32_t syllables;       /* Syllables left in the word; 0 during a pause. */
    struct tone pan;
};

/* An evening cicada (higurashi), whose song is a tone that beats and falls. */
struct ambience_cicada {
    struct tone wave;
    float phase; /* Phase of the beat, [0, 1). */
    uint32_t age_blocks;
    uint32_t wait_blocks; /* Blocks until the next song. */
};

/* A bubble that bursts above the air stone. */
struct ambience_bubble {
    struct tone wave;
    float hz, keep;
    struct tone pan;
};

struct ambience {
    uint32_t random;
    uint32_t blocks; /* Number of rendered blocks. */
    struct ambience_talker talker[AMBIENCE_TALKERS];
    struct ambience_cicada cicada[AMBIENCE_CICADAS];
    struct ambience_bubble bubble[AMBIENCE_BUBBLES];
    struct tone_filter trill, rim[2];
    float trill_phase;
    bool is_stone_right; /* True if the air stone is on the right; else it is on the left. */
};

void ambience_init(struct ambience *ambience, uint32_t seed);

/* Adds the next block to `mix`, SOUND_BLOCK frames of two samples. `has_pump` adds bubbles. */
void ambience_render(struct ambience *ambience, bool has_pump, float *mix);
