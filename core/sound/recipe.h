/* recipe.h -- the parameters of each sound of the stall, as constants for the synthesiser. */
#ifndef KINGYO_CORE_SOUND_RECIPE_H
#define KINGYO_CORE_SOUND_RECIPE_H

#include "core/sound/synth.h"

enum layer_kind {
    LAYER_NONE = 0,
    LAYER_TONE,  /* A sine whose pitch glides: bubbles, drum skins, wood. */
    LAYER_NOISE, /* Noise through a band-pass: splashes, slaps, paper. */
};

struct layer_recipe {
    uint8_t kind;         /* enum layer_kind */
    float gain;           /* Peak, about [0, 1]. */
    float delay_ms;       /* Delay after the start of the sound. */
    float attack_ms;      /* Duration of the linear rise. */
    float decay_ms;       /* Decay time to 1/e. */
    float hz_from, hz_to; /* Pitch, or centre of the band; (0, 8000]. */
    float glide_ms;       /* Time to within 1/e of hz_to; 0 stays at hz_from. */
    float damping;        /* For noise: 1 / Q of the band, (0, 2]. */
    float roughness;      /* [0, 1] random variation of the level. */
};

struct sound_recipe {
    struct layer_recipe layer[SYNTH_LAYER_MAX];
    float string_hz; /* Pitch of a plucked string, >= 190; 0: no string. */
    float string_gain;
    float string_delay_ms;
    float string_keep; /* Share of a wave that remains after one round of the delay line, (0, 1). */
    float length_ms;   /* Time until the voice is free again; all of the sound has decayed by
                          then. */
};

extern const struct sound_recipe sound_recipes[SOUND_COUNT];

#endif
