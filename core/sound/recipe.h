/* recipe.h -- how each sound of the stall is made: the synthesiser's score, as constants. */
#ifndef KINGYO_CORE_SOUND_RECIPE_H
#define KINGYO_CORE_SOUND_RECIPE_H

#include "core/sound/sound.h"

enum layer_kind {
    LAYER_NONE = 0,
    LAYER_TONE,  /* A sine whose pitch glides: bubbles, drum skins, wood. */
    LAYER_NOISE, /* Noise through a band-pass: splashes, slaps, paper. */
};

struct layer_recipe {
    uint8_t kind;     /* enum layer_kind */
    float gain;       /* Peak, about [0, 1]. */
    float delay_ms;   /* After the sound begins. */
    float attack_ms;  /* Linear rise. */
    float decay_ms;   /* To 1/e. */
    float hz_from, hz_to; /* Pitch, or centre of the band; (0, 8000]. */
    float glide_ms;   /* To within 1/e of hz_to; 0 stays at hz_from. */
    float damping;    /* Noise: 1 / Q of the band, (0, 2]. */
    float roughness;  /* [0, 1] how much the level crackles. */
};

struct sound_recipe {
    struct layer_recipe layer[SYNTH_LAYER_MAX];
    float string_hz;       /* A plucked string, >= 190; 0 none. */
    float string_gain;
    float string_delay_ms;
    float string_keep;     /* Share of a wave that is left after one round, (0, 1). */
    float length_ms;       /* When the voice is free again; everything has died away by then. */
};

extern const struct sound_recipe sound_recipes[SOUND_COUNT];

#endif
