/* plate.h -- what stands beside a fish on a plate: how old, how long, and a bar of true size. */
#ifndef KINGYO_PLATFORM_CTL_PLATE_H
#define KINGYO_PLATFORM_CTL_PLATE_H

#include "core/morph/morph.h"
#include "platform/ctl/canvas.h"

#define PLATE_WORDS_SIZE 64u

#define PLATE_INK 0x1d2b33u
#define PLATE_SOFT_INK 0x56676fu

/* "hatching", "12.5 days", "3.2 years" */
void plate_age(char out[PLATE_WORDS_SIZE], float age_days);

/* "0.5 mm", "20.4 mm", "15.0 cm", "2.08 m" */
void plate_length(char out[PLATE_WORDS_SIZE], float length_m);

/* A name of a species or a key as people write it: "long leaf". */
void plate_name(char out[PLATE_WORDS_SIZE], const char *name);

/* What a species' length means: "TL", "SL", "FL" or "DW". */
const char *plate_measure(const struct species_card *card);

/* The longest of 1, 2, 5, 10 .. in any unit that is at most `length_m` > 0. */
float plate_round_length_m(float length_m);

/* A bar of round true length, at most `width_max_px`, centred on `x` with its line at `y`, its
 * length below it. `px_per_m`: how large the fish is drawn. */
void plate_bar(struct canvas *canvas, float x, float y, float width_max_px, float px_per_m,
               float size_px);

/* The keys' weights side by side in their colours (platform/key_colour.h). */
void plate_weights(struct canvas *canvas, struct canvas_box box, uint32_t key_count,
                   const float weights[MORPH_KEY_MAX]);

#endif
