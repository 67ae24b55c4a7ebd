/* caption.h -- the caption of a fish: its age, its length and a bar of true size. */
#ifndef KINGYO_PLATFORM_CTL_LIB_CAPTION_H
#define KINGYO_PLATFORM_CTL_LIB_CAPTION_H

#include "core/morph/morph.h"
#include "platform/ctl/lib/canvas.h"

#define CAPTION_WORDS_SIZE 64u

#define CAPTION_INK 0x1d2b33u
#define CAPTION_SOFT_INK 0x56676fu

/* Writes an age, for example "hatching", "12.5 days" or "3.2 years". */
void caption_age(char out[CAPTION_WORDS_SIZE], float age_days);

/* Writes a length, for example "0.5 mm", "20.4 mm", "15.0 cm" or "2.08 m". */
void caption_length(char out[CAPTION_WORDS_SIZE], float length_m);

/* Converts the name of a species or a key to readable words, for example "long leaf". */
void caption_name(char out[CAPTION_WORDS_SIZE], const char *name);

/* Returns the abbreviation of a species' length measure: "TL" (total), "SL" (standard), "FL" (fork)
 * or "DW" (disc width). */
const char *caption_measure(const struct species_card *card);

/* Returns the greatest length that is 1, 2 or 5 times a power of ten of a unit and at most
 * `length_m`, which must be above 0. */
float caption_round_length_m(float length_m);

/* Draws a bar of round true length with its length below. The bar is at most `width_max_px` wide,
 * its line is at the height `y`, and its middle is at `x`. `px_per_m` is the scale at which the
 * fish is drawn. */
void caption_bar(struct canvas *canvas, float x, float y, float width_max_px, float px_per_m,
                 float size_px);

/* Draws the weights of the keys side by side in the colours of the keys (platform/key_colour.h). */
void caption_weights(struct canvas *canvas, struct canvas_box box, uint32_t key_count,
                     const float weights[MORPH_KEY_MAX]);

#endif
