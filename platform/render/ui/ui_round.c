/* ui_round.c -- draws the screen during a round: the catch, the paper, the remaining time and the
 * hint. Also draws the announcements over the tank: the countdown of the last seconds, a foul, and
 * the pause. */
#include <math.h>
#include <stdio.h>

#include "core/base/panic.h"
#include "platform/render/ui/ui_widgets.h"

/* Time in seconds for which an announcement is shown, which is longer than reading it takes. */
#define CALL_S 1.9f
#define FOUL_S 2.6f
#define COUNTDOWN_S 5.0f

static float announcement_opacity(float age_s, float length_s)
{
    return ui_smooth(0.0f, 0.12f, age_s) * (1.0f - ui_smooth(length_s - 0.5f, length_s, age_s));
}

/* Draws the last seconds of a round as one large digit per second, which grows and fades out. */
static void countdown(const struct ui_frame *frame, const struct scene *scene)
{
    if (scene->phase != PHASE_ROUND || scene->seconds_left <= 0.0f ||
        scene->seconds_left > COUNTDOWN_S) {
        return;
    }
    const float whole = ceilf(scene->seconds_left), gone = whole - scene->seconds_left;
    const char digit[2] = { (char)('0' + (int)whole), 0 };
    const float pop = 1.0f + 0.30f * (1.0f - ui_smooth(0.0f, 0.25f, gone));
    ui_big_word(frame, FONT_STALL, 0.36f * frame->height, 150.0f * frame->unit * pop,
                0.85f * (1.0f - ui_smooth(0.6f, 0.95f, gone)), digit);
}

/* Draws a red flag with the foul's name and, if there are several players, the player's number.
 * Returns the flag's height. */
static float foul_flag(const struct ui_frame *frame, const struct scene *scene, uint32_t player,
                       float y)
{
    CORE_ASSERT(player < POI_MAX);
    static const uint16_t keys[FOUL_COUNT] = {
        [FOUL_POURED] = TEXT_FOUL_POURED,
        [FOUL_WALL] = TEXT_FOUL_WALL,
        [FOUL_SHADE] = TEXT_FOUL_SHADE,
    };
    const struct scene_player *state = &scene->player[player];
    const float u = frame->unit, height = 66.0f * u;
    if (state->foul == FOUL_NONE || state->foul >= FOUL_COUNT || state->foul_s >= FOUL_S) {
        return 0.0f;
    }
    const char *foul = ui_words(frame, TEXT_FOUL);
    const char *name = ui_words(frame, (enum text_key)keys[state->foul]);
    const struct ui_text head = ui_style(frame, FONT_STALL, 32.0f, 0.0f, 0xffd9a0ffu, 0.0f);
    const struct ui_text body = ui_style(frame, FONT_STALL, 42.0f, 0.0f, 0xfff8eaffu, 0.0f);
    const float mark = ui_seat_count(scene) > 1u ? 58.0f * u : 0.0f;
    const float head_width = ui_text_width(&head, foul), gap = 20.0f * u, lamps = 112.0f * u;
    const float width =
        2.0f * 26.0f * u + mark + head_width + gap + ui_text_width(&body, name) + lamps;
    float x = 0.5f * (frame->width - width);
    frame->batch->opacity = announcement_opacity(state->foul_s, FOUL_S);
    ui_panel(frame, UI_WASHI, (struct ui_box){ x, y, width, height }, 10.0f * u, 2.5f * u,
             0xb3261ef2u, 0xfff1ddd0u);
    x += 26.0f * u;
    if (mark > 0.0f) {
        ui_player_mark(frame, x + 20.0f * u, y + 0.5f * height, 20.0f * u, player);
        x += mark;
    }
    ui_text_at(frame, &head, x, y + 0.5f * height, foul);
    x += head_width + gap;
    x += ui_text_at(frame, &body, x, y + 0.5f * height, name);
    ui_foul_lamps(frame, x + 38.0f * u, y + 0.5f * height, 10.0f * u, 29.0f * u, state->fouls);
    frame->batch->opacity = 1.0f;
    return height + 8.0f * u;
}

static void draw_foul_flags(const struct ui_frame *frame, const struct scene *scene)
{
    /* During the countdown the first flag is below the digits, and further flags are above the
     * first flag. */
    const int counts_down = scene->phase == PHASE_READY;
    float y = (counts_down ? 0.72f : 0.47f) * frame->height;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const float height = foul_flag(frame, scene, i, y);
        y += counts_down ? -height : height;
    }
}

void ui_umpire(const struct ui_frame *frame, const struct scene *scene)
{
    if (scene->paused) {
        /* A band across the tank shows the word with which a sumo referee pauses a bout. */
        const float u = frame->unit, y = 0.46f * frame->height, height = 220.0f * u;
        const int is_brush = frame->language == LANGUAGE_JA;
        const struct ui_box band = { 0.0f, y - 0.5f * height, frame->width, height };
        const struct ui_text words =
            ui_style(frame, FONT_BODY, 30.0f, 0.5f, 0xfff8eaffu, frame->width - 60.0f * u);
        ui_panel(frame, UI_PANEL, band, 0.0f, 0.0f, 0x0a0c24c8u, 0);
        ui_big_word(frame, is_brush ? FONT_BRUSH : FONT_STALL, y - 30.0f * u,
                    (is_brush ? 132.0f : 96.0f) * u, 1.0f, ui_words(frame, TEXT_PAUSED));
        ui_text(frame->batch, &words, 0.5f * frame->width, y + 82.0f * u,
                ui_words(frame, TEXT_PAUSED_WORDS));
        float x = 0.5f * frame->width + 270.0f * u;
        for (uint32_t i = 0; i < POI_MAX && ui_seat_count(scene) > 1u; i++) {
            if (scene->player[i].lost && !scene->player[i].out) {
                ui_player_mark(frame, x, y - 30.0f * u, 24.0f * u, i);
                x += 56.0f * u;
            }
        }
        return;
    }
    static const uint16_t keys[] = {
        [CALL_ONE_MINUTE] = TEXT_CALL_ONE_MINUTE,
        [CALL_TWO_MINUTES] = TEXT_CALL_TWO_MINUTES,
        [CALL_TEN_SECONDS] = TEXT_CALL_TEN_SECONDS,
        [CALL_TIME] = TEXT_CALL_TIME,
    };
    if (scene->call == CALL_COUNTDOWN) {
        countdown(frame, scene);
    } else if (scene->call < sizeof keys / sizeof *keys && keys[scene->call] != 0 &&
               scene->call_s < CALL_S) {
        const int brush = frame->language == LANGUAGE_JA;
        const float grow = 1.0f + 0.10f * ui_smooth(0.0f, CALL_S, scene->call_s);
        ui_big_word(frame, brush ? FONT_BRUSH : FONT_STALL, 0.33f * frame->height,
                    (brush ? 122.0f : 84.0f) * frame->unit * grow,
                    announcement_opacity(scene->call_s, CALL_S),
                    ui_words(frame, (enum text_key)keys[scene->call]));
    }
    draw_foul_flags(frame, scene);
}

#define HURRY_S 10.0f /* Remaining time in seconds below which the clock is red. */
/* Time in seconds for which the number of caught fish is enlarged after a catch. */
#define POP_S 0.45f
#define BOWL_MARKS_S 3.0f
#define LONG_ROUND_S 99.5f
#define TIME_WIDTH 136.0f /* Width of the text "9:59", in layout units. */

static void caught_plate(const struct ui_frame *frame, const struct scene *scene, uint32_t player,
                         float pop)
{
    CORE_ASSERT(player < POI_MAX);
    const float u = frame->unit, left = 18.0f * u, top = 16.0f * u, height = 88.0f * u;
    char number[12];
    text_number(number, sizeof number, "{}", scene->caught[player]);
    const struct ui_text digits = ui_style(frame, FONT_STALL, 68.0f, 0.0f, 0xfff8eaffu, 0.0f);
    const struct ui_text unit = ui_style(frame, FONT_STALL, 34.0f, 0.0f, UI_GOLD, 0.0f);
    const char *words = ui_words(frame, TEXT_UNIT);
    const float number_x = left + 108.0f * u;
    const float unit_x = number_x + ui_text_width(&digits, number) + 12.0f * u;
    const float right = unit_x + ui_text_width(&unit, words) + 22.0f * u;
    const float baseline = ui_text_middle(&digits, top + 0.5f * height);
    ui_plate(frame, (struct ui_box){ left, top, right - left, height });
    ui_fish_sign(frame, left + 58.0f * u, top + 0.5f * height, (74.0f + 12.0f * pop) * u);
    struct ui_text jump = digits;
    jump.size_px *= 1.0f + 0.22f * pop;
    jump.align = 0.5f;
    ui_text_at(frame, &jump, number_x + 0.5f * ui_text_width(&digits, number), top + 0.5f * height,
               number);
    ui_text(frame->batch, &unit, unit_x, baseline, words);
}

static int is_long(const struct scene *scene)
{
    return scene->phase_s + scene->seconds_left > LONG_ROUND_S;
}

/* Draws the remaining time, centred at (x, y). In a long round the time is in minutes and seconds.
 * Otherwise the time is in seconds inside a ring. */
static void clock_at(const struct ui_frame *frame, const struct scene *scene, float x, float y)
{
    const float u = frame->unit, radius = 37.0f * u;
    const int wide = is_long(scene), hurry = scene->seconds_left < HURRY_S;
    const float beat = hurry ? ui_pulse(scene->seconds_left, 1.0f) : 0.0f;
    const uint32_t left_s = (uint32_t)ceilf(fmaxf(scene->seconds_left, 0.0f));
    const float total_s = scene->phase_s + scene->seconds_left;
    const struct ui_text digits =
        ui_style(frame, FONT_STALL, (wide ? 58.0f : 36.0f) + 5.0f * beat, 0.5f,
                 hurry ? 0xff9a80ffu : 0xfff8eaffu, (wide ? TIME_WIDTH : 56.0f) * u);
    struct ui_text fitted = digits;
    char words[16], number[12];
    text_number(number, sizeof number, wide ? "{}:" : "{}", wide ? left_s / 60u : left_s);
    if (wide) {
        snprintf(words, sizeof words, "%s%02u", number, left_s % 60u);
        ui_text_at(frame, &digits, x, y, words);
        return;
    }
    ui_ring(frame, x, y, radius, 6.0f * u, total_s > 0.0f ? scene->seconds_left / total_s : 0.0f,
            hurry ? UI_VERMILION : UI_GOLD, 0xffffff28u);
    fitted.size_px = ui_text_size(&digits, number);
    ui_text(frame->batch, &digits, x, ui_text_middle(&fitted, y), number);
}

/* Draws the state of the player's paper and the remaining time at the top right. If the player has
 * several papers, draws the number of papers instead of the state. Returns the plate's width in
 * pixels. */
static float state_plate(const struct ui_frame *frame, const struct scene *scene, uint32_t player,
                         int alone)
{
    CORE_ASSERT(player < POI_MAX);
    const float u = frame->unit, height = 88.0f * u, top = 16.0f * u, y = top + 0.5f * height;
    const struct ui_text label = ui_style(frame, FONT_STALL, 27.0f, 0.0f, UI_GOLD, 88.0f * u);
    char grade[TEXT_LINE_MAX];
    text_number(grade, sizeof grade, ui_words(frame, TEXT_GRADE), scene->grade);
    const int names_time = alone && !is_long(scene);
    const char *const paper = scene->grade ? grade : ui_words(frame, TEXT_PAPER_LEFT);
    const char *const time = ui_words(frame, TEXT_TIME_LEFT);
    const float paper_width = ui_text_width(&label, paper);
    const float poi_width = alone ? 76.0f * u : 0.0f;
    const float time_width = names_time ? ui_text_width(&label, time) + 6.0f * u : 0.0f;
    const float clock_width = is_long(scene) ? TIME_WIDTH * u : 74.0f * u;
    const float width =
        20.0f * u + paper_width + poi_width + 20.0f * u + time_width + clock_width + 16.0f * u;
    const float left = frame->width - 18.0f * u - width, baseline = ui_text_middle(&label, y);
    ui_plate(frame, (struct ui_box){ left, top, width, height });
    float x = left + 20.0f * u;
    ui_text(frame->batch, &label, x, baseline, paper);
    x += paper_width;
    if (alone) {
        ui_poi_sign(frame, x + 38.0f * u, y - 9.0f * u, 26.0f * u, scene->poi[player].paper_left,
                    ui_player_colours[player]);
    }
    x += poi_width + 20.0f * u;
    if (names_time) {
        ui_text(frame->batch, &label, x, baseline, time);
    }
    x += time_width + 0.5f * clock_width;
    clock_at(frame, scene, x, y);
    return width;
}

/* Draws the legend that explains the colours of the paper's stress. */
static void stress_legend(const struct ui_frame *frame, float top)
{
    const float u = frame->unit, width = 256.0f * u, height = 92.0f * u;
    const float left = frame->width - 18.0f * u - width, room = width - 28.0f * u;
    const struct ui_text title = ui_style(frame, FONT_BODY, 23.0f, 0.5f, 0xfff8eaffu, room);
    struct ui_text end = ui_style(frame, FONT_BODY, 22.0f, 0.0f, UI_GOLD, 0.0f);
    ui_plate(frame, (struct ui_box){ left, top, width, height });
    ui_text_at(frame, &title, left + 0.5f * width, top + 21.0f * u, ui_words(frame, TEXT_STRESS));
    ui_panel(frame, UI_HEAT, (struct ui_box){ left + 14.0f * u, top + 39.0f * u, room, 17.0f * u },
             5.0f * u, 1.5f * u, 0xffffffffu, 0x0a0c24ffu);
    const float y = ui_text_middle(&end, top + 73.0f * u);
    ui_text(frame->batch, &end, left + 14.0f * u, y, ui_words(frame, TEXT_STRESS_LOW));
    end.align = 1.0f;
    ui_text(frame->batch, &end, left + width - 14.0f * u, y, ui_words(frame, TEXT_STRESS_HIGH));
}

void ui_round(const struct ui_frame *frame, const struct scene *scene,
              const struct ui_memory *memory)
{
    float bottom = 104.0f * frame->unit;
    if (ui_player_count(scene) > 1u) {
        const float right_px = state_plate(frame, scene, 0, 0);
        bottom = fmaxf(bottom, ui_player_plates(frame, scene, memory, right_px));
    } else {
        const uint32_t player = ui_first_player(scene);
        const float since_s = (float)(scene->tick - memory->caught_tick[player]) * CORE_TICK_S;
        const float pop =
            memory->caught[player] > 0 ? 1.0f - ui_smooth(0.0f, POP_S, since_s) : 0.0f;
        caught_plate(frame, scene, player, pop);
        if (rules_of(scene->mode)->judges) {
            /* The plate shows the word "Fouls" and three lamps. One lamp is lit for each foul. */
            const float u = frame->unit, left = 18.0f * u, top = 112.0f * u, height = 46.0f * u;
            const struct ui_text label = ui_style(frame, FONT_STALL, 26.0f, 0.0f, UI_GOLD, 0.0f);
            const char *words = ui_words(frame, TEXT_FOUL);
            const float lamps_x = left + 16.0f * u + ui_text_width(&label, words) + 28.0f * u;
            ui_plate(frame, (struct ui_box){ left, top, lamps_x + 72.0f * u - left, height });
            ui_text_at(frame, &label, left + 16.0f * u, top + 0.5f * height, words);
            ui_foul_lamps(frame, lamps_x, top + 0.5f * height, 9.5f * u, 26.0f * u,
                          scene->player[player].fouls);
        }
        state_plate(frame, scene, player, 1);
    }
    ui_bowl_marks(frame, scene,
                  1.0f - ui_smooth(BOWL_MARKS_S - 0.5f, BOWL_MARKS_S, scene->phase_s));
    int shows = 0;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        shows |= scene->poi[i].present && scene->poi[i].shows_stress;
    }
    if (shows) {
        stress_legend(frame, bottom + 8.0f * frame->unit);
    }
    if (scene->phase_s < 1.0f) {
        const float out = 1.0f - ui_smooth(0.55f, 1.0f, scene->phase_s);
        const float grow = 1.0f + 0.25f * ui_smooth(0.0f, 1.0f, scene->phase_s);
        ui_big_word(frame, frame->language == LANGUAGE_JA ? FONT_BRUSH : FONT_STALL,
                    0.44f * frame->height, 150.0f * frame->unit * grow, out,
                    ui_words(frame, TEXT_GO));
    }
    ui_umpire(frame, scene);
    if (!scene->paused) {
        ui_hint_ribbon(frame, scene, memory);
    }
}
