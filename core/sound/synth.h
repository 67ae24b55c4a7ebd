/* synth.h -- a synthesiser with a fixed number of voices: the sounds of the stall from noise and
 * plucked tones.
 *
 * The caller owns `struct synth`. There are no samples and no allocation, so a board without a file
 * system also has sound. The synthesiser is not part of the game's state. The code runs on the
 * platform's audio thread and may not be called from two threads at once. */
#ifndef KINGYO_CORE_SOUND_SYNTH_H
#define KINGYO_CORE_SOUND_SYNTH_H

#include <stdint.h>

#include "core/output.h"

#define SYNTH_RATE_HZ 48000u
/* More voices at once are indistinct; a new sound replaces the oldest. */
#define SYNTH_VOICE_MAX 16u
#define SYNTH_LAYER_MAX 4u   /* Bursts and tones of one sound. */
#define SYNTH_PLUCK_MAX 256u /* Longest string: 48000 / 256 = 188 Hz. */

/* State of one active burst or tone. */
struct synth_layer {
    float phase;               /* For a tone: turns, [0, 1). */
    float hz;                  /* Present frequency; glides. */
    float level;               /* Envelope; decays. */
    float low, band;           /* State of the noise filter. */
    float decay, cutoff, gate; /* Factors of this control step: decay of the level, cutoff of the
                                  filter, gate of the roughness. */
};

struct synth_voice {
    uint8_t sound; /* enum sound; SOUND_NONE: free. */
    uint32_t age_frames;
    float left, right;
    uint32_t noise;                   /* State of the voice's own noise generator. */
    uint32_t string_count, string_at; /* Delay line of a plucked string; 0: no string. */
    float string[SYNTH_PLUCK_MAX];
    struct synth_layer layer[SYNTH_LAYER_MAX];
};

struct synth {
    uint32_t played; /* Sounds played so far; seeds their noise. */
    struct synth_voice voice[SYNTH_VOICE_MAX];
};

void synth_init(struct synth *synth);

/* Starts a sound at the next rendered frame. Unknown sounds are ignored; gain is clamped to [0, 1]
 * and pan to [-1, 1]. */
void synth_play(struct synth *synth, const struct sound_event *event);

/* Writes `frame_count` frames of interleaved left and right samples; levels are limited to the
 * sample format. */
void synth_render(struct synth *synth, int16_t *stereo, uint32_t frame_count);

/* Returns the number of active voices; 0 is silence. */
uint32_t synth_voices(const struct synth *synth);

#endif
