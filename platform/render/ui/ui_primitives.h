/* ui_primitives.h -- drawing primitives of the user interface: colours, boxes, texts, shop curtain,
 * lanterns, ribbons and wooden tags. */
#pragma once

#include <stdbool.h>

#include "core/game/pointer_mapping.h"
#include "platform/render/ui/ui_batch.h"

#define UI_INDIGO 0x1b2452ffu /* Indigo, the colour of dyed cloth. */
/* Translucent indigo, for plates through which the tank is visible. */
#define UI_NIGHT 0x10142eb8u
#define UI_VERMILION 0xd9402affu
#define UI_GOLD 0xe8b85cffu
#define UI_GOLD_DIM 0xe8b85c80u
#define UI_WASHI_WHITE 0xfbf2ddffu
#define UI_INK 0x241a20ffu
#define UI_INK_SOFT 0x5a4648ffu
#define UI_CREAM 0xfff6e2ffu
#define UI_CEDAR 0xe0b074ffu
#define UI_CEDAR_DIM 0xc4965fffu  /* Wood of a tag that is not pointed at. */
#define UI_WORD_SHADE 0x0a0c24e0u /* Colour of the shadow around large words. */

struct ui_memory;

/* Drawing context of all screens. */
struct ui_frame {
    struct ui_batch *batch;
    const struct scene *scene; /* Scene whose screen is drawn. */
    struct ui_memory *memory;  /* Values that the screens showed last (ui_screens.h). */
    float width, height;       /* Width and height of the screen in pixels. */
    /* Position in pixels of the upper left corner of the layout area on the screen. */
    float x, y;
    /* Size of the layout unit in pixels. In a context that is not from ui_canvas(), the size is 1
     * px on a 1280x720 screen. */
    float unit;
    float text_scale; /* Factor by which the size of a text in the common font is multiplied. */
    float time_s;     /* Time in seconds for the animation of swaying and pulsing objects. */
    uint8_t language; /* Language of all texts (enum language). */
    /* True if the layout area is the core's canvas (ui_canvas()) for portrait screens. */
    bool is_upright;
};

/* Returns a drawing context whose layout area is the core's canvas (core/game/pointer_mapping.h),
 * on which the pointer also moves. The canvas is centred on the screen and as large as the screen
 * permits, and its scale equals the camera's scale. */
struct ui_frame ui_canvas(const struct ui_frame *frame, bool is_upright);

/* Returns a box on the canvas. All lengths are in canvas units. */
static inline struct layout_box canvas_box(float x, float y, float width, float height)
{
    return (struct layout_box){ x, y, width, height };
}

/* Converts a box on the canvas to a box on the screen. */
struct ui_box ui_place(const struct ui_frame *frame, struct layout_box box);

/* Converts one of two boxes on the canvas to a box on the screen: `upright` if the canvas is the
 * one for portrait screens, otherwise `wide`. */
struct ui_box ui_place_either(const struct ui_frame *frame, struct layout_box wide,
                              struct layout_box upright);

/* Returns the square that is centred at (x, y) and 2 * `half` pixels wide. */
struct ui_box ui_around(float x, float y, float half);

/* Returns the box `box` without a margin of `margin` pixels on its left and its right side. */
struct ui_box ui_inset(struct ui_box box, float margin);

/* Returns a colour with its alpha multiplied by `alpha` [0, 1]. */
uint32_t ui_fade(uint32_t colour, float alpha);
/* Returns the value at `time_s` of a smooth pulse, which goes from 0 to 1 and back to 0 in each
 * period of `period_s` seconds. */
float ui_pulse(float time_s, float period_s);

/* Screen position of a point in the tank, in pixels (x, y), and scale at this point (px_per_m): the
 * length on the screen of one metre that is perpendicular to the line of sight. */
struct ui_point {
    float x, y, px_per_m;
};
/* Returns the position on the screen of the point `at_m` of the tank. The position may be outside
 * the screen. */
struct ui_point ui_project(const struct ui_frame *frame, vec3 at_m);

/* Returns the text with the key `key` in the language of the screen. */
const char *ui_words(const struct ui_frame *frame, enum text_key key);

/* Returns a text style without outline. `size` is in layout units. `align` is 0 for text that
 * begins at x, 0.5 for text that is centred at x, and 1 for text that ends at x. A text that is
 * longer than `fit_px` is shrunk, unless `fit_px` is 0. */
struct ui_text ui_style(const struct ui_frame *frame, enum font_id font, float size, float align,
                        uint32_t fill, float fit_px);
/* Returns a style of left-aligned text in the common font. `size` is in layout units. Text on the
 * core's canvas is readable from a distance of one metre if `size` is at least 22. */
struct ui_text ui_body(const struct ui_frame *frame, float size, uint32_t fill);
/* Returns the style of a large word: a brush font in the size `brush_size` for Japanese, and the
 * festival stall's font in the size `size` for other languages. Both sizes are in layout units. */
struct ui_text ui_brush(const struct ui_frame *frame, float brush_size, float size,
                        float spacing_em, uint32_t fill);
/* Returns the style `style` with an outline of the colour `line` (see struct ui_text). */
struct ui_text ui_outlined(struct ui_text style, float outline_em, float soft_em, uint32_t line);

/* Draws a box with rounded corners. `kind` is UI_PANEL, UI_WASHI, UI_WAVES, UI_WOOD or UI_HEAT. A
 * border of 0 px means no border. `fill` is the colour of the surface, and `line` is the colour of
 * the border. Other functions of this module also call ui_panel() with UI_GLOW and UI_WATER. The
 * comments of enum ui_kind (ui_batch.h) describe the parameters of these kinds. */
void ui_panel(const struct ui_frame *frame, enum ui_kind kind, struct ui_box box, float radius_px,
              float border_px, uint32_t fill, uint32_t line);
/* Draws a rectangle of one colour without a border. */
void ui_fill(const struct ui_frame *frame, struct ui_box box, uint32_t colour);
/* Covers the whole screen with a translucent colour. A dark veil over the tank makes text readable
 * over the bright lights of the tank. */
void ui_veil(const struct ui_frame *frame, uint32_t colour);
/* Draws a disc of one colour with a border, centred at (x, y). */
void ui_disc(const struct ui_frame *frame, float x, float y, float radius_px, float border_px,
             uint32_t fill, uint32_t line);
/* Draws a ring that is centred at (x, y). The fraction `part` [0, 1] of the ring has the colour
 * `fill`, clockwise from the top. The rest of the ring has the colour `line`. A `width_px` that is
 * greater than the radius fills the whole disc. */
void ui_ring(const struct ui_frame *frame, float x, float y, float radius_px, float width_px,
             float part, uint32_t fill, uint32_t line);
/* Draws a glow that adds light to the picture. `fill` is the colour in the middle of the box. */
void ui_glow(const struct ui_frame *frame, struct ui_box box, uint32_t fill);
/* Draws the water of an aquarium. `deep` is the colour at the bottom. `time_s` is the time in
 * seconds of the animation. */
void ui_water(const struct ui_frame *frame, struct ui_box box, float radius_px, float time_s,
              uint32_t deep);

/* Draws an arrow from (x, y) to (x + `to_x`, y + `to_y`). */
void ui_arrow(const struct ui_frame *frame, float x, float y, float to_x, float to_y,
              uint32_t colour);

/* Adds one line of text as ui_text() does, vertically centred on `y`. Returns the width of the text
 * in pixels. */
float ui_text_at(const struct ui_frame *frame, struct ui_text style, float x, float y,
                 const char *words);
/* Draws the decimal digits of `number` at the position where ui_text_at() draws a text. */
void ui_number_at(const struct ui_frame *frame, struct ui_text style, float x, float y,
                  uint32_t number);
/* Draws text whose start (align 0), centre (0.5) or end (1) is at `x`. The text is shrunk to the
 * width `room`, and the shrunk text is vertically centred on `y`. All lengths are in pixels. */
void ui_words_at(const struct ui_frame *frame, float x, float y, float room, float align,
                 struct ui_text style, const char *words);
/* Draws a line of text that is centred in a box and shrunk to the width of the box. */
void ui_words_in(const struct ui_frame *frame, struct ui_box box, struct ui_text style,
                 const char *words);

/* Draws the text `key` in the common font (ui_body()), centred in a box and shrunk to the width of
 * the box. */
void ui_label_in(const struct ui_frame *frame, struct ui_box box, float size, uint32_t fill,
                 enum text_key key);

/* Draws the text `key` in the common font (ui_body()). The text begins at `x` and is shrunk to the
 * width `room`. */
void ui_label_at(const struct ui_frame *frame, float x, float y, float room, float size,
                 uint32_t fill, enum text_key key);

/* Draws the shop curtain: a pole, strips of dyed cloth, the title, and two paper lanterns. `lift`
 * in [0, 1] states how far the curtain is raised. At 1 the curtain is outside the picture. */
void ui_noren(const struct ui_frame *frame, float lift);

/* Draws a horizontal bamboo pole centred at (x, y). */
void ui_pole(const struct ui_frame *frame, float x, float y, float width);
/* Draws the two cords by which a tag hangs from the pole at height `pole_y`. */
void ui_cords(const struct ui_frame *frame, struct ui_box box, float pole_y);
/* Draws a wooden tag without text. The tag is brighter if `is_pointed` is true. */
void ui_wooden_tag(const struct ui_frame *frame, struct ui_box box, bool is_pointed);

/* Draws a large card of paper with a shadow. */
void ui_card(const struct ui_frame *frame, struct ui_box box);

/* Font and colours of a ribbon. */
struct ui_ribbon {
    enum font_id font;
    uint32_t fill, line;
    uint32_t ink; /* Colour of the text. 0 means cream. */
};
/* Draws a rounded ribbon with one line of text, centred at (x, y). `size_px` is the size of one em
 * of the text. The text is shrunk if the ribbon would be wider than `room_px`. Returns the ribbon's
 * width in pixels. */
float ui_ribbon_at(const struct ui_frame *frame, struct ui_ribbon ribbon, float x, float y,
                   float size_px, float room_px, const char *words);
/* Draws a ribbon as ui_ribbon_at() does, in the horizontal middle of the screen. */
void ui_ribbon(const struct ui_frame *frame, struct ui_ribbon ribbon, float y, float size_px,
               const char *words);
