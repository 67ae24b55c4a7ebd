/* recipe.h -- defines the parameters of each sound of the kiosk, as constants for the synthesiser
 * (synth.h).
 *
 * A sound consists of layers (tones and noise), at most one plucked string and one call. */
#pragma once

#include "core/sound/synth.h"

enum layer_kind {
    LAYER_NONE = 0,
    LAYER_TONE,  /* A sine wave whose pitch glides. Used for bubbles, drum skins and wood. */
    LAYER_NOISE, /* Noise through a band-pass filter. Used for splashes, slaps and paper. */
};

struct layer_recipe {
    uint8_t kind;    /* Kind of the layer (enum layer_kind). */
    float gain;      /* Peak level of the layer, about 0 to 1. */
    float delay_ms;  /* Delay of the layer after the start of the sound. */
    float attack_ms; /* Duration of the linear rise to the peak level. */
    float decay_ms;  /* Time in which the level decreases to 1/e. */
    /* Pitch of a tone, or centre frequency of a noise band: `hz_from` at the start and `hz_to`
     * after the glide, each in (0, 8000]. */
    float hz_from, hz_to;
    /* Time constant of the glide from hz_from to hz_to; 0 means that the frequency stays at
     * hz_from. */
    float glide_ms;
    /* Damping of a noise layer's band-pass filter, (0, 2]: the inverse of its quality factor Q. A
     * larger value passes a wider band. */
    float damping;
    float roughness; /* Strength [0, 1] of the random changes of a noise layer's level. */
};

struct sound_recipe {
    struct layer_recipe layer[SYNTH_LAYER_MAX];
    /* Pitch of the plucked string in Hz, at least 190; 0 means that the sound has no string. */
    float string_hz;
    float string_gain;
    float string_delay_ms;
    /* Factor (0, 1) by which each pass through the delay line weakens the string's wave. */
    float string_keep;
    uint8_t call;   /* Call that begins with the sound (enum vocal_call); VOCAL_NONE means none. */
    float vary;     /* Largest random change of the pitch as a share; 0 means no change. */
    float apart_ms; /* Shortest time between two starts of the sound; 0 means no limit. */
    /* Duration of the sound, after which its voice is free. All layers and the string must be
     * inaudible when the duration ends. */
    float length_ms;
};

extern const struct sound_recipe sound_recipes[SOUND_COUNT];
