/* music.h -- plays the festival music (score.h) with two flutes and the drums.
 *
 * The seed chooses the phrases, the drums of each bar, the ornaments of the flute, and small
 * deviations of time and strength. The music is endless: after its last part the form begins again
 * with other variants. */
#pragma once

#include <stdint.h>

#include "core/sound/drum.h"
#include "core/sound/flute.h"

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
