/* ui_lab.h -- functions and colours that the source files of the growth lab's screen share.
 *
 * All coordinates are on the core's canvas (core/game/lab/lab_layout.h), which is the layout area
 * in which the pointer also moves. The drawing context of each function is the canvas
 * (ui_canvas()). */
#pragma once

#include "core/game/lab/lab_layout.h"
#include "platform/render/ui/ui_primitives.h"
#include "platform/render/ui/ui_screens.h"

/* Colour of the curve that shows the fish's length, the same as in the 2005 thesis. */
#define LAB_PURPLE 0x8a3fb5ffu
#define LAB_PAPER 0xfbf2ddffu
#define LAB_PAPER_LINE 0xb5762fffu
#define LAB_INK 0x2a2024ffu
#define LAB_INK_SOFT 0x6b5a50ffu
#define LAB_MIST 0xdff3f2ffu /* Colour of text that is drawn on the water. */

/* Returns the box on the screen of a part of the growth lab. */
struct ui_box lab_place(const struct ui_frame *frame, enum lab_part part);

/* Returns the colour of a key (modelled growth stage) as opaque 0xRRGGBBAA, computed by
 * key_colour(). */
uint32_t lab_key_colour(uint32_t key_count, uint32_t key);

/* Returns true if the pointer is over the part or drags the part. */
bool lab_is_pointed(const struct ui_frame *frame, enum lab_part part);

/* Writes an age such as "45 days" or "3.2 years". */
void lab_age_words(uint8_t language, float age_days, char *out, size_t out_size);
/* Writes a length such as "23.4 mm" or "12.3 cm". */
void lab_length_words(float length_m, char *out, size_t out_size);

/* Returns the name of a species or of a key (modelled growth stage) in the screen's language. If
 * there is no translation, returns `id`, the identifier in the species file. */
const char *lab_name(uint8_t language, const char *id);

/* Returns the previewed fish at `progress` through life in its usual view. The box that contains
 * the fish at all ages is centred at (x, y). With `share` = 1, the fish has the largest size at
 * which it fits into `width` x `height` pixels at every age. `share` is a factor of this size. */
struct specimen lab_fish(const struct ui_frame *frame, float progress, float x, float y,
                         float width, float height, float share);

/* Draws the aquarium with the fish. */
void lab_stage(const struct ui_frame *frame);
/* Draws the key shapes (modelled growth stages), the weight of each key at the current age, and the
 * lifeline, on which the player selects the age. */
void lab_keys(const struct ui_frame *frame);
/* Draws the deformation graph, which shows the weight of each key over the fish's progress through
 * life. */
void lab_graph(const struct ui_frame *frame);
/* Draws the growth curve, which shows the fish's length over its age. */
void lab_chart(const struct ui_frame *frame);
