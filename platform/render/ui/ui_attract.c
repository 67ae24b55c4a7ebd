/* ui_attract.c -- draws attract mode (the demonstration between rounds) and the countdown before a
 * round. */
#include <math.h>
#include <stdio.h>

#include "core/base/panic.h"
#include "core/game/accounting/accounts.h"
#include "core/game/rules.h"
#include "platform/render/ui/ui_widgets.h"

/* Share of the width of the screen, at its left, that the arm of the demonstration leaves free. */
#define ARM_FREE 0.6f

void ui_best_ribbon(const struct ui_frame *frame, float y, float size_px)
{
    char words[TEXT_LINE_MAX];
    ui_best_words(frame->scene, words, sizeof words);
    ui_ribbon(frame, (struct ui_ribbon){ FONT_STALL, UI_NIGHT, 0, UI_GOLD }, y, size_px, words);
}

void ui_attract(const struct ui_frame *frame)
{
    const struct scene *const scene = frame->scene;
    const float u = frame->unit, board = ui_leaderboard_in(&scene->leaderboard);
    /* The ribbons hide no arm of the demonstration, which comes from the right. */
    struct ui_frame free = *frame;
    if (board == 0.0f && scene->poi[0].present && !scene->poi[0].left_hand &&
        frame->width > frame->height) {
        free.width *= ARM_FREE;
    }
    const float risen = fmaxf(1.0f - f_smoothstep(0.0f, 0.8f, scene->phase_s), board);
    if (risen < 1.0f) {
        ui_noren(frame, risen);
    }
    if (board > 0.0f) {
        /* The shop curtain is raised to leave room for the leaderboard, and the credits are drawn
         * at the side. */
        ui_leaderboard(frame, 16.0f * u, frame->height - 160.0f * u);
        ui_credits(frame, 128.0f * u, 62.0f * u);
    } else {
        ui_best_ribbon(&free, frame->height - 174.0f * u, 24.0f * u);
        ui_credits(&free, 0.5f * free.width, frame->height - 230.0f * u);
    }
    ui_start_ribbon(&free, frame->height - 108.0f * u, TEXT_START);
    /* The line that explains the use of the mouse is drawn only if a poi (paper scoop) is
     * present. */
    const struct ui_text text =
        ui_outlined(ui_style(frame, FONT_BODY, 17.0f, 0.5f, 0xe9dcc6ffu, frame->width - 32.0f * u),
                    0.05f, 0.12f, 0x0a0814d0u);
    const float x = 0.5f * frame->width;
    /* Larger letters need a larger distance between the lines. */
    const float keys_y = frame->height - 15.0f * u, step = (8.0f + 21.0f * frame->text_scale) * u;
    if (!(scene->credit.warnings & WARN_NO_POI)) {
        ui_text(frame->batch, text, x, keys_y - step, ui_words(frame, TEXT_MOUSE));
    }
    ui_text(frame->batch, text, x, keys_y, ui_words(frame, TEXT_KEYS));
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
    ui_text(frame->batch, ui_outlined(word, 0.03f, 0.1f, UI_WORD_SHADE), x, y + radius + 62.0f * u,
            ui_words(frame, TEXT_READY));
    frame->batch->opacity = 1.0f;
    if (whole >= 1.0f) {
        const char digit[2] = { (char)('0' + (int)fminf(whole, 9.0f)), 0 };
        const float pop = 1.0f + 0.35f * (1.0f - f_smoothstep(0.0f, 0.25f, gone));
        ui_big_word(frame, FONT_STALL, y, 190.0f * u * pop,
                    in * (1.0f - f_smoothstep(0.82f, 1.0f, gone)), digit);
    }
    /* A ribbon shows the game mode of the round that begins and, if all players have the same paper
     * grade, the grade. */
    char paper[TEXT_LINE_MAX] = "", words[2u * TEXT_LINE_MAX];
    if (scene->grade != 0) {
        text_number(paper, sizeof paper, ui_words(frame, TEXT_PAPER), scene->grade);
    }
    snprintf(words, sizeof words, "%s  %s", ui_mode_name(frame->language, scene->mode), paper);
    frame->batch->opacity = in;
    ui_ribbon(frame, (struct ui_ribbon){ FONT_STALL, UI_NIGHT, UI_GOLD_DIM, UI_GOLD },
              y - radius - 50.0f * u, 29.0f * u, words);
    frame->batch->opacity = 1.0f;
    ui_bowl_marks(frame, in);
    ui_lessons(frame);
    ui_umpire(frame);
    if (!scene->paused) {
        ui_hint_ribbon(frame);
    }
}
