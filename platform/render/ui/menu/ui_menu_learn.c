/* ui_menu_learn.c -- draws the page on which the operator teaches the program the axes of a
 * controller. An animated poi in a basin demonstrates the motion that the operator must make. */
#include <math.h>

#include "platform/render/ui/menu/ui_menu.h"

#define LOOP_S 2.4f /* Period of the demonstrated motion in seconds. */
/* Time in seconds from the start of the period to the end of the outward motion. */
#define WAY_S 0.9f
#define BACK_S 2.1f /* Time in seconds from the start of the period to the poi's return. */
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
struct places {
    struct layout_box basin, name, words, dots;
};

static const struct places wide = {
    .basin = { 130.0f, 150.0f, 480.0f, 330.0f },
    .name = { 660.0f, 160.0f, 560.0f, 170.0f },
    .words = { 660.0f, 350.0f, 560.0f, 60.0f },
    .dots = { 660.0f, 440.0f, 560.0f, 40.0f },
};
static const struct places upright_places = {
    .basin = { 107.0f, 240.0f, 640.0f, 440.0f },
    .name = { 40.0f, 730.0f, 774.0f, 220.0f },
    .words = { 27.0f, 970.0f, 800.0f, 70.0f },
    .dots = { 27.0f, 1090.0f, 800.0f, 50.0f },
};

/* Returns how far the demonstrating poi has moved outward at `time_s`, [0, 1]. The poi moves
 * outward, waits, and moves back. */
static float way(float time_s)
{
    const float t = fmodf(time_s, LOOP_S);
    return ui_smooth(0.2f, WAY_S, t) * (1.0f - ui_smooth(BACK_S - 0.5f, BACK_S, t));
}

static void arrow(const struct menu_view *view, const struct step_words *step, float x, float y,
                  float length)
{
    const float u = view->frame.unit, norm = fmaxf(fabsf(step->x) + fabsf(step->y), 0.01f);
    const float dx = step->x / norm, dy = step->y / norm, head = 22.0f * u;
    const float from[2] = { x, y };
    const float to[2] = { x + dx * length, y + dy * length };
    ui_segment(view->frame.batch, from, to, 7.0f * u, 0xffe0a0c0u);
    for (int side = -1; side <= 1; side += 2) {
        const float end[2] = { to[0] - head * (dx + (float)side * dy),
                               to[1] - head * (dy - (float)side * dx) };
        ui_segment(view->frame.batch, to, end, 7.0f * u, 0xffe0a0c0u);
    }
}

/* Draws the water of the basin from above. If `from_the_side` is 1, draws the water from the side
 * instead, with its surface in the middle of the box. */
static void water(const struct menu_view *view, struct ui_box box, int from_the_side)
{
    const float u = view->frame.unit;
    ui_shape(view->frame.batch, &(struct ui_shape){ .box = box,
                                                    .kind = UI_WOOD,
                                                    .fill = 0x6e4528ffu,
                                                    .line = 0x3a2214ffu,
                                                    .shape = { 0, 0, 18.0f * u, 3.0f * u } });
    struct ui_box pool = { box.x + 16.0f * u, box.y + 16.0f * u, box.width - 32.0f * u,
                           box.height - 32.0f * u };
    if (from_the_side) {
        ui_shape(view->frame.batch, &(struct ui_shape){ .box = pool,
                                                        .kind = UI_PANEL,
                                                        .fill = 0x0c1130ffu,
                                                        .shape = { 0, 0, 10.0f * u } });
        pool.y += 0.5f * pool.height;
        pool.height *= 0.5f;
    }
    ui_shape(view->frame.batch,
             &(struct ui_shape){ .box = pool,
                                 .kind = UI_WATER,
                                 .fill = 0x1d7a86ffu,
                                 .line = 0x0d3a4cffu,
                                 .shape = { 0, 0, 10.0f * u, view->frame.time_s } });
}

/* Draws the progress of the current step as a ring round the demonstrating poi. `part` in [0, 1] is
 * the finished fraction. */
static void progress_ring(const struct menu_view *view, float x, float y, float part)
{
    const float u = view->frame.unit, radius = 78.0f * u;
    ui_shape(view->frame.batch,
             &(struct ui_shape){ .box = { x - radius, y - radius, 2.0f * radius, 2.0f * radius },
                                 .kind = UI_RING,
                                 .fill = UI_GOLD,
                                 .line = 0xffffff30u,
                                 .shape = { radius, 9.0f * u, part } });
}

static void teacher(const struct menu_view *view, struct ui_box box, uint8_t step)
{
    const float u = view->frame.unit, t = way(view->frame.time_s);
    const struct scene_menu *menu = view->menu;
    const struct layout_point canvas = pointer_layout_size(menu->upright);
    float x = 0.5f, y = 0.5f;
    const int plays = step == LEARN_TRY || step == LEARN_NOT_SAVED;
    float paper = step == LEARN_FAILED ? 0.15f : 1.0f, radius = 46.0f * u;
    if (plays && menu->has_hand) { /* The controller that is being taught moves this poi. */
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
        progress_ring(view, px, py, (float)menu->controllers.learn_progress / 255.0f);
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
            ui_shape(
                view->frame.batch,
                &(struct ui_shape){ .box = { x - radius, y - radius, 2.0f * radius, 2.0f * radius },
                                    .kind = UI_RING,
                                    .line = 0xffffff60u,
                                    .fill = UI_GOLD,
                                    .shape = { radius, 4.0f * u, i == step ? 1.0f : 0.0f } });
        }
        x += pitch;
    }
}

void menu_learning(const struct menu_view *view)
{
    const struct places *places = view->menu->upright ? &upright_places : &wide;
    const uint8_t step = view->menu->controllers.learn_step;
    const struct ui_box basin = menu_place(view, places->basin);
    const struct ui_text name = menu_brush(view, 150.0f, MENU_CREAM);
    const struct ui_text words = menu_style(view, 30.0f, MENU_CREAM);
    water(view, basin, step == LEARN_DIP);
    if (step >= LEARN_LEFT && step <= LEARN_NEAR) {
        const float half = 0.44f * (steps[step].x != 0.0f ? basin.width : basin.height);
        arrow(view, &steps[step], basin.x + 0.5f * basin.width, basin.y + 0.5f * basin.height,
              half);
    }
    teacher(view, basin, step);
    ui_words_in(&view->frame, menu_place(view, places->name), &name,
                menu_text(view, steps[step].name));
    ui_words_in(&view->frame, menu_place(view, places->words), &words,
                menu_text(view, steps[step].words));
    dots(view, menu_place(view, places->dots), step);
}
