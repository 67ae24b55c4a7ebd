/* drum.h -- the percussion of the festival music: large drum (taiko), small drum (shime-daiko),
 * bell (kane) and wooden clappers, as modal resonators.
 *
 * A stroke excites the modes of a skin, a bell or a bar. Each mode is a decaying sine wave. A burst
 * of noise is the contact of the stick. */
#pragma once

#include <stdint.h>

#include "core/sound/tone.h"

/* Number of modes of a stroke. Eight modes fit into the SIMD registers of all boards. */
#define DRUM_MODES 8u
/* Number of strokes that sound at the same time. The loudest rolls use about ten. */
#define DRUM_STROKES 14u

enum drum_kind {
    DRUM_NONE = 0,
    DRUM_TAIKO,    /* Large drum, struck in the middle ("don"). */
    DRUM_RIM,      /* Rim of the large drum ("ka"). */
    DRUM_SHIME,    /* Small drum with a tight skin, struck hard ("ten"). */
    DRUM_SHIME_LO, /* Small drum, struck lightly ("tsu"). */
    DRUM_BELL,     /* Bell, struck in the middle ("chan"). */
    DRUM_BELL_LO,  /* Bell, struck at its edge and damped by the hand ("chi"). */
    DRUM_KIND_COUNT,
};

/* State of one stroke. */
struct drum_stroke {
    uint8_t kind;          /* Kind of the stroke (enum drum_kind). DRUM_NONE means free. */
    uint32_t delay_blocks; /* Blocks until the stroke begins. */
    uint32_t age_blocks;
    float left, right;
    float x[DRUM_MODES], y[DRUM_MODES];           /* Modes as oscillators. */
    float turn_x[DRUM_MODES], turn_y[DRUM_MODES]; /* Rotation of each mode by one frame. */
    float tap, tap_keep; /* Level of the noise of the stick, and its decay. */
    struct tone_filter skin;
};

struct drums {
    uint32_t noise; /* State of the noise generator. */
    struct drum_stroke stroke[DRUM_STROKES];
};

/* Starts a stroke of the strength (0, 1] after `delay_blocks`. If all strokes sound, replaces the
 * oldest stroke. */
void drum_strike(struct drums *drums, uint8_t kind, float strength, uint32_t delay_blocks);

/* Adds a block of all strokes to `mix`, SOUND_BLOCK frames of two samples. */
void drum_render(struct drums *drums, float *mix);
