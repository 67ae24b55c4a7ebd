/* ui_menu_settings.c -- draws the pages of settings. Each setting has a wooden board, which shows
 * the setting's name, range, default and value. A seal marks a value that differs from its
 * default. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/render/ui/menu/ui_menu.h"

#define ARROW_PAINT 0x5a3418ffu /* Colour of the plate of an arrow that changes a value. */

/* Text size of the range on a board, and margin at the left edge of a board. Both are in canvas
 * units. */
#define RANGE_SIZE 22.0f
#define INSET 22.0f

/* Positions of the texts on a board, in canvas units from the left edge of the board. The range of
 * the setting is beside the name on a wide screen, and below the name on an upright screen. */
struct places {
    float name_size, value_size, name_width;
    float range_x, range_width;
    struct layout_box help, saved;
    uint32_t help_lines;
};

/* Positions on a wide screen and on an upright screen. */
static const struct places layouts[2] = {
    { .name_size = 28.0f,
      .value_size = 30.0f,
      .name_width = 290.0f,
      .range_x = 318.0f,
      .range_width = 380.0f,
      .help = { 60.0f, 556.0f, 1160.0f, 44.0f },
      .help_lines = 1,
      .saved = { 24.0f, 48.0f, 280.0f, 40.0f } },
    { .name_size = 30.0f,
      .value_size = 34.0f,
      .name_width = 440.0f,
      .range_x = 22.0f,
      .range_width = 440.0f,
      .help = { 27.0f, 1126.0f, 800.0f, 100.0f },
      .help_lines = 3,
      .saved = { 27.0f, 152.0f, 300.0f, 40.0f } },
};

/* ---- Texts of values and ranges ------------------------------------------------------------- */

/* Writes the value of a setting as a text, such as "5 min", "never" or "18:30". */
static void value_words(const struct ui_frame *frame, uint32_t id, int32_t value, char *out,
                        size_t out_size)
{
    CORE_ASSERT(id < SETTING_COUNT && out_size > 0);
    const struct setting_words *const words = menu_setting_words_of(id);
    const struct setting *const setting = settings_entry(id);
    if (setting->kind == KIND_CHOICE && words->choices[0]) {
        snprintf(out, out_size, "%s", ui_words(frame, words->choices[value]));
    } else if (setting->kind == KIND_BITS) {
        snprintf(out, out_size, "%d / %d", __builtin_popcount((uint32_t)value),
                 __builtin_popcount((uint32_t)setting->max));
    } else if (setting->kind == KIND_MINUTE) {
        snprintf(out, out_size, "%02d:%02d", (int)value / 60, (int)value % 60);
    } else if (words->unit == TEXT_VAL_PER_MILLE) {
        /* This setting is in per mille, and its value is shown in per cent with one decimal
         * place. */
        snprintf(out, out_size, "%d.%d %%", (int)value / 10, (int)value % 10);
    } else {
        const enum text_key special = value == 0 ? words->zero : value == 1 ? words->one : 0;
        text_number(out, out_size, ui_words(frame, special ? special : words->unit),
                    (uint32_t)value);
    }
}

/* Writes the range of a setting, such as "5 - 240 min" or "0.0 - 10.0 %". If the value 0 has its
 * own text, this text comes before the range ("silent / 1 - 10"). However, if 0 is the default, its
 * text is omitted because the board shows the default beside the range. */
static void span_words(const struct ui_frame *frame, uint32_t id, char *out, size_t out_size)
{
    const struct setting_words *const words = menu_setting_words_of(id);
    const struct setting *const setting = settings_entry(id);
    const bool has_zero = setting->min == 0 && words->zero != 0;
    const bool lists_zero = has_zero && setting->standard != 0;
    const char *unit = words->one ? "{}" : ui_words(frame, words->unit);
    const char *hole = strstr(unit, "{}");
    const int max = (int)(id == SET_FISH ? (int32_t)frame->scene->menu.fish_max : setting->max);
    int32_t min = setting->min;
    while (has_zero && (min == 0 || !settings_allows(id, min))) {
        min += setting->step;
    }
    if (words->unit == TEXT_VAL_PER_MILLE) {
        snprintf(out, out_size, "0.0 - %d.%d %%", max / 10, max % 10);
        return;
    }
    snprintf(out, out_size, "%s%s%.*s%d - %d%s", lists_zero ? ui_words(frame, words->zero) : "",
             lists_zero ? " / " : "", hole ? (int)(hole - unit) : 0, unit, (int)min, max,
             hole ? hole + 2 : "");
}

void menu_range_words(const struct ui_frame *frame, uint32_t id, char *out, size_t out_size)
{
    const struct setting *const setting = settings_entry(id);
    char standard[TEXT_LINE_MAX / 2u], range[TEXT_LINE_MAX] = "";
    if (setting->kind == KIND_CHOICE && menu_setting_words_of(id)->choices[0]) {
        size_t used = 0; /* The range is a list of the choices, such as "free / paid / event". */
        for (int32_t value = 0; value <= setting->max && used < sizeof range; value++) {
            char word[TEXT_LINE_MAX / 2u];
            value_words(frame, id, value, word, sizeof word);
            used += (size_t)snprintf(range + used, sizeof range - used, "%s%s", value ? " / " : "",
                                     word);
        }
    } else if (setting->kind == KIND_MINUTE) {
        snprintf(range, sizeof range, "00:00 - %02d:%02d", (int)setting->max / 60,
                 (int)setting->max % 60);
    } else if (setting->kind != KIND_BITS) {
        span_words(frame, id, range, sizeof range);
    }
    value_words(frame, id, setting->standard, standard, sizeof standard);
    snprintf(out, out_size, "%s%s%s %s", range, range[0] ? "   " : "",
             ui_words(frame, TEXT_SET_STANDARD), standard);
}

/* ---- Boards, one for each setting ----------------------------------------------------------- */

static struct ui_text sized(const struct ui_frame *frame, struct ui_box box, float size,
                            uint32_t fill)
{
    return ui_body(frame, fminf(size, 0.74f * box.height / frame->unit), fill);
}

void menu_seal(const struct ui_frame *frame, float x, float y)
{
    const float u = frame->unit;
    ui_panel(frame, UI_PANEL, ui_around(x, y, 8.0f * u), 3.0f * u, 0.0f, MENU_INK_CHANGED, 0);
}

/* Texts on the board of a setting or of one bit of a setting. */
struct board {
    const char *name, *range, *value;
    uint32_t ink;    /* Colour of the value if the value is the default. */
    bool is_changed; /* True if the value differs from its default. */
    uint32_t tag;    /* Item of the page to which the board belongs. */
};

/* Draws the value of a board, and the arrows beside it if the menu offers them. */
static void draw_value(const struct ui_frame *frame, struct ui_box box, float size,
                       const struct board *board)
{
    const struct scene_menu *const menu = &frame->scene->menu;
    const struct layout_box row =
        menu_box(menu->upright, menu->page, menu->rules, menu->tags, board->tag);
    const struct ui_box arrows[2] = { ui_place(frame, menu_arrow_box(row, true)),
                                      ui_place(frame, menu_arrow_box(row, false)) };
    const float left = arrows[0].x + arrows[0].width, middle = box.y + 0.47f * box.height;
    const float room = arrows[1].x - left - 16.0f * frame->unit;
    ui_words_at(frame, 0.5f * (left + arrows[1].x), middle, room, 0.5f,
                sized(frame, box, size, board->is_changed ? MENU_INK_CHANGED : board->ink),
                board->value);
    for (int i = 0; i < 2 && menu_has_arrows(menu->page, menu->rules, board->tag); i++) {
        const float way = (float)(2 * i - 1) * 26.0f * frame->unit;
        const struct ui_box at = { arrows[i].x + 3.0f * frame->unit, box.y + 0.08f * box.height,
                                   arrows[i].width - 6.0f * frame->unit, 0.78f * box.height };
        ui_panel(frame, UI_PANEL, at, 8.0f * frame->unit, 0.0f, ARROW_PAINT, 0);
        ui_arrow(frame, arrows[i].x + 0.5f * (arrows[i].width - way), middle, way, 0.0f, UI_CREAM);
    }
}

static void draw_board(const struct ui_frame *frame, const struct places *places, struct ui_box box,
                       const struct board *board)
{
    const float u = frame->unit, middle = box.y + 0.47f * box.height;
    const float name_y = frame->is_upright ? box.y + 0.30f * box.height : middle;
    const float range_y = frame->is_upright ? box.y + 0.70f * box.height : middle;
    ui_words_at(frame, box.x + INSET * u, name_y, places->name_width * u, 0.0f,
                sized(frame, box, places->name_size, MENU_INK), board->name);
    ui_words_at(frame, box.x + places->range_x * u, range_y, places->range_width * u, 0.0f,
                sized(frame, box, RANGE_SIZE, MENU_INK_SOFT), board->range);
    draw_value(frame, box, places->value_size, board);
    if (board->is_changed) {
        menu_seal(frame, box.x + 0.5f * INSET * u, middle);
    }
}

/* Draws the description `words` above the tags at the bottom of the page. If a setting has been
 * changed, also draws whether the last change has been written to disk. */
static void draw_setting_notes(const struct ui_frame *frame, const struct places *places,
                               const char *words)
{
    const struct scene_menu *const menu = &frame->scene->menu;
    const struct ui_text style = ui_body(frame, 25.0f, UI_CREAM);
    struct ui_box box = ui_place(frame, places->help);
    box.height /= (float)places->help_lines;
    char line[TEXT_LINE_MAX];
    for (uint32_t i = 0; i < places->help_lines && *words; i++) {
        menu_take_line(style, &words, box.width, i + 1u == places->help_lines, line, sizeof line);
        ui_words_in(frame,
                    (struct ui_box){ box.x, box.y + (float)i * box.height, box.width, box.height },
                    style, line);
    }
    if (!menu->is_saved || menu->has_turned) {
        ui_label_in(frame, ui_place(frame, places->saved), 22.0f, MENU_NOTE,
                    menu->is_saved ? TEXT_SET_SAVED : TEXT_SET_SAVING);
    }
}

static void draw_tag_board(const struct ui_frame *frame, const struct places *places, uint32_t tag)
{
    const struct scene_menu *const menu = &frame->scene->menu;
    if (!(menu->tags >> tag & 1u)) {
        return;
    }
    const struct ui_box box = menu_tag_board(frame, tag);
    const uint32_t id = menu_setting_at(menu->page, menu->rules, tag);
    if (id < SETTING_COUNT) {
        char range[TEXT_LINE_MAX], value[TEXT_LINE_MAX];
        menu_range_words(frame, id, range, sizeof range);
        value_words(frame, id, menu->settings.value[id], value, sizeof value);
        draw_board(
            frame, places, box,
            &(struct board){ .name = ui_words(frame, menu_setting_words_of(id)->name),
                             .range = range,
                             .value = value,
                             .ink = MENU_INK,
                             .is_changed = menu->settings.value[id] != settings_entry(id)->standard,
                             .tag = tag });
    } else {
        ui_words_in(
            frame, box, sized(frame, box, places->name_size, MENU_INK),
            ui_words(frame, menu_words_of(menu_page_at(menu->page, menu->rules, tag))->title));
    }
}

void menu_settings(const struct ui_frame *frame)
{
    const struct scene_menu *const menu = &frame->scene->menu;
    const struct places *const places = &layouts[frame->is_upright];
    const uint32_t body_count = menu_body_count(menu->page, menu->rules);
    const bool is_row = menu->tag < body_count;
    if (is_row) {
        /* The selected board is drawn first, so that its glow is behind the neighbouring boards. */
        draw_tag_board(frame, places, menu->tag);
    }
    for (uint32_t tag = 0; tag < body_count; tag++) {
        if (tag != menu->tag) {
            draw_tag_board(frame, places, tag);
        }
    }
    const uint8_t row = is_row ? menu->tag : menu->chosen;
    const uint32_t id = menu_setting_at(menu->page, menu->rules, row);
    const uint8_t page = menu_page_at(menu->page, menu->rules, row);
    char words[2u * TEXT_LINE_MAX] = "", standard[TEXT_LINE_MAX / 2u];
    const char *help = words;
    if (is_row && id < SETTING_COUNT) {
        help = ui_words(frame, menu_setting_words_of(id)->help);
    } else if (is_row && page < MENU_PAGE_COUNT) {
        help = ui_words(frame, menu_words_of(page)->about);
    } else if (menu->tag == body_count + SETTINGS_STANDARD && id < SETTING_COUNT) {
        value_words(frame, id, settings_entry(id)->standard, standard, sizeof standard);
        snprintf(words, sizeof words, "%s → %s", ui_words(frame, menu_setting_words_of(id)->name),
                 standard);
    }
    draw_setting_notes(frame, places, help);
}

/* Draws the page of a setting that is a bit mask, with one wooden board for each bit. A board shows
 * the bit's range (on / off), default and value. A seal marks a bit that differs from its
 * default. */
void menu_bits(const struct ui_frame *frame)
{
    const struct scene_menu *const menu = &frame->scene->menu;
    const struct places *const places = &layouts[frame->is_upright];
    const uint32_t id = menu_page_desc_of(menu->page)->topic;
    const struct setting_words *const words = menu_setting_words_of(id);
    const char *const states[2] = { ui_words(frame, TEXT_BIT_OFF), ui_words(frame, TEXT_BIT_ON) };
    for (uint32_t bit = 0; bit < menu_body_count(menu->page, menu->rules); bit++) {
        if (!(menu->tags >> bit & 1u)) {
            continue;
        }
        const bool is_on = (menu->settings.value[id] >> bit & 1) != 0;
        const bool is_standard = (settings_entry(id)->standard >> bit & 1) != 0;
        char range[TEXT_LINE_MAX];
        snprintf(range, sizeof range, "%.60s / %.60s    %.60s %.60s", states[1], states[0],
                 ui_words(frame, TEXT_SET_STANDARD), states[is_standard]);
        draw_board(frame, places, menu_tag_board(frame, bit),
                   &(struct board){ .name = ui_words(frame, words->choices[bit]),
                                    .range = range,
                                    .value = states[is_on],
                                    .ink = is_on ? MENU_INK_ON : MENU_INK_SOFT,
                                    .is_changed = is_on != is_standard,
                                    .tag = bit });
    }
    draw_setting_notes(frame, places, ui_words(frame, words->help));
}
