/* synth.h -- synthesises the sounds of the kiosk from noise, tones and plucked strings, with a
 * fixed number of voices.
 *
 * The caller owns `struct synth`. The synthesiser uses no recorded samples and allocates no memory.
 * Therefore a board without a file system also has sound. The state of the synthesiser is not part
 * of the game's state. The platform's audio thread calls the synthesiser, and two threads must not
 * call it at the same time. */
#pragma once

#include <stdint.h>

#include "core/output.h"

#define SYNTH_RATE_HZ 48000u
/* Number of voices, each of which plays one sound. If all voices are active, a new sound replaces
 * the oldest sound, because more than 16 simultaneous sounds would be indistinct. */
#define SYNTH_VOICE_MAX 16u
/* Largest number of layers of a sound. A layer is a tone or a noise burst. */
#define SYNTH_LAYER_MAX 4u
/* Largest length of a string's delay line in frames. The pitch is therefore at least 48000 / 256 =
 * 188 Hz. */
#define SYNTH_PLUCK_MAX 256u

/* State of one active layer. */
struct synth_layer {
    uint32_t delay_frames;  /* Frames from the start of the sound to the start of the layer. */
    float attack_per_frame; /* Rise of the level per frame during the attack. */
    float phase;            /* Phase of a tone in turns, [0, 1). */
    float hz;               /* Present frequency in Hz, which changes during the glide. */
    float level;            /* Present level, which decreases over time. */
    float low, band;        /* State variables of the band-pass filter for noise. */
    /* Values for the present control step. `decay` is the factor by which the level falls per
     * frame, `cutoff` is the cutoff coefficient of the noise filter, and `gate` is a random gain
     * that makes the noise rough. */
    float decay, cutoff, gate;
};

struct synth_voice {
    /* Sound that the voice plays (enum sound). SOUND_NONE means that the voice is free. */
    uint8_t sound;
    uint32_t age_frames;
    float left, right;
    uint32_t noise; /* State of the voice's own random noise generator. */
    /* Length of the string's delay line, and present position in it. A length of 0 means that the
     * sound has no string. */
    uint32_t string_count, string_at;
    float string[SYNTH_PLUCK_MAX];
    struct synth_layer layer[SYNTH_LAYER_MAX];
};

struct synth {
    /* Number of sounds played so far, which seeds the noise generator of each new voice. */
    uint32_t played;
    struct synth_voice voice[SYNTH_VOICE_MAX];
};

void synth_init(struct synth *synth);

/* Starts a sound at the next rendered frame. Unknown sounds are ignored. The gain is clamped to [0,
 * 1], and the pan is clamped to [-1, 1]. */
void synth_play(struct synth *synth, const struct sound_event *event);

/* Writes `frame_count` frames, each with a left and a right sample, to `stereo`. The levels are
 * limited to the range of int16_t. */
void synth_render(struct synth *synth, int16_t *stereo, uint32_t frame_count);
