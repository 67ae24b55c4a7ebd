/* ui_lesson.c -- draws the lessons (core/game/lesson/lesson.h) into the tank: the ghost that shows
 * the technique, the ring around a fish that is easy to catch, the arrow from the poi to the bowl,
 * and the hint beside the poi. */
#include <math.h>

#include "core/base/panic.h"
#include "platform/render/ui/ui_widgets.h"

#define FADE_IN_S 0.35f    /* Time in seconds in which the ring around a fish appears. */
#define RING_PERIOD_S 1.6f /* Period in seconds with which the ring around a fish widens. */
/* Radius of the ring around a fish, as a fraction of the fish's length. The radius is at least
 * RING_RADIUS_M. */
#define RING_LENGTHS 0.65f
#define RING_RADIUS_M 0.020f
#define ARROW_PERIOD_S 0.9f /* Time in seconds in which a chevron moves by one step. */
#define ARROW_STEP 46.0f    /* Distance between two chevrons in layout units. */
#define ARROW_STEPS_MAX 24u
#define GHOST_RADIUS_M 0.042f
#define GHOST_OPACITY 0.72f

/* Draws a ring of light around the marked fish. The ring of one of several players has the player's
 * colour and number. */
static void draw_mark(const struct ui_frame *frame, uint32_t player)
{
    const struct scene *const scene = frame->scene;
    const struct scene_lesson *const lesson = &scene->lesson[player];
    CORE_ASSERT(lesson->fish < scene->fish_count);
    const struct scene_fish *const fish = &scene->fish[lesson->fish];
    const struct ui_point at = ui_project(frame, fish->position_m);
    const float u = frame->unit, in = f_smoothstep(0.0f, FADE_IN_S, lesson->mark_s);
    const float wide = ui_pulse(lesson->mark_s, RING_PERIOD_S);
    const float radius_m = fmaxf(RING_LENGTHS * fish->length_m, RING_RADIUS_M);
    const float radius = (1.5f - 0.5f * in + 0.1f * wide) * radius_m * at.px_per_m;
    const bool is_alone = ui_player_count(scene) <= 1u;
    const uint32_t colour = is_alone ? 0xffe9b0ffu : ui_player_colours[player];
    const float width = 4.0f * u;
    frame->batch->opacity = in;
    ui_ring(frame, at.x, at.y, radius + 2.0f * u, width + 4.0f * u, 1.0f, 0x0a0c2450u, 0);
    ui_glow(frame, ui_around(at.x, at.y, 1.5f * radius), ui_fade(colour, 0.24f + 0.16f * wide));
    ui_ring(frame, at.x, at.y, radius, width, 1.0f, ui_fade(colour, 0.95f - 0.3f * wide), 0);
    if (!is_alone) {
        ui_player_mark(frame, at.x + 0.75f * radius, at.y - 0.75f * radius, 17.0f * u, player);
    }
    frame->batch->opacity = 1.0f;
}

/* Draws one chevron whose tip is at (x, y). The chevron points in the direction of the unit vector
 * (`ahead_x`, `ahead_y`). */
static void draw_chevron(const struct ui_frame *frame, float x, float y, float ahead_x,
                         float ahead_y, float width, uint32_t colour)
{
    const float arm = 25.0f * frame->unit;
    for (int i = -1; i <= 1; i += 2) {
        const float side = 0.95f * (float)i;
        const float end[2] = { x - arm * (ahead_x - side * ahead_y),
                               y - arm * (ahead_y + side * ahead_x) };
        ui_segment(frame->batch, end, (const float[2]){ x, y }, width, colour);
    }
}

/* Draws an arrow of chevrons (V-shaped marks) that move from the poi of `player` to the bowl of
 * `player`. */
static void draw_arrow(const struct ui_frame *frame, uint32_t player)
{
    const struct scene_poi *const poi = &frame->scene->poi[player];
    const struct scene_bowl *const bowl = &frame->scene->bowl[player];
    const struct ui_point from = ui_project(frame, poi->position_m);
    const struct ui_point to = ui_project(frame, bowl->position_m);
    const float x = to.x - from.x, y = to.y - from.y, u = frame->unit;
    const float length = fmaxf(hypotf(x, y), 1.0f), ahead_x = x / length, ahead_y = y / length;
    const float begin = 1.3f * poi->ring_radius_m * from.px_per_m + 20.0f * u;
    const float end = fmaxf(length - 0.75f * bowl->radius_m * to.px_per_m, begin);
    const float step = ARROW_STEP * u, run = fmodf(frame->time_s / ARROW_PERIOD_S, 1.0f) * step;
    for (uint32_t i = 0; i < ARROW_STEPS_MAX && begin + step * (float)i + run <= end; i++) {
        const float way = begin + step * (float)i + run;
        const float tip_x = from.x + way * ahead_x, tip_y = from.y + way * ahead_y;
        frame->batch->opacity = fminf(f_smoothstep(begin - 0.2f * step, begin + step, way),
                                      1.0f - 0.8f * f_smoothstep(end - step, end, way));
        draw_chevron(frame, tip_x, tip_y, ahead_x, ahead_y, 15.0f * u, 0x0a0c24a0u);
        draw_chevron(frame, tip_x, tip_y, ahead_x, ahead_y, 9.0f * u, 0xffe08affu);
    }
    frame->batch->opacity = 1.0f;
    /* A ring around the mouth of the bowl shows where the arrow ends. */
    ui_ring(frame, to.x, to.y, 1.08f * bowl->radius_m * to.px_per_m, 5.0f * u, 1.0f,
            ui_fade(0xffe08affu, 0.4f + 0.5f * ui_pulse(frame->time_s, ARROW_PERIOD_S)), 0);
}

/* Draws the ghost poi that demonstrates a motion to `player`, and its hand. The ring is drawn as a
 * flat ellipse, whose height depends on the slant of the ghost. */
static void draw_ghost(const struct ui_frame *frame, uint32_t player)
{
    const struct scene_ghost *const ghost = &frame->scene->lesson[player].ghost;
    const struct basis axes = vec_basis_from_angles(ghost->angles);
    const struct ui_point at = ui_project(frame, ghost->position_m);
    const struct ui_point rim =
        ui_project(frame, v3_muladd(ghost->position_m, axes.back, GHOST_RADIUS_M));
    const float radius = GHOST_RADIUS_M * at.px_per_m;
    const float flat = f_clamp(hypotf(rim.x - at.x, rim.y - at.y) / radius, 0.15f, 1.0f);
    const float under = 1.0f - f_smoothstep(-0.02f, 0.01f, ghost->position_m.y);
    frame->batch->opacity = ghost->opacity;
    if (ghost->carries) {
        ui_fish_sign(frame, at.x, at.y, 1.2f * radius);
    }
    ui_shape(frame->batch,
             &(struct ui_shape){ .box = { at.x - UI_GHOST_RING_X * radius,
                                          at.y - UI_GHOST_RING_Y * radius, UI_GHOST_WIDTH * radius,
                                          UI_GHOST_HEIGHT * radius },
                                 .kind = UI_GHOST,
                                 .fill = ui_fade(ui_player_colours[player], GHOST_OPACITY),
                                 .shape = { radius, flat, under } });
    if (ui_bowl_count(frame->scene) > 1u) {
        ui_player_mark(frame, at.x - 0.8f * radius, at.y - 0.9f * radius, 17.0f * frame->unit,
                       player);
    }
    frame->batch->opacity = 1.0f;
}

void ui_lessons(const struct ui_frame *frame)
{
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct scene_lesson *const lesson = &frame->scene->lesson[i];
        if (lesson->ghost.is_present) {
            draw_ghost(frame, i);
        }
        if (lesson->marks_fish) {
            draw_mark(frame, i);
        }
        if (lesson->points_to_bowl) {
            draw_arrow(frame, i);
        }
        ui_poi_hint(frame, i);
    }
}
