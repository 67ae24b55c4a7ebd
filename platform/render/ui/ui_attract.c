/* ui_attract.c -- draws the screens before a round: attract mode (the demonstration between
 * rounds), the mode selection with wooden tags that hang side by side from a pole, and the
 * countdown. */
#include <math.h>
#include <stdio.h>

#include "core/base/panic.h"
#include "core/game/accounting/accounts.h"
#include "core/game/rules.h"
#include "platform/render/ui/ui_widgets.h"

#define SHADE 0x0a0c24e0u /* Colour of the shadow around large words. */

/* Draws a ribbon with the best score of the day. */
static void best_ribbon(const struct ui_frame *frame, float y, float size_px)
{
    char words[TEXT_LINE_MAX];
    ui_best_words(frame->scene, words, sizeof words);
    ui_ribbon(frame, (struct ui_ribbon){ FONT_STALL, UI_NIGHT, 0, UI_GOLD }, y, size_px, words);
}

void ui_attract(const struct ui_frame *frame)
{
    const struct scene *const scene = frame->scene;
    const float u = frame->unit, board = ui_leaderboard_in(&scene->leaderboard);
    const float risen = fmaxf(1.0f - f_smoothstep(0.0f, 0.8f, scene->phase_s), board);
    if (risen < 1.0f) {
        ui_noren(frame, risen);
    }
    if (board > 0.0f) {
        /* The curtain is raised to leave room for the leaderboard, and the credits move to the
         * side. */
        ui_leaderboard(frame, 16.0f * u, frame->height - 160.0f * u);
        ui_credits(frame, 128.0f * u, 62.0f * u);
    } else {
        best_ribbon(frame, frame->height - 174.0f * u, 24.0f * u);
        ui_credits(frame, 0.5f * frame->width, frame->height - 230.0f * u);
    }
    ui_start_ribbon(frame, frame->height - 108.0f * u, TEXT_START);
    /* The line about the mouse is omitted if no poi (paper scoop) is present. */
    const struct ui_text text =
        ui_outlined(ui_style(frame, FONT_BODY, 17.0f, 0.5f, 0xe9dcc6ffu, frame->width - 32.0f * u),
                    0.05f, 0.12f, 0x0a0814d0u);
    const float x = 0.5f * frame->width;
    if (!(scene->credit.warnings & WARN_NO_POI)) {
        ui_text(frame->batch, text, x, frame->height - 41.0f * u, ui_words(frame, TEXT_MOUSE));
    }
    ui_text(frame->batch, text, x, frame->height - 15.0f * u, ui_words(frame, TEXT_KEYS));
}

/* Draws the start of a round. The curtain rises, then a ring over the water counts down three
 * seconds. */
void ui_ready(const struct ui_frame *frame)
{
    const struct scene *const scene = frame->scene;
    const float u = frame->unit, x = 0.5f * frame->width, y = 0.42f * frame->height;
    const float whole = ceilf(scene->seconds_left), radius = 128.0f * u;
    const float gone = whole - scene->seconds_left; /* `gone` is the fraction of the current second
                                                       that has elapsed, [0, 1]. */
    const float in = f_smoothstep(0.15f, 0.5f, scene->phase_s);
    ui_noren(frame, f_smoothstep(0.0f, 0.6f, scene->phase_s));
    frame->batch->opacity = in;
    ui_shape(frame->batch, &(struct ui_shape){ .box = ui_around(x, y, 1.8f * radius),
                                               .kind = UI_GLOW,
                                               .fill = 0x080c24d8u });
    ui_ring(frame, x, y, radius, 9.0f * u, 1.0f - gone, UI_VERMILION, 0xffffff26u);
    const struct ui_text word = ui_style(frame, FONT_STALL, 46.0f, 0.5f, UI_CREAM, 0.0f);
    ui_text(frame->batch, ui_outlined(word, 0.03f, 0.1f, SHADE), x, y + radius + 62.0f * u,
            ui_words(frame, TEXT_READY));
    frame->batch->opacity = 1.0f;
    if (whole >= 1.0f) {
        const char digit[2] = { (char)('0' + (int)fminf(whole, 9.0f)), 0 };
        const float pop = 1.0f + 0.35f * (1.0f - f_smoothstep(0.0f, 0.25f, gone));
        ui_big_word(frame, FONT_STALL, y, 190.0f * u * pop,
                    in * (1.0f - f_smoothstep(0.82f, 1.0f, gone)), digit);
    }
    /* A tag shows the mode and the paper grade of the next round. */
    char paper[TEXT_LINE_MAX], words[2u * TEXT_LINE_MAX];
    text_number(paper, sizeof paper, ui_words(frame, TEXT_PAPER), scene->grade);
    snprintf(words, sizeof words, "%s  %s", ui_mode_name(frame->language, scene->mode), paper);
    frame->batch->opacity = in;
    ui_ribbon(frame, (struct ui_ribbon){ FONT_STALL, UI_NIGHT, UI_GOLD_DIM, UI_GOLD },
              y - radius - 50.0f * u, 29.0f * u, words);
    frame->batch->opacity = 1.0f;
    ui_bowl_marks(frame, in);
    ui_umpire(frame);
    if (!scene->paused) {
        ui_hint_ribbon(frame);
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

static void tag_words(const struct ui_frame *frame, uint8_t mode, struct ui_box box)
{
    CORE_ASSERT(mode < CHOICE_COUNT);
    const float u = frame->unit, x = box.x + 0.5f * box.width, room = box.width - 28.0f * u;
    struct ui_text name = ui_brush(frame, 88.0f, 46.0f, -0.08f, UI_INK);
    name.align = 0.5f;
    name.fit_px = room;
    const struct ui_text line = ui_style(frame, FONT_BODY, 26.0f, 0.5f, 0x3a2418ffu, room);
    char length[TEXT_LINE_MAX], paper[TEXT_LINE_MAX];
    const char *lines[3] = { length, paper, ui_words(frame, tags[mode].ends) };
    ui_text_at(frame, name, x, box.y + 84.0f * u, ui_mode_name(frame->language, mode));
    const struct ui_box rule = { box.x + 34.0f * u, box.y + 148.0f * u, box.width - 68.0f * u,
                                 2.5f * u };
    ui_panel(frame, UI_PANEL, rule, 1.2f * u, 0.0f, 0x5a3a20a0u, 0);
    if (mode == CHOICE_LAB) {
        lines[0] = ui_words(frame, TEXT_LAB_SHAPES);
        lines[1] = ui_words(frame, TEXT_LAB_GRAPH);
    } else {
        /* The duration is written as a text such as "3 minutes" or "90 seconds". Minutes are used
         * only if the duration is a whole number of at least two minutes. */
        const struct scene_offer *const offer = &frame->scene->offer[mode];
        const bool is_even = offer->round_s >= 120u && offer->round_s % 60u == 0;
        text_number(length, sizeof length, ui_words(frame, is_even ? TEXT_MINUTES : TEXT_SECONDS),
                    is_even ? offer->round_s / 60u : offer->round_s);
        text_number(paper, sizeof paper, ui_words(frame, TEXT_PAPER), offer->grade);
    }
    for (uint32_t i = 0; i < 3u; i++) {
        ui_text(frame->batch, line, x, box.y + (188.0f + 40.0f * (float)i) * u, lines[i]);
    }
}

/* Draws the time that remains for the selection as a ring. */
static void seconds_ring(const struct ui_frame *frame, float x, float y)
{
    const float u = frame->unit, radius = 36.0f * u;
    const float left = fminf(fmaxf(frame->scene->seconds_left, 0.0f), SECONDS_SHOWN);
    const float part = left / ((float)RULES_MODE_SELECT_TICKS * CORE_TICK_S);
    ui_disc(frame, x, y, radius, 0.0f, UI_NIGHT, 0);
    ui_ring(frame, x, y, radius, 6.0f * u, f_clamp(part, 0.0f, 1.0f), UI_GOLD, 0xffffff28u);
    ui_number_at(frame, ui_style(frame, FONT_STALL, 34.0f, 0.5f, 0xfff8eaffu, 52.0f * u), x, y,
                 (uint32_t)ceilf(left));
}

/* Draws the best score of the day in the selected mode and the line about the keys. */
static void draw_choose_foot(const struct ui_frame *frame)
{
    const struct scene *const scene = frame->scene;
    const float u = frame->unit;
    if (scene->choice != CHOICE_LAB && rules_of(scene->mode)->keeps_score) {
        best_ribbon(frame, frame->height - 128.0f * u, 25.0f * u);
    }
    ui_ribbon(frame, (struct ui_ribbon){ FONT_BODY, 0xc8341ff2u, UI_GOLD, 0 },
              frame->height - 58.0f * u, 29.0f * u,
              ui_words(frame, scene->credit.warnings & WARN_NO_POI ? TEXT_START_NO_POI
                                                                   : TEXT_CHOOSE_KEYS));
}

void ui_choose(const struct ui_frame *frame)
{
    const struct scene *const scene = frame->scene;
    const struct ui_memory *const memory = frame->memory;
    const float u = frame->unit, in = f_smoothstep(0.0f, 0.35f, scene->phase_s);
    uint32_t count = 0;
    for (uint32_t mode = 0; mode < CHOICE_COUNT; mode++) {
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
    const struct ui_text title =
        ui_style(frame, FONT_STALL, 46.0f, 0.5f, UI_CREAM, frame->width - 220.0f * u);
    frame->batch->opacity = in;
    ui_veil(frame, 0x080a2078u);
    ui_text_at(frame, ui_outlined(title, 0.03f, 0.1f, SHADE), 0.5f * frame->width,
               fmaxf(pole_y - 64.0f * u, 40.0f * u), ui_words(frame, TEXT_CHOOSE));
    ui_pole(frame, 0.5f * frame->width, pole_y, fminf(row + 56.0f * u, frame->width));
    struct ui_box box = { 0.5f * (frame->width - row), middle - 0.5f * height, width, height };
    for (uint32_t mode = 0; mode < CHOICE_COUNT; mode++) {
        if ((scene->modes >> mode & 1u) == 0) {
            continue;
        }
        struct ui_box hung = box;
        /* When the selection changes, the selected tag rises and the previously selected tag
         * sinks. */
        const float age_s = (float)(scene->tick - memory->pointed_tick) * CORE_TICK_S;
        const float moved = f_smoothstep(0.0f, RAISE_S, age_s);
        const float raised = mode == scene->choice            ? moved
                             : mode == memory->pointed_before ? 1.0f - moved
                                                              : 0.0f;
        hung.y += (22.0f - 32.0f * raised) * u - 60.0f * u * (1.0f - in);
        ui_cords(frame, hung, pole_y);
        ui_wooden_tag(frame, hung, mode == scene->choice);
        tag_words(frame, (uint8_t)mode, hung);
        box.x += width + gap;
    }
    draw_choose_foot(frame);
    seconds_ring(frame, frame->width - 66.0f * u, 62.0f * u);
    ui_credits(frame, 128.0f * u, 62.0f * u);
    frame->batch->opacity = 1.0f;
}
