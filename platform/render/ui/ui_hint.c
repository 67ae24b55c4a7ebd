/* ui_hint.c -- draws the hint beside a poi: a small moving picture of the action and, for a single
 * player, a line of words. */
#include <math.h>

#include "core/base/panic.h"
#include "platform/render/ui/ui_widgets.h"

#define FADE_IN_S 0.3f
#define LOOP_S 1.6f /* Period in seconds of the motion in a hint's picture. */
/* Sizes, in layout units, of a hint's picture, of the whole hint and of its words. */
#define PICTURE_WIDTH 104.0f
#define HEIGHT 76.0f
#define WORDS_SIZE 27.0f
#define MARGIN 14.0f
#define GAP 20.0f /* Distance in layout units between the poi's ring and the hint. */
/* Height in layout units that the plates occupy at the top of the screen for a single player, and
 * the greatest such height for several players. The plates of several players are below the clock
 * if the window is narrow. */
#define PLATES_HEIGHT 110.0f
#define PLATES_HEIGHT_MANY 190.0f

#define WATER_LINE 0x6fd2f4ffu

/* Draws a straight line between two points, whose coordinates are layout units from (x, y). */
static void line(const struct ui_frame *frame, float x, float y, const float from[2],
                 const float to[2], float width, uint32_t colour)
{
    const float u = frame->unit;
    ui_segment(frame->batch, (const float[2]){ x + from[0] * u, y + from[1] * u },
               (const float[2]){ x + to[0] * u, y + to[1] * u }, width * u, colour);
}

/* Draws the poi's paper as seen from the side, centred at (`paper_x`, `paper_y`) in layout units
 * from (x, y). The right end of the paper is `slant` layout units above its centre. */
static void side_paper(const struct ui_frame *frame, float x, float y, float paper_x, float paper_y,
                       float slant)
{
    line(frame, x, y, (const float[2]){ paper_x - 17.0f, paper_y + slant },
         (const float[2]){ paper_x + 17.0f, paper_y - slant }, 6.0f, UI_CREAM);
}

static void water_line(const struct ui_frame *frame, float x, float y)
{
    line(frame, x, y, (const float[2]){ -46.0f, 0.0f }, (const float[2]){ 46.0f, 0.0f }, 3.0f,
         WATER_LINE);
}

/* Draws, as seen from the side, a fish and a paper that dips beside the fish, glides under the fish
 * and lifts it. */
static void glide_picture(const struct ui_frame *frame, float x, float y, float part)
{
    const float u = frame->unit;
    const float across = f_lerp(-34.0f, 12.0f, f_smoothstep(0.25f, 0.65f, part));
    const float down = part < 0.5f ? f_lerp(-20.0f, 22.0f, f_smoothstep(0.0f, 0.3f, part))
                                   : f_lerp(22.0f, -14.0f, f_smoothstep(0.7f, 1.0f, part));
    const float lift = f_smoothstep(0.78f, 1.0f, part);
    water_line(frame, x, y - 6.0f * u);
    ui_fish_sign(frame, x + 12.0f * u, y + (8.0f - 28.0f * lift) * u, 44.0f * u);
    side_paper(frame, x, y, across, down, part < 0.3f ? -8.0f : 0.0f);
}

/* Draws, as seen from the side, a paper that dips into the water or that lifts a fish out of the
 * water. */
static void stroke_picture(const struct ui_frame *frame, float x, float y, uint8_t hint, float part)
{
    const float u = frame->unit, swing = ui_pulse(part, 1.0f);
    water_line(frame, x, y);
    if (hint == HINT_LIFT) {
        ui_fish_sign(frame, x, y + (10.0f - 24.0f * part) * u, 46.0f * u);
        side_paper(frame, x, y, 0.0f, 24.0f - 24.0f * part, 0.0f);
        ui_arrow(frame, x + 38.0f * u, y + 26.0f * u, 0.0f, -46.0f * u, UI_GOLD);
    } else if (hint == HINT_WET_ALL) {
        side_paper(frame, x, y, 0.0f, -18.0f + 34.0f * swing, 0.0f);
        ui_arrow(frame, x + 38.0f * u, y - 22.0f * u, 0.0f, 44.0f * u, UI_GOLD);
    } else {
        const bool is_slanted = hint == HINT_TILT;
        side_paper(frame, x, y, is_slanted ? -12.0f + 20.0f * part : -26.0f, -20.0f + 38.0f * part,
                   is_slanted ? -13.0f : 0.0f);
        ui_arrow(frame, x + (is_slanted ? 18.0f : -2.0f) * u, y - 24.0f * u,
                 (is_slanted ? 18.0f : 0.0f) * u, 40.0f * u, UI_GOLD);
        if (!is_slanted) {
            ui_fish_sign(frame, x + 28.0f * u, y + 14.0f * u, 44.0f * u);
        }
    }
}

/* Draws the picture of a hint, centred at (x, y). `part` in [0, 1] is the progress of the motion in
 * the picture. */
static void picture(const struct ui_frame *frame, float x, float y, uint8_t hint, uint32_t player,
                    float part)
{
    const float u = frame->unit;
    const uint32_t ring = ui_player_colours[player];
    switch (hint) {
    case HINT_BOWL:
    case HINT_CLEAR_RIM:
        ui_poi_sign(frame, x - 30.0f * u, y + (14.0f - 24.0f * part) * u, 17.0f * u, 1.0f, ring);
        ui_fish_sign(frame, x - 30.0f * u, y + (14.0f - 24.0f * part) * u, 24.0f * u);
        ui_arrow(frame, x - 6.0f * u, y - 8.0f * u, 20.0f * u, 8.0f * u, UI_GOLD);
        ui_disc(frame, x + 34.0f * u, y + 6.0f * u, 18.0f * u, 4.0f * u, 0x7fc8ecffu, ring);
        break;
    case HINT_SLOWLY:
        ui_poi_sign(frame, x + (-22.0f + 34.0f * part) * u, y - 8.0f * u, 18.0f * u, 1.0f, ring);
        ui_arrow(frame, x - 24.0f * u, y + 27.0f * u, 22.0f * u, 0.0f, UI_GOLD);
        break;
    case HINT_GLIDE:
        glide_picture(frame, x, y, part);
        break;
    case HINT_TORN:
        ui_poi_sign(frame, x - 4.0f * u, y - 6.0f * u, 24.0f * u, 0.35f, ring);
        break;
    default:
        stroke_picture(frame, x, y, hint, part);
    }
}

void ui_poi_hint(const struct ui_frame *frame, uint32_t player)
{
    const struct scene *const scene = frame->scene;
    const struct scene_lesson *const lesson = &scene->lesson[player];
    const struct scene_poi *const poi = &scene->poi[player];
    CORE_ASSERT(player < POI_MAX);
    if (lesson->hint == HINT_NONE || lesson->hint >= HINT_COUNT || !poi->present ||
        ui_shows_near_miss(scene, player)) {
        return;
    }
    const float u = frame->unit, in = f_smoothstep(0.0f, FADE_IN_S, lesson->hint_s);
    const bool is_alone = ui_player_count(scene) <= 1u;
    const struct ui_point at = ui_project(frame, poi->position_m);
    const struct ui_text style = ui_style(frame, FONT_BODY, WORDS_SIZE, 0.0f, UI_CREAM,
                                          frame->width - (PICTURE_WIDTH + 4.0f * MARGIN) * u);
    const char *const words = ui_hint_words(frame, lesson->hint);
    const float room = is_alone ? ui_text_width(style, words) + MARGIN * u : 0.0f;
    const float width = (PICTURE_WIDTH + MARGIN) * u + room, height = HEIGHT * u;
    const float reach = poi->ring_radius_m * at.px_per_m + GAP * u;
    /* The hint is above the poi's ring, or below the ring if the hint would otherwise cover the
     * plates at the top of the screen. */
    const bool is_above =
        at.y - reach - height > (is_alone ? PLATES_HEIGHT : PLATES_HEIGHT_MANY) * u;
    const float top = is_above ? at.y - reach - height : at.y + reach;
    const struct ui_box box = {
        f_clamp(at.x - 0.5f * width, 8.0f * u, fmaxf(frame->width - width - 8.0f * u, 8.0f * u)),
        f_clamp(top, 8.0f * u, frame->height - height - 8.0f * u), width, height
    };
    const float part = fmodf(lesson->hint_s, LOOP_S) / LOOP_S;
    const bool is_urgent = lesson->hint == HINT_TORN;
    frame->batch->opacity = in;
    ui_panel(frame, UI_PANEL, box, 16.0f * u, 3.0f * u, is_urgent ? 0xb8301ee8u : UI_NIGHT,
             is_alone ? UI_GOLD : ui_player_colours[player]);
    picture(frame, box.x + (0.5f * PICTURE_WIDTH + 4.0f) * u, box.y + 0.5f * height, lesson->hint,
            player, f_smoothstep(0.0f, 0.8f, part));
    if (is_alone) {
        ui_text_at(frame, style, box.x + (PICTURE_WIDTH + 4.0f) * u, box.y + 0.5f * height, words);
    } else {
        ui_player_mark(frame, box.x + 14.0f * u, box.y + 14.0f * u, 17.0f * u, player);
    }
    frame->batch->opacity = 1.0f;
}
