/* mixer.h -- mixes the effects, the festival music and the sounds around the stall to stereo
 * samples.
 *
 * Effects lower the music and the surroundings for a moment (ducking). A limiter with a look-ahead
 * of one block keeps the true peak below -1 dBTP.
 *
 * The caller owns `struct mixer`, which is not part of the game's state. The platform's audio
 * thread calls the mixer, and two threads must not call it at the same time. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/sound/ambience.h"
#include "core/sound/music.h"
#include "core/sound/synth.h"

/* Samples before a block from which the limiter computes the signal between two samples. */
#define MIXER_HISTORY 7u

struct mixer {
    struct synth synth;
    struct music music;
    struct ambience ambience;
    struct sound_levels levels; /* Levels that mixer_set_levels() requested. */
    struct sound_levels now;    /* Present levels. */
    float duck;                 /* Present factor on music and surroundings. */
    /* Limiter: the block that waits, its largest peak, the last samples of the block before it, and
     * the factor at its begin. */
    float waiting[2u * SOUND_BLOCK];
    float history[2][MIXER_HISTORY];
    float need, gain;
    /* Samples of the block that was rendered last, of which the first `taken` frames were
     * returned. */
    int16_t ready[2u * SOUND_BLOCK];
    uint32_t taken;
};

/* Initializes the mixer: effects at full level, no music and no surroundings. */
void mixer_init(struct mixer *mixer, uint32_t seed);

/* Sets the levels. Changes take effect smoothly within 0.1 s. A change of `song` starts the music
 * again from its first part. */
void mixer_set_levels(struct mixer *mixer, const struct sound_levels *levels);

/* Starts an effect in the next block (synth_play()). */
void mixer_play(struct mixer *mixer, const struct sound_event *event);

/* Writes `frame_count` frames, each with a left and a right sample, to `stereo`. */
void mixer_render(struct mixer *mixer, int16_t *stereo, uint32_t frame_count);
