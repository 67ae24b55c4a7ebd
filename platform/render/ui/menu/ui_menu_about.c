/* ui_menu_about.c -- draws the page about this machine: the program's version, the state of the
 * account books, and the status line of each device. */
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/core.h"
#include "platform/render/ui/menu/ui_menu.h"
#include "platform/render/ui/text.h"

struct places {
    struct layout_box page;
    float name_width; /* Width of the column of device names. 0 means that each name is above its
                         status line. */
    float head, pitch, line;
    uint32_t line_count;
};

static const struct places wide = {
    .page = { 60.0f, 120.0f, 1160.0f, 474.0f },
    .name_width = 150.0f,
    .head = 60.0f,
    .pitch = 58.0f,
    .line = 28.0f,
    .line_count = 2,
};
static const struct places upright_places = {
    .page = { 27.0f, 200.0f, 800.0f, 1020.0f },
    .head = 108.0f,
    .pitch = 128.0f,
    .line = 29.0f,
    .line_count = 3,
};

static void draw_device_row(const struct menu_view *view, const struct places *places,
                            struct ui_box box, uint32_t index)
{
    CORE_ASSERT(index < ABOUT_COUNT);
    static const enum text_key names[ABOUT_COUNT] = {
        TEXT_DEVICE_DISPLAY, TEXT_DEVICE_SOUND,    TEXT_DEVICE_STORE,    TEXT_DEVICE_CONTROLLERS,
        TEXT_DEVICE_BUTTONS, TEXT_DEVICE_SWITCHES, TEXT_DEVICE_WATCHDOG,
    };
    const float u = view->frame.unit;
    const int is_beside = places->name_width > 0.0f;
    const struct ui_text name = menu_style(view, 24.0f, 0xa85a12ffu);
    const struct ui_text style = menu_style(view, 22.0f, UI_INK);
    const float top = box.y + (places->head + (float)index * places->pitch) * u;
    const float left = box.x + (22.0f + places->name_width) * u;
    const float room = box.x + box.width - 22.0f * u - left;
    char row[TEXT_TRANSLATE_SIZE], said[TEXT_TRANSLATE_SIZE];
    text_translate(said, sizeof said, view->frame.language, view->devices->about[index]);
    const char *words = *said ? said : menu_text(view, TEXT_DEVICE_NONE);
    menu_words_at(view, box.x + 22.0f * u, top + 0.5f * places->line * u,
                  is_beside ? (places->name_width - 12.0f) * u : room, 0.0f, &name,
                  menu_text(view, names[index]));
    for (uint32_t i = is_beside ? 0u : 1u; i < places->line_count + (is_beside ? 0u : 1u) && *words;
         i++) {
        const int is_last = i + 1u == places->line_count + (is_beside ? 0u : 1u);
        menu_take_line(&style, &words, room, is_last, row, sizeof row);
        menu_words_at(view, left, top + ((float)i + 0.5f) * places->line * u, room, 0.0f, &style,
                      row);
    }
}

void menu_about(const struct menu_view *view)
{
    const struct places *places = view->menu->upright ? &upright_places : &wide;
    const float u = view->frame.unit;
    const struct ui_box box = menu_place(view, places->page);
    ui_panel(&view->frame, UI_WASHI, box, 10.0f * u, 2.0f * u, UI_WASHI_WHITE, 0xb5762fffu);
    /* The heading has two parts. The first part is a line such as "Kingyo 0.1.0 Start no. 12
     * Running for 340 min". The second part is the number of the last entry of the account books
     * and the number of the last entry on disk. */
    const struct scene_menu *menu = view->menu;
    const struct ui_text style = menu_style(view, 27.0f, UI_INK);
    char boots[TEXT_LINE_MAX / 2u], up[TEXT_LINE_MAX / 2u], first[TEXT_LINE_MAX];
    char second[TEXT_LINE_MAX];
    text_number(boots, sizeof boots, menu_text(view, TEXT_LEDGER_LINE), menu->boot);
    text_number(up, sizeof up, menu_text(view, TEXT_UP_LINE),
                view->scene->tick / (60u * CORE_TICK_HZ));
    snprintf(first, sizeof first, "Kingyo %s    %.60s    %.60s", KINGYO_VERSION, boots, up);
    snprintf(second, sizeof second, "%s %u    %s %u", menu_text(view, TEXT_LEDGER_ENTRIES),
             menu->last_id, menu_text(view, TEXT_LEDGER_SAVED), menu->saved_id);
    const int is_one = places->name_width > 0.0f;
    const float room = box.width - 44.0f * u, x = box.x + 22.0f * u;
    const float y = box.y + (is_one ? 0.5f : 0.28f) * places->head * u;
    menu_words_at(view, x, y, is_one ? 0.6f * room : room, 0.0f, &style, first);
    menu_words_at(view, is_one ? x + room : x, is_one ? y : box.y + 0.7f * places->head * u,
                  is_one ? 0.39f * room : room, is_one ? 1.0f : 0.0f, &style, second);
    for (uint32_t i = 0; i < ABOUT_COUNT; i++) {
        draw_device_row(view, places, box, i);
    }
}

/* ---- Page of files --------------------------------------------------------------------------- */

#define WORDS_SIZE (TEXT_TRANSLATE_SIZE + TEXT_LINE_MAX + 4u)

struct file_places {
    float x, y, width, pitch, height;
    float name_height, line_height;
    uint32_t line_count; /* Number of lines that are available for the reason of a fault. A text of
                            SCENE_LINE_SIZE letters of average width fits in these lines. */
    struct layout_box count;
};

static const struct file_places file_wide = {
    .x = 60.0f,
    .y = 116.0f,
    .width = 1160.0f,
    .pitch = 95.0f,
    .height = 89.0f,
    .name_height = 33.0f,
    .line_height = 23.5f,
    .line_count = 2,
    .count = { 60.0f, 48.0f, 260.0f, 44.0f },
};
static const struct file_places file_upright = {
    .x = 27.0f,
    .y = 196.0f,
    .width = 800.0f,
    .pitch = 131.0f,
    .height = 123.0f,
    .name_height = 42.0f,
    .line_height = 25.0f,
    .line_count = 3,
    .count = { 27.0f, 150.0f, 200.0f, 40.0f },
};

struct state_look {
    enum text_key name;
    uint32_t paint;
};
static const struct state_look looks[FILE_STATE_COUNT] = {
    [FILE_USED] = { TEXT_FILE_USED, 0x17754effu },
    [FILE_REFUSED] = { TEXT_FILE_REFUSED, 0xb3261effu },
    [FILE_ASIDE] = { TEXT_FILE_ASIDE, 0xb3261effu },
    [FILE_SEEN] = { TEXT_FILE_SEEN, 0x5b6172ffu },
};

/* ---- Texts on the paper slips --------------------------------------------------------------- */

size_t menu_fill_line(const struct ui_text *style, const char *words, float room_px)
{
    CORE_ASSERT(style && words);
    const char *at = words, *fits = words, *gap = NULL;
    float width_em = 0.0f;
    for (uint32_t code = printable_next(&at); code != 0; code = printable_next(&at)) {
        const struct font_glyph *glyph = text_glyph_or_mark(style->font, code);
        width_em += glyph ? glyph->advance_em : 0.0f;
        if (width_em * style->size_px > room_px && fits > words) {
            return (size_t)((gap ? gap : fits) - words);
        }
        fits = at;
        gap = code == ' ' ? at : gap;
    }
    return strlen(words);
}

void menu_take_line(const struct ui_text *style, const char **words, float room_px, int is_last,
                    char *out, size_t out_size)
{
    CORE_ASSERT(out_size > 0);
    const size_t size = is_last ? strlen(*words) : menu_fill_line(style, *words, room_px);
    snprintf(out, out_size, "%.*s", (int)size, *words);
    *words += size;
}

/* ---- Paper slips, one for each file --------------------------------------------------------- */

/* Writes the text beside a file's state to `out` and returns `out`. The text of the store begins
 * with the number of lost scores. */
static const char *words_of(const struct menu_view *view, uint32_t row,
                            const struct scene_file *file, char *out, size_t out_size)
{
    char missed[TEXT_LINE_MAX];
    size_t length = 0;
    if (row == 0 && view->devices->machine.missed > 0) {
        text_number(missed, sizeof missed, menu_text(view, TEXT_FILE_MISSED),
                    view->devices->machine.missed);
        length = (size_t)snprintf(out, out_size, "%s  ", missed);
    }
    text_translate(out + length, out_size - length, view->frame.language, file->words);
    return out;
}

static void slip(const struct menu_view *view, const struct file_places *places, uint32_t index)
{
    const struct scene_file *file = &view->devices->file[index];
    const uint32_t row = view->menu->file_first + index;
    const float u = view->frame.unit, slip_width = 130.0f * u, slip_height = 30.0f * u;
    const struct ui_box box =
        menu_place(view, (struct layout_box){ places->x, places->y + (float)index * places->pitch,
                                              places->width, places->height });
    const struct ui_box reason = { box.x + 16.0f * u, box.y + places->name_height * u,
                                   box.width - 32.0f * u, box.height };
    struct ui_text name = menu_style(view, 26.0f, UI_INK);
    char words[SCENE_NAME_SIZE + SCENE_FILE_SIZE], said[WORDS_SIZE];
    /* Row 0 is the store, whose name is a text of the menu. If the name of a file is unknown, as in
     * a recording, the number of the row replaces the name. */
    if (row == 0) {
        snprintf(words, sizeof words, "%s", menu_text(view, TEXT_FILE_STORE));
    } else if (file->state == FILE_UNKNOWN) {
        snprintf(words, sizeof words, "%u", row);
    } else {
        snprintf(words, sizeof words, "%.*s", (int)SCENE_FILE_SIZE, file->name);
    }
    ui_panel(&view->frame, UI_WASHI, box, 8.0f * u, 1.5f * u, UI_WASHI_WHITE, 0xb5762fffu);
    name.fit_px = box.width - slip_width - 48.0f * u;
    ui_text_at(&view->frame, &name, reason.x, box.y + 0.5f * places->name_height * u + 2.0f * u,
               words);
    /* The reason of a fault has several lines. The last line is shrunk so that the complete
     * remaining text fits. */
    const char *rest = words_of(view, row, file, said, sizeof said);
    const struct ui_text style = menu_style(view, 22.0f, UI_INK_SOFT);
    const float pitch = places->line_height * view->frame.unit;
    char line[WORDS_SIZE];
    for (uint32_t i = 0; i < places->line_count && *rest; i++) {
        struct ui_text fitted = style;
        fitted.fit_px = reason.width;
        menu_take_line(&style, &rest, reason.width, i + 1u == places->line_count, line,
                       sizeof line);
        ui_text(view->frame.batch, &fitted, reason.x,
                ui_text_middle(&style, reason.y + ((float)i + 0.5f) * pitch), line);
    }
    if (file->state != FILE_UNKNOWN) {
        CORE_ASSERT(file->state < FILE_STATE_COUNT);
        const struct state_look *const look = &looks[file->state];
        const struct ui_text state = menu_style(view, 22.0f, MENU_CREAM);
        struct ui_box tag = { box.x + box.width - slip_width - 10.0f * u, box.y + 5.0f * u,
                              slip_width, slip_height };
        ui_panel(&view->frame, UI_PANEL, tag, 7.0f * u, 0.0f, look->paint, 0);
        tag.x += 6.0f * u;
        tag.width -= 12.0f * u;
        ui_words_in(&view->frame, tag, &state, menu_text(view, look->name));
    }
}

void menu_files(const struct menu_view *view)
{
    const struct scene_menu *menu = view->menu;
    const struct file_places *places = menu->upright ? &file_upright : &file_wide;
    const uint32_t shown = menu_files_shown(menu->upright), count = menu->controllers.file_count;
    const uint32_t first = menu->file_first;
    const uint32_t behind = first + shown < count ? first + shown : count;
    const struct ui_text style = menu_style(view, 22.0f, 0xc9d2eeffu);
    char words[32];
    for (uint32_t row = first; row < behind; row++) {
        slip(view, places, row - first);
    }
    if (count > shown) {
        snprintf(words, sizeof words, "%u - %u / %u", first + 1u, behind, count);
        ui_words_in(&view->frame, menu_place(view, places->count), &style, words);
    }
}
