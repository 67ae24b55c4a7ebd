/* ui_lab.h -- what the files of the growth lab's screen share.
 *
 * All coordinates are on the core's canvas (core/game/lab/lab_layout.h), which the pointer uses as
 * well. */
#ifndef KINGYO_PLATFORM_RENDER_UI_LAB_UI_LAB_H
#define KINGYO_PLATFORM_RENDER_UI_LAB_UI_LAB_H

#include "core/game/lab/lab_layout.h"
#include "platform/render/ui/lab/ui_lab_preview.h"
#include "platform/render/ui/ui_primitives.h"
#include "platform/species/library.h"

#define LAB_PURPLE 0x8a3fb5ffu /* Purple of the scale curve, as in the 2005 thesis. */
#define LAB_PAPER 0xfbf2ddffu
#define LAB_PAPER_LINE 0xb5762fffu
#define LAB_INK 0x2a2024ffu
#define LAB_INK_SOFT 0x6b5a50ffu
#define LAB_MIST 0xdff3f2ffu /* Colour of words on water. */

struct lab_page {
    struct ui_frame frame; /* Frame whose `unit` is one canvas unit. */
    const struct scene_lab *lab;
    struct ui_lab_preview *bench; /* Null: this kiosk lacks the species. */
    const struct library
        *library; /* Species library with the rejected makers' files; null: none. */
    float x, y;   /* Position of the canvas' corner on the screen. */
};

/* Return the position of a part, and of a coordinate, on the screen. */
struct ui_box lab_place(const struct lab_page *page, enum lab_part part);
float lab_px_x(const struct lab_page *page, float x);
float lab_px_y(const struct lab_page *page, float y);

/* Returns key_colour() as opaque 0xRRGGBBAA. */
uint32_t lab_key_colour(uint32_t key_count, uint32_t key);

/* Returns 1 if the pointer is over a part or drags it. */
int lab_is_pointed(const struct lab_page *page, enum lab_part part);

/* Returns a text style. `size` is in canvas units; 22 is the smallest size that a standing player
 * can read. */
struct ui_text lab_text(const struct lab_page *page, float size, uint32_t fill);

/* Draws a line of text centred in a box, shrunk to its width. */
void lab_words_in(const struct lab_page *page, struct ui_box box, const struct ui_text *style,
                  const char *words);

/* Write an age such as "45 days" or "3.2 years", and a length such as "23.4 mm" or "12.3 cm". */
void lab_age_words(uint8_t language, float age_days, char *out, size_t out_size);
void lab_length_words(float length_m, char *out, size_t out_size);

/* Return the name of a species or of a key in the screen's language, or the maker's identifier if
 * there is no translation. */
const char *lab_species_name(uint8_t language, const char *id);
const char *lab_key_name(uint8_t language, const char *name);

/* Draw the screen's parts, in painter's order. */
void lab_stage(const struct lab_page *page);
void lab_keys(const struct lab_page *page);
void lab_graph(const struct lab_page *page);
void lab_chart(const struct lab_page *page);

#endif
