/* ui_result.c -- after the round: what was caught, and what the stallkeeper says to it. */
#include <math.h>

#include "platform/render/ui_signs.h"

#define GRADES 6u
#define COUNT_UP_S 1.0f /* The figure counts up to what was caught. */

struct grade {
    uint32_t at_least;           /* Fish. A stall's guest takes three to five home. */
    enum text_key praise, words;
};

static const struct grade *grade_of(uint32_t caught)
{
    static const struct grade grades[GRADES] = {
        { 0, TEXT_GRADE_0, TEXT_GRADE_0_WORDS },  { 1, TEXT_GRADE_1, TEXT_GRADE_1_WORDS },
        { 3, TEXT_GRADE_2, TEXT_GRADE_2_WORDS },  { 6, TEXT_GRADE_3, TEXT_GRADE_3_WORDS },
        { 10, TEXT_GRADE_4, TEXT_GRADE_4_WORDS }, { 15, TEXT_GRADE_5, TEXT_GRADE_5_WORDS },
    };
    uint32_t grade = 0;
    while (grade + 1u < GRADES && caught >= grades[grade + 1u].at_least) {
        grade++;
    }
    return &grades[grade];
}

/* The seal that a proud stallkeeper stamps on a record. */
static void seal(const struct ui_frame *frame, float x, float y, float in)
{
    const float u = frame->unit;
    const char *words = text_words(frame->language, TEXT_NEW_BEST);
    const struct ui_text text = { .font = FONT_STALL, .size_px = 27.0f * u * (2.0f - in),
                                  .align = 0.5f, .fill = 0xfff1ddffu };
    const float width = ui_text_width(&text, words) + 34.0f * u, height = 50.0f * u * (2.0f - in);
    frame->batch->opacity = in;
    ui_shape(frame->batch,
             &(struct ui_shape){ .box = { x - 0.5f * width, y - 0.5f * height, width, height },
                                 .kind = UI_WASHI, .fill = 0xc92c1cffu, .line = 0xfff1ddb0u,
                                 .shape = { 0, 0, 8.0f * u, 2.5f * u } });
    ui_text(frame->batch, &text, x, ui_text_middle(&text, y), words);
    frame->batch->opacity = 1.0f;
}

static void result_count(const struct ui_frame *frame, const struct scene *scene, float x, float y)
{
    const float u = frame->unit, counted = ui_smooth(0.2f, 0.2f + COUNT_UP_S, scene->phase_s);
    char number[12];
    text_number(number, sizeof number, "{}",
                (uint32_t)(counted * (float)scene->caught[0] + 0.001f));
    const struct ui_text digits = { .font = FONT_STALL, .size_px = 116.0f * u, .fill = UI_INK };
    const struct ui_text unit = { .font = FONT_STALL, .size_px = 48.0f * u, .fill = UI_INK_SOFT };
    const char *words = text_words(frame->language, TEXT_UNIT);
    const float fish = 164.0f * u, gap = 20.0f * u;
    const float number_width = ui_text_width(&digits, number);
    const float whole = fish + number_width + ui_text_width(&unit, words) + 2.0f * gap;
    const float left = x - 0.5f * whole, baseline = ui_text_middle(&digits, y);
    ui_fish_sign(frame, left + 0.5f * fish, y, fish);
    ui_text(frame->batch, &digits, left + fish + gap, baseline, number);
    ui_text(frame->batch, &unit, left + fish + number_width + 2.0f * gap, baseline, words);
}

/* A paper card; its shadow is drawn only where it shows, for a card covers many pixels. */
static void card(const struct ui_frame *frame, struct ui_box box)
{
    const float u = frame->unit;
    const struct ui_box shade = { box.x - 2.0f * u, box.y + box.height - 28.0f * u,
                                  box.width + 4.0f * u, 38.0f * u };
    ui_shape(frame->batch, &(struct ui_shape){ .box = shade, .kind = UI_PANEL, .fill = 0x05061c80u,
                                               .shape = { 0, 0, 16.0f * u } });
    ui_shape(frame->batch, &(struct ui_shape){ .box = box, .kind = UI_WASHI,
                                               .fill = UI_WASHI_WHITE, .line = 0xb5762fffu,
                                               .shape = { 0, 0, 14.0f * u, 3.0f * u } });
}

static void result_words(const struct ui_frame *frame, const struct scene *scene, struct ui_box box)
{
    const float u = frame->unit, x = box.x + 0.5f * box.width;
    const struct grade *grade = grade_of(scene->caught[0]);
    const int brush = frame->language == LANGUAGE_JA;
    const struct ui_text heading = { .font = FONT_STALL, .size_px = 30.0f * u, .align = 0.5f,
                                     .fill = UI_INK_SOFT };
    const struct ui_text praise = { .font = brush ? FONT_BRUSH : FONT_STALL,
                                    .align = 0.5f,
                                    .size_px = (brush ? 104.0f : 76.0f) * u,
                                    .weight_em = brush ? 0.022f : 0.0f,
                                    .spacing_em = brush ? -0.10f : 0.0f,
                                    .fill = 0xc8301effu,
                                    .fit_px = box.width - 60.0f * u };
    const struct ui_text words = { .font = FONT_BODY, .size_px = 27.0f * u, .align = 0.5f,
                                   .fill = UI_INK, .fit_px = box.width - 60.0f * u };
    ui_text(frame->batch, &heading, x, box.y + 52.0f * u,
            text_words(frame->language, TEXT_RESULT));
    result_count(frame, scene, x, box.y + 128.0f * u);
    frame->batch->opacity = ui_smooth(1.1f, 1.5f, scene->phase_s);
    ui_text(frame->batch, &praise, x, ui_text_middle(&praise, box.y + 252.0f * u),
            text_words(frame->language, grade->praise));
    ui_text(frame->batch, &words, x, box.y + 338.0f * u,
            text_words(frame->language, grade->words));
    frame->batch->opacity = 1.0f;
    char best[TEXT_LINE_MAX];
    ui_best_words(scene, best, sizeof best);
    const struct ui_text small = { .font = FONT_STALL, .size_px = 25.0f * u, .align = 0.5f,
                                   .fill = 0x8a5a1cffu };
    ui_text(frame->batch, &small, x, box.y + 388.0f * u, best);
}

void ui_result(const struct ui_frame *frame, const struct scene *scene,
               const struct ui_memory *memory)
{
    const float u = frame->unit, in = ui_smooth(0.0f, 0.45f, scene->phase_s);
    const float width = fminf(680.0f * u, frame->width - 40.0f * u), height = 416.0f * u;
    const struct ui_box box = { 0.5f * (frame->width - width),
                                0.45f * frame->height - 0.5f * height + 40.0f * u * (1.0f - in),
                                width, height };
    ui_other_players(frame, scene);
    frame->batch->opacity = in;
    card(frame, box);
    frame->batch->opacity = 1.0f;
    result_words(frame, scene, box);
    const float stamped = ui_smooth(1.6f, 1.8f, scene->phase_s);
    if (stamped > 0.0f && !scene->by_bot && scene->caught[0] > memory->best_before) {
        seal(frame, box.x + box.width - 130.0f * u, box.y + 8.0f * u, stamped);
    }
    if (scene->hint == HINT_START) {
        ui_start_ribbon(frame, frame->height - 58.0f * u, TEXT_AGAIN);
    } else {
        ui_hint_ribbon(frame, scene, memory);
    }
}
