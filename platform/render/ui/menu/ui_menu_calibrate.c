/* ui_menu_calibrate.c -- draws the calibration page. First, the page shows the tank from above with
 * four marks and the next instruction. In the last step, the page shows the water from the side,
 * and the operator lays the poi on the water. */
#include <math.h>
#include <stdio.h>

#include "core/game/menu/menu_calibrate.h"
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

static enum text_key name_of(uint8_t step)
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
    return names[step < CALIBRATE_STEPS ? step : 0u];
}

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

/* Draws a paragraph in as many lines as needed, from the top of the box downward. */
static void paragraph(const struct menu_view *view, struct ui_box box, const struct ui_text *style,
                      const char *words)
{
    char row[TEXT_LINE_MAX];
    for (float y = box.y; *words && y < box.y + box.height; y += 1.4f * style->size_px) {
        const size_t size = menu_fill_line(style, words, box.width);
        snprintf(row, sizeof row, "%.*s", (int)size, words);
        menu_words_at(view, box.x + 0.5f * box.width, y + 0.7f * style->size_px, box.width, 0.5f,
                      style, row);
        words += size;
    }
}

/* ---- Tank seen from above ------------------------------------------------------------------- */

static struct ui_box pool_of(const struct menu_view *view, struct ui_box box)
{
    const float u = view->frame.unit, room = 22.0f * u;
    return (struct ui_box){ box.x + room, box.y + room, box.width - 2.0f * room,
                            box.height - 2.0f * room };
}

static void basin(const struct menu_view *view, struct ui_box box, int from_the_side)
{
    const float u = view->frame.unit;
    struct ui_box pool = pool_of(view, box);
    ui_shape(view->frame.batch, &(struct ui_shape){ .box = box,
                                                    .kind = UI_WOOD,
                                                    .fill = 0x6e4528ffu,
                                                    .line = 0x3a2214ffu,
                                                    .shape = { 0, 0, 18.0f * u, 3.0f * u } });
    if (from_the_side) {
        ui_shape(view->frame.batch, &(struct ui_shape){ .box = pool,
                                                        .kind = UI_PANEL,
                                                        .fill = 0x0c1130ffu,
                                                        .shape = { 0, 0, 8.0f * u } });
        pool.y += 0.5f * pool.height;
        pool.height *= 0.5f;
    }
    ui_shape(view->frame.batch,
             &(struct ui_shape){ .box = pool,
                                 .kind = UI_WATER,
                                 .fill = 0x1d7a86ffu,
                                 .line = 0x0d3a4cffu,
                                 .shape = { 0, 0, 8.0f * u, view->frame.time_s } });
}

static void ring(const struct menu_view *view, float x, float y, float radius, float part)
{
    ui_shape(view->frame.batch,
             &(struct ui_shape){ .box = { x - radius, y - radius, 2.0f * radius, 2.0f * radius },
                                 .kind = UI_RING,
                                 .fill = UI_GOLD,
                                 .line = 0xffffff60u,
                                 .shape = { radius, 7.0f * view->frame.unit, part } });
}

/* Converts a position on the water to a point in the box `pool`, which shows the tank from
 * above. */
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
static void marks(const struct menu_view *view, struct ui_box pool)
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
            ring(view, x, y, (is_now ? 30.0f : 16.0f) * u,
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

/* Draws the water from the side. An animated poi sinks onto the water and stays there. */
static void laid_flat(const struct menu_view *view, struct ui_box pool)
{
    const float u = view->frame.unit, t = fmodf(view->frame.time_s, 2.4f);
    const float x = pool.x + 0.5f * pool.width, water = pool.y + 0.5f * pool.height;
    const float y = water - 90.0f * u * (1.0f - ui_smooth(0.2f, 1.0f, t));
    const float left[2] = { x - 90.0f * u, y }, right[2] = { x + 90.0f * u, y };
    const float grip[2] = { x + 210.0f * u, y };
    ui_segment(view->frame.batch, left, right, 9.0f * u, 0xfff6e2ffu);
    ui_segment(view->frame.batch, right, grip, 14.0f * u, ui_player_colours[view->menu->seat]);
    ring(view, x, water - 130.0f * u, 30.0f * u, view->menu->menu_calibrate_progress);
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
    const struct places *places = view->menu->upright ? &upright_places : &wide;
    const uint8_t step = view->menu->calibrate_step;
    const struct ui_box box = menu_place(view, places->basin), pool = pool_of(view, box);
    const struct ui_text name = menu_brush(view, 130.0f, MENU_CREAM);
    const struct ui_text words = menu_style(view, 30.0f, MENU_CREAM);
    basin(view, box, step == CALIBRATE_WATER);
    if (step == CALIBRATE_WATER) {
        laid_flat(view, pool);
    } else {
        marks(view, pool);
        live_poi(view, pool);
    }
    state_line(view, menu_place(view, places->state));
    ui_words_in(&view->frame, menu_place(view, places->name), &name,
                menu_text(view, name_of(step)));
    paragraph(view, menu_place(view, places->words), &words, menu_text(view, words_of(view)));
}
