/* vocal.h -- a voice of formant tones: a buzz and noise pass three resonances, as in a mouth.
 *
 * The stall keeper's calls and the murmur of the crowd use such voices. They contain no recorded
 * speech: each call is a short list of vowels and consonants. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/sound/tone.h"

#define VOCAL_FORMANTS 3u

/* One sound of speech. */
struct vocal_phone {
    float ms;                 /* Duration; 0 ends a list of sounds. */
    float hz[VOCAL_FORMANTS]; /* Resonances of the mouth. */
    float pitch_hz;           /* Pitch of the buzz at the end of the sound. */
    float buzz;               /* Level of the buzz, [0, 1]. */
    float noise, noise_hz;    /* Level and centre frequency of the noise of a consonant. */
};

enum vocal_call {
    VOCAL_NONE = 0,
    VOCAL_WELCOME, /* "rasshai": the stall keeper greets a player. */
    VOCAL_PITY,    /* "oshii": a near miss. */
    VOCAL_BRAVO,   /* "yatta": a good result. */
    VOCAL_CALL_COUNT,
};

#define VOCAL_PHONES_MAX 8u
extern const struct vocal_phone vocal_calls[VOCAL_CALL_COUNT][VOCAL_PHONES_MAX];

struct vocal {
    float phase; /* Phase of the buzz, [0, 1). */
    float pitch_hz, buzz, noise;
    float hz[VOCAL_FORMANTS];
    struct tone_filter formant[VOCAL_FORMANTS], breath;
    uint32_t random; /* State of the noise generator. */
};

/* Adds a block of the sound `phone` to `wave`. The mouth moves from its present sound to `phone`
 * within some 30 ms. */
void vocal_render(struct vocal *vocal, const struct vocal_phone *phone, float wave[SOUND_BLOCK]);

/* Returns the sound of the call `call` (enum vocal_call) at an age, or NULL after its end. */
const struct vocal_phone *vocal_phone_at(uint32_t call, uint32_t age_blocks);

/* Sets the mouth to the first sound of a call or a word. */
void vocal_begin(struct vocal *vocal, const struct vocal_phone *phone);
