/* ui_attract.c -- draws the screens before a round: attract mode (the demonstration between
 * rounds), the mode selection with wooden tags that hang side by side from a pole, and the
 * countdown. */
#include <math.h>
#include <stdio.h>

#include "core/base/panic.h"
#include "core/game/game.h"
#include "platform/render/ui/ui_widgets.h"

void ui_attract(const struct ui_frame *frame, const struct scene *scene)
{
    const float u = frame->unit, board = ui_leaderboard_in(&scene->leaderboard);
    const float risen = fmaxf(1.0f - ui_smooth(0.0f, 0.8f, scene->phase_s), board);
    if (risen < 1.0f) {
        ui_noren(frame, risen);
    }
    if (board > 0.0f) {
        /* The curtain is raised to leave room for the leaderboard, and the credits move to the
         * side. */
        ui_leaderboard(frame, &scene->leaderboard, 16.0f * u, frame->height - 160.0f * u);
        ui_credits(frame, scene, 128.0f * u, 62.0f * u);
    } else {
        char words[TEXT_LINE_MAX];
        ui_best_words(scene, words, sizeof words);
        const struct ui_ribbon tag = {
            .y = frame->height - 174.0f * u,
            .size_px = 24.0f * frame->unit,
            .font = FONT_STALL,
            .fill = UI_NIGHT,
            .ink = UI_GOLD,
        };
        ui_ribbon(frame, &tag, words);
        ui_credits(frame, scene, 0.5f * frame->width, frame->height - 230.0f * u);
    }
    ui_start_ribbon(frame, scene, frame->height - 108.0f * u, TEXT_START);
    /* The line about the mouse is omitted if no poi (paper scoop) is present. */
    const struct ui_text text = { .font = FONT_BODY,
                                  .size_px = 17.0f * u,
                                  .align = 0.5f,
                                  .outline_em = 0.05f,
                                  .soft_em = 0.12f,
                                  .fill = 0xe9dcc6ffu,
                                  .line = 0x0a0814d0u,
                                  .fit_px = frame->width - 32.0f * u };
    const float x = 0.5f * frame->width;
    if (!ui_lacks_poi(scene)) {
        ui_text(frame->batch, &text, x, frame->height - 41.0f * u, ui_words(frame, TEXT_MOUSE));
    }
    ui_text(frame->batch, &text, x, frame->height - 15.0f * u, ui_words(frame, TEXT_KEYS));
}

/* Draws the start of a round. The curtain rises, then a ring over the water counts down three
 * seconds. */
void ui_ready(const struct ui_frame *frame, const struct scene *scene,
              const struct ui_memory *memory)
{
    const float u = frame->unit, x = 0.5f * frame->width, y = 0.42f * frame->height;
    const float whole = ceilf(scene->seconds_left), radius = 128.0f * u;
    const float gone = whole - scene->seconds_left; /* `gone` is the fraction of the current second
                                                       that has elapsed, [0, 1]. */
    const float in = ui_smooth(0.15f, 0.5f, scene->phase_s);
    ui_noren(frame, ui_smooth(0.0f, 0.6f, scene->phase_s));
    frame->batch->opacity = in;
    const struct ui_box shade = { x - 1.8f * radius, y - 1.8f * radius, 3.6f * radius,
                                  3.6f * radius };
    ui_shape(frame->batch,
             &(struct ui_shape){ .box = shade, .kind = UI_GLOW, .fill = 0x080c24d8u });
    const struct ui_box ring = { x - radius, y - radius, 2.0f * radius, 2.0f * radius };
    ui_shape(frame->batch, &(struct ui_shape){ .box = ring,
                                               .kind = UI_RING,
                                               .fill = UI_VERMILION,
                                               .line = 0xffffff26u,
                                               .shape = { radius, 9.0f * u, 1.0f - gone } });
    const struct ui_text word = { .font = FONT_STALL,
                                  .size_px = 46.0f * u,
                                  .align = 0.5f,
                                  .outline_em = 0.03f,
                                  .soft_em = 0.1f,
                                  .fill = 0xfff6e2ffu,
                                  .line = 0x0a0c24e0u };
    ui_text(frame->batch, &word, x, y + radius + 62.0f * u, ui_words(frame, TEXT_READY));
    frame->batch->opacity = 1.0f;
    if (whole >= 1.0f) {
        const char digit[2] = { (char)('0' + (int)fminf(whole, 9.0f)), 0 };
        const float pop = 1.0f + 0.35f * (1.0f - ui_smooth(0.0f, 0.25f, gone));
        ui_big_word(frame, FONT_STALL, y, 190.0f * u * pop,
                    in * (1.0f - ui_smooth(0.82f, 1.0f, gone)), digit);
    }
    /* A tag shows the mode and the paper grade of the next round. */
    char paper[TEXT_LINE_MAX], words[2u * TEXT_LINE_MAX];
    text_number(paper, sizeof paper, ui_words(frame, TEXT_PAPER), scene->grade);
    snprintf(words, sizeof words, "%s  %s", ui_mode_name(frame->language, scene->mode), paper);
    const struct ui_ribbon tag = {
        .y = y - radius - 50.0f * u,
        .size_px = 29.0f * frame->unit,
        .font = FONT_STALL,
        .fill = UI_NIGHT,
        .line = UI_GOLD_DIM,
        .ink = UI_GOLD,
    };
    frame->batch->opacity = in;
    ui_ribbon(frame, &tag, words);
    frame->batch->opacity = 1.0f;
    ui_bowl_marks(frame, scene, in);
    ui_umpire(frame, scene);
    if (!scene->paused) {
        ui_hint_ribbon(frame, scene, memory);
    }
}

#define SECONDS_SHOWN 99.0f
#define RAISE_S 0.16f

struct tag {
    enum text_key name, ends;
};

static const struct tag tags[CHOICE_COUNT] = {
    [MODE_FESTIVAL] = { TEXT_FESTIVAL, TEXT_FESTIVAL_ENDS },
    [MODE_CHAMPIONSHIP] = { TEXT_CHAMPIONSHIP, TEXT_CHAMPIONSHIP_ENDS },
    [MODE_PRACTICE] = { TEXT_PRACTICE, TEXT_PRACTICE_ENDS },
    [CHOICE_LAB] = { TEXT_LAB, TEXT_LAB_ENDS },
};

const char *ui_mode_name(uint8_t language, uint8_t mode)
{
    return text_words(language, tags[mode < CHOICE_COUNT ? mode : MODE_FESTIVAL].name);
}

static void tag_words(const struct ui_frame *frame, const struct scene *scene, uint8_t mode,
                      struct ui_box box)
{
    CORE_ASSERT(mode < CHOICE_COUNT);
    const float u = frame->unit, x = box.x + 0.5f * box.width, room = box.width - 28.0f * u;
    const int brush = frame->language == LANGUAGE_JA;
    const struct ui_text name = { .font = brush ? FONT_BRUSH : FONT_STALL,
                                  .align = 0.5f,
                                  .size_px = (brush ? 88.0f : 46.0f) * u,
                                  .weight_em = brush ? 0.022f : 0.0f,
                                  .spacing_em = brush ? -0.08f : 0.0f,
                                  .fill = UI_INK,
                                  .fit_px = room };
    const struct ui_text line = ui_style(frame, FONT_BODY, 26.0f, 0.5f, 0x3a2418ffu, room);
    char words[TEXT_LINE_MAX];
    ui_text_at(frame, &name, x, box.y + 84.0f * u, ui_mode_name(frame->language, mode));
    const struct ui_box rule = { box.x + 34.0f * u, box.y + 148.0f * u, box.width - 68.0f * u,
                                 2.5f * u };
    ui_panel(frame, UI_PANEL, rule, 1.2f * u, 0.0f, 0x5a3a20a0u, 0);
    if (mode == CHOICE_LAB) {
        ui_text(frame->batch, &line, x, box.y + 188.0f * u, ui_words(frame, TEXT_LAB_SHAPES));
        ui_text(frame->batch, &line, x, box.y + 228.0f * u, ui_words(frame, TEXT_LAB_GRAPH));
    } else {
        /* The duration is written as a text such as "3 minutes" or "90 seconds". Minutes are used
         * only if the duration is a whole number of at least two minutes. */
        const uint32_t seconds = scene->offer[mode].round_s;
        const int even = seconds >= 120u && seconds % 60u == 0;
        text_number(words, sizeof words,
                    text_words(frame->language, even ? TEXT_MINUTES : TEXT_SECONDS),
                    even ? seconds / 60u : seconds);
        ui_text(frame->batch, &line, x, box.y + 188.0f * u, words);
        text_number(words, sizeof words, ui_words(frame, TEXT_PAPER), scene->offer[mode].grade);
        ui_text(frame->batch, &line, x, box.y + 228.0f * u, words);
    }
    ui_text(frame->batch, &line, x, box.y + 268.0f * u, ui_words(frame, tags[mode].ends));
}

/* Draws the time that remains for the selection as a ring. */
static void seconds_ring(const struct ui_frame *frame, const struct scene *scene, float x, float y)
{
    const float u = frame->unit, radius = 36.0f * u;
    const float left = fminf(fmaxf(scene->seconds_left, 0.0f), SECONDS_SHOWN);
    const struct ui_box box = { x - radius, y - radius, 2.0f * radius, 2.0f * radius };
    char number[12];
    text_number(number, sizeof number, "{}", (uint32_t)ceilf(left));
    ui_panel(frame, UI_PANEL, box, radius, 0.0f, UI_NIGHT, 0);
    const float part = ui_clamp01(left / ((float)GAME_MODE_SELECT_TICKS * CORE_TICK_S));
    ui_shape(frame->batch, &(struct ui_shape){ .box = box,
                                               .kind = UI_RING,
                                               .fill = UI_GOLD,
                                               .line = 0xffffff28u,
                                               .shape = { radius, 6.0f * u, part } });
    const struct ui_text digits = ui_style(frame, FONT_STALL, 34.0f, 0.5f, 0xfff8eaffu, 52.0f * u);
    ui_text_at(frame, &digits, x, y, number);
}

static void draw_attract_foot(const struct ui_frame *frame, const struct scene *scene)
{
    const float u = frame->unit;
    char words[TEXT_LINE_MAX];
    ui_best_words(scene, words, sizeof words);
    const struct ui_ribbon best = { .y = frame->height - 128.0f * u,
                                    .size_px = 25.0f * u,
                                    .font = FONT_STALL,
                                    .fill = UI_NIGHT,
                                    .ink = UI_GOLD };
    if (scene->choice != CHOICE_LAB && rules_of(scene->mode)->keeps_score) {
        ui_ribbon(frame, &best, words);
    }
    const struct ui_ribbon keys = { .y = frame->height - 58.0f * u,
                                    .size_px = 29.0f * u,
                                    .font = FONT_BODY,
                                    .fill = 0xc8341ff2u,
                                    .line = UI_GOLD };
    ui_ribbon(frame, &keys,
              ui_words(frame, ui_lacks_poi(scene) ? TEXT_START_NO_POI : TEXT_CHOOSE_KEYS));
}

void ui_choose(const struct ui_frame *frame, const struct scene *scene,
               const struct ui_memory *memory)
{
    const float u = frame->unit, in = ui_smooth(0.0f, 0.35f, scene->phase_s);
    uint32_t count = 0;
    for (uint8_t mode = 0; mode < CHOICE_COUNT; mode++) {
        count += scene->modes >> mode & 1u;
    }
    const float tags_max = fmaxf((float)count, 3.0f); /* If there are only two tags, each tag is as
                                                         wide as in a row of three tags. Otherwise
                                                         the two tags would be too broad. */
    const float gap = (count > 3u ? 14.0f : 24.0f) * u, height = 300.0f * u;
    const float room = frame->width - (count > 3u ? 36.0f : 60.0f) * u;
    const float width = fminf(316.0f * u, (room - (tags_max - 1.0f) * gap) / tags_max);
    const float row = (float)count * width + (float)(count - 1u) * gap;
    const float middle = 0.5f * (frame->height - 40.0f * u);
    const float pole_y = middle - 0.5f * height - 44.0f * u - 60.0f * u * (1.0f - in);
    const struct ui_text title = { .font = FONT_STALL,
                                   .size_px = 46.0f * u,
                                   .align = 0.5f,
                                   .outline_em = 0.03f,
                                   .soft_em = 0.1f,
                                   .fill = 0xfff6e2ffu,
                                   .line = 0x0a0c24e0u,
                                   .fit_px = frame->width - 220.0f * u };
    frame->batch->opacity = in;
    const struct ui_box veil = { 0.0f, 0.0f, frame->width, frame->height };
    ui_panel(frame, UI_PANEL, veil, 0.0f, 0.0f, 0x080a2078u, 0);
    ui_text_at(frame, &title, 0.5f * frame->width, fmaxf(pole_y - 64.0f * u, 40.0f * u),
               ui_words(frame, TEXT_CHOOSE));
    ui_pole(frame, 0.5f * frame->width, pole_y, fminf(row + 56.0f * u, frame->width));
    struct ui_box box = { 0.5f * (frame->width - row), middle - 0.5f * height, width, height };
    for (uint8_t mode = 0; mode < CHOICE_COUNT; mode++) {
        if ((scene->modes >> mode & 1u) == 0) {
            continue;
        }
        struct ui_box hung = box;
        /* When the selection changes, the selected tag rises and the previously selected tag
         * sinks. */
        const float age_s = (float)(scene->tick - memory->pointed_tick) * CORE_TICK_S;
        const float moved = ui_smooth(0.0f, RAISE_S, age_s);
        const float raised = mode == scene->choice            ? moved
                             : mode == memory->pointed_before ? 1.0f - moved
                                                              : 0.0f;
        hung.y += (22.0f - 32.0f * raised) * u - 60.0f * u * (1.0f - in);
        ui_cords(frame, hung, pole_y);
        ui_wooden_tag(frame, hung, mode == scene->choice);
        tag_words(frame, scene, mode, hung);
        box.x += width + gap;
    }
    draw_attract_foot(frame, scene);
    seconds_ring(frame, scene, frame->width - 66.0f * u, 62.0f * u);
    ui_credits(frame, scene, 128.0f * u, 62.0f * u);
    frame->batch->opacity = 1.0f;
}
