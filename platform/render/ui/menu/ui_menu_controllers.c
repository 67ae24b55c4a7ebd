/* ui_menu_controllers.c -- draws the list of controllers, the page of one controller, and the page
 * of axes. For the controller of each slot (place of one of up to four controllers), the page of
 * axes shows the position over the tank, the rotation, the report rate and the longest time between
 * two reports. */
#include <math.h>
#include <stdio.h>

#include "core/base/fmath.h"
#include "core/base/panic.h"
#include "platform/render/ui/menu/ui_menu.h"
#include "platform/render/ui/text.h"

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
    CORE_ASSERT(row < CONTROLLER_MAX);
    const char *name = view->devices->controller[row];
    if (name[0] != 0) {
        snprintf(out, out_size, "%.*s", (int)SCENE_NAME_SIZE, name);
    } else {
        snprintf(out, out_size, "%u", row + 1u);
    }
}

/* Draws a paper slip on which the controller's state is written as a word. */
static void state_slip(const struct menu_view *view, struct ui_box box, uint8_t state)
{
    CORE_ASSERT(state < CONTROLLER_STATE_COUNT);
    const float u = view->frame.unit;
    const struct ui_text style = menu_style(view, 24.0f, MENU_CREAM);
    ui_panel(&view->frame, UI_PANEL, box, 8.0f * u, 1.5f * u, states[state].paint, 0xffe7b0a0u);
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

static void draw_controller_row(const struct menu_view *view, uint32_t index)
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
    ui_text_at(&view->frame, &fitted, box.x + 76.0f * u, box.y + 0.5f * box.height, name);
    state_slip(view,
               (struct ui_box){ box.x + box.width - slip_width - 14.0f * u,
                                box.y + 0.5f * (box.height - slip_height), slip_width,
                                slip_height },
               state);
}

void menu_rows(const struct menu_view *view)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < CONTROLLER_MAX; i++) {
        if (view->menu->tags >> i & 1u) {
            draw_controller_row(view, i);
            count++;
        }
    }
    if (count == 0) {
        /* The controller manager's status line states why no controller is connected. */
        char said[TEXT_TRANSLATE_SIZE];
        text_translate(said, sizeof said, view->frame.language, view->devices->controllers);
        const int upright = view->menu->upright;
        const struct ui_text words = menu_style(view, 32.0f, MENU_CREAM);
        const struct ui_text line = menu_style(view, 24.0f, 0xf0c089ffu);
        const float y = upright ? 560.0f : 280.0f, x = upright ? 27.0f : 60.0f;
        const float width = pointer_layout_size(upright).x - 2.0f * x;
        ui_words_in(&view->frame, menu_place(view, (struct layout_box){ x, y, width, 60.0f }),
                    &words, menu_text(view, TEXT_MENU_NONE));
        ui_words_in(&view->frame,
                    menu_place(view, (struct layout_box){ x, y + 64.0f, width, 50.0f }), &line,
                    said);
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
    ui_panel(&view->frame, UI_WASHI, slip, 10.0f * u, 2.0f * u, UI_WASHI_WHITE, 0xb5762fffu);
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

/* ---- Page of axes: position, rotation and reports of each controller ------------------------- */

#define AXIS_COUNT 6u
#define NEGATIVE_PAINT 0x2b4c8cffu
#define POSITIVE_PAINT 0x17754effu
/* Longest time in ms between two reports from which a controller is treated as unreliable. See
 * core/game/control/input_validation.h. */
#define GAP_BAD_MS 100.0f

struct axis {
    char name[4];
    float full; /* Axis value, in metres or radians, that a bar of full length stands for. */
};

/* Table of a controller's axes. A bar of full length stands for half of the tank's length (x), half
 * of the tank's width (z), the height that an arm can reach (y), half a turn (yaw), or a quarter
 * turn (pitch and roll). */
static const struct axis axes[AXIS_COUNT] = {
    { "x", 0.70f },        { "y", 0.30f },        { "z", 0.40f },
    { "yaw", 3.1415927f }, { "pit", 1.5707964f }, { "rol", 1.5707964f },
};

/* Draws a bar from the middle to the right for a positive value and to the left for a negative
 * value. Beside the bar, draws the value in mm or degrees. */
static void ui_menu_axes_bar(const struct menu_view *view, const struct scene_axes *seat,
                             struct ui_box box, uint32_t axis)
{
    CORE_ASSERT(axis < AXIS_COUNT);
    const float values[AXIS_COUNT] = { seat->position_m.x,     seat->position_m.y,
                                       seat->position_m.z,     seat->angles.yaw_rad,
                                       seat->angles.pitch_rad, seat->angles.roll_rad };
    const float u = view->frame.unit, value = isfinite(values[axis]) ? values[axis] : 0.0f;
    const struct ui_text name = menu_style(view, 22.0f, UI_INK_SOFT);
    const struct ui_text number = menu_style(view, 22.0f, UI_INK);
    const float track = box.x + 46.0f * u, width = box.width - 136.0f * u;
    const float middle = track + 0.5f * width, y = box.y + 0.5f * box.height;
    const float part = fmaxf(-1.0f, fminf(value / axes[axis].full, 1.0f)) * 0.5f * width;
    char words[24];
    const int is_angle = axis >= 3u;
    const float shown = fmaxf(-9999.0f, fminf(is_angle ? value / F_DEG : value * 1000.0f, 9999.0f));
    const int whole = (int)roundf(shown); /* The conversion to an integer avoids the text "-0". */
    snprintf(words, sizeof words, "%s%d %s", whole > 0 ? "+" : "", whole, is_angle ? "°" : "mm");
    menu_words_at(view, box.x, y, 40.0f * u, 0.0f, &name, axes[axis].name);
    ui_panel(&view->frame, UI_PANEL, (struct ui_box){ track, y - 5.0f * u, width, 10.0f * u },
             5.0f * u, 0.0f, 0xb5762f50u, 0);
    ui_panel(&view->frame, UI_PANEL,
             (struct ui_box){ part < 0.0f ? middle + part : middle, y - 8.0f * u,
                              fmaxf(fabsf(part), 2.0f * u), 16.0f * u },
             3.0f * u, 0.0f, part < 0.0f ? NEGATIVE_PAINT : POSITIVE_PAINT, 0);
    menu_words_at(view, box.x + box.width, y, 84.0f * u, 1.0f, &number, words);
}

/* Draws the heading above the bars: the slot (place of one of up to four controllers), the
 * controller's state, the report rate and the longest time between two reports. */
static void ui_menu_axes_heading(const struct menu_view *view, const struct scene_axes *seat,
                                 uint32_t index, struct ui_box box)
{
    const float u = view->frame.unit, y = box.y + 30.0f * u;
    const int is_late = seat->gap_ms >= GAP_BAD_MS;
    const struct ui_text state = menu_style(view, 24.0f, UI_INK);
    const struct ui_text rate = menu_style(view, 22.0f, UI_INK_SOFT);
    const struct ui_text gap = menu_style(view, 22.0f, is_late ? 0xb3261effu : UI_INK_SOFT);
    char words[TEXT_LINE_MAX];
    ui_player_mark(&view->frame, box.x + 34.0f * u, y, 18.0f * u, index);
    menu_words_at(view, box.x + 64.0f * u, y, 0.24f * box.width, 0.0f, &state,
                  menu_text(view, seat->link == POI_SOURCE_LIVE   ? TEXT_AXIS_LIVE
                                  : seat->link == POI_SOURCE_BOT  ? TEXT_AXIS_BOT
                                  : seat->link == POI_SOURCE_LOST ? TEXT_AXIS_LOST
                                                                  : TEXT_AXIS_ABSENT));
    if (seat->link != POI_SOURCE_LIVE) {
        return;
    }
    text_number(words, sizeof words, menu_text(view, TEXT_AXIS_RATE), seat->report_count);
    menu_words_at(view, box.x + 0.62f * box.width, y, 0.28f * box.width, 1.0f, &rate, words);
    text_number(words, sizeof words, menu_text(view, TEXT_AXIS_GAP),
                (uint32_t)fminf(fmaxf(seat->gap_ms, 0.0f), 99999.0f));
    menu_words_at(view, box.x + box.width - 20.0f * u, y, 0.31f * box.width, 1.0f, &gap, words);
}

static void seat_sheet(const struct menu_view *view, uint32_t index)
{
    CORE_ASSERT(index < POI_MAX);
    const struct scene_axes *seat = &view->devices->axes[index];
    const float u = view->frame.unit;
    const int upright = view->menu->upright;
    const struct ui_box box = menu_place(
        view, upright
                  ? (struct layout_box){ 27.0f, 200.0f + 258.0f * (float)index, 800.0f, 240.0f }
                  : (struct layout_box){ 40.0f + 610.0f * (float)(index % 2u),
                                         120.0f + 240.0f * (float)(index / 2u), 590.0f, 228.0f });
    ui_panel(&view->frame, UI_WASHI, box, 10.0f * u, 2.0f * u, UI_WASHI_WHITE, 0xb5762fffu);
    ui_menu_axes_heading(view, seat, index, box);
    if (seat->link != POI_SOURCE_LIVE) {
        return;
    }
    const float pitch = (box.height - 68.0f * u) / 3.0f, width = 0.5f * box.width - 34.0f * u;
    for (uint32_t axis = 0; axis < AXIS_COUNT; axis++) {
        /* Positions are drawn on the left side, rotations on the right side. */
        const float x = box.x + 22.0f * u + (axis >= 3u ? width + 24.0f * u : 0.0f);
        ui_menu_axes_bar(
            view, seat,
            (struct ui_box){ x, box.y + 58.0f * u + (float)(axis % 3u) * pitch, width, pitch },
            axis);
    }
}

void menu_axes(const struct menu_view *view)
{
    for (uint32_t seat = 0; seat < POI_MAX; seat++) {
        seat_sheet(view, seat);
    }
}
