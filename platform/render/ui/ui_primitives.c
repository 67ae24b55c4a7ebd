/* ui_primitives.c -- drawing primitives of the user interface: boxes, texts, shop curtain,
 * lanterns, ribbons and wooden tags. */
#include "platform/render/ui/ui_primitives.h"

#include <math.h>

#include "core/base/panic.h"

#define TAU 6.28318531f
#define NOREN_STRIPS 5u

uint32_t ui_fade(uint32_t colour, float alpha)
{
    return (colour & 0xffffff00u) | (uint32_t)((float)(colour & 0xffu) * ui_clamp01(alpha) + 0.5f);
}

float ui_clamp01(float x)
{
    return x < 0.0f ? 0.0f : x > 1.0f ? 1.0f : x;
}

float ui_smooth(float from, float to, float x)
{
    const float t = ui_clamp01((x - from) / (to - from));
    return t * t * (3.0f - 2.0f * t);
}

float ui_pulse(float time_s, float period_s)
{
    return 0.5f - 0.5f * cosf(time_s * TAU / period_s);
}

const char *ui_words(const struct ui_frame *frame, enum text_key key)
{
    return text_words(frame->language, key);
}

struct ui_text ui_style(const struct ui_frame *frame, enum font_id font, float size, float align,
                        uint32_t fill, float fit_px)
{
    return (struct ui_text){
        .font = font, .size_px = size * frame->unit, .align = align, .fill = fill, .fit_px = fit_px
    };
}

void ui_panel(const struct ui_frame *frame, enum ui_kind kind, struct ui_box box, float radius_px,
              float border_px, uint32_t fill, uint32_t line)
{
    CORE_ASSERT(kind == UI_PANEL || kind == UI_WASHI || kind == UI_WAVES || kind == UI_WOOD ||
                kind == UI_HEAT);
    ui_shape(frame->batch, &(struct ui_shape){ .box = box,
                                               .kind = kind,
                                               .fill = fill,
                                               .line = line,
                                               .shape = { 0, 0, radius_px, border_px } });
}

void ui_disc(const struct ui_frame *frame, float x, float y, float radius_px, float border_px,
             uint32_t fill, uint32_t line)
{
    const struct ui_box box = { x - radius_px, y - radius_px, 2.0f * radius_px, 2.0f * radius_px };
    ui_panel(frame, UI_PANEL, box, radius_px, border_px, fill, line);
}

void ui_ring(const struct ui_frame *frame, float x, float y, float radius_px, float width_px,
             float part, uint32_t fill, uint32_t line)
{
    CORE_ASSERT(radius_px >= width_px);
    const struct ui_box box = { x - radius_px, y - radius_px, 2.0f * radius_px, 2.0f * radius_px };
    ui_shape(frame->batch, &(struct ui_shape){ .box = box,
                                               .kind = UI_RING,
                                               .fill = fill,
                                               .line = line,
                                               .shape = { radius_px, width_px, part } });
}

void ui_glow(const struct ui_frame *frame, struct ui_box box, uint32_t fill)
{
    ui_shape(
        frame->batch,
        &(struct ui_shape){ .box = box, .kind = UI_GLOW, .fill = fill, .shape = { 0, 0, 1.0f } });
}

float ui_text_at(const struct ui_frame *frame, const struct ui_text *style, float x, float y,
                 const char *words)
{
    return ui_text(frame->batch, style, x, ui_text_middle(style, y), words);
}

void ui_hang_lantern(const struct ui_frame *frame, float x, float y, float size, float phase)
{
    CORE_ASSERT(size > 0.0f);
    const float sway = sinf(frame->time_s * 1.1f + phase) * size * 0.035f;
    const float flicker = 0.86f + 0.08f * sinf(frame->time_s * 2.3f + phase * 3.0f) +
                          0.06f * sinf(frame->time_s * 5.9f + phase * 7.0f);
    const float width = size * 0.80f, cord = size * 0.30f, cap = size * 0.085f;
    const float middle_x = x + sway, top = y + cord;
    const struct ui_box halo = { middle_x - size, top - size * 0.45f, size * 2.0f, size * 1.9f };
    ui_glow(frame, halo, 0xff9a3c50u);
    ui_shape(frame->batch,
             &(struct ui_shape){ .box = { x - size * 0.012f, y, size * 0.024f, cord + cap },
                                 .kind = UI_PANEL,
                                 .fill = 0x1a1216ffu,
                                 .lean_px = sway });
    ui_shape(frame->batch, &(struct ui_shape){ .box = { middle_x - 0.5f * width, top, width, size },
                                               .kind = UI_LANTERN,
                                               .shape = { 0, 0, flicker },
                                               .fill = 0xf0452cffu,
                                               .lean_px = sway * 0.3f });
    for (uint32_t i = 0; i < 2u; i++) {
        const struct ui_box rim = { middle_x - 0.23f * width + sway * 0.3f * (float)i,
                                    top - 0.45f * cap + (float)i * (size - 0.1f * cap),
                                    0.46f * width, cap };
        ui_panel(frame, UI_PANEL, rim, 0.2f * cap, 0.14f * cap, 0x17121affu, UI_GOLD);
    }
    const struct ui_text brush = { .font = FONT_BRUSH,
                                   .size_px = size * 0.56f,
                                   .align = 0.5f,
                                   .weight_em = 0.020f,
                                   .fill = 0x2a0d0cffu };
    ui_text_at(frame, &brush, middle_x + sway * 0.15f, top + 0.52f * size,
               ui_words(frame, TEXT_LANTERN));
}

static void noren_title(const struct ui_frame *frame, float left, float top, float width,
                        float height)
{
    const int brush = frame->language == LANGUAGE_JA;
    struct ui_text title = { .font = brush ? FONT_BRUSH : FONT_STALL,
                             .align = 0.5f,
                             .size_px = brush ? height * 0.86f : height * 0.56f,
                             .weight_em = brush ? 0.022f : 0.004f,
                             .fill = 0xfff6e2ffu };
    const char *words = ui_words(frame, TEXT_TITLE);
    if (!brush) {
        title.fit_px = width * 0.92f;
        title.size_px = ui_text_size(&title, words);
        ui_text_at(frame, &title, left + 0.5f * width, top + 0.50f * height, words);
        return;
    }
    /* Each strip of the curtain shows one character of the title, like a real shop curtain. */
    for (uint32_t i = 0; i < NOREN_STRIPS && *words != 0; i++) {
        char one[8] = "";
        const char *from = words;
        printable_next(&words);
        for (uint32_t k = 0; from + k < words && k < sizeof one - 1u; k++) {
            one[k] = from[k];
        }
        const float x = left + width * ((float)i + 0.5f) / (float)NOREN_STRIPS;
        const float sway = frame->unit * 1.6f * sinf(frame->time_s * 0.9f + (float)i * 0.8f);
        ui_text_at(frame, &title, x + sway, top + 0.51f * height, one);
    }
}

void ui_noren(const struct ui_frame *frame, float lift)
{
    const float u = frame->unit;
    const float width = fminf(frame->width - 276.0f * u, 860.0f * u);
    const float height = fminf(0.235f * frame->height, width / (float)NOREN_STRIPS * 0.98f);
    const float left = 0.5f * (frame->width - width), strip = width / (float)NOREN_STRIPS;
    const float top = 24.0f * u - lift * (height + 200.0f * u);
    const struct ui_box pole = { left - 130.0f * u, top - 9.0f * u, width + 260.0f * u, 15.0f * u };
    ui_panel(frame, UI_WASHI, pole, 7.0f * u, 2.0f * u, 0x8a5a34ffu, 0x3a2214ffu);
    for (uint32_t i = 0; i < NOREN_STRIPS; i++) {
        /* Each strip consists of two loops over the pole, the cloth and a white hem. */
        const struct ui_box box = { left + strip * (float)i + u, top + 9.0f * u, strip - 2.0f * u,
                                    height - 9.0f * u };
        const float lean = u * 3.0f * sinf(frame->time_s * 0.9f + (float)i * 0.8f);
        for (uint32_t k = 0; k < 2u; k++) {
            const struct ui_box loop = { box.x + box.width * (0.18f + 0.54f * (float)k),
                                         box.y - 21.0f * u, box.width * 0.10f, 26.0f * u };
            ui_panel(frame, UI_PANEL, loop, 3.0f * u, 1.2f * u, 0x2b3878ffu, 0x0b1030ffu);
        }
        ui_shape(frame->batch, &(struct ui_shape){ .box = box,
                                                   .kind = UI_WAVES,
                                                   .fill = UI_INDIGO,
                                                   .line = 0x0b1030ffu,
                                                   .lean_px = lean,
                                                   .shape = { 0, 0, 9.0f * u, 1.5f * u } });
        const struct ui_box hem = { box.x + lean * 0.93f + 5.0f * u, box.y + box.height * 0.935f,
                                    box.width - 10.0f * u, 2.5f * u };
        ui_panel(frame, UI_PANEL, hem, 1.2f * u, 0.0f, 0xfff6e2b0u, 0);
    }
    noren_title(frame, left, top, width, height);
    ui_hang_lantern(frame, left - 64.0f * u, top, 118.0f * u, 0.0f);
    ui_hang_lantern(frame, left + width + 64.0f * u, top, 118.0f * u, 2.0f);
}

void ui_words_in(const struct ui_frame *frame, struct ui_box box, const struct ui_text *style,
                 const char *words)
{
    struct ui_text fitted = *style;
    fitted.align = 0.5f;
    fitted.fit_px = box.width;
    fitted.size_px = ui_text_size(&fitted, words);
    ui_text_at(frame, &fitted, box.x + 0.5f * box.width, box.y + 0.5f * box.height, words);
}

void ui_card(const struct ui_frame *frame, struct ui_box box)
{
    const float u = frame->unit;
    /* Only the visible lower part of the card's shadow is drawn, because drawing the hidden part
     * would cost time for many pixels. */
    const struct ui_box shade = { box.x - 2.0f * u, box.y + box.height - 28.0f * u,
                                  box.width + 4.0f * u, 38.0f * u };
    ui_panel(frame, UI_PANEL, shade, 16.0f * u, 0.0f, 0x05061c80u, 0);
    ui_panel(frame, UI_WASHI, box, 14.0f * u, 3.0f * u, UI_WASHI_WHITE, 0xb5762fffu);
}

float ui_ribbon(const struct ui_frame *frame, const struct ui_ribbon *ribbon, const char *words)
{
    CORE_ASSERT(ribbon->size_px > 0.0f);
    const float x = ribbon->x > 0.0f ? ribbon->x : 0.5f * frame->width;
    const float room_px =
        ribbon->room_px > 0.0f ? ribbon->room_px : frame->width - 32.0f * frame->unit;
    const float pad = 0.95f * ribbon->size_px, height = 1.95f * ribbon->size_px;
    const struct ui_text text = { .font = ribbon->font,
                                  .size_px = ribbon->size_px,
                                  .align = 0.5f,
                                  .fill = ribbon->ink ? ribbon->ink : 0xfff8eaffu,
                                  .fit_px = room_px - 2.0f * pad };
    const float width = ui_text_width(&text, words) + 2.0f * pad;
    const struct ui_box box = { x - 0.5f * width, ribbon->y - 0.5f * height, width, height };
    ui_panel(frame, UI_PANEL, box, 0.5f * height, 2.0f * frame->unit, ribbon->fill, ribbon->line);
    struct ui_text fitted = text;
    fitted.size_px = ui_text_size(&text, words);
    ui_text(frame->batch, &text, x, ui_text_middle(&fitted, ribbon->y), words);
    return width;
}

/* ---- Wooden parts of a festival stall: bamboo pole, red cords and tags of cedar ------------- */

#define CEDAR 0xd9a667ffu
#define CEDAR_DIM 0xa77d50ffu

void ui_pole(const struct ui_frame *frame, float x, float y, float width)
{
    const float u = frame->unit;
    const struct ui_box box = { x - 0.5f * width, y - 8.0f * u, width, 15.0f * u };
    ui_panel(frame, UI_WASHI, box, 7.0f * u, 2.0f * u, 0x8a5a34ffu, 0x3a2214ffu);
}

void ui_cords(const struct ui_frame *frame, struct ui_box box, float pole_y)
{
    const float u = frame->unit;
    for (uint32_t i = 0; i < 2u; i++) {
        const float x = box.x + box.width * (i == 0 ? 0.2f : 0.8f);
        const struct ui_box cord = { x - 2.5f * u, pole_y, 5.0f * u, box.y + 12.0f * u - pole_y };
        ui_panel(frame, UI_PANEL, cord, 2.5f * u, u, 0xb83a26ffu, 0x641a12ffu);
    }
}

void ui_wooden_tag(const struct ui_frame *frame, struct ui_box box, int pointed)
{
    const float u = frame->unit;
    if (pointed) {
        const struct ui_box halo = { box.x - 60.0f * u, box.y - 50.0f * u, box.width + 120.0f * u,
                                     box.height + 110.0f * u };
        ui_glow(frame, halo, ui_fade(0xffb050ffu, 0.75f + 0.25f * ui_pulse(frame->time_s, 2.4f)));
    }
    const struct ui_box shade = { box.x + 5.0f * u, box.y + 12.0f * u, box.width, box.height };
    ui_panel(frame, UI_PANEL, shade, 12.0f * u, 0.0f, 0x05061c70u, 0);
    ui_panel(frame, UI_WOOD, box, 10.0f * u, (pointed ? 5.0f : 2.0f) * u,
             pointed ? CEDAR : CEDAR_DIM, pointed ? 0xc8341fffu : 0x5a3a20ffu);
}
