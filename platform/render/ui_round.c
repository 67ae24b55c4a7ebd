/* ui_round.c -- while a round is played: the catch, the paper, the time, a hint. */
#include <math.h>

#include "platform/render/ui_signs.h"

#define HURRY_S 10.0f /* The clock turns red. */
#define POP_S 0.45f   /* The count jumps when a fish lands. */

static void caught_plate(const struct ui_frame *frame, const struct scene *scene, float pop)
{
    const float u = frame->unit, left = 18.0f * u, top = 16.0f * u, height = 88.0f * u;
    char number[12];
    text_number(number, sizeof number, "{}", scene->caught[0]);
    const struct ui_text digits = { .font = FONT_STALL, .size_px = 68.0f * u, .fill = 0xfff8eaffu };
    const struct ui_text unit = { .font = FONT_STALL, .size_px = 34.0f * u, .fill = UI_GOLD };
    const char *words = text_words(frame->language, TEXT_UNIT);
    const float number_x = left + 108.0f * u;
    const float unit_x = number_x + ui_text_width(&digits, number) + 12.0f * u;
    const float right = unit_x + ui_text_width(&unit, words) + 22.0f * u;
    const float baseline = ui_text_middle(&digits, top + 0.5f * height);
    ui_plate(frame, (struct ui_box){ left, top, right - left, height });
    ui_fish_sign(frame, left + 58.0f * u, top + 0.5f * height, (74.0f + 12.0f * pop) * u);
    struct ui_text jump = digits;
    jump.size_px *= 1.0f + 0.22f * pop;
    jump.align = 0.5f;
    ui_text(frame->batch, &jump, number_x + 0.5f * ui_text_width(&digits, number),
            ui_text_middle(&jump, top + 0.5f * height), number);
    ui_text(frame->batch, &unit, unit_x, baseline, words);
}

static void time_ring(const struct ui_frame *frame, const struct scene *scene, float x, float y)
{
    const float u = frame->unit, radius = 37.0f * u;
    const float total = scene->phase_s + scene->seconds_left;
    const int hurry = scene->seconds_left < HURRY_S;
    const float beat = hurry ? ui_pulse(scene->seconds_left, 1.0f) : 0.0f;
    ui_shape(frame->batch,
             &(struct ui_shape){ .box = { x - radius, y - radius, 2.0f * radius, 2.0f * radius },
                                 .kind = UI_RING,
                                 .fill = hurry ? UI_VERMILION : UI_GOLD, .line = 0xffffff28u,
                                 .shape = { radius, 6.0f * u,
                                            total > 0.0f ? scene->seconds_left / total : 0.0f } });
    char number[12];
    text_number(number, sizeof number, "{}", (uint32_t)ceilf(fmaxf(scene->seconds_left, 0.0f)));
    const struct ui_text digits = { .font = FONT_STALL, .size_px = (36.0f + 5.0f * beat) * u,
                                    .align = 0.5f, .fit_px = 56.0f * u,
                                    .fill = hurry ? 0xff9a80ffu : 0xfff8eaffu };
    struct ui_text fitted = digits;
    fitted.size_px = ui_text_size(&digits, number);
    ui_text(frame->batch, &digits, x, ui_text_middle(&fitted, y), number);
}

static void state_plate(const struct ui_frame *frame, const struct scene *scene)
{
    const float u = frame->unit, height = 88.0f * u, top = 16.0f * u, y = top + 0.5f * height;
    const struct ui_text label = { .font = FONT_STALL, .size_px = 27.0f * u, .fill = UI_GOLD,
                                   .fit_px = 88.0f * u };
    const char *paper = text_words(frame->language, TEXT_PAPER_LEFT);
    const char *time = text_words(frame->language, TEXT_TIME_LEFT);
    const float paper_width = ui_text_width(&label, paper);
    const float time_width = ui_text_width(&label, time);
    const float width = paper_width + time_width + 224.0f * u;
    const float left = frame->width - 18.0f * u - width, baseline = ui_text_middle(&label, y);
    ui_plate(frame, (struct ui_box){ left, top, width, height });
    float x = left + 20.0f * u;
    ui_text(frame->batch, &label, x, baseline, paper);
    x += paper_width + 38.0f * u;
    ui_poi_sign(frame, x, y - 9.0f * u, 26.0f * u, scene->poi[0].paper_left, ui_player_colours[0]);
    x += 58.0f * u;
    ui_text(frame->batch, &label, x, baseline, time);
    time_ring(frame, scene, x + time_width + 50.0f * u, y);
}

void ui_round(const struct ui_frame *frame, const struct scene *scene,
              const struct ui_memory *memory)
{
    const float since_s = (float)(scene->tick - memory->caught_tick) * CORE_TICK_S;
    const float pop = memory->caught > 0 ? 1.0f - ui_smooth(0.0f, POP_S, since_s) : 0.0f;
    caught_plate(frame, scene, pop);
    ui_other_players(frame, scene);
    state_plate(frame, scene);
    if (scene->phase_s < 1.0f) {
        const float out = 1.0f - ui_smooth(0.55f, 1.0f, scene->phase_s);
        const float grow = 1.0f + 0.25f * ui_smooth(0.0f, 1.0f, scene->phase_s);
        ui_big_word(frame, frame->language == LANGUAGE_JA ? FONT_BRUSH : FONT_STALL,
                 0.44f * frame->height, 150.0f * frame->unit * grow, out,
                 text_words(frame->language, TEXT_GO));
    }
    ui_hint_ribbon(frame, scene, memory);
}
