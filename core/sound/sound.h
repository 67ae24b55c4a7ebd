/* sound.h -- a fixed-voice synthesiser: the stall's sounds, made of noise and plucked tones.
 *
 * The caller owns `struct synth`; there are no samples and no allocation, so a board without a
 * file system still sounds. It is no part of the game's state: it runs on the platform's audio
 * thread and may not be called from two threads at once. */
#ifndef KINGYO_CORE_SOUND_SOUND_H
#define KINGYO_CORE_SOUND_SOUND_H

#include <stdint.h>

#include "core/output.h"

#define SYNTH_RATE_HZ 48000u
#define SYNTH_VOICE_MAX 16u  /* More at once are a blur; the oldest gives way. */
#define SYNTH_LAYER_MAX 4u   /* Bursts and tones that make one sound. */
#define SYNTH_PLUCK_MAX 256u /* Longest string: 48000 / 256 = 188 Hz. */

/* One burst or tone while it sounds. */
struct synth_layer {
    float phase;          /* Tone: turns, [0, 1). */
    float hz;             /* Now; glides. */
    float level;          /* Envelope, decays. */
    float low, band;      /* State of the noise filter. */
    float decay, cutoff, gate; /* For this control step: of the level, of the filter, roughness. */
};

struct synth_voice {
    uint8_t sound;        /* enum sound; SOUND_NONE: free. */
    uint32_t age_frames;
    float left, right;
    uint32_t noise;       /* State of its own noise. */
    uint32_t string_count, string_at; /* Delay line of a plucked string; 0: none. */
    float string[SYNTH_PLUCK_MAX];
    struct synth_layer layer[SYNTH_LAYER_MAX];
};

struct synth {
    uint32_t played;      /* Sounds so far; seeds their noise. */
    struct synth_voice voice[SYNTH_VOICE_MAX];
};

void synth_init(struct synth *synth);

/* Starts a sound with the next rendered frame. Unknown sounds are not heard; gain is clamped to
 * [0, 1] and pan to [-1, 1]. */
void synth_play(struct synth *synth, const struct sound_event *event);

/* Writes `frame_count` frames of interleaved left and right; never louder than the format holds. */
void synth_render(struct synth *synth, int16_t *stereo, uint32_t frame_count);

/* How many voices sound now; 0 is silence. */
uint32_t synth_voices(const struct synth *synth);

#endif
