/* ui_widgets.c -- drawing functions that several screens share: plates, hints, small signs, credits
 * and warnings. */
#include "platform/render/ui/ui_widgets.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/game/accounting/accounts.h"

#define HINT_FADE_S 0.35f
/* Time in seconds for which the coin request is emphasized after a player tried to start without
 * credit. */
#define GLOW_S 1.2f

/* The colours equal the colours of the pois (paper scoops) in the tank (poi_paint()). */
const uint32_t ui_player_colours[POI_MAX] = { 0xf74c75ffu, 0x3385f2ffu, 0x40c25cffu, 0xfabd29ffu };

void ui_fish_sign(const struct ui_frame *frame, float x, float y, float width)
{
    const float height = 0.56f * width;
    ui_shape(frame->batch,
             &(struct ui_shape){ .box = { x - 0.5f * width, y - 0.5f * height, width, height },
                                 .kind = UI_FISH,
                                 .fill = 0xf2552effu,
                                 .line = 0xfff4e4ffu,
                                 .shape = { 0, 0, sinf(frame->time_s * 6.0f) } });
}

void ui_poi_sign(const struct ui_frame *frame, float x, float y, float radius, float paper_left,
                 uint32_t ring)
{
    CORE_ASSERT(radius > 0.0f);
    /* The box of the sign is larger than the ring because the poi's handle extends to the lower
     * right. */
    const struct ui_shape sign = { .box = ui_around(x, y, 1.5f * radius),
                                   .kind = UI_POI,
                                   .fill = ring,
                                   .shape = { radius, f_clamp(paper_left, 0.0f, 1.0f) } };
    ui_shape(frame->batch, &sign);
}

void ui_bow(const struct ui_frame *frame, float x, float y, float width)
{
    CORE_ASSERT(width > 0.0f);
    const float knot[2] = { x, y };
    for (uint32_t pass = 0; pass < 2u; pass++) { /* First the outline, then the ribbon. */
        const float edge = pass == 0 ? 0.06f * width : 0.0f;
        const uint32_t colour = pass == 0 ? UI_WASHI_WHITE : UI_VERMILION;
        for (uint32_t i = 0; i < 2u; i++) {
            const float side = i == 0 ? -1.0f : 1.0f;
            const float tail[2] = { x + 0.24f * side * width, y + 0.36f * width };
            ui_segment(frame->batch, knot, tail, 0.12f * width + edge, colour);
            ui_ring(frame, x + 0.26f * side * width, y - 0.05f * width, 0.20f * width + 0.5f * edge,
                    0.13f * width + edge, 1.0f, colour, colour);
        }
    }
    ui_disc(frame, x, y, 0.12f * width, 0.03f * width, 0xb3261effu, UI_WASHI_WHITE);
}

void ui_pointer(const struct ui_frame *canvas, float x, float y, bool presses, uint32_t ring)
{
    const float u = canvas->unit, radius = (presses ? 16.0f : 22.0f) * u;
    const float at_x = canvas->x + x * u, at_y = canvas->y + y * u;
    ui_glow(canvas, ui_around(at_x, at_y, 2.2f * radius), presses ? 0xff9a50a0u : 0xffffff38u);
    ui_poi_sign(canvas, at_x, at_y, radius, 0.0f, ring);
}

void ui_plate(const struct ui_frame *frame, struct ui_box box)
{
    const float u = frame->unit;
    ui_panel(frame, UI_WAVES, box, 16.0f * u, 1.5f * u, UI_NIGHT, UI_GOLD_DIM);
}

const char *ui_hint_words(const struct ui_frame *frame, uint8_t hint)
{
    static const uint16_t keys[HINT_COUNT] = {
        [HINT_START] = TEXT_HINT_START,         [HINT_DIP] = TEXT_HINT_DIP,
        [HINT_LIFT] = TEXT_HINT_LIFT,           [HINT_BOWL] = TEXT_HINT_BOWL,
        [HINT_TILT] = TEXT_HINT_TILT,           [HINT_SLOWLY] = TEXT_HINT_SLOWLY,
        [HINT_GLIDE] = TEXT_HINT_GLIDE,         [HINT_TORN] = TEXT_HINT_TORN,
        [HINT_LOST_POI] = TEXT_HINT_LOST_POI,   [HINT_WET_ALL] = TEXT_HINT_WET_ALL,
        [HINT_NO_SHADE] = TEXT_HINT_NO_SHADE,   [HINT_CLEAR_RIM] = TEXT_HINT_CLEAR_RIM,
        [HINT_CHOOSE] = TEXT_HINT_CHOOSE,       [HINT_COIN] = TEXT_HINT_COIN,
        [HINT_PAID_BACK] = TEXT_HINT_PAID_BACK,
    };
    CORE_ASSERT(hint != HINT_NONE && hint < HINT_COUNT);
    return ui_words(frame, (enum text_key)keys[hint]);
}

void ui_hint_ribbon(const struct ui_frame *frame)
{
    const struct scene *const scene = frame->scene;
    const uint8_t hint = scene->hint;
    if (hint == HINT_NONE || hint >= HINT_COUNT ||
        (hint == HINT_COIN && scene->credit.warnings != 0)) {
        return;
    }
    const float u = frame->unit;
    const float age_s = (float)(scene->tick - frame->memory->hint_tick) * CORE_TICK_S;
    const float in = f_smoothstep(0.0f, HINT_FADE_S, age_s);
    /* The ribbon of a hint about a failure is red, and the ribbon of advice is dark. */
    struct ui_ribbon ribbon = { FONT_BODY, UI_NIGHT, UI_GOLD_DIM, 0 };
    if (hint == HINT_LOST_POI) {
        ribbon.fill = 0xb8301ee8u;
        ribbon.line = UI_GOLD;
    }
    frame->batch->opacity = in;
    ui_ribbon(frame, ribbon, frame->height - 52.0f * u + 14.0f * u * (1.0f - in), 32.0f * u,
              ui_hint_words(frame, hint));
    frame->batch->opacity = 1.0f;
}

void ui_start_ribbon(const struct ui_frame *frame, float y, enum text_key key)
{
    const float u = frame->unit, pulse = ui_pulse(frame->time_s, 2.4f);
    const struct scene_credit *const credit = &frame->scene->credit;
    const bool lacks_poi = credit->warnings & WARN_NO_POI, is_coin = credit->unpaid && !lacks_poi;
    const bool waits_for_store =
        credit->coming > 0 && credit->credits == 0 && credit->warnings & WARN_STORE;
    if ((is_coin && credit->warnings != 0) || waits_for_store) {
        /* While a warning is active, the coin slot returns inserted coins. Therefore the screen
         * shows only the warning and no request for coins. Nor does the screen invite to start with
         * credits that a failing store cannot make playable. */
        return;
    }
    /* `glow` is the strength with which the request for coins is emphasized. `glow` is 1 when a
     * player tries to start without credit, and then decreases to 0. */
    const float glow = credit->unpaid ? 1.0f - f_smoothstep(0.0f, GLOW_S, credit->request_s) : 0.0f;
    const struct ui_box halo = { 0.5f * frame->width - 400.0f * u, y - 64.0f * u, 800.0f * u,
                                 128.0f * u };
    char coins[TEXT_LINE_MAX];
    const uint32_t worth = credit->coin_units > 0 ? credit->coin_units : 1u;
    const uint32_t missing = credit->price > credit->units ? credit->price - credit->units : 0u;
    text_number(coins, sizeof coins, ui_words(frame, TEXT_COIN), (missing + worth - 1u) / worth);
    ui_glow(frame, halo, ui_fade(0xff7a30b0u, fmaxf(0.25f + 0.55f * pulse, glow)));
    const uint32_t ink = ui_fade(0xfff8eaffu, 0.82f + 0.18f * pulse);
    ui_ribbon(frame, (struct ui_ribbon){ FONT_STALL, 0xc8341ff2u, UI_GOLD, ink }, y,
              (35.0f + 6.0f * glow) * u,
              is_coin ? coins : ui_words(frame, lacks_poi ? TEXT_START_NO_POI : key));
}

void ui_best_words(const struct scene *scene, char *out, size_t out_size)
{
    CORE_ASSERT(out_size > 0);
    const enum text_key key = scene->best_today > 0 ? TEXT_BEST_TODAY : TEXT_NO_BEST;
    text_number(out, out_size, text_words(scene->language, key), scene->best_today);
}

void ui_big_word(const struct ui_frame *frame, enum font_id font, float y, float size_px,
                 float alpha, const char *words)
{
    CORE_ASSERT(alpha >= 0.0f && alpha <= 1.0f);
    const struct ui_text text = { .font = font,
                                  .size_px = size_px,
                                  .weight_em = font == FONT_BRUSH ? 0.024f : 0.0f,
                                  .spacing_em = font == FONT_BRUSH ? -0.14f : 0.0f,
                                  .outline_em = 0.014f,
                                  .soft_em = 0.035f,
                                  .fill = 0xfff6e2ffu,
                                  .line = 0x9c1f14ffu };
    frame->batch->opacity = alpha;
    ui_words_at(frame, 0.5f * frame->width, y, frame->width - 48.0f * frame->unit, 0.5f, text,
                words);
    frame->batch->opacity = 1.0f;
}

/* Time in seconds for which the credit plate is enlarged after a coin was inserted. */
#define CLINK_S 0.5f
#define COMING_WIDTH 84.0f /* Width of the text "+99" with its margins, in layout units. */

/* Width in layout units that the plates occupy at each side of the screen during a round, and the
 * credits on the page of modes. The stress legend of ui_round.c is the widest plate. */
#define PLATES_WIDTH 284.0f
/* Lower edge in layout units of the plates at the sides of the screen during a round. The stress
 * legend of ui_round.c is the lowest plate. */
#define PLATES_REACH 240.0f

void ui_credits(const struct ui_frame *frame, float x, float y)
{
    const struct scene_credit *const credit = &frame->scene->credit;
    const float u = frame->unit, room_px = 2.0f * fminf(x, frame->width - x) - 8.0f * u;
    const float clink = 1.0f - f_smoothstep(0.0f, CLINK_S, credit->coin_s);
    char words[TEXT_LINE_MAX + 32u];
    if (credit->is_event) {
        ui_ribbon_at(frame, (struct ui_ribbon){ FONT_STALL, 0x8a2f6ee8u, UI_GOLD, 0 }, x, y,
                     25.0f * u, room_px, ui_words(frame, TEXT_EVENT));
    }
    if (credit->price == 0) {
        return;
    }
    text_number(words, TEXT_LINE_MAX, ui_words(frame, TEXT_CREDITS), credit->credits);
    if (credit->units > 0 && credit->units < credit->price) {
        /* Coins that do not pay for a whole round are kept for the next player. The text shows
         * their units and the price. */
        const size_t length = strlen(words);
        snprintf(words + length, sizeof words - length, "  +  %u/%u", credit->units, credit->price);
    }
    const bool has_credit = credit->credits > 0;
    const struct ui_ribbon plate = { FONT_STALL, has_credit ? 0x17754ee8u : UI_NIGHT,
                                     has_credit || clink > 0.0f ? UI_GOLD : UI_GOLD_DIM, 0 };
    const float width =
        ui_ribbon_at(frame, plate, x, y, (25.0f + 4.0f * clink) * u, room_px, words);
    /* A text with an outline beside the plate shows the number of credits that are not on disk
     * yet. */
    const float left = x + 0.5f * width + 10.0f * u, coming_px = COMING_WIDTH * u;
    if (credit->coming == 0 || frame->width - left - 8.0f * u < coming_px) {
        return;
    }
    snprintf(words, sizeof words, "+%u", credit->coming);
    const uint32_t line = ui_fade(UI_GOLD, 0.55f + 0.45f * ui_pulse(frame->time_s, 1.2f));
    ui_ribbon_at(frame, (struct ui_ribbon){ FONT_STALL, 0, line, ui_fade(0xfff8eaffu, 0.7f) },
                 left + 0.5f * coming_px, y, 21.0f * u, coming_px, words);
}

void ui_warnings(const struct ui_frame *frame)
{
    const struct scene *const scene = frame->scene;
    const uint32_t active = scene->credit.warnings;
    const bool in_round = scene->phase == PHASE_ROUND || scene->phase == PHASE_READY;
    const struct {
        bool is_shown;
        enum text_key key;
    } warnings[] = {
        { scene->is_confirming_quit, TEXT_QUIT_ASK },
        { scene->is_confirming_menu, TEXT_MENU_ASK },
        { active & WARN_TILT, TEXT_WARN_TILT },
        { active & WARN_DOOR, TEXT_WARN_DOOR },
        /* The warning about a missing controller is omitted during a round, because the pause sign
         * already shows the same text in larger letters. */
        { (active & WARN_NO_POI) && !in_round, TEXT_WARN_NO_POI },
        { active & WARN_STORE, TEXT_WARN_STORE },
    };
    /* The warnings are below the shop curtain in attract mode (the demonstration between rounds),
     * and below the plates during a round. On a page they cover the title, which a visitor needs
     * least. */
    const bool is_page = scene->phase == PHASE_NAME || scene->phase == PHASE_MODE_SELECT ||
                         scene->phase == PHASE_RESULT;
    float y = (scene->phase == PHASE_ATTRACT ? 0.335f : is_page ? 0.06f : 0.215f) * frame->height;
    const bool has_plates = in_round || scene->phase == PHASE_MODE_SELECT;
    const float beside = has_plates && y < PLATES_REACH * frame->unit ? PLATES_WIDTH : 16.0f;
    const float room_px = frame->width - 2.0f * beside * frame->unit;
    for (uint32_t i = 0; i < sizeof warnings / sizeof *warnings; i++) {
        if (warnings[i].is_shown) {
            ui_ribbon_at(frame, (struct ui_ribbon){ FONT_BODY, 0xb8301ee8u, UI_GOLD, 0 },
                         0.5f * frame->width, y, 27.0f * frame->unit, room_px,
                         ui_words(frame, warnings[i].key));
            y += 58.0f * frame->unit;
        }
    }
}
