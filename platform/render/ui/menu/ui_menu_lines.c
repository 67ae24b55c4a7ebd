/* ui_menu_lines.c -- draws the page of input lines. A cell for each button has a lamp, which is lit
 * while the button is pressed. A further cell shows the number of inserted coins. The lower corners
 * of each cell show the input line before debouncing: its level, its number of changes and its
 * number of faults. */
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/render/ui/menu/ui_menu.h"
#include "platform/render/ui/text.h"

#define CLINK_S 0.5f
#define MISSING_PAINT 0xb3261effu
#define STATE_ROWS 2u /* Number of text rows for the status line of the input lines. */

static const enum text_key names[INPUT_BUTTON_COUNT + 1u] = {
    TEXT_LINE_START, TEXT_LINE_LEFT,    TEXT_LINE_RIGHT, TEXT_LINE_OK,   TEXT_LINE_LANGUAGE,
    TEXT_LINE_TEST,  TEXT_LINE_SERVICE, TEXT_LINE_TILT,  TEXT_LINE_DOOR, TEXT_LINE_COIN,
};
/* Index of the page's cell for the coin input line. The cells of the buttons have the lower
 * indices, in the order of the buttons' bits. */
#define COIN INPUT_BUTTON_COUNT

static struct ui_box input_line_cell(const struct menu_view *view, uint32_t index)
{
    const int upright = view->menu->upright;
    const uint32_t columns = upright ? 2u : 5u;
    const float width = upright ? 385.0f : 218.0f, height = upright ? 150.0f : 188.0f;
    const float gap = upright ? 30.0f : 18.0f;
    const float left = 0.5f * (pointer_layout_size(upright).x - (float)columns * width -
                               (float)(columns - 1u) * gap);
    return menu_place(view,
                      (struct layout_box){
                          left + (float)(index % columns) * (width + gap),
                          (upright ? 206.0f : 118.0f) + (float)(index / columns) * (height + gap),
                          width,
                          height,
                      });
}

/* Draws the state of the input line before debouncing in the lower corners of `box`: a square lamp
 * for the level, the number of changes, and in red the number of invalid changes. */
static void raw_line(const struct menu_view *view, uint32_t index, struct ui_box box)
{
    CORE_ASSERT(index <= COIN);
    const float u = view->frame.unit, size = 16.0f * u;
    const struct scene_devices *devices = view->devices;
    struct scene_line line = devices->line[index];
    uint32_t bits = 1u << index;
    for (uint32_t i = 1; index == COIN && i < COIN_LINE_COUNT; i++) {
        line.edges += devices->line[COIN + i].edges;
        line.faults += devices->line[COIN + i].faults;
        bits |= 1u << (COIN + i);
    }
    const int is_raw = (devices->line_raw & bits) != 0;
    const struct ui_text edges = menu_style(view, 22.0f, MENU_INK_SOFT);
    const struct ui_text faults = menu_style(view, 22.0f, MISSING_PAINT);
    const float y = box.y + box.height - 22.0f * u;
    char digits[12];
    ui_panel(&view->frame, UI_PANEL,
             (struct ui_box){ box.x + 14.0f * u, y - 0.5f * size, size, size }, 3.0f * u, 1.5f * u,
             is_raw ? 0xffd070feu : 0x4a3630ffu, 0x2a160cffu);
    snprintf(digits, sizeof digits, "%u", line.edges % 1000000u);
    menu_words_at(view, box.x + 38.0f * u, y, 0.5f * box.width, 0.0f, &edges, digits);
    if (line.faults > 0) {
        snprintf(digits, sizeof digits, "%u", line.faults % 10000u);
        menu_words_at(view, box.x + box.width - 14.0f * u, y, 0.3f * box.width, 1.0f, &faults,
                      digits);
    }
}

/* Draws the cell of an input line. The lamp is above the name and the count. On an upright screen
 * the lamp is beside the name and the count. */
static void draw_input_line(const struct menu_view *view, uint32_t index, float lit, uint32_t count)
{
    CORE_ASSERT(index <= COIN);
    const struct ui_box box = input_line_cell(view, index);
    const float u = view->frame.unit;
    const int upright = view->menu->upright;
    const struct ui_text name = menu_style(view, 27.0f, MENU_INK);
    const struct ui_text number =
        ui_style(&view->frame, FONT_STALL, 36.0f, 0.0f, MENU_INK_SOFT, 0.0f);
    char digits[12];
    snprintf(digits, sizeof digits, "%u", count);
    ui_wooden_tag(&view->frame, box, 0);
    const int is_missing = (view->devices->buttons_missing >> index & 1u) != 0;
    if (is_missing) {
        /* A red slip replaces the lamp if a configured input line is missing. */
        struct ui_box slip = { box.x + (upright ? 12.0f : 24.0f) * u,
                               box.y + (upright ? 54.0f : 26.0f) * u,
                               upright ? 134.0f * u : box.width - 48.0f * u, 42.0f * u };
        const struct ui_text style = menu_style(view, 22.0f, MENU_CREAM);
        ui_panel(&view->frame, UI_PANEL, slip, 8.0f * u, 1.5f * u, MISSING_PAINT, 0xffe7b0a0u);
        slip.x += 6.0f * u;
        slip.width -= 12.0f * u;
        ui_words_in(&view->frame, slip, &style, menu_text(view, TEXT_LINE_MISSING));
    } else {
        const float x = box.x + (upright ? 74.0f * u : 0.5f * box.width);
        const float y = box.y + (upright ? 0.5f * box.height : 46.0f * u);
        const float radius = (upright ? 36.0f : 29.0f) * u;
        const float glow = 3.2f * radius;
        if (lit > 0.0f) {
            ui_glow(&view->frame, (struct ui_box){ x - glow, y - glow, 2.0f * glow, 2.0f * glow },
                    ui_fade(0xff8a30ffu, 0.9f * lit));
        }
        ui_disc(&view->frame, x, y, radius, 3.0f * u, lit > 0.5f ? 0xffd070ffu : 0x3a2a30ffu,
                lit > 0.5f ? 0xfff4deffu : 0x6b5a50ffu);
    }
    const float left = box.x + (upright ? (is_missing ? 152.0f : 130.0f) : 10.0f) * u;
    const float width = box.x + box.width - 12.0f * u - left;
    const float top = box.y + (upright ? 12.0f : 76.0f) * u;
    ui_words_in(&view->frame, (struct ui_box){ left, top, width, 40.0f * u }, &name,
                menu_text(view, names[index]));
    ui_words_in(&view->frame, (struct ui_box){ left, top + 40.0f * u, width, 46.0f * u }, &number,
                digits);
    raw_line(view, index, box);
}

/* Draws the status line of the input lines, the note that coins inserted on this page count only as
 * a test, and the number of input faults. */
static void draw_input_line_notes(const struct menu_view *view)
{
    const int upright = view->menu->upright;
    const struct ui_text warm = menu_style(view, 24.0f, 0xf0c089ffu);
    const float x = upright ? 27.0f : 60.0f, y = upright ? 1100.0f : 517.0f;
    const float width = pointer_layout_size(upright).x - 2.0f * x;
    char faults[TEXT_LINE_MAX], words[TEXT_LINE_MAX + 64u];
    text_number(faults, sizeof faults, menu_text(view, TEXT_LINE_FAULTS),
                view->devices->button_faults);
    snprintf(words, sizeof words, "%s%s%s", menu_text(view, TEXT_TEST_COINS_WORDS),
             upright ? "" : "      ", upright ? "" : faults);
    /* The status line of the input lines has STATE_ROWS rows. The status line names the program or
     * device that uses the input lines, and the input lines that are missing. The last row is
     * shrunk to fit. */
    const uint32_t paint = view->devices->buttons_missing ? 0xff9c86ffu : 0xc9d2eeffu;
    const struct ui_text style = menu_style(view, 22.0f, paint);
    char row[TEXT_TRANSLATE_SIZE], said[TEXT_TRANSLATE_SIZE];
    text_translate(said, sizeof said, view->frame.language, view->devices->lines);
    const char *state_words = said;
    for (uint32_t i = 0; i < STATE_ROWS && *state_words; i++) {
        menu_take_line(&style, &state_words, width * view->frame.unit, i + 1u == STATE_ROWS, row,
                       sizeof row);
        ui_words_in(&view->frame,
                    menu_place(view, (struct layout_box){ x, y + 28.0f * (float)i, width, 28.0f }),
                    &style, row);
    }
    ui_words_in(&view->frame,
                menu_place(view, (struct layout_box){ x, y + 28.0f * STATE_ROWS, width, 32.0f }),
                &warm, words);
    if (upright) { /* On an upright screen, one row is too narrow for the note about coins and the
                      number of faults. */
        ui_words_in(&view->frame,
                    menu_place(view, (struct layout_box){ x, y + 28.0f * STATE_ROWS + 32.0f, width,
                                                          32.0f }),
                    &warm, faults);
    }
}

void menu_lines(const struct menu_view *view)
{
    const struct scene_menu *menu = view->menu;
    for (uint32_t i = 0; i < INPUT_BUTTON_COUNT; i++) {
        draw_input_line(view, i, menu->held >> i & 1u ? 1.0f : 0.0f, menu->pressed_count[i]);
    }
    draw_input_line(view, COIN, 1.0f - ui_smooth(0.0f, CLINK_S, menu->coin_s), menu->test_coins);
    draw_input_line_notes(view);
}
