/* ui_parts.h -- the stall's furniture: colours, curtain, lanterns, ribbons and small signs. */
#ifndef KINGYO_PLATFORM_RENDER_UI_PARTS_H
#define KINGYO_PLATFORM_RENDER_UI_PARTS_H

#include "platform/render/ui_batch.h"

#define UI_INDIGO 0x1b2452ffu     /* Dyed cloth. */
#define UI_NIGHT 0x10142eb8u      /* The same, for plates that let the tank through. */
#define UI_VERMILION 0xd9402affu
#define UI_GOLD 0xe8b85cffu
#define UI_GOLD_DIM 0xe8b85c80u
#define UI_WASHI_WHITE 0xfbf2ddffu
#define UI_INK 0x241a20ffu
#define UI_INK_SOFT 0x5a4648ffu

/* Where everything is measured: `unit` is 1 px on a 1280x720 screen. */
struct ui_frame {
    struct ui_batch *batch;
    float width, height, unit;
    float time_s;           /* For what sways and pulses. */
    uint8_t language;
};

/* A colour with its alpha times `alpha` [0, 1]. */
uint32_t ui_fade(uint32_t colour, float alpha);
float ui_clamp01(float x);
float ui_smooth(float from, float to, float x);
/* 0 .. 1 .. 0, smoothly, once in `period_s`. */
float ui_pulse(float time_s, float period_s);

/* The shop curtain: a pole, dyed cloth in strips, and the title; `lift` [0, 1] raises it away. */
void ui_noren(const struct ui_frame *frame, float lift);
/* A paper lantern hanging from (x, y); `size` is its body's height, in pixels. */
void ui_hang_lantern(const struct ui_frame *frame, float x, float y, float size, float phase);

/* A bamboo pole centred at (x, y); the two cords on which a tag hangs from it; and the tag, bare,
 * in the light when it is pointed at. */
void ui_pole(const struct ui_frame *frame, float x, float y, float width);
void ui_cords(const struct ui_frame *frame, struct ui_box box, float pole_y);
void ui_wooden_tag(const struct ui_frame *frame, struct ui_box box, int pointed);

/* A large card of paper, and its shadow. */
void ui_card(const struct ui_frame *frame, struct ui_box box);

/* A line of words in the middle of a box, shrunk to its width. */
void ui_words_in(const struct ui_frame *frame, struct ui_box box, const struct ui_text *style,
                 const char *words);

/* A pill with one line of words in it, centred at (x, y); returns how wide it is. */
struct ui_ribbon {
    float x, y, size_px;
    enum font_id font;
    uint32_t fill, line, ink;
    float room_px;          /* It never grows wider; the words shrink instead. */
};
float ui_ribbon(const struct ui_frame *frame, const struct ui_ribbon *ribbon, const char *words);

#endif
