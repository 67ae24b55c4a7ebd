/* ui_menu_calibrate.c -- draws the calibration page and the learning page.
 *
 * The calibration page first shows the tank from above with four marks and the next instruction. In
 * the last step, the page shows the water from the side, and the operator lays the poi on the
 * water. On the learning page, the operator teaches the program the axes of a controller. An
 * animated poi in a basin demonstrates the motion that the operator must make. */
#include <math.h>
#include <stdio.h>

#include "core/base/panic.h"
#include "core/game/menu/menu.h"
#include "platform/render/ui/menu/ui_menu.h"

struct places {
    struct layout_box basin, state, name, words;
};

static const struct places wide = {
    .basin = { 60.0f, 140.0f, 600.0f, 400.0f },
    .state = { 60.0f, 552.0f, 600.0f, 44.0f },
    .name = { 700.0f, 180.0f, 530.0f, 160.0f },
    .words = { 700.0f, 370.0f, 530.0f, 150.0f },
};
static const struct places upright_places = {
    .basin = { 77.0f, 220.0f, 700.0f, 500.0f },
    .state = { 77.0f, 736.0f, 700.0f, 50.0f },
    .name = { 40.0f, 800.0f, 774.0f, 200.0f },
    .words = { 40.0f, 1020.0f, 774.0f, 160.0f },
};

static int is_corner(uint8_t step)
{
    return step >= CALIBRATE_CORNER && step < CALIBRATE_WATER;
}

/* ---- Texts of the calibration steps --------------------------------------------------------- */

static enum text_key fault_words(uint8_t fault)
{
    static const enum text_key words[CALIBRATION_FAULTS] = {
        [CALIBRATION_GOOD] = TEXT_CALIBRATE_DONE_WORDS,
        [CALIBRATION_NEAR] = TEXT_CALIBRATION_NEAR,
        [CALIBRATION_CROSSED] = TEXT_CALIBRATION_CROSSED,
        [CALIBRATION_MIRRORED] = TEXT_CALIBRATION_MIRRORED,
        [CALIBRATION_FAR] = TEXT_CALIBRATION_FAR,
        [CALIBRATION_UNEVEN] = TEXT_CALIBRATION_UNEVEN,
        [CALIBRATION_TILTED] = TEXT_CALIBRATION_TILTED,
    };
    return words[fault < CALIBRATION_FAULTS ? fault : 0u];
}

static enum text_key words_of(const struct menu_view *view)
{
    const struct scene_menu *menu = view->menu;
    const int is_there = view->devices->axes[menu->seat].link == POI_SOURCE_LIVE;
    return menu->calibrate_step == CALIBRATE_REFUSED ? fault_words(menu->calibrate_fault)
           : menu->calibrate_step == CALIBRATE_DONE  ? TEXT_CALIBRATE_DONE_WORDS
           : !is_there                               ? TEXT_CALIBRATE_NO_POI
           : menu->calibrate_step == CALIBRATE_WATER ? TEXT_CALIBRATE_WATER_WORDS
           : is_corner(menu->calibrate_step)         ? TEXT_CALIBRATE_CORNER_WORDS
                                                     : TEXT_CALIBRATE_IDLE_WORDS;
}

/* ---- Tank seen from above ------------------------------------------------------------------- */

/* Draws the water of the basin from above, inside a wooden frame that is `margin` pixels wide. If
 * `from_the_side` is 1, draws the water from the side instead, with its surface in the middle of
 * the basin. Returns the box inside the frame. */
static struct ui_box draw_basin_water(const struct menu_view *view, struct ui_box box, float margin,
                                      float radius, int from_the_side)
{
    const float u = view->frame.unit;
    const struct ui_box inside = { box.x + margin, box.y + margin, box.width - 2.0f * margin,
                                   box.height - 2.0f * margin };
    struct ui_box pool = inside;
    ui_panel(&view->frame, UI_WOOD, box, 18.0f * u, 3.0f * u, 0x6e4528ffu, 0x3a2214ffu);
    if (from_the_side) {
        ui_panel(&view->frame, UI_PANEL, pool, radius, 0.0f, 0x0c1130ffu, 0);
        pool.y += 0.5f * pool.height;
        pool.height *= 0.5f;
    }
    ui_shape(view->frame.batch,
             &(struct ui_shape){ .box = pool,
                                 .kind = UI_WATER,
                                 .fill = 0x1d7a86ffu,
                                 .line = 0x0d3a4cffu,
                                 .shape = { 0, 0, radius, view->frame.time_s } });
    return inside;
}

static void draw_calibration_ring(const struct menu_view *view, float x, float y, float radius,
                                  float part)
{
    ui_ring(&view->frame, x, y, radius, 7.0f * view->frame.unit, part, UI_GOLD, 0xffffff60u);
}

/* Converts a position on the water in metres to a point in the box `pool`, which shows the tank
 * from above. */
static void place_in(const struct menu_view *view, struct ui_box pool, vec3 at_m, float *x,
                     float *y)
{
    const vec3 size_m = view->scene->tank_size_m;
    const float right = size_m.x > 0.0f ? at_m.x / size_m.x : 0.0f;
    const float near = size_m.z > 0.0f ? at_m.z / size_m.z : 0.0f;
    *x = pool.x + pool.width * (0.5f + fmaxf(-0.5f, fminf(right, 0.5f)));
    *y = pool.y + pool.height * (0.5f + fmaxf(-0.5f, fminf(near, 0.5f)));
}

/* Draws a mark for each calibration step: a fish for a finished step, a large ring for the current
 * step, and a small ring for a later step. The large ring fills while the operator holds the poi
 * still. */
static void draw_calibration_marks(const struct menu_view *view, struct ui_box pool)
{
    const float u = view->frame.unit;
    const uint8_t step = view->menu->calibrate_step;
    for (uint32_t i = 0; i < CALIBRATE_CORNERS; i++) {
        float x, y;
        place_in(view, pool, calibration_mark(view->scene->tank_size_m, i), &x, &y);
        const int is_now = step == CALIBRATE_CORNER + i;
        if (step > CALIBRATE_CORNER + i && step <= CALIBRATE_DONE) {
            ui_fish_sign(&view->frame, x, y, 54.0f * u);
        } else {
            draw_calibration_ring(view, x, y, (is_now ? 30.0f : 16.0f) * u,
                                  is_now ? view->menu->menu_calibrate_progress : 0.0f);
        }
        if (is_now) {
            ui_poi_sign(&view->frame, x, y, 21.0f * u, 1.0f, ui_player_colours[view->menu->seat]);
        }
    }
}

/* Draws the current position of the poi, as computed with the new calibration. */
static void live_poi(const struct menu_view *view, struct ui_box pool)
{
    const struct scene_menu *menu = view->menu;
    float x, y;
    if (view->devices->axes[menu->seat].link != POI_SOURCE_LIVE ||
        is_corner(menu->calibrate_step)) {
        return;
    }
    place_in(view, pool, menu->calibrated_m, &x, &y);
    const float room = 26.0f * view->frame.unit;
    x = fmaxf(pool.x + room, fminf(x, pool.x + pool.width - room));
    y = fmaxf(pool.y + room, fminf(y, pool.y + pool.height - room));
    ui_poi_sign(&view->frame, x, y, 24.0f * view->frame.unit, 1.0f, ui_player_colours[menu->seat]);
}

static void state_line(const struct menu_view *view, struct ui_box box)
{
    const float u = view->frame.unit;
    const struct scene_menu *menu = view->menu;
    const struct ui_text style = menu_style(view, 24.0f, MENU_CREAM);
    const enum text_key words = calibration_is_torn(&menu->settings, menu->seat)
                                    ? TEXT_CALIBRATE_IS_TORN
                                : menu->calibrated >> menu->seat & 1u ? TEXT_CALIBRATE_IS_SET
                                                                      : TEXT_CALIBRATE_IS_NOT_SET;
    ui_player_mark(&view->frame, box.x + 24.0f * u, box.y + 0.5f * box.height, 16.0f * u,
                   menu->seat);
    menu_words_at(view, box.x + 56.0f * u, box.y + 0.5f * box.height, box.width - 60.0f * u, 0.0f,
                  &style, menu_text(view, words));
}

void menu_calibration(const struct menu_view *view)
{
    CORE_ASSERT(view->menu->seat < POI_MAX);
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
    const struct places *places = view->menu->upright ? &upright_places : &wide;
    const uint8_t step = view->menu->calibrate_step;
    const float u = view->frame.unit;
    const struct ui_text name = menu_brush(view, 130.0f, MENU_CREAM);
    const struct ui_text words = menu_style(view, 30.0f, MENU_CREAM);
    const struct ui_box pool = draw_basin_water(view, menu_place(view, places->basin), 22.0f * u,
                                                8.0f * u, step == CALIBRATE_WATER);
    if (step == CALIBRATE_WATER) {
        /* The water is seen from the side. An animated poi sinks onto the water and stays there. */
        const float t = fmodf(view->frame.time_s, 2.4f);
        const float x = pool.x + 0.5f * pool.width, water = pool.y + 0.5f * pool.height;
        const float y = water - 90.0f * u * (1.0f - ui_smooth(0.2f, 1.0f, t));
        const float left[2] = { x - 90.0f * u, y }, right[2] = { x + 90.0f * u, y };
        const float grip[2] = { x + 210.0f * u, y };
        ui_segment(view->frame.batch, left, right, 9.0f * u, 0xfff6e2ffu);
        ui_segment(view->frame.batch, right, grip, 14.0f * u, ui_player_colours[view->menu->seat]);
        draw_calibration_ring(view, x, water - 130.0f * u, 30.0f * u,
                              view->menu->menu_calibrate_progress);
    } else {
        draw_calibration_marks(view, pool);
        live_poi(view, pool);
    }
    state_line(view, menu_place(view, places->state));
    ui_words_in(&view->frame, menu_place(view, places->name), &name,
                menu_text(view, names[step < CALIBRATE_STEPS ? step : 0u]));
    /* The explanation has as many lines as needed, from the top of its box downward. */
    const struct ui_box area = menu_place(view, places->words);
    const char *rest = menu_text(view, words_of(view));
    char row[TEXT_LINE_MAX];
    for (float y = area.y; *rest && y < area.y + area.height; y += 1.4f * words.size_px) {
        menu_take_line(&words, &rest, area.width, 0, row, sizeof row);
        menu_words_at(view, area.x + 0.5f * area.width, y + 0.7f * words.size_px, area.width, 0.5f,
                      &words, row);
    }
}

/* ---- Learning page: the axes of a controller ------------------------------------------------- */

#define LOOP_S 2.4f /* Period of the demonstrated motion in seconds. */
/* Time in seconds at which the demonstrated outward motion ends, counted from the start of each
 * period of LOOP_S seconds. */
#define WAY_S 0.9f
/* Time in seconds at which the demonstrating poi has returned, counted from the start of each
 * period of LOOP_S seconds. */
#define BACK_S 2.1f
#define STEPS (LEARN_DIP - LEARN_REST + 1)

struct step_words {
    enum text_key name, words;
    float x, y; /* Direction of the poi's motion, in units of half of the basin's width and
                   height. */
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

/* Boxes of the parts of the page, on the canvas. */
struct learn_places {
    struct layout_box basin, name, words, dots;
};

static const struct learn_places learn_wide = {
    .basin = { 130.0f, 150.0f, 480.0f, 330.0f },
    .name = { 660.0f, 160.0f, 560.0f, 170.0f },
    .words = { 660.0f, 350.0f, 560.0f, 60.0f },
    .dots = { 660.0f, 440.0f, 560.0f, 40.0f },
};
static const struct learn_places learn_upright = {
    .basin = { 107.0f, 240.0f, 640.0f, 440.0f },
    .name = { 40.0f, 730.0f, 774.0f, 220.0f },
    .words = { 27.0f, 970.0f, 800.0f, 70.0f },
    .dots = { 27.0f, 1090.0f, 800.0f, 50.0f },
};

static void teacher(const struct menu_view *view, struct ui_box box, uint8_t step)
{
    /* `t` is how far the demonstrating poi (paper scoop) has moved outward, [0, 1]. The poi moves
     * outward, waits, and moves back. */
    const float loop_s = fmodf(view->frame.time_s, LOOP_S);
    const float t =
        ui_smooth(0.2f, WAY_S, loop_s) * (1.0f - ui_smooth(BACK_S - 0.5f, BACK_S, loop_s));
    const float u = view->frame.unit;
    const struct scene_menu *menu = view->menu;
    const struct layout_point canvas = pointer_layout_size(menu->upright);
    float x = 0.5f, y = 0.5f;
    const int plays = step == LEARN_TRY || step == LEARN_NOT_SAVED;
    float paper = step == LEARN_FAILED ? 0.15f : 1.0f, radius = 46.0f * u;
    if (plays && menu->has_hand) { /* The poi in the picture follows the controller that is being
                                      taught. */
        x = menu->x / canvas.x;
        y = menu->y / canvas.y;
        radius *= menu->presses ? 0.75f : 1.0f;
    } else if (plays) {
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
        ui_ring(&view->frame, px, py, 78.0f * u, 9.0f * u,
                (float)menu->controllers.learn_progress / 255.0f, UI_GOLD, 0xffffff30u);
    }
    ui_poi_sign(&view->frame, px, py, radius, paper, ui_player_colours[0]);
}

/* Draws a fish for each finished step and a ring for each later step. */
static void dots(const struct menu_view *view, struct ui_box box, uint8_t step)
{
    const float u = view->frame.unit, pitch = 62.0f * u;
    const float y = box.y + 0.5f * box.height;
    float x = box.x + 0.5f * box.width - 0.5f * (float)(STEPS - 1) * pitch;
    for (int i = LEARN_REST; i <= LEARN_DIP; i++) {
        const float radius = (i == step ? 15.0f : 10.0f) * u;
        if (i < step && step != LEARN_FAILED) {
            ui_fish_sign(&view->frame, x, y, 46.0f * u);
        } else {
            ui_ring(&view->frame, x, y, radius, 4.0f * u, i == step ? 1.0f : 0.0f, UI_GOLD,
                    0xffffff60u);
        }
        x += pitch;
    }
}

void menu_learning(const struct menu_view *view)
{
    CORE_ASSERT(view->menu->controllers.learn_step < LEARN_STEP_COUNT);
    const struct learn_places *places = view->menu->upright ? &learn_upright : &learn_wide;
    const uint8_t step = view->menu->controllers.learn_step;
    const struct ui_box box = menu_place(view, places->basin);
    const float u = view->frame.unit;
    const struct ui_text name = menu_brush(view, 150.0f, MENU_CREAM);
    const struct ui_text words = menu_style(view, 30.0f, MENU_CREAM);
    draw_basin_water(view, box, 16.0f * u, 10.0f * u, step == LEARN_DIP);
    if (step >= LEARN_LEFT && step <= LEARN_NEAR) {
        /* An arrow points in the direction of the motion that the operator must make. */
        const float half = 0.44f * (steps[step].x != 0.0f ? box.width : box.height);
        const float norm = fmaxf(fabsf(steps[step].x) + fabsf(steps[step].y), 0.01f);
        const float dx = steps[step].x / norm, dy = steps[step].y / norm, head = 22.0f * u;
        const float from[2] = { box.x + 0.5f * box.width, box.y + 0.5f * box.height };
        const float to[2] = { from[0] + dx * half, from[1] + dy * half };
        ui_segment(view->frame.batch, from, to, 7.0f * u, 0xffe0a0c0u);
        for (int side = -1; side <= 1; side += 2) {
            const float end[2] = { to[0] - head * (dx + (float)side * dy),
                                   to[1] - head * (dy - (float)side * dx) };
            ui_segment(view->frame.batch, to, end, 7.0f * u, 0xffe0a0c0u);
        }
    }
    teacher(view, box, step);
    ui_words_in(&view->frame, menu_place(view, places->name), &name,
                menu_text(view, steps[step].name));
    ui_words_in(&view->frame, menu_place(view, places->words), &words,
                menu_text(view, steps[step].words));
    dots(view, menu_place(view, places->dots), step);
}
