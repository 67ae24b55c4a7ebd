/* ui_menu_axes.c -- draws for the controller of each slot (place of one of up to four controllers):
 * the position over the tank, the rotation, the report rate and the longest time between two
 * reports. */
#include <math.h>
#include <stdio.h>

#include "core/base/fmath.h"
#include "platform/render/ui/menu/ui_menu.h"

#define AXIS_COUNT 6u
#define NEGATIVE_PAINT 0x2b4c8cffu
#define POSITIVE_PAINT 0x17754effu
/* Longest time in ms between two reports from which a controller is treated as unreliable. See
 * core/game/control/input_validation.h. */
#define GAP_BAD_MS 100.0f

struct axis {
    char name[4];
    float full; /* Axis value, in metres or radians, at which the bar is drawn to the end of its
                   half. */
};

/* The axes of a controller. A full half of the bar stands for half of the tank's length (x), half
 * of the tank's width (z), the height of an arm (y), half a turn (yaw), or a quarter turn (pitch
 * and roll). */
static const struct axis axes[AXIS_COUNT] = {
    { "x", 0.70f },        { "y", 0.30f },        { "z", 0.40f },
    { "yaw", 3.1415927f }, { "pit", 1.5707964f }, { "rol", 1.5707964f },
};

static float value_of(const struct scene_axes *seat, uint32_t axis)
{
    const float values[AXIS_COUNT] = { seat->position_m.x,     seat->position_m.y,
                                       seat->position_m.z,     seat->angles.yaw_rad,
                                       seat->angles.pitch_rad, seat->angles.roll_rad };
    return isfinite(values[axis]) ? values[axis] : 0.0f;
}

static struct ui_box cell(const struct menu_view *view, uint32_t seat)
{
    const int upright = view->menu->upright;
    return menu_place(
        view, upright
                  ? (struct layout_box){ 27.0f, 200.0f + 258.0f * (float)seat, 800.0f, 240.0f }
                  : (struct layout_box){ 40.0f + 610.0f * (float)(seat % 2u),
                                         120.0f + 240.0f * (float)(seat / 2u), 590.0f, 228.0f });
}

/* Draws a bar from the middle to the right for a positive value and to the left for a negative
 * value. Beside the bar, draws the value in mm or degrees. */
static void ui_menu_axes_bar(const struct menu_view *view, const struct scene_axes *seat,
                             struct ui_box box, uint32_t axis)
{
    const float u = view->frame.unit, value = value_of(seat, axis);
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
    ui_shape(view->frame.batch,
             &(struct ui_shape){ .box = { track, y - 5.0f * u, width, 10.0f * u },
                                 .kind = UI_PANEL,
                                 .fill = 0xb5762f50u,
                                 .shape = { 0, 0, 5.0f * u } });
    ui_shape(view->frame.batch,
             &(struct ui_shape){ .box = { part < 0.0f ? middle + part : middle, y - 8.0f * u,
                                          fmaxf(fabsf(part), 2.0f * u), 16.0f * u },
                                 .kind = UI_PANEL,
                                 .fill = part < 0.0f ? NEGATIVE_PAINT : POSITIVE_PAINT,
                                 .shape = { 0, 0, 3.0f * u } });
    menu_words_at(view, box.x + box.width, y, 84.0f * u, 1.0f, &number, words);
}

static enum text_key link_name(uint8_t link)
{
    return link == POI_SOURCE_LIVE   ? TEXT_AXIS_LIVE
           : link == POI_SOURCE_BOT  ? TEXT_AXIS_BOT
           : link == POI_SOURCE_LOST ? TEXT_AXIS_LOST
                                     : TEXT_AXIS_ABSENT;
}

/* Draws the slot, the controller's state, the report rate and the longest time between two reports
 * above the bars. */
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
                  menu_text(view, link_name(seat->link)));
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
    const struct scene_axes *seat = &view->devices->axes[index];
    const float u = view->frame.unit;
    const struct ui_box box = cell(view, index);
    ui_shape(view->frame.batch, &(struct ui_shape){ .box = box,
                                                    .kind = UI_WASHI,
                                                    .fill = UI_WASHI_WHITE,
                                                    .line = 0xb5762fffu,
                                                    .shape = { 0, 0, 10.0f * u, 2.0f * u } });
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
