/* ui_menu_self.c -- ready for opening: a mark for each thing that is tried, and what to do next. */
#include "core/game/self_test.h"
#include "platform/render/ui_menu.h"

#define GOOD_PAINT 0x17754effu
#define BAD_PAINT 0xb3261effu
#define ASK_PAINT 0xa85a12ffu
#define COLUMNS 3u

static const struct check_words {
    enum text_key name, bad, asks;
} checks[SELF_CHECKS] = {
    [SELF_STORE] = { TEXT_CHECK_STORE, TEXT_CHECK_STORE_BAD, TEXT_CHECK_WAITS },
    [SELF_CLOCK] = { TEXT_CHECK_CLOCK, TEXT_CHECK_CLOCK_BAD, TEXT_CHECK_WAITS },
    [SELF_DISPLAY] = { TEXT_CHECK_DISPLAY, TEXT_CHECK_DISPLAY_BAD, TEXT_CHECK_WAITS },
    [SELF_FILES] = { TEXT_CHECK_FILES, TEXT_CHECK_FILES_BAD, TEXT_CHECK_WAITS },
    [SELF_SOUND] = { TEXT_CHECK_SOUND, TEXT_CHECK_SOUND_BAD, TEXT_CHECK_SOUND_ASK },
    [SELF_LAMP] = { TEXT_CHECK_LAMP, TEXT_CHECK_LAMP_BAD, TEXT_CHECK_LAMP_ASK },
    [SELF_BUTTONS] = { TEXT_CHECK_BUTTONS, TEXT_CHECK_WAITS, TEXT_CHECK_BUTTONS_ASK },
    [SELF_COINS] = { TEXT_CHECK_COINS, TEXT_CHECK_WAITS, TEXT_CHECK_COINS_ASK },
    [SELF_POIS] = { TEXT_CHECK_POIS, TEXT_CHECK_POIS_BAD, TEXT_CHECK_POIS_ASK },
};

static uint32_t paint_of(uint8_t state)
{
    return state == SELF_GOOD ? GOOD_PAINT : state == SELF_BAD ? BAD_PAINT : ASK_PAINT;
}

/* A tick, a cross; what is still to be tried has a question mark. */
static void mark(const struct menu_view *view, float x, float y, uint8_t state)
{
    const float u = view->frame.unit, r = 15.0f * u;
    const float low[2] = { x - 0.3f * r, y + 0.8f * r };
    const float left[2] = { x - r, y + (state == SELF_GOOD ? 0.1f : -0.9f) * r };
    const float right[2] = { x + r, y - 0.9f * r }, down[2] = { x - r, y + 0.9f * r };
    const float end[2] = { x + r, y + 0.9f * r };
    const struct ui_text asks = menu_style(view, 40.0f, ASK_PAINT);
    if (state == SELF_GOOD) {
        ui_segment(view->frame.batch, left, low, 6.0f * u, GOOD_PAINT);
        ui_segment(view->frame.batch, low, right, 6.0f * u, GOOD_PAINT);
    } else if (state == SELF_BAD) {
        ui_segment(view->frame.batch, left, end, 6.0f * u, BAD_PAINT);
        ui_segment(view->frame.batch, down, right, 6.0f * u, BAD_PAINT);
    } else {
        menu_words_at(view, x, y, 3.0f * r, 0.5f, &asks, "?");
    }
}

static void sheet(const struct menu_view *view, struct ui_box box, uint32_t edge)
{
    const float u = view->frame.unit;
    ui_shape(view->frame.batch,
             &(struct ui_shape){ .box = box, .kind = UI_WASHI, .fill = UI_WASHI_WHITE, .line = edge,
                                 .shape = { 0, 0, 10.0f * u, 2.0f * u } });
}

static void check(const struct menu_view *view, uint32_t index, uint8_t state)
{
    const int upright = view->menu->upright;
    const float u = view->frame.unit;
    const float width = upright ? 256.0f : 330.0f, height = upright ? 130.0f : 96.0f;
    const float x = (upright ? 27.0f : 125.0f) + (float)(index % COLUMNS) * (width + 16.0f);
    const float y = (upright ? 240.0f : 130.0f) + (float)(index / COLUMNS) * (height + 18.0f);
    const struct ui_box box = menu_place(view, (struct overlay_box){ x, y, width, height });
    const struct ui_text name = menu_style(view, 30.0f, UI_INK);
    sheet(view, box, paint_of(state));
    mark(view, box.x + 40.0f * u, box.y + 0.5f * box.height, state);
    menu_words_at(view, box.x + 76.0f * u, box.y + 0.5f * box.height, box.width - 92.0f * u, 0.0f,
                  &name, menu_text(view, checks[index].name));
}

static enum text_key verdict(uint32_t first, const uint8_t state[SELF_CHECKS])
{
    return first == SELF_CHECKS           ? TEXT_CHECK_READY
           : state[first] == SELF_BAD     ? checks[first].bad
           : state[first] == SELF_ASKS    ? checks[first].asks
                                          : TEXT_CHECK_WAITS;
}

void menu_self_test(const struct menu_view *view)
{
    uint8_t state[SELF_CHECKS];
    const uint32_t first = self_test_judge(view->scene, state);
    const int upright = view->menu->upright;
    const uint8_t kind = first < SELF_CHECKS ? state[first] : (uint8_t)SELF_GOOD;
    const struct ui_box box =
        menu_place(view, upright ? (struct overlay_box){ 27.0f, 760.0f, 800.0f, 120.0f }
                                 : (struct overlay_box){ 125.0f, 486.0f, 1022.0f, 96.0f });
    const struct ui_text words = menu_style(view, 36.0f, paint_of(kind));
    for (uint32_t i = 0; i < SELF_CHECKS; i++) {
        check(view, i, state[i]);
    }
    sheet(view, box, paint_of(kind));
    menu_words_at(view, box.x + 0.5f * box.width, box.y + 0.5f * box.height,
                  box.width - 40.0f * view->frame.unit, 0.5f, &words,
                  menu_text(view, verdict(first, state)));
}
