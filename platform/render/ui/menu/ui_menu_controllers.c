/* ui_menu_controllers.c -- draws the list of controllers, and the page of one controller. */
#include <stdio.h>

#include "platform/render/ui/menu/ui_menu.h"
#include "platform/render/ui/message_translate.h"

struct state_words {
    enum text_key name, words;
    uint32_t paint;
};

static const struct state_words states[CONTROLLER_STATE_COUNT] = {
    [CONTROLLER_NONE] = { TEXT_STATE_LOST, TEXT_ROW_NONE, 0x5a4648ffu },
    [CONTROLLER_FREE] = { TEXT_STATE_FREE, TEXT_ROW_FREE, 0x2b4c8cffu },
    [CONTROLLER_ACTIVE] = { TEXT_STATE_PLAYS, TEXT_ROW_PLAYS, 0x17754effu },
    [CONTROLLER_LOST] = { TEXT_STATE_LOST, TEXT_ROW_LOST, 0xa85a12ffu },
    [CONTROLLER_UNSUPPORTED] = { TEXT_STATE_BARRED, TEXT_ROW_BARRED, 0x5a4648ffu },
    [CONTROLLER_DENIED] = { TEXT_STATE_DENIED, TEXT_ROW_DENIED, 0xb3261effu },
};

/* Writes the name of a controller, such as "057e:2009 Pro Controller, port 3-1.2". Without a name,
 * as in a recording, writes the number of the row. */
static void name_of(const struct menu_view *view, uint32_t row, char *out, size_t out_size)
{
    const char *name = view->devices->controller[row];
    if (name[0] != 0) {
        snprintf(out, out_size, "%.*s", (int)SCENE_NAME_SIZE, name);
    } else {
        snprintf(out, out_size, "%u", row + 1u);
    }
}

/* Draws a paper slip with the controller's state as a word. */
static void state_slip(const struct menu_view *view, struct ui_box box, uint8_t state)
{
    const float u = view->frame.unit;
    const struct ui_text style = menu_style(view, 24.0f, MENU_CREAM);
    ui_shape(view->frame.batch, &(struct ui_shape){ .box = box,
                                                    .kind = UI_PANEL,
                                                    .fill = states[state].paint,
                                                    .line = 0xffe7b0a0u,
                                                    .shape = { 0, 0, 8.0f * u, 1.5f * u } });
    ui_words_in(&view->frame,
                (struct ui_box){ box.x + 8.0f * u, box.y, box.width - 16.0f * u, box.height },
                &style, menu_text(view, states[state].name));
}

/* Draws an intact poi if the controller is in use or available, otherwise a torn poi. */
static void state_sign(const struct menu_view *view, float x, float y, float radius, uint8_t state)
{
    const float paper = state == CONTROLLER_ACTIVE || state == CONTROLLER_FREE ? 1.0f : 0.2f;
    ui_poi_sign(&view->frame, x, y, radius, paper,
                state == CONTROLLER_ACTIVE ? ui_player_colours[0] : states[state].paint);
}

static void row(const struct menu_view *view, uint32_t index)
{
    const float u = view->frame.unit;
    const uint8_t state = view->menu->controllers.state[index];
    const struct ui_box box = menu_tag_place(view, index);
    const float slip_width = 170.0f * u, slip_height = 38.0f * u;
    char name[SCENE_NAME_SIZE + 1u];
    struct ui_text style = menu_style(view, 26.0f, MENU_INK);
    name_of(view, index, name, sizeof name);
    ui_wooden_tag(&view->frame, box, view->menu->tag == index);
    state_sign(view, box.x + 36.0f * u, box.y + 0.46f * box.height, 14.0f * u, state);
    style.fit_px = box.width - slip_width - 110.0f * u;
    struct ui_text fitted = style;
    fitted.size_px = ui_text_size(&style, name);
    ui_text(view->frame.batch, &fitted, box.x + 76.0f * u,
            ui_text_middle(&fitted, box.y + 0.5f * box.height), name);
    state_slip(view,
               (struct ui_box){ box.x + box.width - slip_width - 14.0f * u,
                                box.y + 0.5f * (box.height - slip_height), slip_width,
                                slip_height },
               state);
}

/* Draws the controller manager's status line, which states why no controller is connected. */
static void nothing_there(const struct menu_view *view)
{
    char said[MESSAGE_TRANSLATE_SIZE];
    message_translate(said, sizeof said, view->frame.language, view->devices->controllers);
    const int upright = view->menu->upright;
    const struct ui_text words = menu_style(view, 32.0f, MENU_CREAM);
    const struct ui_text line = menu_style(view, 24.0f, 0xf0c089ffu);
    const float y = upright ? 560.0f : 280.0f, x = upright ? 27.0f : 60.0f;
    const float width = pointer_layout_size(upright).x - 2.0f * x;
    ui_words_in(&view->frame, menu_place(view, (struct layout_box){ x, y, width, 60.0f }), &words,
                menu_text(view, TEXT_MENU_NONE));
    ui_words_in(&view->frame, menu_place(view, (struct layout_box){ x, y + 64.0f, width, 50.0f }),
                &line, said);
}

void menu_rows(const struct menu_view *view)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < CONTROLLER_MAX; i++) {
        if (view->menu->tags >> i & 1u) {
            row(view, i);
            count++;
        }
    }
    if (count == 0) {
        nothing_there(view);
    }
}

/* Draws the page of one controller: its name and state above the tags, and an explanation of the
 * state below the tags. */
void menu_one_controller(const struct menu_view *view)
{
    const int upright = view->menu->upright;
    const float u = view->frame.unit;
    const uint8_t state = view->menu->controllers.state[view->menu->row];
    const struct ui_text style = menu_style(view, 30.0f, MENU_INK);
    const struct ui_text words = menu_style(view, 26.0f, MENU_CREAM);
    char name[SCENE_NAME_SIZE + 1u];
    name_of(view, view->menu->row, name, sizeof name);
    const struct ui_box slip =
        menu_place(view, upright ? (struct layout_box){ 27.0f, 240.0f, 800.0f, 90.0f }
                                 : (struct layout_box){ 190.0f, 128.0f, 900.0f, 66.0f });
    ui_shape(view->frame.batch, &(struct ui_shape){ .box = slip,
                                                    .kind = UI_WASHI,
                                                    .fill = UI_WASHI_WHITE,
                                                    .line = 0xb5762fffu,
                                                    .shape = { 0, 0, 10.0f * u, 2.0f * u } });
    state_sign(view, slip.x + 44.0f * u, slip.y + 0.46f * slip.height, 17.0f * u, state);
    ui_words_in(&view->frame,
                (struct ui_box){ slip.x + 90.0f * u, slip.y, slip.width - 296.0f * u, slip.height },
                &style, name);
    state_slip(view,
               (struct ui_box){ slip.x + slip.width - 190.0f * u,
                                slip.y + 0.5f * slip.height - 21.0f * u, 174.0f * u, 42.0f * u },
               state);
    ui_words_in(&view->frame,
                menu_place(view, upright ? (struct layout_box){ 27.0f, 1150.0f, 800.0f, 60.0f }
                                         : (struct layout_box){ 60.0f, 540.0f, 1160.0f, 50.0f }),
                &words, menu_text(view, states[state].words));
}
