/* ui_menu_about.c -- draws the page about this machine: the program's version, the state of the
 * account books, and the status line of each device. */
#include <stdio.h>
#include <string.h>

#include "core/core.h"
#include "platform/render/ui/menu/ui_menu.h"
#include "platform/render/ui/message_translate.h"

struct places {
    struct layout_box page;
    float name_width; /* Width of the column of names. 0 means that a name is above its status
                         line. */
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

/* Draws a line such as "Kingyo 0.1.0 Start no. 12 Running for 340 min", and whether all entries of
 * the account books are on disk. */
static void ui_menu_about_heading(const struct menu_view *view, const struct places *places,
                                  struct ui_box box)
{
    const struct scene_menu *menu = view->menu;
    const float u = view->frame.unit;
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
}

static void device(const struct menu_view *view, const struct places *places, struct ui_box box,
                   uint32_t index)
{
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
    char row[MESSAGE_TRANSLATE_SIZE], said[MESSAGE_TRANSLATE_SIZE];
    message_translate(said, sizeof said, view->frame.language, view->devices->about[index]);
    const char *words = *said ? said : menu_text(view, TEXT_DEVICE_NONE);
    menu_words_at(view, box.x + 22.0f * u, top + 0.5f * places->line * u,
                  is_beside ? (places->name_width - 12.0f) * u : room, 0.0f, &name,
                  menu_text(view, names[index]));
    for (uint32_t i = is_beside ? 0u : 1u; i < places->line_count + (is_beside ? 0u : 1u) && *words;
         i++) {
        const int is_last = i + 1u == places->line_count + (is_beside ? 0u : 1u);
        const size_t size = is_last ? strlen(words) : menu_fill_line(&style, words, room);
        snprintf(row, sizeof row, "%.*s", (int)size, words);
        menu_words_at(view, left, top + ((float)i + 0.5f) * places->line * u, room, 0.0f, &style,
                      row);
        words += size;
    }
}

void menu_about(const struct menu_view *view)
{
    const struct places *places = view->menu->upright ? &upright_places : &wide;
    const float u = view->frame.unit;
    const struct ui_box box = menu_place(view, places->page);
    ui_shape(view->frame.batch, &(struct ui_shape){ .box = box,
                                                    .kind = UI_WASHI,
                                                    .fill = UI_WASHI_WHITE,
                                                    .line = 0xb5762fffu,
                                                    .shape = { 0, 0, 10.0f * u, 2.0f * u } });
    ui_menu_about_heading(view, places, box);
    for (uint32_t i = 0; i < ABOUT_COUNT; i++) {
        device(view, places, box, i);
    }
}
