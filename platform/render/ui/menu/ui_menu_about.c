/* ui_menu_about.c -- draws the page about this machine, which shows the program's version, the
 * state of the account books, and the status line of each device. Also draws the page of files. */
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/core.h"
#include "platform/render/ui/menu/ui_menu.h"
#include "platform/render/ui/text.h"

/* Layout of the page in canvas units. */
struct places {
    struct layout_box page;
    float name_width; /* Width of the column of device names. 0 means that each name is above its
                         status line. */
    float head, pitch, line;
    uint32_t line_count;
};

/* Layouts of a wide screen (index 0) and of an upright screen (index 1). */
static const struct places layouts[2] = {
    { { 60, 120, 1160, 474 }, 150, 60, 58, 28, 2 },
    { { 27, 200, 800, 1020 }, 0, 108, 128, 29, 3 },
};

static void draw_device_row(const struct ui_frame *frame, const struct places *places,
                            struct ui_box box, uint32_t index)
{
    CORE_ASSERT(index < ABOUT_COUNT);
    static const enum text_key names[ABOUT_COUNT] = {
        TEXT_DEVICE_DISPLAY, TEXT_DEVICE_SOUND,    TEXT_DEVICE_STORE,    TEXT_DEVICE_CONTROLLERS,
        TEXT_DEVICE_BUTTONS, TEXT_DEVICE_SWITCHES, TEXT_DEVICE_WATCHDOG,
    };
    const float u = frame->unit;
    const bool is_beside = places->name_width > 0.0f;
    const struct ui_text style = ui_body(frame, 22.0f, UI_INK);
    const float top = box.y + (places->head + (float)index * places->pitch) * u;
    const float left = box.x + (22.0f + places->name_width) * u;
    const float room = box.x + box.width - 22.0f * u - left;
    char row[TEXT_TRANSLATE_SIZE], text[TEXT_TRANSLATE_SIZE];
    text_translate(text, sizeof text, frame->language, frame->scene->devices.about[index]);
    const char *words = *text ? text : ui_words(frame, TEXT_DEVICE_NONE);
    ui_label_at(frame, box.x + 22.0f * u, top + 0.5f * places->line * u,
                is_beside ? (places->name_width - 12.0f) * u : room, 24.0f, 0xa85a12ffu,
                names[index]);
    const uint32_t first = is_beside ? 0u : 1u, end = first + places->line_count;
    for (uint32_t i = first; i < end && *words; i++) {
        menu_take_line(style, &words, room, i + 1u == end, row, sizeof row);
        ui_words_at(frame, left, top + ((float)i + 0.5f) * places->line * u, room, 0.0f, style,
                    row);
    }
}

void menu_about(const struct ui_frame *frame)
{
    const struct places *const places = &layouts[frame->is_upright];
    const struct scene_menu *const menu = &frame->scene->menu;
    const float u = frame->unit;
    const struct ui_box box = ui_place(frame, places->page);
    menu_paper(frame, box);
    /* The heading has two parts. The first part is a line such as "Kingyo 0.1.0 Start no. 12
     * Running for 340 min". The second part is the number of the last entry of the account books
     * and the number of the last entry on disk. */
    const struct ui_text style = ui_body(frame, 27.0f, UI_INK);
    char boots[TEXT_LINE_MAX / 2u], up[TEXT_LINE_MAX / 2u], words[TEXT_LINE_MAX];
    text_number(boots, sizeof boots, ui_words(frame, TEXT_LEDGER_LINE), menu->boot);
    text_number(up, sizeof up, ui_words(frame, TEXT_UP_LINE),
                frame->scene->tick / (60u * CORE_TICK_HZ));
    /* True if the two parts of the heading are beside each other. */
    const bool is_one = places->name_width > 0.0f;
    const float room = box.width - 44.0f * u, x = box.x + 22.0f * u;
    const float y = box.y + (is_one ? 0.5f : 0.28f) * places->head * u;
    snprintf(words, sizeof words, "Kingyo %s    %.60s    %.60s", KINGYO_VERSION, boots, up);
    ui_words_at(frame, x, y, is_one ? 0.6f * room : room, 0.0f, style, words);
    snprintf(words, sizeof words, "%s %u    %s %u", ui_words(frame, TEXT_LEDGER_ENTRIES),
             menu->last_id, ui_words(frame, TEXT_LEDGER_SAVED), menu->saved_id);
    ui_words_at(frame, is_one ? x + room : x, is_one ? y : box.y + 0.7f * places->head * u,
                is_one ? 0.39f * room : room, is_one ? 1.0f : 0.0f, style, words);
    for (uint32_t i = 0; i < ABOUT_COUNT; i++) {
        draw_device_row(frame, places, box, i);
    }
}

/* ---- Page of files --------------------------------------------------------------------------- */

#define WORDS_SIZE (TEXT_TRANSLATE_SIZE + TEXT_LINE_MAX + 4u)

/* Layout of the page of files in canvas units. */
struct file_places {
    float x, y, width, pitch, height;
    float name_height, line_height;
    /* Number of lines that a paper slip has for the reason of a file's fault. These lines are
     * enough for SCENE_LINE_SIZE letters of average width. */
    uint32_t line_count;
    struct layout_box count;
};

/* Layouts of a wide screen (index 0) and of an upright screen (index 1). */
static const struct file_places file_layouts[2] = {
    { 60, 116, 1160, 95, 89, 33, 23.5f, 2, { 60, 48, 260, 44 } },
    { 27, 196, 800, 131, 123, 42, 25, 3, { 27, 150, 200, 40 } },
};

/* Name and colour of each state of a file. */
static const struct {
    enum text_key name;
    uint32_t paint;
} looks[FILE_STATE_COUNT] = {
    [FILE_USED] = { TEXT_FILE_USED, MENU_GOOD },
    [FILE_REFUSED] = { TEXT_FILE_REFUSED, MENU_BAD },
    [FILE_ASIDE] = { TEXT_FILE_ASIDE, MENU_BAD },
    [FILE_SEEN] = { TEXT_FILE_SEEN, 0x5b6172ffu },
};

/* ---- Texts on the paper slips --------------------------------------------------------------- */

size_t menu_fill_line(struct ui_text style, const char *words, float room_px)
{
    CORE_ASSERT(words);
    const char *at = words, *fits = words, *gap = NULL;
    float width_em = 0.0f;
    for (uint32_t code = printable_next(&at); code != 0; code = printable_next(&at)) {
        const struct font_glyph *glyph = text_glyph_or_mark(style.font, code);
        width_em += glyph ? glyph->advance_em : 0.0f;
        if (width_em * style.size_px > room_px && fits > words) {
            return (size_t)((gap ? gap : fits) - words);
        }
        fits = at;
        gap = code == ' ' ? at : gap;
    }
    return strlen(words);
}

void menu_take_line(struct ui_text style, const char **words, float room_px, bool is_last,
                    char *out, size_t out_size)
{
    CORE_ASSERT(out_size > 0);
    const size_t size = is_last ? strlen(*words) : menu_fill_line(style, *words, room_px);
    snprintf(out, out_size, "%.*s", (int)size, *words);
    *words += size;
}

/* ---- Paper slips, one for each file --------------------------------------------------------- */

/* Draws the reason of a file's fault in several lines. The last line is shrunk so that the complete
 * remaining text fits. In row 0, the row of the store, the text begins with the number of lost
 * scores. */
static void draw_file_reason(const struct ui_frame *frame, const struct file_places *places,
                             uint32_t row, const struct scene_file *file, struct ui_box box)
{
    char words[WORDS_SIZE], missed[TEXT_LINE_MAX], line[WORDS_SIZE];
    const uint32_t missed_count = frame->scene->devices.machine.missed;
    size_t length = 0;
    if (row == 0 && missed_count > 0) {
        text_number(missed, sizeof missed, ui_words(frame, TEXT_FILE_MISSED), missed_count);
        length = (size_t)snprintf(words, sizeof words, "%s  ", missed);
    }
    text_translate(words + length, sizeof words - length, frame->language, file->words);
    const char *rest = words;
    struct ui_text style = ui_body(frame, 22.0f, UI_INK_SOFT);
    style.fit_px = box.width;
    for (uint32_t i = 0; i < places->line_count && *rest; i++) {
        menu_take_line(style, &rest, box.width, i + 1u == places->line_count, line, sizeof line);
        ui_text_at(frame, style, box.x,
                   box.y + ((float)i + 0.5f) * (places->line_height * frame->unit), line);
    }
}

static void draw_file_slip(const struct ui_frame *frame, const struct file_places *places,
                           uint32_t index)
{
    const struct scene_file *const file = &frame->scene->devices.file[index];
    const uint32_t row = frame->scene->menu.file_first + index;
    const float u = frame->unit, slip_width = 130.0f * u, slip_height = 30.0f * u;
    const struct ui_box box =
        ui_place(frame, canvas_box(places->x, places->y + (float)index * places->pitch,
                                   places->width, places->height));
    struct ui_box reason = ui_inset(box, 16.0f * u);
    reason.y += places->name_height * u;
    struct ui_text name = ui_body(frame, 26.0f, UI_INK);
    name.fit_px = box.width - slip_width - 48.0f * u;
    char words[SCENE_NAME_SIZE + SCENE_FILE_SIZE];
    /* Row 0 is the store, whose name is a text of the menu. If the name of a file is unknown, as in
     * a recording, the number of the row replaces the name. */
    if (row == 0) {
        snprintf(words, sizeof words, "%s", ui_words(frame, TEXT_FILE_STORE));
    } else if (file->state == FILE_UNKNOWN) {
        snprintf(words, sizeof words, "%u", row);
    } else {
        snprintf(words, sizeof words, "%.*s", (int)SCENE_FILE_SIZE, file->name);
    }
    ui_panel(frame, UI_WASHI, box, 8.0f * u, 1.5f * u, UI_WASHI_WHITE, 0xb5762fffu);
    ui_text_at(frame, name, reason.x, box.y + 0.5f * places->name_height * u + 2.0f * u, words);
    draw_file_reason(frame, places, row, file, reason);
    if (file->state != FILE_UNKNOWN) {
        CORE_ASSERT(file->state < FILE_STATE_COUNT);
        const struct ui_box tag = { box.x + box.width - slip_width - 10.0f * u, box.y + 5.0f * u,
                                    slip_width, slip_height };
        ui_panel(frame, UI_PANEL, tag, 7.0f * u, 0.0f, looks[file->state].paint, 0);
        ui_label_in(frame, ui_inset(tag, 6.0f * u), 22.0f, UI_CREAM, looks[file->state].name);
    }
}

void menu_files(const struct ui_frame *frame)
{
    const struct scene_menu *const menu = &frame->scene->menu;
    const struct file_places *const places = &file_layouts[frame->is_upright];
    const uint32_t shown = menu_files_shown(menu->upright), count = menu->controllers.file_count;
    const uint32_t first = menu->file_first;
    const uint32_t behind = first + shown < count ? first + shown : count;
    char words[32];
    for (uint32_t row = first; row < behind; row++) {
        draw_file_slip(frame, places, row - first);
    }
    if (count > shown) {
        snprintf(words, sizeof words, "%u - %u / %u", first + 1u, behind, count);
        ui_words_in(frame, ui_place(frame, places->count), ui_body(frame, 22.0f, MENU_NOTE), words);
    }
}
