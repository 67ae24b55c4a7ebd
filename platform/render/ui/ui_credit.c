/* ui_credit.c -- draws the credits, the remaining price, and the warnings about the cabinet. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/game/accounting/credit.h"
#include "platform/render/ui/ui_widgets.h"

/* Time in seconds for which the credit plate is enlarged after a coin was inserted. */
#define CLINK_S 0.5f
#define COMING_WIDTH 84.0f /* Width of the text "+99" with its margins, in layout units. */
/* Time in seconds for which the coin request is emphasized after a player tried to start without
 * credit. */
#define ASK_S 1.2f

/* Width and lower edge, in layout units, of the plates at the sides of the screen during a round.
 * The stress legend of ui_round.c is the widest and the lowest plate. */
#define PLATES_WIDTH 284.0f
#define PLATES_REACH 240.0f

static void credit_words(const struct ui_frame *frame, const struct scene_credit *credit, char *out,
                         size_t out_size)
{
    text_number(out, TEXT_LINE_MAX, text_words(frame->language, TEXT_CREDITS), credit->credits);
    if (credit->units > 0 && credit->units < credit->price) {
        /* A credit that does not pay for a whole round is kept and shown to the next player. */
        const size_t length = strlen(out);
        snprintf(out + length, out_size - length, "  +  %u/%u", credit->units, credit->price);
    }
}

/* Draws the number of credits that are not on disk yet, as an outlined text beside the plate.
 * `left` is the left edge of the text in pixels. */
static void coming(const struct ui_frame *frame, const struct scene_credit *credit, float left,
                   float y)
{
    const float u = frame->unit, room = frame->width - left - 8.0f * u;
    char words[16];
    if (credit->coming == 0 || room < COMING_WIDTH * u) {
        return;
    }
    snprintf(words, sizeof words, "+%u", credit->coming);
    const struct ui_ribbon outline = {
        .x = left + 0.5f * COMING_WIDTH * u,
        .y = y,
        .size_px = 21.0f * u,
        .font = FONT_STALL,
        .line = ui_fade(UI_GOLD, 0.55f + 0.45f * ui_pulse(frame->time_s, 1.2f)),
        .ink = ui_fade(0xfff8eaffu, 0.7f),
        .room_px = COMING_WIDTH * u,
    };
    ui_ribbon(frame, &outline, words);
}

static void event_plate(const struct ui_frame *frame, float x, float y)
{
    const struct ui_ribbon plate = {
        .x = x,
        .y = y,
        .size_px = 25.0f * frame->unit,
        .font = FONT_STALL,
        .fill = 0x8a2f6ee8u,
        .line = UI_GOLD,
        .ink = 0xfff8eaffu,
        .room_px = 2.0f * fminf(x, frame->width - x) - 8.0f * frame->unit,
    };
    ui_ribbon(frame, &plate, text_words(frame->language, TEXT_EVENT));
}

void ui_credits(const struct ui_frame *frame, const struct scene *scene, float x, float y)
{
    const struct scene_credit *credit = &scene->credit;
    const float u = frame->unit;
    const float clink = 1.0f - ui_smooth(0.0f, CLINK_S, credit->coin_s);
    char words[TEXT_LINE_MAX + 32u];
    if (credit->is_event) {
        event_plate(frame, x, y);
    }
    if (credit->price == 0) {
        return;
    }
    credit_words(frame, credit, words, sizeof words);
    const struct ui_ribbon plate = {
        .x = x,
        .y = y,
        .size_px = (25.0f + 4.0f * clink) * u,
        .font = FONT_STALL,
        .fill = credit->credits > 0 ? 0x17754ee8u : UI_NIGHT,
        .line = credit->credits > 0 || clink > 0.0f ? UI_GOLD : UI_GOLD_DIM,
        .ink = 0xfff8eaffu,
        .room_px = 2.0f * fminf(x, frame->width - x) - 8.0f * u,
    };
    const float width = ui_ribbon(frame, &plate, words);
    coming(frame, credit, x + 0.5f * width + 10.0f * u, y);
}

int ui_lacks_poi(const struct scene *scene)
{
    return (scene->credit.warnings & WARN_NO_POI) != 0;
}

int ui_refuses_coins(const struct scene *scene)
{
    return scene->credit.unpaid && scene->credit.warnings != 0 && !ui_lacks_poi(scene);
}

float ui_credit_prompt(const struct scene *scene)
{
    return scene->credit.unpaid ? 1.0f - ui_smooth(0.0f, ASK_S, scene->credit.asked_s) : 0.0f;
}

void ui_coin_words(const struct scene *scene, char *out, size_t out_size)
{
    const struct scene_credit *credit = &scene->credit;
    const uint32_t worth = credit->coin_units > 0 ? credit->coin_units : 1u;
    const uint32_t missing = credit->price > credit->units ? credit->price - credit->units : 0u;
    text_number(out, out_size, text_words(scene->language, TEXT_COIN),
                (missing + worth - 1u) / worth);
}

static void warning(const struct ui_frame *frame, float y, float room_px, enum text_key key)
{
    const float u = frame->unit;
    const struct ui_ribbon ribbon = { .x = 0.5f * frame->width,
                                      .y = y,
                                      .size_px = 27.0f * u,
                                      .font = FONT_BODY,
                                      .fill = 0xb8301ee8u,
                                      .line = UI_GOLD,
                                      .ink = 0xfff8eaffu,
                                      .room_px = room_px };
    ui_ribbon(frame, &ribbon, text_words(frame->language, key));
}

void ui_warnings(const struct ui_frame *frame, const struct scene *scene)
{
    static const enum text_key keys[] = { TEXT_WARN_TILT, TEXT_WARN_DOOR, TEXT_WARN_NO_POI,
                                          TEXT_WARN_STORE };
    const int in_round = scene->phase == PHASE_ROUND || scene->phase == PHASE_READY;
    uint32_t shown = scene->credit.warnings;
    /* The warnings are below the curtain in attract mode, and below the plates during a round. */
    float y = (scene->phase == PHASE_ATTRACT ? 0.335f : 0.215f) * frame->height;
    const float beside = in_round && y < PLATES_REACH * frame->unit ? PLATES_WIDTH : 16.0f;
    const float room_px = frame->width - 2.0f * beside * frame->unit;
    if (scene->asks_quit) {
        warning(frame, y, room_px, TEXT_QUIT_ASK);
        y += 58.0f * frame->unit;
    }
    if (scene->asks_menu) {
        warning(frame, y, room_px, TEXT_MENU_ASK);
        y += 58.0f * frame->unit;
    }
    if (in_round) {
        shown &= ~(uint32_t)WARN_NO_POI; /* During a round, the pause sign shows the warning
                                            WARN_NO_POI in larger letters. */
    }
    for (uint32_t i = 0; i < sizeof keys / sizeof keys[0]; i++) {
        if (shown >> i & 1u) {
            warning(frame, y, room_px, keys[i]);
            y += 58.0f * frame->unit;
        }
    }
}
