/* ui_primitives.h -- drawing primitives of the user interface: colours, shop curtain, lanterns,
 * ribbons and wooden tags. */
#ifndef KINGYO_PLATFORM_RENDER_UI_UI_PRIMITIVES_H
#define KINGYO_PLATFORM_RENDER_UI_UI_PRIMITIVES_H

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

/* Drawing context of all screens. `unit` is the size of the layout unit in pixels, which is 1 px on
 * a 1280x720 screen. */
struct ui_frame {
    struct ui_batch *batch;
    float width, height, unit;
    float time_s; /* Time in seconds for the animation of swaying and pulsing objects. */
    uint8_t language;
};

/* Returns a colour with its alpha multiplied by `alpha` [0, 1]. */
uint32_t ui_fade(uint32_t colour, float alpha);
float ui_clamp01(float x);
float ui_smooth(float from, float to, float x);
/* Returns a smooth pulse from 0 to 1 and back to 0 with period `period_s`. */
float ui_pulse(float time_s, float period_s);

/* Returns the text with the key `key` in the language of the screen. */
const char *ui_words(const struct ui_frame *frame, enum text_key key);

/* Returns a text style without outline. `size` is in layout units. `align` is 0 for text that
 * begins at x, 0.5 for text that is centred at x, and 1 for text that ends at x. A text that is
 * longer than `fit_px` is shrunk, unless `fit_px` is 0. */
struct ui_text ui_style(const struct ui_frame *frame, enum font_id font, float size, float align,
                        uint32_t fill, float fit_px);

/* Draws a box with rounded corners. `kind` is UI_PANEL, UI_WASHI, UI_WAVES, UI_WOOD or UI_HEAT. A
 * border of 0 px means no border. `fill` is the colour of the surface, and `line` is the colour of
 * the border. */
void ui_panel(const struct ui_frame *frame, enum ui_kind kind, struct ui_box box, float radius_px,
              float border_px, uint32_t fill, uint32_t line);
/* Draws a disc of one colour with a border, centred at (x, y). */
void ui_disc(const struct ui_frame *frame, float x, float y, float radius_px, float border_px,
             uint32_t fill, uint32_t line);
/* Draws a ring that is centred at (x, y). The fraction `part` [0, 1] of the ring has the colour
 * `fill`, clockwise from the top. The rest of the ring has the colour `line`. */
void ui_ring(const struct ui_frame *frame, float x, float y, float radius_px, float width_px,
             float part, uint32_t fill, uint32_t line);
/* Draws a glow that adds light to the picture. `fill` is the colour in the middle of the box. */
void ui_glow(const struct ui_frame *frame, struct ui_box box, uint32_t fill);
/* Adds one line of text as ui_text() does, vertically centred on `y`. Returns the width of the text
 * in pixels. */
float ui_text_at(const struct ui_frame *frame, const struct ui_text *style, float x, float y,
                 const char *words);

/* Draws the shop curtain: a pole, strips of dyed cloth, and the title. `lift` in [0, 1] states how
 * far the curtain is raised. At 1 the curtain is outside the picture. */
void ui_noren(const struct ui_frame *frame, float lift);
/* Draws a paper lantern that hangs from (x, y). `size` is the height of its body in pixels. */
void ui_hang_lantern(const struct ui_frame *frame, float x, float y, float size, float phase);

/* Draws a horizontal bamboo pole centred at (x, y). */
void ui_pole(const struct ui_frame *frame, float x, float y, float width);
/* Draws the two cords by which a tag hangs from the pole at height `pole_y`. */
void ui_cords(const struct ui_frame *frame, struct ui_box box, float pole_y);
/* Draws a wooden tag without text. The tag is brighter if `pointed` is 1. */
void ui_wooden_tag(const struct ui_frame *frame, struct ui_box box, int pointed);

/* Draws a large card of paper with a shadow. */
void ui_card(const struct ui_frame *frame, struct ui_box box);

/* Draws a line of text that is centred in a box and shrunk to the width of the box. */
void ui_words_in(const struct ui_frame *frame, struct ui_box box, const struct ui_text *style,
                 const char *words);

/* Parameters of ui_ribbon(). The comment on a field states the default value for which the value 0
 * stands. */
struct ui_ribbon {
    float x, y; /* Centre of the ribbon in pixels. An `x` of 0 means the middle of the screen. */
    float size_px;
    enum font_id font;
    uint32_t fill, line;
    uint32_t ink;  /* Colour of the text. 0 means cream. */
    float room_px; /* Maximum width of the ribbon in pixels. A longer text is shrunk to fit. 0 means
                      nearly the width of the screen. */
};
/* Draws a rounded ribbon with one line of text, centred at (x, y). Returns the ribbon's width in
 * pixels. */
float ui_ribbon(const struct ui_frame *frame, const struct ui_ribbon *ribbon, const char *words);

#endif
