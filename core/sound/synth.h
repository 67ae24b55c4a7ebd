/* synth.h -- a synthesiser with a fixed number of voices for the sounds of the kiosk: noise, tones
 * and plucked strings.
 *
 * The caller owns `struct synth`. The synthesiser uses no recorded samples and allocates no memory,
 * so that a board without a file system also has sound. The synthesiser is not part of the game's
 * state. The platform's audio thread calls the synthesiser, and two threads must not call it at the
 * same time. */
#ifndef KINGYO_CORE_SOUND_SYNTH_H
#define KINGYO_CORE_SOUND_SYNTH_H

#include <stdint.h>

#include "core/output.h"

#define SYNTH_RATE_HZ 48000u
/* Number of voices. More simultaneous sounds would be indistinct, so that a new sound replaces the
 * oldest sound if all voices are active. */
#define SYNTH_VOICE_MAX 16u
#define SYNTH_LAYER_MAX 4u /* Largest number of layers (noise bursts and tones) of a sound. */
/* Longest delay line of a string in frames, which limits the pitch to at least 48000 / 256 = 188
 * Hz. */
#define SYNTH_PLUCK_MAX 256u

/* State of one active layer. */
struct synth_layer {
    float phase;               /* Phase of a tone in turns, [0, 1). */
    float hz;                  /* Present frequency, which glides. */
    float level;               /* Present level, which decays. */
    float low, band;           /* State of the noise filter. */
    float decay, cutoff, gate; /* Factors of the present control step: decay of the level per frame,
                                  cutoff of the noise filter, and gain by roughness. */
};

struct synth_voice {
    uint8_t sound; /* Sound of the voice (enum sound); SOUND_NONE means that the voice is free. */
    uint32_t age_frames;
    float left, right;
    uint32_t noise;                   /* State of the voice's own noise generator. */
    uint32_t string_count, string_at; /* Length and position of the string's delay line; a length of
                                         0 means no string. */
    float string[SYNTH_PLUCK_MAX];
    struct synth_layer layer[SYNTH_LAYER_MAX];
};

struct synth {
    uint32_t played; /* Number of sounds played so far, which seeds the noise of each sound. */
    struct synth_voice voice[SYNTH_VOICE_MAX];
};

void synth_init(struct synth *synth);

/* Starts a sound at the next rendered frame. Unknown sounds are ignored, gain is clamped to [0, 1],
 * and pan is clamped to [-1, 1]. */
void synth_play(struct synth *synth, const struct sound_event *event);

/* Writes `frame_count` frames of interleaved left and right samples. Levels are limited to the
 * range of the sample format. */
void synth_render(struct synth *synth, int16_t *stereo, uint32_t frame_count);

/* Returns the number of active voices; 0 means silence. */
uint32_t synth_voices(const struct synth *synth);

#endif
