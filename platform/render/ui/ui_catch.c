/* ui_catch.c -- draws the animations of a catch: paper tags that fly from the bowl to the counter
 * (the displayed number of caught fish), and the word over a poi that narrowly missed a fish. */
#include <math.h>

#include "core/base/panic.h"
#include "platform/render/ui/ui_widgets.h"

/* Duration in ticks of a tag's flight from the bowl to the counter, and delay in ticks between the
 * flights of the tags of two fish that were poured into the bowl together. */
#define FLIGHT_TICKS (CORE_TICK_HZ / 2u)
#define FLIGHT_APART_TICKS (CORE_TICK_HZ / 8u)
#define FLIGHT_RISE 130.0f /* Height of the flight's arc in layout units. */
/* Widths in layout units of a tag at the start of its flight and at its end. */
#define FLIGHT_WIDTH 92.0f
#define FLIGHT_WIDTH_END 52.0f
/* Shape of a tag, as factors of its width: height, radius of the corners, width of the border, and
 * size of the text. */
#define TAG_HEIGHT 0.66f
#define TAG_CORNER 0.10f
#define TAG_BORDER 0.06f
#define TAG_TEXT 0.52f
/* Time in seconds for which the number of caught fish is enlarged after a tag has arrived. */
#define POP_S 0.45f

/* Time in seconds for which the word for a near miss is shown, and the distance in layout units
 * that it rises in this time. */
#define MISS_S 1.4f
#define MISS_RISE 34.0f
#define MISS_OVER 64.0f /* Distance in layout units from the poi up to the word. */

/* Returns the number of ticks since the flight of a player's fish number `number` began. A negative
 * result means that the flight begins later. */
static int32_t flight_age(const struct ui_memory *memory, uint32_t tick, uint32_t player,
                          uint32_t number)
{
    CORE_ASSERT(player < POI_MAX);
    return (int32_t)(tick - memory->flight_tick[player][number % UI_FLIGHT_MAX]);
}

/* Returns the smaller of `caught` and UI_FLIGHT_MAX. The memory stores the start of the flight for
 * at most UI_FLIGHT_MAX fish of a player, the newest ones. */
static uint32_t flight_count(uint32_t caught)
{
    return caught < UI_FLIGHT_MAX ? caught : UI_FLIGHT_MAX;
}

void ui_catch_notice(struct ui_memory *memory, const struct scene *scene)
{
    const bool is_round = scene->phase == PHASE_ROUND && memory->phase == PHASE_ROUND;
    const bool continues = scene->tick >= memory->tick;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const uint32_t caught = scene->caught[i], before = memory->caught[i];
        if (is_round && continues && caught > before) {
            for (uint32_t k = flight_count(caught - before); k > 0; k--) {
                const uint32_t waits = flight_count(caught - before) - k;
                const uint32_t slot = (caught - k + 1u) % UI_FLIGHT_MAX;
                memory->flight_tick[i][slot] = scene->tick + waits * FLIGHT_APART_TICKS;
            }
        } else if (caught != before || !continues) {
            /* Outside a continuing round, all caught fish count as arrived, and no tag flies. */
            for (uint32_t k = 0; k < UI_FLIGHT_MAX; k++) {
                memory->flight_tick[i][k] = scene->tick - FLIGHT_TICKS;
            }
        }
        memory->caught[i] = caught;
    }
}

uint32_t ui_catch_shown(const struct ui_frame *frame, uint32_t player)
{
    const uint32_t caught = frame->scene->caught[player];
    uint32_t flying = 0;
    for (uint32_t k = 0; k < flight_count(caught); k++) {
        flying += flight_age(frame->memory, frame->scene->tick, player, caught - k) <
                  (int32_t)FLIGHT_TICKS;
    }
    return caught - flying;
}

float ui_catch_pop(const struct ui_frame *frame, uint32_t player)
{
    const uint32_t caught = frame->scene->caught[player];
    float pop = 0.0f;
    for (uint32_t k = 0; k < flight_count(caught); k++) {
        const int32_t age = flight_age(frame->memory, frame->scene->tick, player, caught - k) -
                            (int32_t)FLIGHT_TICKS;
        if (age >= 0) {
            pop = fmaxf(pop, 1.0f - f_smoothstep(0.0f, POP_S, (float)age * CORE_TICK_S));
        }
    }
    return pop;
}

/* Draws a paper tag with "+1" and a border of the player's colour, centred at (x, y). */
static void draw_tag(const struct ui_frame *frame, uint32_t player, float x, float y, float width)
{
    const float height = TAG_HEIGHT * width;
    const struct ui_box box = { x - 0.5f * width, y - 0.5f * height, width, height };
    CORE_ASSERT(player < POI_MAX);
    ui_panel(frame, UI_WASHI, box, TAG_CORNER * width, TAG_BORDER * width, UI_WASHI_WHITE,
             ui_player_colours[player]);
    const float size = TAG_TEXT * width / frame->unit;
    ui_text_at(frame, ui_style(frame, FONT_STALL, size, 0.5f, UI_INK, 0.0f), x, y, "+1");
}

void ui_catch_flights(const struct ui_frame *frame, uint32_t player, struct ui_point counter)
{
    const uint32_t caught = frame->scene->caught[player];
    for (uint32_t k = 0; k < flight_count(caught); k++) {
        const int32_t age = flight_age(frame->memory, frame->scene->tick, player, caught - k);
        const float part = (float)age / (float)FLIGHT_TICKS;
        if (part < 0.0f || part >= 1.0f) {
            continue;
        }
        const struct ui_point from = ui_project(frame, frame->scene->bowl[player].position_m);
        const float along = f_smoothstep(0.0f, 1.0f, part);
        const float rise = 4.0f * FLIGHT_RISE * along * (1.0f - along) * frame->unit;
        const float width = f_lerp(FLIGHT_WIDTH, FLIGHT_WIDTH_END, along) * frame->unit;
        const float at_x = f_lerp(from.x, counter.x, along);
        const float at_y = fmaxf(f_lerp(from.y, counter.y, along) - rise, 0.5f * width);
        draw_tag(frame, player, at_x, at_y, width);
    }
}

bool ui_shows_near_miss(const struct scene *scene, uint32_t player)
{
    const float miss_s = scene->player[player].miss_s;
    CORE_ASSERT(player < POI_MAX);
    return miss_s > 0.0f && miss_s < MISS_S && scene->poi[player].present;
}

void ui_near_misses(const struct ui_frame *frame)
{
    const bool is_brush = frame->language == LANGUAGE_JA;
    const char *const words = ui_words(frame, TEXT_CALL_NEAR_MISS);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const float miss_s = frame->scene->player[i].miss_s;
        if (!ui_shows_near_miss(frame->scene, i)) {
            continue;
        }
        const float u = frame->unit;
        const struct ui_point poi = ui_project(frame, frame->scene->poi[i].position_m);
        struct ui_text style = ui_style(frame, is_brush ? FONT_BRUSH : FONT_STALL,
                                        is_brush ? 104.0f : 74.0f, 0.5f, 0xfff8eaffu, 0.0f);
        style = ui_outlined(style, 0.03f, 0.1f, UI_WORD_SHADE);
        style.weight_em = 0.02f; /* The strokes stay readable over bright fish. */
        const float half = 0.5f * ui_text_width(style, words) + 12.0f * u;
        const float rise = MISS_OVER + MISS_RISE * f_smoothstep(0.0f, MISS_S, miss_s);
        frame->batch->opacity =
            f_smoothstep(0.0f, 0.1f, miss_s) * (1.0f - f_smoothstep(MISS_S - 0.4f, MISS_S, miss_s));
        ui_text_at(frame, style, fminf(fmaxf(poi.x, half), frame->width - half),
                   fminf(fmaxf(poi.y - rise * u, 150.0f * u), frame->height - 130.0f * u), words);
    }
    frame->batch->opacity = 1.0f;
}
