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
    [CONTROLLER_ACTIVE] = { TEXT_STATE_PLAYS, TEXT_ROW_PLAYS, MENU_GOOD },
    [CONTROLLER_LOST] = { TEXT_STATE_LOST, TEXT_ROW_LOST, 0xa85a12ffu },
    [CONTROLLER_UNSUPPORTED] = { TEXT_STATE_BARRED, TEXT_ROW_BARRED, 0x5a4648ffu },
    [CONTROLLER_DENIED] = { TEXT_STATE_DENIED, TEXT_ROW_DENIED, MENU_BAD },
};

/* Writes the name of the controller in the row `row`, such as "057e:2009 Pro Controller, port
 * 3-1.2". If the name is unknown, as in a recording, writes the number of the row. */
static void name_of(const struct ui_frame *frame, uint32_t row, char *out, size_t out_size)
{
    CORE_ASSERT(row < CONTROLLER_MAX);
    const char *name = frame->scene->devices.controller[row];
    if (name[0] != 0) {
        snprintf(out, out_size, "%.*s", (int)SCENE_NAME_SIZE, name);
    } else {
        snprintf(out, out_size, "%u", row + 1u);
    }
}

/* Draws a paper slip on which the controller's state is written as a word. */
static void state_slip(const struct ui_frame *frame, struct ui_box box, uint8_t state)
{
    CORE_ASSERT(state < CONTROLLER_STATE_COUNT);
    const float u = frame->unit;
    ui_panel(frame, UI_PANEL, box, 8.0f * u, 1.5f * u, states[state].paint, 0xffe7b0a0u);
    ui_label_in(frame, ui_inset(box, 8.0f * u), 24.0f, UI_CREAM, states[state].name);
}

/* Draws an intact poi if the controller is in use or available, otherwise a torn poi. */
static void state_sign(const struct ui_frame *frame, float x, float y, float radius, uint8_t state)
{
    const bool is_active = state == CONTROLLER_ACTIVE;
    ui_poi_sign(frame, x, y, radius, is_active || state == CONTROLLER_FREE ? 1.0f : 0.2f,
                is_active ? ui_player_colours[0] : states[state].paint);
}

void menu_rows(const struct ui_frame *frame)
{
    const struct scene_menu *const menu = &frame->scene->menu;
    const float u = frame->unit, slip_width = 170.0f * u, slip_height = 38.0f * u;
    uint32_t count = 0;
    for (uint32_t i = 0; i < CONTROLLER_MAX; i++) {
        if (!(menu->tags >> i & 1u)) {
            continue;
        }
        const uint8_t state = menu->controllers.state[i];
        const struct ui_box box = menu_tag_place(frame, i);
        char name[SCENE_NAME_SIZE + 1u];
        name_of(frame, i, name, sizeof name);
        ui_wooden_tag(frame, box, menu->tag == i);
        state_sign(frame, box.x + 36.0f * u, box.y + 0.46f * box.height, 14.0f * u, state);
        ui_words_at(frame, box.x + 76.0f * u, box.y + 0.5f * box.height,
                    box.width - slip_width - 110.0f * u, 0.0f, ui_body(frame, 26.0f, MENU_INK),
                    name);
        state_slip(frame,
                   (struct ui_box){ box.x + box.width - slip_width - 14.0f * u,
                                    box.y + 0.5f * (box.height - slip_height), slip_width,
                                    slip_height },
                   state);
        count++;
    }
    if (count == 0) {
        /* The controller manager's status line states why no controller is connected. */
        char text[TEXT_TRANSLATE_SIZE];
        text_translate(text, sizeof text, frame->language, frame->scene->devices.controllers);
        menu_note(frame, canvas_box(60, 280, 1160, 60), canvas_box(27, 560, 800, 60),
                  ui_body(frame, 32.0f, UI_CREAM), ui_words(frame, TEXT_MENU_NONE));
        menu_note(frame, canvas_box(60, 344, 1160, 50), canvas_box(27, 624, 800, 50),
                  ui_body(frame, 24.0f, 0xf0c089ffu), text);
    }
}

/* Draws the page of one controller: its name and state above the tags, and an explanation of the
 * state below the tags. */
void menu_one_controller(const struct ui_frame *frame)
{
    const struct scene_menu *const menu = &frame->scene->menu;
    const float u = frame->unit;
    const uint8_t state = menu->controllers.state[menu->row];
    char name[SCENE_NAME_SIZE + 1u];
    name_of(frame, menu->row, name, sizeof name);
    const struct ui_box slip =
        ui_place_either(frame, canvas_box(190, 128, 900, 66), canvas_box(27, 240, 800, 90));
    menu_paper(frame, slip);
    state_sign(frame, slip.x + 44.0f * u, slip.y + 0.46f * slip.height, 17.0f * u, state);
    ui_words_in(frame,
                (struct ui_box){ slip.x + 90.0f * u, slip.y, slip.width - 296.0f * u, slip.height },
                ui_body(frame, 30.0f, MENU_INK), name);
    state_slip(frame,
               (struct ui_box){ slip.x + slip.width - 190.0f * u,
                                slip.y + 0.5f * slip.height - 21.0f * u, 174.0f * u, 42.0f * u },
               state);
    menu_note(frame, canvas_box(60, 540, 1160, 50), canvas_box(27, 1150, 800, 60),
              ui_body(frame, 26.0f, UI_CREAM), ui_words(frame, states[state].words));
}

/* ---- Page of axes: position, rotation and reports of each controller ------------------------- */

#define AXIS_COUNT 6u
#define NEGATIVE_PAINT 0x2b4c8cffu
/* If the longest time between two reports of a controller reaches this value in ms, the controller
 * is treated as unreliable. See core/game/control/input_pose.h. */
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
static void axis_bar(const struct ui_frame *frame, const struct scene_axes *input,
                     struct ui_box box, uint32_t axis)
{
    CORE_ASSERT(axis < AXIS_COUNT);
    const float values[AXIS_COUNT] = { input->position_m.x,     input->position_m.y,
                                       input->position_m.z,     input->angles.yaw_rad,
                                       input->angles.pitch_rad, input->angles.roll_rad };
    const float u = frame->unit, value = isfinite(values[axis]) ? values[axis] : 0.0f;
    const float track = box.x + 46.0f * u, width = box.width - 136.0f * u;
    const float middle = track + 0.5f * width, y = box.y + 0.5f * box.height;
    const float part = f_clamp(value / axes[axis].full, -1.0f, 1.0f) * 0.5f * width;
    const bool is_angle = axis >= 3u;
    const float shown = f_clamp(is_angle ? value / F_DEG : value * 1000.0f, -9999.0f, 9999.0f);
    const int whole = (int)roundf(shown); /* The conversion to an integer avoids the text "-0". */
    char words[24];
    snprintf(words, sizeof words, "%s%d %s", whole > 0 ? "+" : "", whole, is_angle ? "°" : "mm");
    ui_words_at(frame, box.x, y, 40.0f * u, 0.0f, ui_body(frame, 22.0f, UI_INK_SOFT),
                axes[axis].name);
    ui_panel(frame, UI_PANEL, (struct ui_box){ track, y - 5.0f * u, width, 10.0f * u }, 5.0f * u,
             0.0f, 0xb5762f50u, 0);
    ui_panel(frame, UI_PANEL,
             (struct ui_box){ part < 0.0f ? middle + part : middle, y - 8.0f * u,
                              fmaxf(fabsf(part), 2.0f * u), 16.0f * u },
             3.0f * u, 0.0f, part < 0.0f ? NEGATIVE_PAINT : MENU_GOOD, 0);
    ui_words_at(frame, box.x + box.width, y, 84.0f * u, 1.0f, ui_body(frame, 22.0f, UI_INK), words);
}

/* Draws the heading above the bars: the slot (place of one of up to four controllers), the
 * controller's state, the report rate and the longest time between two reports. */
static void axes_heading(const struct ui_frame *frame, const struct scene_axes *input,
                         uint32_t index, struct ui_box box)
{
    const float u = frame->unit, y = box.y + 30.0f * u;
    char words[TEXT_LINE_MAX];
    ui_player_mark(frame, box.x + 34.0f * u, y, 18.0f * u, index);
    ui_label_at(frame, box.x + 64.0f * u, y, 0.24f * box.width, 24.0f, UI_INK,
                input->link == POI_SOURCE_LIVE   ? TEXT_AXIS_LIVE
                : input->link == POI_SOURCE_BOT  ? TEXT_AXIS_BOT
                : input->link == POI_SOURCE_LOST ? TEXT_AXIS_LOST
                                                 : TEXT_AXIS_ABSENT);
    if (input->link != POI_SOURCE_LIVE) {
        return;
    }
    text_number(words, sizeof words, ui_words(frame, TEXT_AXIS_RATE), input->report_count);
    ui_words_at(frame, box.x + 0.62f * box.width, y, 0.28f * box.width, 1.0f,
                ui_body(frame, 22.0f, UI_INK_SOFT), words);
    text_number(words, sizeof words, ui_words(frame, TEXT_AXIS_GAP),
                (uint32_t)fminf(fmaxf(input->gap_ms, 0.0f), 99999.0f));
    ui_words_at(frame, box.x + box.width - 20.0f * u, y, 0.31f * box.width, 1.0f,
                ui_body(frame, 22.0f, input->gap_ms >= GAP_BAD_MS ? MENU_BAD : UI_INK_SOFT), words);
}

void menu_axes(const struct ui_frame *frame)
{
    const float u = frame->unit;
    for (uint32_t index = 0; index < POI_MAX; index++) {
        const struct scene_axes *const input = &frame->scene->devices.axes[index];
        const float column = (float)(index % 2u), row = (float)(index / 2u);
        const struct ui_box box = ui_place_either(
            frame, canvas_box(40.0f + 610.0f * column, 120.0f + 240.0f * row, 590, 228),
            canvas_box(27, 200.0f + 258.0f * (float)index, 800, 240));
        menu_paper(frame, box);
        axes_heading(frame, input, index, box);
        const float pitch = (box.height - 68.0f * u) / 3.0f, width = 0.5f * box.width - 34.0f * u;
        for (uint32_t axis = 0; axis < AXIS_COUNT && input->link == POI_SOURCE_LIVE; axis++) {
            /* The three positions are drawn on the left side, and the three rotations on the right
             * side. */
            const float x = box.x + 22.0f * u + (axis >= 3u ? width + 24.0f * u : 0.0f);
            const float y = box.y + 58.0f * u + (float)(axis % 3u) * pitch;
            axis_bar(frame, input, (struct ui_box){ x, y, width, pitch }, axis);
        }
    }
}
