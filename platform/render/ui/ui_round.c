/* ui_round.c -- draws the screen during a round: the catch, the paper, the remaining time and the
 * hint. Also draws the announcements over the tank: the countdown of the last seconds, a foul, and
 * the pause. */
#include <math.h>
#include <stdio.h>

#include "core/base/panic.h"
#include "platform/render/ui/ui_widgets.h"

/* Time in seconds for which an announcement is shown. The time is longer than players need to read
 * the announcement. */
#define CALL_S 1.9f
#define FOUL_S 2.6f
#define COUNTDOWN_S 5.0f

#define HURRY_S 10.0f /* Remaining time in seconds below which the clock is red. */
#define BOWL_MARKS_S 3.0f
#define LONG_ROUND_S 99.5f
#define TIME_WIDTH 136.0f /* Width of the text "9:59", in layout units. */

static float announcement_opacity(float age_s, float length_s)
{
    return f_smoothstep(0.0f, 0.12f, age_s) *
           (1.0f - f_smoothstep(length_s - 0.5f, length_s, age_s));
}

/* Draws one large word with a brush font for Japanese, and with the festival stall's font for other
 * languages. `brush_px` and `stall_px` are the sizes in pixels of one em of these fonts. */
static void big_brush_word(const struct ui_frame *frame, float y, float brush_px, float stall_px,
                           float alpha, enum text_key key)
{
    const bool is_brush = frame->language == LANGUAGE_JA;
    ui_big_word(frame, is_brush ? FONT_BRUSH : FONT_STALL, y, is_brush ? brush_px : stall_px, alpha,
                ui_words(frame, key));
}

/* Draws a red flag with the foul's name and, if there are several players, the player's number.
 * Returns the flag's height. */
static float foul_flag(const struct ui_frame *frame, uint32_t player, float y)
{
    CORE_ASSERT(player < POI_MAX);
    static const uint16_t keys[FOUL_COUNT] = {
        [FOUL_POURED] = TEXT_FOUL_POURED,
        [FOUL_WALL] = TEXT_FOUL_WALL,
        [FOUL_SHADE] = TEXT_FOUL_SHADE,
    };
    const struct scene_player *const state = &frame->scene->player[player];
    const float u = frame->unit, height = 66.0f * u, middle = y + 0.5f * height;
    if (state->foul == FOUL_NONE || state->foul >= FOUL_COUNT || state->foul_s >= FOUL_S) {
        return 0.0f;
    }
    const char *foul = ui_words(frame, TEXT_FOUL);
    const char *name = ui_words(frame, (enum text_key)keys[state->foul]);
    const struct ui_text head = ui_style(frame, FONT_STALL, 32.0f, 0.0f, 0xffd9a0ffu, 0.0f);
    const struct ui_text body = ui_style(frame, FONT_STALL, 42.0f, 0.0f, 0xfff8eaffu, 0.0f);
    const float mark = ui_bowl_count(frame->scene) > 1u ? 58.0f * u : 0.0f;
    const float head_width = ui_text_width(head, foul), gap = 20.0f * u, lamps = 112.0f * u;
    const float width =
        2.0f * 26.0f * u + mark + head_width + gap + ui_text_width(body, name) + lamps;
    float x = 0.5f * (frame->width - width);
    frame->batch->opacity = announcement_opacity(state->foul_s, FOUL_S);
    ui_panel(frame, UI_WASHI, (struct ui_box){ x, y, width, height }, 10.0f * u, 2.5f * u,
             0xb3261ef2u, 0xfff1ddd0u);
    x += 26.0f * u;
    if (mark > 0.0f) {
        ui_player_mark(frame, x + 20.0f * u, middle, 20.0f * u, player);
        x += mark;
    }
    ui_text_at(frame, head, x, middle, foul);
    x += head_width + gap;
    x += ui_text_at(frame, body, x, middle, name);
    ui_foul_lamps(frame, x + 38.0f * u, middle, 10.0f * u, 29.0f * u, state->fouls);
    frame->batch->opacity = 1.0f;
    return height + 8.0f * u;
}

/* Draws a band across the tank. The band has the word with which a sumo referee pauses a bout, and
 * the numbers of the players whose controller input is lost. */
static void draw_pause(const struct ui_frame *frame)
{
    const struct scene *const scene = frame->scene;
    const float u = frame->unit, y = 0.46f * frame->height, height = 220.0f * u;
    ui_fill(frame, (struct ui_box){ 0.0f, y - 0.5f * height, frame->width, height }, 0x0a0c24c8u);
    big_brush_word(frame, y - 30.0f * u, 132.0f * u, 96.0f * u, 1.0f, TEXT_PAUSED);
    ui_text(frame->batch,
            ui_style(frame, FONT_BODY, 30.0f, 0.5f, 0xfff8eaffu, frame->width - 60.0f * u),
            0.5f * frame->width, y + 82.0f * u, ui_words(frame, TEXT_PAUSED_WORDS));
    float x = 0.5f * frame->width + 270.0f * u;
    for (uint32_t i = 0; i < POI_MAX && ui_bowl_count(scene) > 1u; i++) {
        if (scene->player[i].lost && !scene->player[i].out) {
            ui_player_mark(frame, x, y - 30.0f * u, 24.0f * u, i);
            x += 56.0f * u;
        }
    }
}

void ui_umpire(const struct ui_frame *frame)
{
    static const uint16_t keys[] = {
        [CALL_ONE_MINUTE] = TEXT_CALL_ONE_MINUTE,
        [CALL_TWO_MINUTES] = TEXT_CALL_TWO_MINUTES,
        [CALL_TEN_SECONDS] = TEXT_CALL_TEN_SECONDS,
        [CALL_TIME] = TEXT_CALL_TIME,
    };
    const struct scene *const scene = frame->scene;
    const float left_s = scene->seconds_left;
    if (scene->paused) {
        draw_pause(frame);
        return;
    }
    if (scene->call == CALL_COUNTDOWN && scene->phase == PHASE_ROUND && left_s > 0.0f &&
        left_s <= COUNTDOWN_S) {
        /* One large digit is shown for each of the last seconds. The digit grows and fades out. */
        const float whole = ceilf(left_s), gone = whole - left_s;
        const char digit[2] = { (char)('0' + (int)whole), 0 };
        const float pop = 1.0f + 0.30f * (1.0f - f_smoothstep(0.0f, 0.25f, gone));
        ui_big_word(frame, FONT_STALL, 0.36f * frame->height, 150.0f * frame->unit * pop,
                    0.85f * (1.0f - f_smoothstep(0.6f, 0.95f, gone)), digit);
    } else if (scene->call < sizeof keys / sizeof *keys && keys[scene->call] != 0 &&
               scene->call_s < CALL_S) {
        const float grow = 1.0f + 0.10f * f_smoothstep(0.0f, CALL_S, scene->call_s);
        big_brush_word(frame, 0.33f * frame->height, 122.0f * frame->unit * grow,
                       84.0f * frame->unit * grow, announcement_opacity(scene->call_s, CALL_S),
                       (enum text_key)keys[scene->call]);
    }
    /* During the countdown, the first foul flag is below the digits, and further flags are above
     * the first flag. The result screen has room for one foul flag, below the result card. */
    const bool counts_down = scene->phase == PHASE_READY, is_result = scene->phase == PHASE_RESULT;
    float y = (is_result ? 0.76f : counts_down ? 0.72f : 0.47f) * frame->height;
    bool is_full = false;
    for (uint32_t i = 0; i < POI_MAX && !is_full; i++) {
        const float height = foul_flag(frame, i, y);
        y += counts_down ? -height : height;
        is_full = is_result && height > 0.0f;
    }
}

/* Draws the number of fish that the only player caught and, in a mode with levels, the picture of
 * the player's level. */
static void caught_plate(const struct ui_frame *frame, uint32_t player)
{
    CORE_ASSERT(player < POI_MAX);
    const float u = frame->unit, left = 18.0f * u, top = 16.0f * u, height = 88.0f * u;
    const float pop = ui_catch_pop(frame, player), y = top + 0.5f * height;
    char number[12];
    snprintf(number, sizeof number, "%u", ui_catch_shown(frame, player));
    struct ui_text digits = ui_style(frame, FONT_STALL, 68.0f, 0.0f, 0xfff8eaffu, 0.0f);
    const struct ui_text unit = ui_style(frame, FONT_STALL, 34.0f, 0.0f, UI_GOLD, 0.0f);
    const char *words = ui_words(frame, TEXT_UNIT);
    const float number_x = left + 108.0f * u, number_width = ui_text_width(digits, number);
    const float unit_x = number_x + number_width + 12.0f * u;
    const float right = unit_x + ui_text_width(unit, words) + 22.0f * u;
    const float level_width = rules_of(frame->scene->mode)->has_levels ? 70.0f * u : 0.0f;
    ui_plate(frame, (struct ui_box){ left, top, right - left + level_width, height });
    if (level_width > 0.0f) {
        ui_level_tag(frame,
                     (struct ui_box){ right - 4.0f * u, top + 10.0f * u, 58.0f * u, 68.0f * u },
                     frame->scene->player[player].level);
    }
    ui_fish_sign(frame, left + 58.0f * u, y, (74.0f + 12.0f * pop) * u);
    ui_text(frame->batch, unit, unit_x, ui_text_middle(digits, y), words);
    digits.size_px *= 1.0f + 0.22f * pop;
    digits.align = 0.5f;
    ui_text_at(frame, digits, number_x + 0.5f * number_width, y, number);
    ui_catch_flights(frame, player, (struct ui_point){ .x = left + 58.0f * u, .y = y });
}

static bool is_long(const struct scene *scene)
{
    return scene->phase_s + scene->seconds_left > LONG_ROUND_S;
}

/* Draws the remaining time, centred at (x, y): in minutes and seconds in a long round, otherwise in
 * seconds inside a ring. */
static void clock_at(const struct ui_frame *frame, float x, float y)
{
    const struct scene *const scene = frame->scene;
    const float u = frame->unit;
    const bool is_wide = is_long(scene), hurries = scene->seconds_left < HURRY_S;
    const float beat = hurries ? ui_pulse(scene->seconds_left, 1.0f) : 0.0f;
    const uint32_t left_s = (uint32_t)ceilf(fmaxf(scene->seconds_left, 0.0f));
    const struct ui_text digits =
        ui_style(frame, FONT_STALL, (is_wide ? 58.0f : 36.0f) + 5.0f * beat, 0.5f,
                 hurries ? 0xff9a80ffu : 0xfff8eaffu, (is_wide ? TIME_WIDTH : 56.0f) * u);
    char words[24];
    if (is_wide) {
        snprintf(words, sizeof words, "%u:%02u", left_s / 60u, left_s % 60u);
        ui_text_at(frame, digits, x, y, words);
        return;
    }
    const float total_s = scene->phase_s + scene->seconds_left;
    ui_ring(frame, x, y, 37.0f * u, 6.0f * u, total_s > 0.0f ? scene->seconds_left / total_s : 0.0f,
            hurries ? UI_VERMILION : UI_GOLD, 0xffffff28u);
    snprintf(words, sizeof words, "%u", left_s);
    ui_words_at(frame, x, y, digits.fit_px, 0.5f, digits, words);
}

/* Draws a plate at the top right with the paper's grade and the remaining time. If
 * `is_alone` is true, `player` is the only player, and the plate also shows the state of the
 * player's paper. Returns the plate's width in pixels. */
static float state_plate(const struct ui_frame *frame, uint32_t player, bool is_alone)
{
    CORE_ASSERT(player < POI_MAX);
    const struct scene *const scene = frame->scene;
    const float u = frame->unit, height = 88.0f * u, top = 16.0f * u, y = top + 0.5f * height;
    const struct ui_text label = ui_style(frame, FONT_STALL, 27.0f, 0.0f, UI_GOLD, 88.0f * u);
    char grade[TEXT_LINE_MAX];
    text_number(grade, sizeof grade, ui_words(frame, TEXT_GRADE), scene->grade);
    const bool names_time = is_alone && !is_long(scene);
    /* Players with different grades see their level and their paper on their own plates. */
    const char *const paper = scene->grade ? grade : "";
    const char *const time = ui_words(frame, TEXT_TIME_LEFT);
    const float paper_width = scene->grade ? ui_text_width(label, paper) + 20.0f * u : 0.0f;
    const float poi_width = is_alone ? 76.0f * u : 0.0f;
    const float time_width = names_time ? ui_text_width(label, time) + 6.0f * u : 0.0f;
    const float clock_width = is_long(scene) ? TIME_WIDTH * u : 74.0f * u;
    const float width = 20.0f * u + paper_width + poi_width + time_width + clock_width + 16.0f * u;
    const float left = frame->width - 18.0f * u - width, baseline = ui_text_middle(label, y);
    ui_plate(frame, (struct ui_box){ left, top, width, height });
    float x = left + 20.0f * u;
    ui_text(frame->batch, label, x, baseline, paper);
    x += paper_width;
    if (is_alone) {
        ui_poi_sign(frame, x + 18.0f * u, y - 9.0f * u, 26.0f * u, scene->poi[player].paper_left,
                    ui_player_colours[player]);
    }
    x += poi_width;
    if (names_time) {
        ui_text(frame->batch, label, x, baseline, time);
    }
    x += time_width + 0.5f * clock_width;
    clock_at(frame, x, y);
    return width;
}

/* Draws the legend that explains the colours of the paper's stress. */
static void stress_legend(const struct ui_frame *frame, float top)
{
    const float u = frame->unit, width = 256.0f * u, height = 92.0f * u;
    const float left = frame->width - 18.0f * u - width, room = width - 28.0f * u;
    struct ui_text end = ui_style(frame, FONT_BODY, 22.0f, 0.0f, UI_GOLD, 0.0f);
    ui_plate(frame, (struct ui_box){ left, top, width, height });
    ui_text_at(frame, ui_style(frame, FONT_BODY, 23.0f, 0.5f, 0xfff8eaffu, room),
               left + 0.5f * width, top + 21.0f * u, ui_words(frame, TEXT_STRESS));
    ui_panel(frame, UI_HEAT, (struct ui_box){ left + 14.0f * u, top + 39.0f * u, room, 17.0f * u },
             5.0f * u, 1.5f * u, 0xffffffffu, 0x0a0c24ffu);
    ui_text_at(frame, end, left + 14.0f * u, top + 73.0f * u, ui_words(frame, TEXT_STRESS_LOW));
    end.align = 1.0f;
    ui_text_at(frame, end, left + width - 14.0f * u, top + 73.0f * u,
               ui_words(frame, TEXT_STRESS_HIGH));
}

void ui_round(const struct ui_frame *frame)
{
    const struct scene *const scene = frame->scene;
    float bottom = 104.0f * frame->unit;
    ui_lessons(frame);
    if (ui_player_count(scene) > 1u) {
        bottom = fmaxf(bottom, ui_player_plates(frame, state_plate(frame, 0, false)));
    } else {
        const uint32_t player = ui_first_player(scene);
        if (rules_of(scene->mode)->counts_fouls) {
            /* Draws a plate with the word "Fouls" and three lamps. One lamp is lit for each
             * foul. */
            const float u = frame->unit, x = 34.0f * u, y = 135.0f * u;
            const struct ui_text label = ui_style(frame, FONT_STALL, 26.0f, 0.0f, UI_GOLD, 0.0f);
            const char *words = ui_words(frame, TEXT_FOUL);
            const float lamps_x = x + ui_text_width(label, words) + 28.0f * u;
            ui_plate(frame,
                     (struct ui_box){ 18.0f * u, 112.0f * u, lamps_x + 54.0f * u, 46.0f * u });
            ui_text_at(frame, label, x, y, words);
            ui_foul_lamps(frame, lamps_x, y, 9.5f * u, 26.0f * u, scene->player[player].fouls);
        }
        state_plate(frame, player, true);
        /* The plate of caught fish is drawn last, so that fish fly in front of all plates. */
        caught_plate(frame, player);
    }
    ui_handle_marks(frame);
    ui_near_misses(frame);
    ui_bowl_marks(frame, 1.0f - f_smoothstep(BOWL_MARKS_S - 0.5f, BOWL_MARKS_S, scene->phase_s));
    for (uint32_t i = 0; i < POI_MAX; i++) {
        if (scene->poi[i].present && scene->poi[i].shows_stress) {
            stress_legend(frame, bottom + 8.0f * frame->unit);
            break;
        }
    }
    if (scene->phase_s < 1.0f) {
        const float out = 1.0f - f_smoothstep(0.55f, 1.0f, scene->phase_s);
        const float grow = 1.0f + 0.25f * f_smoothstep(0.0f, 1.0f, scene->phase_s);
        const float size_px = 150.0f * frame->unit * grow;
        big_brush_word(frame, 0.44f * frame->height, size_px, size_px, out, TEXT_GO);
    }
    ui_umpire(frame);
    if (!scene->paused) {
        ui_hint_ribbon(frame);
    }
}
