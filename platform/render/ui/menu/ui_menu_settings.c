/* ui_menu_settings.c -- draws the pages of settings. A wooden board for each setting shows its
 * name, range, default and value. */
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/render/ui/menu/ui_menu.h"

/* Colour of a value that differs from its default, dark enough to be readable on wood. */
#define CHANGED_PAINT 0x94140cffu

/* Positions of the texts on a board, in canvas units from the left or the right edge of the
 * board. */
struct places {
    float name_size, value_size, range_size;
    float inset, name_width, value_width;
    float range_x, range_width;
    int two_lines; /* 1 if the range of a setting is below its name, 0 if the range and the name are
                      in one line. */
    struct layout_box help, saved;
    uint32_t help_lines;
};

static const struct places wide = {
    .name_size = 28.0f,
    .value_size = 30.0f,
    .range_size = 22.0f,
    .inset = 22.0f,
    .name_width = 312.0f,
    .value_width = 222.0f,
    .range_x = 346.0f,
    .range_width = 396.0f,
    .help = { 60.0f, 556.0f, 1160.0f, 44.0f },
    .help_lines = 1,
    .saved = { 24.0f, 48.0f, 280.0f, 40.0f },
};
static const struct places upright_places = {
    .name_size = 30.0f,
    .value_size = 34.0f,
    .range_size = 22.0f,
    .inset = 22.0f,
    .name_width = 480.0f,
    .value_width = 222.0f,
    .range_x = 22.0f,
    .range_width = 480.0f,
    .two_lines = 1,
    .help = { 27.0f, 1126.0f, 800.0f, 100.0f },
    .help_lines = 3,
    .saved = { 27.0f, 152.0f, 300.0f, 40.0f },
};

/* ---- Texts of values and ranges ------------------------------------------------------------- */

static int count_bits(int32_t value)
{
    int count = 0;
    for (; value > 0; value >>= 1) {
        count += value & 1;
    }
    return count;
}

void menu_value_words(const struct menu_view *view, uint32_t id, int32_t value, char *out,
                      size_t out_size)
{
    CORE_ASSERT(id < SETTING_COUNT && out_size > 0);
    const struct setting_words *words = menu_setting_words_of(id);
    switch (settings_entry(id)->kind) {
    case KIND_CHOICE:
        if (words->choices[0]) {
            snprintf(out, out_size, "%s", menu_text(view, words->choices[value]));
            return;
        }
        break;
    case KIND_BITS:
        snprintf(out, out_size, "%d / %d", count_bits(value), count_bits(settings_entry(id)->max));
        return;
    case KIND_MINUTE:
        snprintf(out, out_size, "%02d:%02d", (int)value / 60, (int)value % 60);
        return;
    default:
        break;
    }
    if (words->unit == TEXT_VAL_PER_MILLE) {
        /* A value in per mille is shown in per cent with one decimal place. */
        snprintf(out, out_size, "%d.%d %%", (int)value / 10, (int)value % 10);
        return;
    }
    const enum text_key special = value == 0 ? words->zero : value == 1 ? words->one : 0;
    text_number(out, out_size, menu_text(view, special ? special : words->unit), (uint32_t)value);
}

/* Writes the choices of a setting, such as "free / paid / event". */
static void choice_words(const struct menu_view *view, uint32_t id, char *out, size_t out_size)
{
    size_t used = 0;
    out[0] = 0;
    for (int32_t value = 0; value <= settings_entry(id)->max && used < out_size; value++) {
        char word[TEXT_LINE_MAX / 2u];
        menu_value_words(view, id, value, word, sizeof word);
        used += (size_t)snprintf(out + used, out_size - used, "%s%s", value ? " / " : "", word);
    }
}

/* Writes the range of a setting, such as "5 - 240 min" or "0.0 - 10.0 %". If the value 0 has its
 * own text, this text is listed before the range ("silent / 1 - 10"). The text is omitted if the
 * default value beside the range already shows the text. */
static void span_words(const struct menu_view *view, uint32_t id, char *out, size_t out_size)
{
    const struct setting_words *words = menu_setting_words_of(id);
    const int has_zero = settings_entry(id)->min == 0 && words->zero != 0;
    const char *unit = words->one ? "{}" : menu_text(view, words->unit);
    const char *hole = strstr(unit, "{}");
    const int max = (int)(id == SET_FISH ? (int32_t)view->menu->fish_max : settings_entry(id)->max);
    int32_t min = settings_entry(id)->min;
    char span[48];
    while (has_zero && (min == 0 || !settings_allows(id, min))) {
        min += settings_entry(id)->step;
    }
    if (words->unit == TEXT_VAL_PER_MILLE) {
        snprintf(out, out_size, "0.0 - %d.%d %%", max / 10, max % 10);
        return;
    }
    snprintf(span, sizeof span, "%d - %d", (int)min, max);
    snprintf(out, out_size, "%s%s%.*s%s%s",
             has_zero && settings_entry(id)->standard != 0 ? menu_text(view, words->zero) : "",
             has_zero && settings_entry(id)->standard != 0 ? " / " : "",
             hole ? (int)(hole - unit) : 0, unit, span, hole ? hole + 2 : "");
}

void menu_range_words(const struct menu_view *view, uint32_t id, char *out, size_t out_size)
{
    const struct setting *setting = settings_entry(id);
    char standard[TEXT_LINE_MAX / 2u], range[TEXT_LINE_MAX] = "";
    if (setting->kind == KIND_CHOICE && menu_setting_words_of(id)->choices[0]) {
        choice_words(view, id, range, sizeof range);
    } else if (setting->kind == KIND_MINUTE) {
        snprintf(range, sizeof range, "00:00 - %02d:%02d", (int)setting->max / 60,
                 (int)setting->max % 60);
    } else if (setting->kind != KIND_BITS) {
        span_words(view, id, range, sizeof range);
    }
    menu_value_words(view, id, setting->standard, standard, sizeof standard);
    snprintf(out, out_size, "%s%s%s %s", range, range[0] ? "    " : "",
             menu_text(view, TEXT_SET_STANDARD), standard);
}

/* ---- Boards, one for each setting ----------------------------------------------------------- */

static struct ui_text sized(const struct menu_view *view, const struct ui_box *box, float size,
                            uint32_t fill)
{
    const float room = 0.74f * box->height / view->frame.unit;
    return menu_style(view, size < room ? size : room, fill);
}

void menu_seal(const struct menu_view *view, float x, float y)
{
    const float radius = 8.0f * view->frame.unit;
    ui_panel(&view->frame, UI_PANEL,
             (struct ui_box){ x - radius, y - radius, 2.0f * radius, 2.0f * radius },
             3.0f * view->frame.unit, 0.0f, CHANGED_PAINT, 0);
}

static void setting_board(const struct menu_view *view, const struct places *places,
                          struct ui_box box, uint32_t id)
{
    CORE_ASSERT(id < SETTING_COUNT);
    const float u = view->frame.unit;
    const int32_t value = view->menu->settings.value[id];
    const int is_changed = value != settings_entry(id)->standard;
    const float middle = box.y + 0.47f * box.height;
    const float name_y = places->two_lines ? box.y + 0.30f * box.height : middle;
    const float range_y = places->two_lines ? box.y + 0.70f * box.height : middle;
    const struct ui_text name = sized(view, &box, places->name_size, MENU_INK);
    const struct ui_text range = sized(view, &box, places->range_size, MENU_INK_SOFT);
    const struct ui_text number =
        sized(view, &box, places->value_size, is_changed ? CHANGED_PAINT : MENU_INK);
    const float right = box.x + box.width - places->inset * u;
    char words[TEXT_LINE_MAX];
    menu_words_at(view, box.x + places->inset * u, name_y, places->name_width * u, 0.0f, &name,
                  menu_text(view, menu_setting_words_of(id)->name));
    menu_range_words(view, id, words, sizeof words);
    menu_words_at(view, box.x + places->range_x * u, range_y, places->range_width * u, 0.0f, &range,
                  words);
    menu_value_words(view, id, value, words, sizeof words);
    menu_words_at(view, right, middle, places->value_width * u, 1.0f, &number, words);
    if (is_changed) {
        menu_seal(view, right - (places->value_width + 8.0f) * u, middle);
    }
}

/* Draws the description of the selected setting above the tags at the bottom of the page. */
static void draw_setting_help(const struct menu_view *view, const struct places *places,
                              const char *words)
{
    const struct ui_text style = menu_style(view, 25.0f, MENU_CREAM);
    const struct ui_box box = menu_place(view, places->help);
    const float pitch = box.height / (float)places->help_lines;
    char line[TEXT_LINE_MAX];
    for (uint32_t i = 0; i < places->help_lines && *words; i++) {
        menu_take_line(&style, &words, box.width, i + 1u == places->help_lines, line, sizeof line);
        ui_words_in(&view->frame,
                    (struct ui_box){ box.x, box.y + (float)i * pitch, box.width, pitch }, &style,
                    line);
    }
}

/* Draws whether the last change of a setting has been written to disk. Draws nothing before the
 * first change. */
static void draw_saved_state(const struct menu_view *view, const struct places *places)
{
    const struct ui_text style = menu_style(view, 22.0f, 0xc9d2eeffu);
    const int is_saved = view->menu->is_saved;
    if (is_saved && !view->menu->has_turned) {
        return;
    }
    ui_words_in(&view->frame, menu_place(view, places->saved), &style,
                menu_text(view, is_saved ? TEXT_SET_SAVED : TEXT_SET_SAVING));
}

static void draw_tag_board(const struct menu_view *view, const struct places *places, uint32_t tag)
{
    if (!(view->menu->tags >> tag & 1u)) {
        return;
    }
    const struct ui_box box = menu_tag_board(view, tag);
    const uint32_t id = menu_setting_at(view->menu->page, tag);
    if (id < SETTING_COUNT) {
        setting_board(view, places, box, id);
    } else {
        const struct ui_text name = sized(view, &box, places->name_size, MENU_INK);
        ui_words_in(&view->frame, box, &name,
                    menu_text(view, menu_words_of(menu_page_at(view->menu->page, tag))->title));
    }
}

void menu_settings(const struct menu_view *view)
{
    const struct scene_menu *menu = view->menu;
    const struct places *places = menu->upright ? &upright_places : &wide;
    const uint32_t body_count = menu_body_count(menu->page);
    if (menu->tag < body_count) {
        /* The selected board is drawn first, so that its glow is behind the neighbouring boards. */
        draw_tag_board(view, places, menu->tag);
    }
    for (uint32_t tag = 0; tag < body_count; tag++) {
        if (tag != menu->tag) {
            draw_tag_board(view, places, tag);
        }
    }
    const int is_row = menu->tag < body_count;
    const uint8_t row = is_row ? menu->tag : menu->chosen;
    const uint32_t id = menu_setting_at(menu->page, row);
    const uint8_t page = menu_page_at(menu->page, row);
    char words[2u * TEXT_LINE_MAX], standard[TEXT_LINE_MAX / 2u];
    if (is_row && id < SETTING_COUNT) {
        draw_setting_help(view, places, menu_text(view, menu_setting_words_of(id)->help));
    } else if (is_row && page < MENU_PAGE_COUNT) {
        draw_setting_help(view, places, menu_text(view, menu_words_of(page)->about));
    } else if (menu->tag == body_count + SETTINGS_STANDARD && id < SETTING_COUNT) {
        menu_value_words(view, id, settings_entry(id)->standard, standard, sizeof standard);
        snprintf(words, sizeof words, "%s → %s", menu_text(view, menu_setting_words_of(id)->name),
                 standard);
        draw_setting_help(view, places, words);
    }
    draw_saved_state(view, places);
}

/* Draws the board of one bit of a setting that is a bit mask. Like the board of a whole setting,
 * the board shows a range, a default and a seal. */
static void bit_board(const struct menu_view *view, const struct places *places, uint32_t id,
                      uint32_t bit)
{
    const struct ui_box box = menu_tag_board(view, bit);
    const float u = view->frame.unit, middle = box.y + 0.47f * box.height;
    const float name_y = places->two_lines ? box.y + 0.30f * box.height : middle;
    const float range_y = places->two_lines ? box.y + 0.70f * box.height : middle;
    const float right = box.x + box.width - places->inset * u;
    const int is_on = (view->menu->settings.value[id] >> bit & 1) != 0;
    const int is_standard = (settings_entry(id)->standard >> bit & 1) != 0;
    const struct ui_text name = sized(view, &box, places->name_size, MENU_INK);
    const struct ui_text range = sized(view, &box, places->range_size, MENU_INK_SOFT);
    const struct ui_text state = sized(view, &box, places->value_size,
                                       is_on != is_standard ? CHANGED_PAINT
                                       : is_on              ? 0x17754effu
                                                            : MENU_INK_SOFT);
    char words[TEXT_LINE_MAX];
    snprintf(words, sizeof words, "%.60s / %.60s    %.60s %.60s", menu_text(view, TEXT_BIT_ON),
             menu_text(view, TEXT_BIT_OFF), menu_text(view, TEXT_SET_STANDARD),
             menu_text(view, is_standard ? TEXT_BIT_ON : TEXT_BIT_OFF));
    menu_words_at(view, box.x + places->inset * u, name_y, places->name_width * u, 0.0f, &name,
                  menu_text(view, menu_setting_words_of(id)->choices[bit]));
    menu_words_at(view, box.x + places->range_x * u, range_y, places->range_width * u, 0.0f, &range,
                  words);
    menu_words_at(view, right, middle, places->value_width * u, 1.0f, &state,
                  menu_text(view, is_on ? TEXT_BIT_ON : TEXT_BIT_OFF));
    if (is_on != is_standard) {
        menu_seal(view, right - (places->value_width + 8.0f) * u, middle);
    }
}

void menu_bits(const struct menu_view *view)
{
    const struct scene_menu *menu = view->menu;
    const struct places *places = menu->upright ? &upright_places : &wide;
    const uint32_t id = menu_page_desc_of(menu->page)->about;
    const struct setting_words *words = menu_setting_words_of(id);
    for (uint32_t bit = 0; bit < menu_body_count(menu->page); bit++) {
        if (menu->tags >> bit & 1u) {
            bit_board(view, places, id, bit);
        }
    }
    draw_setting_help(view, places, menu_text(view, words->help));
    draw_saved_state(view, places);
}
