/* synth.h -- synthesises the sound effects of the kiosk from noise, tones, plucked strings and
 * calls of formant tones, with a fixed number of voices.
 *
 * The caller owns `struct synth`. The synthesiser uses no recorded samples and allocates no memory.
 * Therefore a board without a file system also has sound. */
#pragma once

#include <stdint.h>

#include "core/output.h"
#include "core/sound/tone.h"
#include "core/sound/vocal.h"

/* Number of voices, each of which plays one sound. If all voices are active, a new sound replaces
 * the oldest sound, because more than 24 simultaneous sounds would be indistinct. */
#define SYNTH_VOICE_MAX 24u
/* Largest number of layers of a sound. A layer is a tone or a noise burst. */
#define SYNTH_LAYER_MAX 6u
/* Largest length of a string's delay line in frames. The pitch is therefore at least 48000 / 256 =
 * 188 Hz. */
#define SYNTH_PLUCK_MAX 256u
/* Number of calls that sound at the same time. */
#define SYNTH_CALL_MAX 2u

/* State of one active layer. */
struct synth_layer {
    uint32_t delay_blocks;  /* Blocks from the start of the sound to the start of the layer. */
    float attack_per_frame; /* Rise of the level per frame during the attack. */
    float rise;             /* Progress of the attack, [0, 1]. */
    float hz, hz_to;        /* Present frequency in Hz, and frequency after the glide. */
    float glide;            /* Share of the glide in each block; 0 means no glide. */
    float level;            /* Present level, which decreases by the factor `keep` per frame. */
    float keep;
    struct tone wave, turn;    /* Oscillator of a tone. */
    struct tone_filter filter; /* Band-pass filter of a noise layer. */
};

struct synth_voice {
    /* Sound that the voice plays (enum sound). SOUND_NONE means that the voice is free. */
    uint8_t sound;
    uint32_t age_blocks, length_blocks;
    float left, right;
    uint32_t noise; /* State of the voice's own random noise generator. */
    /* Length of the string's delay line, and present position in it. A length of 0 means that the
     * sound has no string. */
    uint32_t string_count, string_at;
    uint32_t string_delay_blocks;
    float string[SYNTH_PLUCK_MAX];
    struct synth_layer layer[SYNTH_LAYER_MAX];
};

/* State of one call. */
struct synth_call {
    uint8_t call; /* Call (enum vocal_call). VOCAL_NONE means free. */
    uint32_t age_blocks;
    float left, right;
    struct vocal vocal;
};

struct synth {
    /* Number of sounds played so far, which seeds the noise generator of each new voice. */
    uint32_t played;
    uint32_t blocks; /* Number of rendered blocks. */
    /* Value of `blocks` + 1 at the last start of each sound; 0 means never. */
    uint32_t started[SOUND_COUNT];
    struct synth_voice voice[SYNTH_VOICE_MAX];
    struct synth_call call[SYNTH_CALL_MAX];
};

void synth_init(struct synth *synth);

/* Starts a sound in the next block. Unknown sounds are ignored, and so is a sound that repeats
 * earlier than its recipe permits. The gain is clamped to [0, 1], and the pan to [-1, 1]. */
void synth_play(struct synth *synth, const struct sound_event *event);

/* Adds the next block to `mix`, SOUND_BLOCK frames of a left and a right sample. */
void synth_render(struct synth *synth, float *mix);
