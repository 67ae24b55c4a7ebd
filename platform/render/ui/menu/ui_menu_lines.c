/* ui_menu_lines.c -- draws the page of input lines. A cell for each button has a lamp, which is lit
 * while the button is pressed. A further cell shows the number of inserted coins. The lower corners
 * of each cell show the input line before debouncing: its level, its number of changes and its
 * number of faults. */
#include <stdio.h>

#include "core/base/panic.h"
#include "platform/render/ui/menu/ui_menu.h"
#include "platform/render/ui/text.h"

#define CLINK_S 0.5f
#define STATE_ROWS 2u /* Number of text rows for the status line that describes all input lines. */

static const enum text_key names[INPUT_BUTTON_COUNT + 1u] = {
    TEXT_LINE_START, TEXT_LINE_LEFT,    TEXT_LINE_RIGHT, TEXT_LINE_OK,   TEXT_LINE_LANGUAGE,
    TEXT_LINE_TEST,  TEXT_LINE_SERVICE, TEXT_LINE_TILT,  TEXT_LINE_DOOR, TEXT_LINE_COIN,
};
/* Index of the page's cell for the coin input line. The cells of the buttons come before this cell,
 * in the order of the buttons' bits. */
#define COIN INPUT_BUTTON_COUNT

/* Draws the state of the input line before debouncing in the lower corners of `box`: a square lamp
 * for the level, the number of changes, and in red the number of invalid changes. */
static void raw_line(const struct ui_frame *frame, uint32_t index, struct ui_box box)
{
    CORE_ASSERT(index <= COIN);
    const float u = frame->unit, size = 16.0f * u;
    const struct scene_devices *const devices = &frame->scene->devices;
    struct scene_line line = devices->line[index];
    uint32_t bits = 1u << index;
    for (uint32_t i = 1; index == COIN && i < COIN_LINE_COUNT; i++) {
        line.edges += devices->line[COIN + i].edges;
        line.faults += devices->line[COIN + i].faults;
        bits |= 1u << (COIN + i);
    }
    const bool is_raw = (devices->line_raw & bits) != 0;
    const float y = box.y + box.height - 22.0f * u;
    char digits[12];
    ui_panel(frame, UI_PANEL, (struct ui_box){ box.x + 14.0f * u, y - 0.5f * size, size, size },
             3.0f * u, 1.5f * u, is_raw ? 0xffd070feu : 0x4a3630ffu, MENU_INK);
    snprintf(digits, sizeof digits, "%u", line.edges % 1000000u);
    ui_words_at(frame, box.x + 38.0f * u, y, 0.5f * box.width, 0.0f,
                ui_body(frame, 22.0f, MENU_INK_SOFT), digits);
    if (line.faults > 0) {
        snprintf(digits, sizeof digits, "%u", line.faults % 10000u);
        ui_words_at(frame, box.x + box.width - 14.0f * u, y, 0.3f * box.width, 1.0f,
                    ui_body(frame, 22.0f, MENU_INK_CHANGED), digits);
    }
}

/* Draws the cell of an input line. The lamp is above the name and the count. On an upright screen
 * the lamp is beside the name and the count. */
static void draw_input_line(const struct ui_frame *frame, uint32_t index, float lit, uint32_t count)
{
    CORE_ASSERT(index <= COIN);
    const bool is_upright = frame->is_upright;
    const uint32_t columns = is_upright ? 2u : 5u;
    const struct layout_box cell =
        is_upright ? canvas_box(27, 206, 385, 150) : canvas_box(59, 118, 218, 188);
    const float gap = is_upright ? 30.0f : 18.0f;
    const struct ui_box box =
        ui_place(frame, canvas_box(cell.x + (float)(index % columns) * (cell.width + gap),
                                   cell.y + (float)(index / columns) * (cell.height + gap),
                                   cell.width, cell.height));
    const float u = frame->unit;
    char digits[12];
    snprintf(digits, sizeof digits, "%u", count);
    ui_wooden_tag(frame, box, false);
    const bool is_missing = (frame->scene->devices.buttons_missing >> index & 1u) != 0;
    if (is_missing) {
        /* A red slip replaces the lamp if a configured input line is missing. */
        const struct ui_box slip = { box.x + (is_upright ? 12.0f : 24.0f) * u,
                                     box.y + (is_upright ? 54.0f : 26.0f) * u,
                                     is_upright ? 134.0f * u : box.width - 48.0f * u, 42.0f * u };
        ui_panel(frame, UI_PANEL, slip, 8.0f * u, 1.5f * u, MENU_BAD, 0xffe7b0a0u);
        ui_label_in(frame, ui_inset(slip, 6.0f * u), 22.0f, UI_CREAM, TEXT_LINE_MISSING);
    } else {
        const float x = box.x + (is_upright ? 74.0f * u : 0.5f * box.width);
        const float y = box.y + (is_upright ? 0.5f * box.height : 46.0f * u);
        const float radius = (is_upright ? 36.0f : 29.0f) * u;
        const bool is_lit = lit > 0.5f;
        if (lit > 0.0f) {
            ui_glow(frame, ui_around(x, y, 3.2f * radius), ui_fade(0xff8a30ffu, 0.9f * lit));
        }
        ui_disc(frame, x, y, radius, 3.0f * u, is_lit ? 0xffd070ffu : 0x3a2a30ffu,
                is_lit ? 0xfff4deffu : 0x6b5a50ffu);
    }
    const float left = box.x + (is_upright ? (is_missing ? 152.0f : 130.0f) : 10.0f) * u;
    const float width = box.x + box.width - 12.0f * u - left;
    const float top = box.y + (is_upright ? 12.0f : 76.0f) * u;
    ui_label_in(frame, (struct ui_box){ left, top, width, 40.0f * u }, 27.0f, MENU_INK,
                names[index]);
    ui_words_in(frame, (struct ui_box){ left, top + 40.0f * u, width, 46.0f * u },
                ui_style(frame, FONT_STALL, 36.0f, 0.0f, MENU_INK_SOFT, 0.0f), digits);
    raw_line(frame, index, box);
}

/* Draws the status line of the input lines, the note that coins inserted on this page count only as
 * a test, and the number of input faults. */
static void draw_input_line_notes(const struct ui_frame *frame)
{
    const struct scene_devices *const devices = &frame->scene->devices;
    const bool is_upright = frame->is_upright;
    const struct ui_text warm = ui_body(frame, 24.0f, 0xf0c089ffu);
    const float x = is_upright ? 27.0f : 60.0f, y = is_upright ? 1100.0f : 517.0f;
    const float width = pointer_layout_size(is_upright).x - 2.0f * x;
    /* The status line names the program or device that uses the input lines, and the input lines
     * that are missing. The status line is wrapped into STATE_ROWS rows, and the last row is shrunk
     * to fit. */
    const struct ui_text style =
        ui_body(frame, 22.0f, devices->buttons_missing ? 0xff9c86ffu : MENU_NOTE);
    char row[TEXT_TRANSLATE_SIZE], text[TEXT_TRANSLATE_SIZE];
    text_translate(text, sizeof text, frame->language, devices->lines);
    const char *rest = text;
    for (uint32_t i = 0; i < STATE_ROWS && *rest; i++) {
        menu_take_line(style, &rest, width * frame->unit, i + 1u == STATE_ROWS, row, sizeof row);
        ui_words_in(frame, ui_place(frame, canvas_box(x, y + 28.0f * (float)i, width, 28.0f)),
                    style, row);
    }
    char faults[TEXT_LINE_MAX], words[TEXT_LINE_MAX + 64u];
    const float foot = y + 28.0f * STATE_ROWS;
    text_number(faults, sizeof faults, ui_words(frame, TEXT_LINE_FAULTS), devices->button_faults);
    snprintf(words, sizeof words, "%s%s%s", ui_words(frame, TEXT_TEST_COINS_WORDS),
             is_upright ? "" : "      ", is_upright ? "" : faults);
    ui_words_in(frame, ui_place(frame, canvas_box(x, foot, width, 32.0f)), warm, words);
    /* On an upright screen, the number of faults has a row of its own, because one row is too
     * narrow for the note about coins and the number of faults. */
    if (is_upright) {
        ui_words_in(frame, ui_place(frame, canvas_box(x, foot + 32.0f, width, 32.0f)), warm,
                    faults);
    }
}

void menu_lines(const struct ui_frame *frame)
{
    const struct scene_menu *const menu = &frame->scene->menu;
    for (uint32_t i = 0; i < INPUT_BUTTON_COUNT; i++) {
        draw_input_line(frame, i, menu->held >> i & 1u ? 1.0f : 0.0f, menu->pressed_count[i]);
    }
    draw_input_line(frame, COIN, 1.0f - f_smoothstep(0.0f, CLINK_S, menu->coin_s),
                    menu->test_coins);
    draw_input_line_notes(frame);
}
