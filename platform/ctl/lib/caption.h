/* caption.h -- writes and draws the caption of a fish: its age, its length and a scale bar. */
#pragma once

#include "core/morph/morph.h"
#include "platform/ctl/lib/canvas.h"

#define CAPTION_WORDS_SIZE 64u

#define CAPTION_INK 0x1d2b33u
#define CAPTION_SOFT_INK 0x56676fu

/* Writes an age to `out`, for example "hatching", "12.5 days" or "3.2 years". */
void caption_age(char out[CAPTION_WORDS_SIZE], float age_days);

/* Writes a length to `out`, for example "0.5 mm", "20.4 mm", "15.0 cm" or "2.08 m". */
void caption_length(char out[CAPTION_WORDS_SIZE], float length_m);

/* Converts the name of a species or of a key to readable words, for example "long_leaf" to "long
 * leaf". */
void caption_name(char out[CAPTION_WORDS_SIZE], const char *name);

/* Returns the abbreviation of the length measure that is used for a species: "TL" (total length),
 * "SL" (standard length), "FL" (fork length) or "DW" (disc width). */
const char *caption_measure(const struct species_card *card);

/* Returns the greatest round length that is at most `length_m`, in metres. A round length is 1, 2
 * or 5 times a power of ten. `length_m` must be above 0. */
float caption_round_length_m(float length_m);

/* Draws a scale bar of a round true length, with the length as text below the bar. `x` is the
 * middle of the bar and `y` the height of its line. The bar is at most `width_max_px` wide. The
 * fish is drawn with `px_per_m` pixels per metre, and the text with a font size of `size_px`. */
void caption_bar(struct canvas *canvas, float x, float y, float width_max_px, float px_per_m,
                 float size_px);

/* Draws a bar that is divided among the keys of a species. The width of each part is the key's
 * weight, and its colour is the key's colour (platform/key_colour.h). */
void caption_weights(struct canvas *canvas, struct canvas_box box, uint32_t key_count,
                     const float weights[MORPH_KEY_MAX]);
