/* ui_primitives.c -- drawing primitives of the user interface: boxes, texts, shop curtain,
 * lanterns, ribbons and wooden tags. */
#include "platform/render/ui/ui_primitives.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/view.h"

#define TAU 6.28318531f
/* Width of the shop curtain divided by its largest height: five square strips. */
#define NOREN_RATIO 5.1f
/* Largest number of strips of the shop curtain. */
#define NOREN_STRIPS_MAX 8u
#define NOREN_PHASE_RAD 0.8f /* Phase difference between the sway of neighbouring strips. */

struct ui_frame ui_canvas(const struct ui_frame *frame, bool is_upright)
{
    const struct layout_point size = pointer_layout_size(is_upright);
    const float across = frame->width / size.x, down = frame->height / size.y;
    struct ui_frame canvas = *frame;
    canvas.is_upright = is_upright;
    canvas.unit = fminf(across, down);
    canvas.x = 0.5f * (frame->width - size.x * canvas.unit);
    canvas.y = 0.5f * (frame->height - size.y * canvas.unit);
    return canvas;
}

struct ui_box ui_place(const struct ui_frame *frame, struct layout_box box)
{
    const float u = frame->unit;
    return (struct ui_box){ frame->x + box.x * u, frame->y + box.y * u, box.width * u,
                            box.height * u };
}

struct ui_box ui_place_either(const struct ui_frame *frame, struct layout_box wide,
                              struct layout_box upright)
{
    return ui_place(frame, frame->is_upright ? upright : wide);
}

struct ui_box ui_around(float x, float y, float half)
{
    return (struct ui_box){ x - half, y - half, 2.0f * half, 2.0f * half };
}

struct ui_box ui_inset(struct ui_box box, float margin)
{
    return (struct ui_box){ box.x + margin, box.y, box.width - 2.0f * margin, box.height };
}

uint32_t ui_fade(uint32_t colour, float alpha)
{
    const float faded = (float)(colour & 0xffu) * f_clamp(alpha, 0.0f, 1.0f);
    return (colour & 0xffffff00u) | (uint32_t)(faded + 0.5f);
}

float ui_pulse(float time_s, float period_s)
{
    return 0.5f - 0.5f * cosf(time_s * TAU / period_s);
}

struct ui_point ui_project(const struct ui_frame *frame, vec3 at_m)
{
    const struct view *const view = &frame->scene->view;
    const vec3 seen = view_project(view, at_m);
    const float half_px = 0.5f * frame->height;
    const float scale_px = half_px / view_half_height_tan(view, frame->width / frame->height);
    return (struct ui_point){ 0.5f * frame->width + seen.x * scale_px, half_px - seen.y * scale_px,
                              seen.z * scale_px };
}

const char *ui_words(const struct ui_frame *frame, enum text_key key)
{
    return text_words(frame->language, key);
}

struct ui_text ui_style(const struct ui_frame *frame, enum font_id font, float size, float align,
                        uint32_t fill, float fit_px)
{
    const float scale = font == FONT_BODY ? frame->text_scale : 1.0f;
    return (struct ui_text){
        .font = font,
        .size_px = size * scale * frame->unit,
        .align = align,
        .fill = fill,
        .fit_px = fit_px,
    };
}

struct ui_text ui_body(const struct ui_frame *frame, float size, uint32_t fill)
{
    return ui_style(frame, FONT_BODY, size, 0.0f, fill, 0.0f);
}

struct ui_text ui_brush(const struct ui_frame *frame, float brush_size, float size,
                        float spacing_em, uint32_t fill)
{
    if (frame->language != LANGUAGE_JA) {
        return ui_style(frame, FONT_STALL, size, 0.0f, fill, 0.0f);
    }
    struct ui_text style = ui_style(frame, FONT_BRUSH, brush_size, 0.0f, fill, 0.0f);
    style.weight_em = 0.022f;
    style.spacing_em = spacing_em;
    return style;
}

struct ui_text ui_outlined(struct ui_text style, float outline_em, float soft_em, uint32_t line)
{
    style.outline_em = outline_em;
    style.soft_em = soft_em;
    style.line = line;
    return style;
}

void ui_panel(const struct ui_frame *frame, enum ui_kind kind, struct ui_box box, float radius_px,
              float border_px, uint32_t fill, uint32_t line)
{
    CORE_ASSERT(kind == UI_PANEL || kind == UI_WASHI || kind == UI_WAVES || kind == UI_WOOD ||
                kind == UI_HEAT || kind == UI_GLOW || kind == UI_WATER);
    ui_shape(frame->batch, &(struct ui_shape){ .box = box,
                                               .kind = kind,
                                               .fill = fill,
                                               .line = line,
                                               .shape = { 0, 0, radius_px, border_px } });
}

void ui_fill(const struct ui_frame *frame, struct ui_box box, uint32_t colour)
{
    CORE_ASSERT(box.width >= 0.0f && box.height >= 0.0f);
    ui_panel(frame, UI_PANEL, box, 0.0f, 0.0f, colour, 0);
}

void ui_veil(const struct ui_frame *frame, uint32_t colour)
{
    ui_fill(frame, (struct ui_box){ 0.0f, 0.0f, frame->width, frame->height }, colour);
}

void ui_disc(const struct ui_frame *frame, float x, float y, float radius_px, float border_px,
             uint32_t fill, uint32_t line)
{
    ui_panel(frame, UI_PANEL, ui_around(x, y, radius_px), radius_px, border_px, fill, line);
}

void ui_ring(const struct ui_frame *frame, float x, float y, float radius_px, float width_px,
             float part, uint32_t fill, uint32_t line)
{
    CORE_ASSERT(radius_px >= 0.0f && width_px >= 0.0f);
    ui_shape(frame->batch,
             &(struct ui_shape){ .box = ui_around(x, y, radius_px),
                                 .kind = UI_RING,
                                 .fill = fill,
                                 .line = line,
                                 .shape = { radius_px, fminf(width_px, radius_px), part } });
}

void ui_glow(const struct ui_frame *frame, struct ui_box box, uint32_t fill)
{
    ui_panel(frame, UI_GLOW, box, 1.0f, 0.0f, fill, 0);
}

void ui_arrow(const struct ui_frame *frame, float x, float y, float to_x, float to_y,
              uint32_t colour)
{
    const float length = fmaxf(hypotf(to_x, to_y), 1.0f), u = frame->unit;
    const float head = fminf(15.0f * u, 0.6f * length) / length, width = 5.0f * u;
    const float tip[2] = { x + to_x, y + to_y };
    ui_segment(frame->batch, (const float[2]){ x, y }, tip, width, colour);
    for (int i = -1; i <= 1; i += 2) {
        const float side = 0.7f * (float)i;
        const float barb[2] = { tip[0] - head * (to_x + side * to_y),
                                tip[1] - head * (to_y - side * to_x) };
        ui_segment(frame->batch, barb, tip, width, colour);
    }
}

void ui_water(const struct ui_frame *frame, struct ui_box box, float radius_px, float time_s,
              uint32_t deep)
{
    ui_panel(frame, UI_WATER, box, radius_px, time_s, 0x1d7a86ffu, deep);
}

float ui_text_at(const struct ui_frame *frame, struct ui_text style, float x, float y,
                 const char *words)
{
    return ui_text(frame->batch, style, x, ui_text_middle(style, y), words);
}

void ui_number_at(const struct ui_frame *frame, struct ui_text style, float x, float y,
                  uint32_t number)
{
    char digits[12];
    snprintf(digits, sizeof digits, "%u", number);
    ui_text_at(frame, style, x, y, digits);
}

void ui_words_at(const struct ui_frame *frame, float x, float y, float room, float align,
                 struct ui_text style, const char *words)
{
    CORE_ASSERT(align >= 0.0f && align <= 1.0f);
    style.fit_px = room;
    style.size_px = ui_text_size(style, words);
    style.align = align;
    ui_text_at(frame, style, x, y, words);
}

void ui_words_in(const struct ui_frame *frame, struct ui_box box, struct ui_text style,
                 const char *words)
{
    ui_words_at(frame, box.x + 0.5f * box.width, box.y + 0.5f * box.height, box.width, 0.5f, style,
                words);
}

void ui_label_in(const struct ui_frame *frame, struct ui_box box, float size, uint32_t fill,
                 enum text_key key)
{
    ui_words_in(frame, box, ui_body(frame, size, fill), ui_words(frame, key));
}

void ui_label_at(const struct ui_frame *frame, float x, float y, float room, float size,
                 uint32_t fill, enum text_key key)
{
    ui_words_at(frame, x, y, room, 0.0f, ui_body(frame, size, fill), ui_words(frame, key));
}

/* Draws a paper lantern that hangs from (x, y). `size` is the height of its body in pixels, and
 * `phase` is the phase of its sway in radians. */
static void hang_lantern(const struct ui_frame *frame, float x, float y, float size, float phase)
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
    struct ui_text brush = { .font = FONT_BRUSH, .size_px = size * 0.56f, .fill = 0x2a0d0cffu };
    brush.align = 0.5f;
    brush.weight_em = 0.020f;
    ui_text_at(frame, brush, middle_x + sway * 0.15f, top + 0.52f * size,
               ui_words(frame, TEXT_LANTERN));
}

/* Copies the text of the next strip of the shop curtain to `out`, and advances `words` behind the
 * text. Each strip shows one character of a Japanese title, like a real shop curtain, and one word
 * of a title in another language. The slits between the strips therefore never cut a letter.
 * Returns false at the end of the title. */
static bool noren_take(uint8_t language, const char **words, char *out, size_t out_size)
{
    size_t size = 0;
    while (**words == ' ') {
        (*words)++;
    }
    if (language == LANGUAGE_JA) {
        const char *end = *words;
        size = printable_next(&end) != 0 ? (size_t)(end - *words) : 0;
    } else {
        size = strcspn(*words, " ");
    }
    snprintf(out, out_size, "%.*s", (int)size, *words);
    *words += size;
    return size > 0;
}

/* Draws one strip of the shop curtain: two loops over the pole, the cloth, a white hem and the text
 * `words`. */
static void noren_strip(const struct ui_frame *frame, struct ui_box box, float phase_rad,
                        struct ui_text title, const char *words)
{
    const float u = frame->unit, sway = sinf(frame->time_s * 0.9f + phase_rad);
    const float lean = 3.0f * u * sway;
    for (uint32_t k = 0; k < 2u; k++) {
        const struct ui_box loop = { box.x + box.width * (0.18f + 0.54f * (float)k),
                                     box.y - 21.0f * u, fminf(0.10f * box.width, 16.0f * u),
                                     26.0f * u };
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
    ui_text_at(frame, title, box.x + 0.5f * box.width + 1.6f * u * sway, box.y + 0.49f * box.height,
               words);
}

void ui_noren(const struct ui_frame *frame, float lift)
{
    const bool is_brush = frame->language == LANGUAGE_JA;
    const float u = frame->unit;
    const float width = fminf(frame->width - 276.0f * u, 860.0f * u);
    const float height = fminf(0.235f * frame->height, width / NOREN_RATIO);
    const float left = 0.5f * (frame->width - width);
    const float top = 24.0f * u - lift * (height + 200.0f * u);
    const struct ui_box pole = { left - 130.0f * u, top - 9.0f * u, width + 260.0f * u, 15.0f * u };
    struct ui_text title = { .font = is_brush ? FONT_BRUSH : FONT_STALL,
                             .align = 0.5f,
                             .size_px = is_brush ? height * 0.86f : height * 0.60f,
                             .weight_em = is_brush ? 0.022f : 0.004f,
                             .fill = UI_CREAM };
    char part[NOREN_STRIPS_MAX][TEXT_LINE_MAX / 4u];
    const char *words = ui_words(frame, TEXT_TITLE);
    uint32_t count = 0;
    while (count < NOREN_STRIPS_MAX &&
           noren_take(frame->language, &words, part[count], sizeof part[count])) {
        count++;
    }
    CORE_ASSERT(count > 0);
    const float strip = width / (float)count;
    for (uint32_t i = 0; i < count; i++) { /* All strips have the size of the longest text. */
        title.fit_px = 0.88f * strip;
        title.size_px = ui_text_size(title, part[i]);
    }
    ui_panel(frame, UI_WASHI, pole, 7.0f * u, 2.0f * u, 0x8a5a34ffu, 0x3a2214ffu);
    for (uint32_t i = 0; i < count; i++) {
        const struct ui_box box = { left + strip * (float)i + u, top + 9.0f * u, strip - 2.0f * u,
                                    height - 9.0f * u };
        noren_strip(frame, box, (float)i * NOREN_PHASE_RAD, title, part[i]);
    }
    hang_lantern(frame, left - 64.0f * u, top, 118.0f * u, 0.0f);
    hang_lantern(frame, left + width + 64.0f * u, top, 118.0f * u, 2.0f);
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

float ui_ribbon_at(const struct ui_frame *frame, struct ui_ribbon ribbon, float x, float y,
                   float size_px, float room_px, const char *words)
{
    CORE_ASSERT(size_px > 0.0f);
    const float pad = 0.95f * size_px, height = 1.95f * size_px;
    const struct ui_text text = { .font = ribbon.font,
                                  .size_px = size_px,
                                  .fill = ribbon.ink ? ribbon.ink : 0xfff8eaffu,
                                  .fit_px = room_px - 2.0f * pad };
    const float width = ui_text_width(text, words) + 2.0f * pad;
    const struct ui_box box = { x - 0.5f * width, y - 0.5f * height, width, height };
    ui_panel(frame, UI_PANEL, box, 0.5f * height, 2.0f * frame->unit, ribbon.fill, ribbon.line);
    ui_words_at(frame, x, y, text.fit_px, 0.5f, text, words);
    return width;
}

void ui_ribbon(const struct ui_frame *frame, struct ui_ribbon ribbon, float y, float size_px,
               const char *words)
{
    ui_ribbon_at(frame, ribbon, 0.5f * frame->width, y, size_px, frame->width - 32.0f * frame->unit,
                 words);
}

/* ---- Wooden parts of a festival stall: bamboo pole, red cords and tags of cedar ------------- */

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

void ui_wooden_tag(const struct ui_frame *frame, struct ui_box box, bool is_pointed)
{
    const float u = frame->unit;
    if (is_pointed) {
        const struct ui_box halo = { box.x - 60.0f * u, box.y - 50.0f * u, box.width + 120.0f * u,
                                     box.height + 110.0f * u };
        ui_glow(frame, halo, ui_fade(0xffb050ffu, 0.75f + 0.25f * ui_pulse(frame->time_s, 2.4f)));
    }
    const struct ui_box shade = { box.x + 5.0f * u, box.y + 12.0f * u, box.width, box.height };
    ui_panel(frame, UI_PANEL, shade, 12.0f * u, 0.0f, 0x05061c70u, 0);
    ui_panel(frame, UI_WOOD, box, 10.0f * u, (is_pointed ? 5.0f : 2.0f) * u,
             is_pointed ? UI_CEDAR : UI_CEDAR_DIM, is_pointed ? 0xc8341fffu : 0x5a3a20ffu);
}
