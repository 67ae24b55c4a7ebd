/* music.h -- the festival music: an original tune in the manner of the bands at summer festivals
 * (matsuri-bayashi), as constants, and its player, which has two flutes and the drums.
 *
 * The tune uses the yo scale on E. The calm part uses the miyako-bushi scale on E. A beat has three
 * steps, so that two notes in a beat swing as 2 : 1. A bar has four beats, and a phrase has two
 * bars. Each phrase is chosen from several variants.
 *
 * The seed chooses the phrases, the drums of each bar, the ornaments of the flute, and small
 * deviations of time and strength. The music is endless: after its last part the form begins again
 * with other variants. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/sound/drum.h"
#include "core/sound/flute.h"

#define SCORE_STEPS_PER_BAR 12u
#define SCORE_STEPS_PER_PHRASE (2u * SCORE_STEPS_PER_BAR)
#define SCORE_VARIANTS_MAX 4u

/* Melody of one phrase. Each pair of characters is a note: its pitch and its length in steps as a
 * hexadecimal digit. The lengths add up to SCORE_STEPS_PER_PHRASE.
 *
 * Pitches, from low to high: d e g a b D E G A B; f c F are further pitches of the calm part. A
 * minus sign is a rest. */
typedef const char *score_melody;

/* Drums of one bar: a string of SCORE_STEPS_PER_BAR characters for each instrument. A point is a
 * rest.
 *
 * Large drum: D loud, d soft, K rim. Small drum: T loud, t soft, R two quick strokes.
 * Bell: C in the middle, c at the edge. */
struct score_bar {
    const char *taiko, *shime, *bell;
};

/* Pitches of the tune and of the calm part, from low to high. */
#define SCALE_YO "degabDEGAB"
#define SCALE_MIYAKO_BUSHI "efabcEFAB"

/* A part of the form, of `phrases` phrases. The last phrase of a part is chosen from `close`. */
struct score_part {
    uint8_t phrases;
    uint8_t beats_per_min;
    uint8_t melody_count, close_count, bar_count;
    const char *scale; /* Pitches of the melodies and of the ornaments, from low to high. */
    score_melody melody[SCORE_VARIANTS_MAX], close[SCORE_VARIANTS_MAX];
    struct score_bar bar[SCORE_VARIANTS_MAX];
    struct score_bar fill; /* Drums of the last bar of the part. */
};

#define SCORE_PARTS 8u
extern const struct score_part score_parts[SCORE_PARTS];

/* Returns the pitch of a melody's character in Hz, or 0 for a rest. */
float music_hz(char pitch);

/* Returns the pitch in Hz of the next higher or lower character of `scale`. At the end of the
 * scale, returns the pitch of `pitch`. Asserts that the scale contains `pitch`. */
float music_neighbor_hz(const char *scale, char pitch, bool is_higher);

struct music {
    uint32_t seed;
    uint32_t part;       /* Index of the present part, which counts on after the end of the form. */
    uint32_t phrase;     /* Index of the phrase in the part. */
    uint32_t step;       /* Next step of the phrase. */
    uint32_t bars;       /* Number of bars since the start, which the random choices use. */
    float wait;          /* Blocks until the next step, less than 0 if the step is due. */
    const char *melody;  /* Rest of the phrase's melody. */
    uint32_t note_steps; /* Steps until the next note of the melody. */
    struct flute flute[2]; /* The second flute follows the first flute by a moment. */
    /* Note that the second flute plays after `late_blocks`. */
    struct {
        float hz, level;
        uint32_t length_blocks;
        uint8_t ornament;
    } late;
    uint32_t late_blocks;
    struct drums drums;
};

/* Starts the music from its first part. */
void music_init(struct music *music, uint32_t seed);

/* Adds the next block of the music to `mix`, SOUND_BLOCK frames of two samples. */
void music_render(struct music *music, float *mix);
