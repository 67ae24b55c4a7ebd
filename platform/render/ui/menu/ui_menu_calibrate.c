/* ui_menu_calibrate.c -- draws the calibration page and the learning page.
 *
 * The calibration page first shows the tank from above, with the four marks at which the operator
 * must hold the poi (the paper scoop), and the next instruction. In the last step, the page shows
 * the water from the side, and the operator lays the poi on the water. On the learning page, the
 * operator teaches the program the axes of a controller. An animated poi in a basin demonstrates
 * the motion that the operator must make. */
#include <math.h>

#include "core/base/panic.h"
#include "platform/render/ui/menu/ui_menu.h"

/* Boxes of the parts of the calibration page, on the canvas. */
struct places {
    struct layout_box basin, state, name, words;
};

/* Layouts of a wide screen (index 0) and of an upright screen (index 1). */
static const struct places layouts[2] = {
    { { 60, 140, 600, 400 }, { 60, 552, 600, 44 }, { 700, 180, 530, 160 }, { 700, 370, 530, 150 } },
    { { 77, 220, 700, 500 }, { 77, 736, 700, 50 }, { 40, 800, 774, 200 }, { 40, 1020, 774, 160 } },
};

static bool is_corner(uint8_t step)
{
    return step >= CALIBRATE_CORNER && step < CALIBRATE_WATER;
}

/* Returns the explanation of the current calibration step. */
static enum text_key words_of(const struct scene *scene)
{
    static const enum text_key faults[CALIBRATION_FAULTS] = {
        [CALIBRATION_GOOD] = TEXT_CALIBRATE_DONE_WORDS,
        [CALIBRATION_NEAR] = TEXT_CALIBRATION_NEAR,
        [CALIBRATION_CROSSED] = TEXT_CALIBRATION_CROSSED,
        [CALIBRATION_MIRRORED] = TEXT_CALIBRATION_MIRRORED,
        [CALIBRATION_FAR] = TEXT_CALIBRATION_FAR,
        [CALIBRATION_UNEVEN] = TEXT_CALIBRATION_UNEVEN,
        [CALIBRATION_TILTED] = TEXT_CALIBRATION_TILTED,
    };
    const struct scene_menu *const menu = &scene->menu;
    const uint8_t step = menu->calibrate_step, fault = menu->calibrate_fault;
    const bool is_there = scene->devices.axes[menu->slot].link == POI_SOURCE_LIVE;
    return step == CALIBRATE_REFUSED ? faults[fault < CALIBRATION_FAULTS ? fault : 0u]
           : step == CALIBRATE_DONE  ? TEXT_CALIBRATE_DONE_WORDS
           : !is_there               ? TEXT_CALIBRATE_NO_POI
           : step == CALIBRATE_WATER ? TEXT_CALIBRATE_WATER_WORDS
           : is_corner(step)         ? TEXT_CALIBRATE_CORNER_WORDS
                                     : TEXT_CALIBRATE_IDLE_WORDS;
}

/* ---- Tank seen from above ------------------------------------------------------------------- */

/* Draws the water of the basin from above, inside a wooden frame that is `margin` pixels wide. If
 * `from_the_side` is true, draws the water from the side instead, with its surface in the middle of
 * the basin. Returns the box inside the frame. */
static struct ui_box draw_basin_water(const struct ui_frame *frame, struct ui_box box, float margin,
                                      float radius, bool from_the_side)
{
    const float u = frame->unit;
    const struct ui_box inside = { box.x + margin, box.y + margin, box.width - 2.0f * margin,
                                   box.height - 2.0f * margin };
    struct ui_box pool = inside;
    ui_panel(frame, UI_WOOD, box, 18.0f * u, 3.0f * u, 0x6e4528ffu, 0x3a2214ffu);
    if (from_the_side) {
        ui_panel(frame, UI_PANEL, pool, radius, 0.0f, 0x0c1130ffu, 0);
        pool.y += 0.5f * pool.height;
        pool.height *= 0.5f;
    }
    ui_water(frame, pool, radius, frame->time_s, 0x0d3a4cffu);
    return inside;
}

static void draw_calibration_ring(const struct ui_frame *frame, float x, float y, float radius,
                                  float part)
{
    ui_ring(frame, x, y, radius, 7.0f * frame->unit, part, UI_GOLD, 0xffffff60u);
}

/* Converts a position on the water in metres to a point in the box `pool`, which shows the tank
 * from above. */
static struct layout_point place_in(const struct ui_frame *frame, struct ui_box pool, vec3 at_m)
{
    const vec3 size_m = frame->scene->tank_size_m;
    const float right = size_m.x > 0.0f ? at_m.x / size_m.x : 0.0f;
    const float near = size_m.z > 0.0f ? at_m.z / size_m.z : 0.0f;
    return (struct layout_point){ pool.x + pool.width * (0.5f + f_clamp(right, -0.5f, 0.5f)),
                                  pool.y + pool.height * (0.5f + f_clamp(near, -0.5f, 0.5f)) };
}

/* Draws the four marks at which the operator must hold the poi, one for each calibration step: a
 * fish for a finished step, a large ring for the current step, and a small ring for a later step.
 * The large ring fills while the operator holds the poi still. Also draws the current position of
 * the poi, as computed with the new calibration. */
static void draw_calibration_marks(const struct ui_frame *frame, struct ui_box pool)
{
    const struct scene *const scene = frame->scene;
    const struct scene_menu *const menu = &scene->menu;
    const float u = frame->unit, room = 26.0f * u;
    const uint8_t step = menu->calibrate_step;
    const uint32_t colour = ui_player_colours[menu->slot];
    for (uint32_t i = 0; i < CALIBRATE_CORNERS; i++) {
        const struct layout_point at =
            place_in(frame, pool, input_calibration_mark(scene->tank_size_m, i));
        const bool is_now = step == CALIBRATE_CORNER + i;
        if (step > CALIBRATE_CORNER + i && step <= CALIBRATE_DONE) {
            ui_fish_sign(frame, at.x, at.y, 54.0f * u);
        } else {
            draw_calibration_ring(frame, at.x, at.y, (is_now ? 30.0f : 16.0f) * u,
                                  is_now ? menu->menu_calibrate_progress : 0.0f);
        }
        if (is_now) {
            ui_poi_sign(frame, at.x, at.y, 21.0f * u, 1.0f, colour);
        }
    }
    if (scene->devices.axes[menu->slot].link == POI_SOURCE_LIVE && !is_corner(step)) {
        const struct layout_point at = place_in(frame, pool, menu->calibrated_m);
        ui_poi_sign(frame, f_clamp(at.x, pool.x + room, pool.x + pool.width - room),
                    f_clamp(at.y, pool.y + room, pool.y + pool.height - room), 24.0f * u, 1.0f,
                    colour);
    }
}

void menu_calibration(const struct ui_frame *frame)
{
    static const enum text_key names[CALIBRATE_STEPS] = {
        [CALIBRATE_IDLE] = TEXT_CALIBRATE_IDLE,
        [CALIBRATE_CORNER] = TEXT_CALIBRATE_CORNER_1,
        [CALIBRATE_CORNER + 1] = TEXT_CALIBRATE_CORNER_2,
        [CALIBRATE_CORNER + 2] = TEXT_CALIBRATE_CORNER_3,
        [CALIBRATE_CORNER + 3] = TEXT_CALIBRATE_CORNER_4,
        [CALIBRATE_WATER] = TEXT_CALIBRATE_WATER,
        [CALIBRATE_DONE] = TEXT_CALIBRATE_DONE,
        [CALIBRATE_REFUSED] = TEXT_CALIBRATE_REFUSED,
    };
    const struct places *const places = &layouts[frame->is_upright];
    const struct scene_menu *const menu = &frame->scene->menu;
    CORE_ASSERT(menu->slot < POI_MAX);
    const uint8_t step = menu->calibrate_step;
    const float u = frame->unit;
    const struct ui_box pool = draw_basin_water(frame, ui_place(frame, places->basin), 22.0f * u,
                                                8.0f * u, step == CALIBRATE_WATER);
    if (step == CALIBRATE_WATER) {
        /* The water is seen from the side. An animated poi sinks onto the water and stays there. */
        const float t = fmodf(frame->time_s, 2.4f);
        const float x = pool.x + 0.5f * pool.width, water = pool.y + 0.5f * pool.height;
        const float y = water - 90.0f * u * (1.0f - f_smoothstep(0.2f, 1.0f, t));
        const float left[2] = { x - 90.0f * u, y }, right[2] = { x + 90.0f * u, y };
        const float grip[2] = { x + 210.0f * u, y };
        ui_segment(frame->batch, left, right, 9.0f * u, UI_CREAM);
        ui_segment(frame->batch, right, grip, 14.0f * u, ui_player_colours[menu->slot]);
        draw_calibration_ring(frame, x, water - 130.0f * u, 30.0f * u,
                              menu->menu_calibrate_progress);
    } else {
        draw_calibration_marks(frame, pool);
    }
    /* This line shows the player's number, and whether a calibration is stored for the player's
     * controller. */
    const struct ui_box line = ui_place(frame, places->state);
    const float line_y = line.y + 0.5f * line.height;
    const bool is_torn = input_calibration_is_torn(&menu->settings, menu->slot);
    const bool is_set = menu->calibrated >> menu->slot & 1u;
    ui_player_mark(frame, line.x + 24.0f * u, line_y, 16.0f * u, menu->slot);
    ui_label_at(frame, line.x + 56.0f * u, line_y, line.width - 60.0f * u, 24.0f, UI_CREAM,
                is_torn  ? TEXT_CALIBRATE_IS_TORN
                : is_set ? TEXT_CALIBRATE_IS_SET
                         : TEXT_CALIBRATE_IS_NOT_SET);
    ui_words_in(frame, ui_place(frame, places->name), menu_brush(frame, 130.0f, UI_CREAM),
                ui_words(frame, names[step < CALIBRATE_STEPS ? step : 0u]));
    /* The explanation has as many lines as needed, from the top of its box downward. */
    const struct ui_box area = ui_place(frame, places->words);
    const struct ui_text words = ui_body(frame, 30.0f, UI_CREAM);
    const char *rest = ui_words(frame, words_of(frame->scene));
    char row[TEXT_LINE_MAX];
    float y = area.y;
    while (*rest && y < area.y + area.height) {
        menu_take_line(words, &rest, area.width, false, row, sizeof row);
        ui_words_at(frame, area.x + 0.5f * area.width, y + 0.7f * words.size_px, area.width, 0.5f,
                    words, row);
        y += 1.4f * words.size_px;
    }
}

/* ---- Learning page: the axes of a controller ------------------------------------------------- */

#define LOOP_S 2.4f /* Period of the demonstrated motion in seconds. */
/* Time in seconds, from the start of a period, at which the demonstrated outward motion ends. */
#define WAY_S 0.9f
/* Time in seconds, from the start of a period, at which the demonstrating poi has returned. */
#define BACK_S 2.1f
#define STEPS (LEARN_DIP - LEARN_REST + 1)

struct step_words {
    enum text_key name, words;
    /* Motion that the operator must make: the way of the poi from the middle of the basin. The
     * units are half of the basin's width (x) and half of its height (y). */
    float x, y;
};

static const struct step_words steps[LEARN_STEP_COUNT] = {
    [LEARN_NONE] = { TEXT_LEARN_NONE, TEXT_LEARN_NONE_WORDS, 0.0f, 0.0f },
    [LEARN_REST] = { TEXT_LEARN_REST, TEXT_LEARN_REST_WORDS, 0.0f, 0.0f },
    [LEARN_LEFT] = { TEXT_LEARN_LEFT, TEXT_LEARN_LEFT_WORDS, -1.0f, 0.0f },
    [LEARN_RIGHT] = { TEXT_LEARN_RIGHT, TEXT_LEARN_RIGHT_WORDS, 1.0f, 0.0f },
    [LEARN_FAR] = { TEXT_LEARN_FAR, TEXT_LEARN_FAR_WORDS, 0.0f, -1.0f },
    [LEARN_NEAR] = { TEXT_LEARN_NEAR, TEXT_LEARN_NEAR_WORDS, 0.0f, 1.0f },
    [LEARN_DIP] = { TEXT_LEARN_DIP, TEXT_LEARN_DIP_WORDS, 0.0f, 0.62f },
    [LEARN_TRY] = { TEXT_LEARN_TRY, TEXT_LEARN_TRY_WORDS, 0.0f, 0.0f },
    [LEARN_FAILED] = { TEXT_LEARN_FAILED, TEXT_LEARN_FAILED_WORDS, 0.0f, 0.0f },
    [LEARN_NOT_SAVED] = { TEXT_LEARN_UNKEPT, TEXT_LEARN_UNKEPT_WORDS, 0.0f, 0.0f },
};

/* Boxes of the parts of the learning page, on the canvas. */
struct learn_places {
    struct layout_box basin, name, words, dots;
};

/* Layouts of a wide screen (index 0) and of an upright screen (index 1). */
static const struct learn_places learn_layouts[2] = {
    { { 130, 150, 480, 330 },
      { 660, 160, 560, 170 },
      { 660, 350, 560, 60 },
      { 660, 440, 560, 40 } },
    { { 107, 240, 640, 440 }, { 40, 730, 774, 220 }, { 27, 970, 800, 70 }, { 27, 1090, 800, 50 } },
};

/* Draws the poi (paper scoop) that demonstrates the motion of the current step. */
static void draw_motion_demo(const struct ui_frame *frame, struct ui_box box, uint8_t step)
{
    /* `t` is how far the demonstrating poi has moved outward, [0, 1]. The poi moves outward, waits,
     * and moves back. */
    const float loop_s = fmodf(frame->time_s, LOOP_S);
    const float t =
        f_smoothstep(0.2f, WAY_S, loop_s) * (1.0f - f_smoothstep(BACK_S - 0.5f, BACK_S, loop_s));
    const float u = frame->unit;
    const struct scene_menu *const menu = &frame->scene->menu;
    const struct layout_point canvas = pointer_layout_size(frame->is_upright);
    float x = 0.5f, y = 0.5f;
    const bool is_trial = step == LEARN_TRY || step == LEARN_NOT_SAVED;
    float paper = step == LEARN_FAILED ? 0.15f : 1.0f, radius = 46.0f * u;
    /* In the trial, the poi in the picture follows the controller whose axes were learned. */
    if (is_trial && menu->has_pointer) {
        x = menu->x / canvas.x;
        y = menu->y / canvas.y;
        radius *= menu->presses ? 0.75f : 1.0f;
    } else if (is_trial) {
        paper = 0.0f;
    } else {
        const float rest_y = step == LEARN_DIP ? 0.26f : 0.5f;
        x = 0.5f + 0.30f * steps[step].x * t;
        y = rest_y + 0.30f * steps[step].y * t + (step == LEARN_DIP ? 0.22f * t : 0.0f);
    }
    const float left = box.x + 70.0f * u, top = box.y + 70.0f * u;
    const float px = left + x * (box.width - 140.0f * u), py = top + y * (box.height - 140.0f * u);
    if (step >= LEARN_REST && step <= LEARN_DIP) {
        /* A ring round the demonstrating poi shows the progress of the current step. */
        ui_ring(frame, px, py, 78.0f * u, 9.0f * u,
                (float)menu->controllers.learn_progress / 255.0f, UI_GOLD, 0xffffff30u);
    }
    ui_poi_sign(frame, px, py, radius, paper, ui_player_colours[0]);
}

void menu_learning(const struct ui_frame *frame)
{
    const uint8_t step = frame->scene->menu.controllers.learn_step;
    CORE_ASSERT(step < LEARN_STEP_COUNT);
    const struct learn_places *const places = &learn_layouts[frame->is_upright];
    const struct ui_box box = ui_place(frame, places->basin);
    const float u = frame->unit;
    draw_basin_water(frame, box, 16.0f * u, 10.0f * u, step == LEARN_DIP);
    if (step >= LEARN_LEFT && step <= LEARN_NEAR) {
        /* An arrow points in the direction of the motion that the operator must make. */
        const float half = 0.44f * (steps[step].x != 0.0f ? box.width : box.height);
        const float norm = fmaxf(fabsf(steps[step].x) + fabsf(steps[step].y), 0.01f);
        const float dx = steps[step].x / norm, dy = steps[step].y / norm, head = 22.0f * u;
        const float from[2] = { box.x + 0.5f * box.width, box.y + 0.5f * box.height };
        const float to[2] = { from[0] + dx * half, from[1] + dy * half };
        ui_segment(frame->batch, from, to, 7.0f * u, 0xffe0a0c0u);
        for (int side = -1; side <= 1; side += 2) {
            const float end[2] = { to[0] - head * (dx + (float)side * dy),
                                   to[1] - head * (dy - (float)side * dx) };
            ui_segment(frame->batch, to, end, 7.0f * u, 0xffe0a0c0u);
        }
    }
    draw_motion_demo(frame, box, step);
    ui_words_in(frame, ui_place(frame, places->name), menu_brush(frame, 150.0f, UI_CREAM),
                ui_words(frame, steps[step].name));
    ui_label_in(frame, ui_place(frame, places->words), 30.0f, UI_CREAM, steps[step].words);
    /* A row of signs has a fish for each finished step and a ring for each later step. */
    const struct ui_box dots = ui_place(frame, places->dots);
    const float pitch = 62.0f * u, y = dots.y + 0.5f * dots.height;
    float x = dots.x + 0.5f * dots.width - 0.5f * (float)(STEPS - 1) * pitch;
    for (int i = LEARN_REST; i <= LEARN_DIP; i++) {
        if (i < step && step != LEARN_FAILED) {
            ui_fish_sign(frame, x, y, 46.0f * u);
        } else {
            ui_ring(frame, x, y, (i == step ? 15.0f : 10.0f) * u, 4.0f * u, i == step ? 1.0f : 0.0f,
                    UI_GOLD, 0xffffff60u);
        }
        x += pitch;
    }
}
