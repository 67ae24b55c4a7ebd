/* ui_menu_files.c -- draws the page of files. For each file, a paper slip shows whether the program
 * uses the file. If the program does not use the file, the slip also shows the reason. */
#include <stdio.h>
#include <string.h>

#include "platform/render/ui/menu/ui_menu.h"
#include "platform/render/ui/message_translate.h"

#define WORDS_SIZE (MESSAGE_TRANSLATE_SIZE + TEXT_LINE_MAX + 4u)

struct places {
    float x, y, width, pitch, height;
    float name_height, line_height;
    uint32_t line_count; /* Number of lines that are available for a reason. SCENE_LINE_SIZE letters
                            of average width fit in these lines. */
    struct layout_box count;
};

static const struct places wide = {
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
static const struct places upright_places = {
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
    const char *at = words, *fits = words, *gap = NULL;
    float width_em = 0.0f;
    for (uint32_t code = text_next(&at); code != 0; code = text_next(&at)) {
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

/* Draws a reason in several lines. The last line is shrunk so that it contains the rest of the
 * text. */
static void wrap(const struct menu_view *view, const struct ui_box *box, const char *words,
                 const struct places *places)
{
    const struct ui_text style = menu_style(view, 22.0f, UI_INK_SOFT);
    const float pitch = places->line_height * view->frame.unit;
    char line[WORDS_SIZE];
    for (uint32_t i = 0; i < places->line_count && *words; i++) {
        const int is_last = i + 1u == places->line_count;
        const size_t size = is_last ? strlen(words) : menu_fill_line(&style, words, box->width);
        struct ui_text fitted = style;
        fitted.fit_px = box->width;
        snprintf(line, sizeof line, "%.*s", (int)size, words);
        ui_text(view->frame.batch, &fitted, box->x,
                ui_text_middle(&style, box->y + ((float)i + 0.5f) * pitch), line);
        words += size;
    }
}

/* ---- Paper slips, one for each file --------------------------------------------------------- */

static void state_slip(const struct menu_view *view, struct ui_box box, uint8_t state)
{
    const float u = view->frame.unit;
    const struct ui_text style = menu_style(view, 22.0f, MENU_CREAM);
    ui_shape(view->frame.batch, &(struct ui_shape){ .box = box,
                                                    .kind = UI_PANEL,
                                                    .fill = looks[state].paint,
                                                    .shape = { 0, 0, 7.0f * u, 0 } });
    ui_words_in(&view->frame,
                (struct ui_box){ box.x + 6.0f * u, box.y, box.width - 12.0f * u, box.height },
                &style, menu_text(view, looks[state].name));
}

/* Writes a file's name. Row 0 is the store, whose name is a text of the menu. If the name is
 * unknown, as in a recording, writes the number of the row. */
static void name_of(const struct menu_view *view, uint32_t row, const struct scene_file *file,
                    char *out, size_t out_size)
{
    if (row == 0) {
        snprintf(out, out_size, "%s", menu_text(view, TEXT_FILE_STORE));
    } else if (file->state == FILE_UNKNOWN) {
        snprintf(out, out_size, "%u", row);
    } else {
        snprintf(out, out_size, "%.*s", (int)SCENE_FILE_SIZE, file->name);
    }
}

/* Writes the text beside a file's state to `out` and returns `out`. The store's text begins with
 * the number of lost scores. */
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
    message_translate(out + length, out_size - length, view->frame.language, file->words);
    return out;
}

static void slip(const struct menu_view *view, const struct places *places, uint32_t index)
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
    name_of(view, row, file, words, sizeof words);
    ui_shape(view->frame.batch, &(struct ui_shape){ .box = box,
                                                    .kind = UI_WASHI,
                                                    .fill = UI_WASHI_WHITE,
                                                    .line = 0xb5762fffu,
                                                    .shape = { 0, 0, 8.0f * u, 1.5f * u } });
    name.fit_px = box.width - slip_width - 48.0f * u;
    ui_text(view->frame.batch, &name, reason.x,
            ui_text_middle(&name, box.y + 0.5f * places->name_height * u + 2.0f * u), words);
    wrap(view, &reason, words_of(view, row, file, said, sizeof said), places);
    if (file->state != FILE_UNKNOWN) {
        state_slip(view,
                   (struct ui_box){ box.x + box.width - slip_width - 10.0f * u, box.y + 5.0f * u,
                                    slip_width, slip_height },
                   file->state);
    }
}

void menu_files(const struct menu_view *view)
{
    const struct scene_menu *menu = view->menu;
    const struct places *places = menu->upright ? &upright_places : &wide;
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
