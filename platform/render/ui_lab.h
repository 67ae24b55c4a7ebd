/* ui_lab.h -- the growth lab's screen, in parts: what its files share.
 *
 * Everything lies on the core's canvas (core/game/lab_layout.h), where the hand finds it. */
#ifndef KINGYO_PLATFORM_RENDER_UI_LAB_H
#define KINGYO_PLATFORM_RENDER_UI_LAB_H

#include "core/game/lab_layout.h"
#include "platform/render/ui_bench.h"
#include "platform/render/ui_parts.h"
#include "platform/species/shelf.h"

#define LAB_PURPLE 0x8a3fb5ffu /* The scale's, as in the 2005 thesis. */
#define LAB_PAPER 0xfbf2ddffu
#define LAB_PAPER_LINE 0xb5762fffu
#define LAB_INK 0x2a2024ffu
#define LAB_INK_SOFT 0x6b5a50ffu
#define LAB_MIST 0xdff3f2ffu   /* Words on water. */

struct lab_page {
    struct ui_frame frame;       /* `unit` is one of the canvas. */
    const struct scene_lab *lab;
    struct ui_bench *bench;      /* Null: this kiosk has not got that species. */
    const struct shelf *shelf;   /* With what was refused of makers' files; null: nothing. */
    float x, y;                  /* The canvas' corner on the screen. */
};

/* A part's place on the screen, and a point's. */
struct ui_box lab_place(const struct lab_page *page, enum lab_part part);
float lab_px_x(const struct lab_page *page, float x);
float lab_px_y(const struct lab_page *page, float y);

/* key_colour(), opaque: 0xRRGGBBAA. */
uint32_t lab_key_colour(uint32_t key_count, uint32_t key);

/* Whether a hand is over a part, or has hold of it. */
int lab_is_pointed(const struct lab_page *page, enum lab_part part);

/* Sizes for a place are in canvas units: `size` 22 is the smallest that is read standing. */
struct ui_text lab_text(const struct lab_page *page, float size, uint32_t fill);

/* A line of words in the middle of a box, shrunk to its room. */
void lab_words_in(const struct lab_page *page, struct ui_box box, const struct ui_text *style,
                  const char *words);

/* "45 days", "3.2 years"; "23.4 mm", "12.3 cm". */
void lab_age_words(uint8_t language, float age_days, char *out, size_t out_size);
void lab_length_words(float length_m, char *out, size_t out_size);

/* The name of a species or of a key in the screen's language; the maker's own word where there is
 * none. */
const char *lab_species_name(uint8_t language, const char *id);
const char *lab_key_name(uint8_t language, const char *name);

/* The parts, in painter's order. */
void lab_stage(const struct lab_page *page);
void lab_keys(const struct lab_page *page);
void lab_graph(const struct lab_page *page);
void lab_chart(const struct lab_page *page);

#endif
