/* flute.h -- a transverse bamboo flute (shinobue): five harmonics, vibrato, breath noise, and the
 * ornaments that the fingers make. */
#pragma once

#include <stdint.h>

#include "core/sound/tone.h"

enum flute_ornament {
    FLUTE_PLAIN = 0,
    FLUTE_GRACE, /* A short higher note begins the note. */
    FLUTE_TAP,   /* A finger taps a hole, so that the pitch falls for a moment in mid-note. */
    FLUTE_FALL,  /* The pitch falls at the end of the note. */
    FLUTE_SHAKE, /* The player shakes the head, which makes a wide vibrato. */
};

struct flute {
    struct tone wave; /* Oscillator of the fundamental. */
    float hz;         /* Present pitch. */
    float goal_hz;    /* Pitch of the note, which the present pitch approaches. */
    float level;      /* Present level, and level of the note, which is 0 after the note. */
    float goal;
    float cents;         /* Tuning of this instrument. */
    uint8_t ornament;    /* Ornament of the note (enum flute_ornament). */
    float other;         /* Pitch of FLUTE_GRACE or FLUTE_TAP divided by the pitch of the note. */
    uint32_t age_blocks; /* Blocks since the start of the note, and its length. */
    uint32_t length_blocks;
    uint32_t noise;
    struct tone_filter breath;
};

/* Starts a note of `hz` that lasts `length_blocks`. `other_hz` is the pitch of the higher note of
 * FLUTE_GRACE or of the lower pitch of FLUTE_TAP; other ornaments do not use it. */
void flute_play(struct flute *flute, float hz, float level, uint32_t length_blocks,
                uint8_t ornament, float other_hz);

/* Adds a block to `mix`, SOUND_BLOCK frames of two samples, with the gains `pan`. */
void flute_render(struct flute *flute, struct tone pan, float *mix);
