/* ui_announcements.c -- draws the announcements over the tank: the countdown of the last seconds, a
 * foul, and the pause. */
#include <math.h>

#include "platform/render/ui/ui_widgets.h"

/* Time in seconds for which an announcement is shown, which is longer than reading it takes. */
#define CALL_S 1.9f
#define FOUL_S 2.6f
#define COUNTDOWN_S 5.0f

static float shown(float age_s, float length_s)
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

static void call(const struct ui_frame *frame, const struct scene *scene)
{
    static const uint16_t keys[] = {
        [CALL_ONE_MINUTE] = TEXT_CALL_ONE_MINUTE,
        [CALL_TWO_MINUTES] = TEXT_CALL_TWO_MINUTES,
        [CALL_TEN_SECONDS] = TEXT_CALL_TEN_SECONDS,
        [CALL_TIME] = TEXT_CALL_TIME,
    };
    if (scene->call == CALL_COUNTDOWN) {
        countdown(frame, scene);
    } else if (scene->call < sizeof keys && keys[scene->call] != 0 && scene->call_s < CALL_S) {
        const int brush = frame->language == LANGUAGE_JA;
        const float grow = 1.0f + 0.10f * ui_smooth(0.0f, CALL_S, scene->call_s);
        ui_big_word(frame, brush ? FONT_BRUSH : FONT_STALL, 0.33f * frame->height,
                    (brush ? 122.0f : 84.0f) * frame->unit * grow, shown(scene->call_s, CALL_S),
                    text_words(frame->language, (enum text_key)keys[scene->call]));
    }
}

/* Draws a red flag with the foul's name and, if there are several players, the player's number.
 * Returns the flag's height. */
static float foul_flag(const struct ui_frame *frame, const struct scene *scene, uint32_t player,
                       float y)
{
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
    const char *foul = text_words(frame->language, TEXT_FOUL);
    const char *name = text_words(frame->language, (enum text_key)keys[state->foul]);
    const struct ui_text head = { .font = FONT_STALL, .size_px = 32.0f * u, .fill = 0xffd9a0ffu };
    const struct ui_text body = { .font = FONT_STALL, .size_px = 42.0f * u, .fill = 0xfff8eaffu };
    const float mark = ui_seat_count(scene) > 1u ? 58.0f * u : 0.0f;
    const float head_width = ui_text_width(&head, foul), gap = 20.0f * u, lamps = 112.0f * u;
    const float width =
        2.0f * 26.0f * u + mark + head_width + gap + ui_text_width(&body, name) + lamps;
    float x = 0.5f * (frame->width - width);
    frame->batch->opacity = shown(state->foul_s, FOUL_S);
    ui_shape(frame->batch, &(struct ui_shape){ .box = { x, y, width, height },
                                               .kind = UI_WASHI,
                                               .fill = 0xb3261ef2u,
                                               .line = 0xfff1ddd0u,
                                               .shape = { 0, 0, 10.0f * u, 2.5f * u } });
    x += 26.0f * u;
    if (mark > 0.0f) {
        ui_player_mark(frame, x + 20.0f * u, y + 0.5f * height, 20.0f * u, player);
        x += mark;
    }
    ui_text(frame->batch, &head, x, ui_text_middle(&head, y + 0.5f * height), foul);
    x += head_width + gap;
    x += ui_text(frame->batch, &body, x, ui_text_middle(&body, y + 0.5f * height), name);
    ui_foul_lamps(frame, x + 38.0f * u, y + 0.5f * height, 10.0f * u, 29.0f * u, state->fouls);
    frame->batch->opacity = 1.0f;
    return height + 8.0f * u;
}

static void fouls(const struct ui_frame *frame, const struct scene *scene)
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

/* Draws the word with which a sumo referee pauses a bout, on a band across the tank. Drawn while
 * the game is paused. */
static void pause(const struct ui_frame *frame, const struct scene *scene)
{
    const float u = frame->unit, y = 0.46f * frame->height, height = 220.0f * u;
    const int brush = frame->language == LANGUAGE_JA;
    const struct ui_box band = { 0.0f, y - 0.5f * height, frame->width, height };
    const struct ui_text words = { .font = FONT_BODY,
                                   .size_px = 30.0f * u,
                                   .align = 0.5f,
                                   .fill = 0xfff8eaffu,
                                   .fit_px = frame->width - 60.0f * u };
    ui_shape(frame->batch,
             &(struct ui_shape){ .box = band, .kind = UI_PANEL, .fill = 0x0a0c24c8u });
    ui_big_word(frame, brush ? FONT_BRUSH : FONT_STALL, y - 30.0f * u, (brush ? 132.0f : 96.0f) * u,
                1.0f, text_words(frame->language, TEXT_PAUSED));
    ui_text(frame->batch, &words, 0.5f * frame->width, y + 82.0f * u,
            text_words(frame->language, TEXT_PAUSED_WORDS));
    float x = 0.5f * frame->width + 270.0f * u;
    for (uint32_t i = 0; i < POI_MAX && ui_seat_count(scene) > 1u; i++) {
        if (scene->player[i].lost && !scene->player[i].out) {
            ui_player_mark(frame, x, y - 30.0f * u, 24.0f * u, i);
            x += 56.0f * u;
        }
    }
}

void ui_umpire(const struct ui_frame *frame, const struct scene *scene)
{
    if (scene->paused) {
        pause(frame, scene);
        return;
    }
    call(frame, scene);
    fouls(frame, scene);
}
