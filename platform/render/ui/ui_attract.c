/* ui_attract.c -- draws the screens before a round: attract mode (the demonstration between
 * rounds), then the countdown. */
#include <math.h>
#include <stdio.h>

#include "platform/render/ui/ui_leaderboard.h"
#include "platform/render/ui/ui_widgets.h"

static void best_tag(const struct ui_frame *frame, const struct scene *scene, float y)
{
    char words[TEXT_LINE_MAX];
    ui_best_words(scene, words, sizeof words);
    const struct ui_ribbon tag = { .x = 0.5f * frame->width,
                                   .y = y,
                                   .size_px = 24.0f * frame->unit,
                                   .font = FONT_STALL,
                                   .fill = UI_NIGHT,
                                   .line = 0,
                                   .ink = UI_GOLD,
                                   .room_px = frame->width - 32.0f * frame->unit };
    ui_ribbon(frame, &tag, words);
}

/* Draws the help lines for the keyboard. Omits the line about the mouse if no poi is present. */
static void key_lines(const struct ui_frame *frame, const struct scene *scene)
{
    const float u = frame->unit;
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
        ui_text(frame->batch, &text, x, frame->height - 41.0f * u,
                text_words(frame->language, TEXT_MOUSE));
    }
    ui_text(frame->batch, &text, x, frame->height - 15.0f * u,
            text_words(frame->language, TEXT_KEYS));
}

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
        best_tag(frame, scene, frame->height - 174.0f * u);
        ui_credits(frame, scene, 0.5f * frame->width, frame->height - 230.0f * u);
    }
    ui_start_ribbon(frame, scene, frame->height - 108.0f * u, TEXT_START);
    key_lines(frame, scene);
}

/* Draws a tag with the mode and the paper grade of the next round. */
static void mode_tag(const struct ui_frame *frame, const struct scene *scene, float y, float alpha)
{
    char paper[TEXT_LINE_MAX], words[2u * TEXT_LINE_MAX];
    text_number(paper, sizeof paper, text_words(frame->language, TEXT_PAPER), scene->grade);
    snprintf(words, sizeof words, "%s  %s", ui_mode_name(frame->language, scene->mode), paper);
    const struct ui_ribbon tag = { .x = 0.5f * frame->width,
                                   .y = y,
                                   .size_px = 29.0f * frame->unit,
                                   .font = FONT_STALL,
                                   .fill = UI_NIGHT,
                                   .line = UI_GOLD_DIM,
                                   .ink = UI_GOLD,
                                   .room_px = frame->width - 32.0f * frame->unit };
    frame->batch->opacity = alpha;
    ui_ribbon(frame, &tag, words);
    frame->batch->opacity = 1.0f;
}

/* Draws the start of a round. The curtain rises, then a ring over the water counts down three
 * seconds. */
void ui_ready(const struct ui_frame *frame, const struct scene *scene,
              const struct ui_memory *memory)
{
    const float u = frame->unit, x = 0.5f * frame->width, y = 0.42f * frame->height;
    const float whole = ceilf(scene->seconds_left), radius = 128.0f * u;
    const float gone = whole - scene->seconds_left; /* Fraction of the current second that has
                                                       elapsed, [0, 1]. */
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
    ui_text(frame->batch, &word, x, y + radius + 62.0f * u,
            text_words(frame->language, TEXT_READY));
    frame->batch->opacity = 1.0f;
    if (whole >= 1.0f) {
        const char digit[2] = { (char)('0' + (int)fminf(whole, 9.0f)), 0 };
        const float pop = 1.0f + 0.35f * (1.0f - ui_smooth(0.0f, 0.25f, gone));
        ui_big_word(frame, FONT_STALL, y, 190.0f * u * pop,
                    in * (1.0f - ui_smooth(0.82f, 1.0f, gone)), digit);
    }
    mode_tag(frame, scene, y - radius - 50.0f * u, in);
    ui_bowl_marks(frame, scene, in);
    ui_umpire(frame, scene);
    if (!scene->paused) {
        ui_hint_ribbon(frame, scene, memory);
    }
}
