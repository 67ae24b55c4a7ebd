/* ui_result.c -- draws the result screen: the catch and the stallkeeper's comment. */
#include <math.h>
#include <stdio.h>

#include "core/base/panic.h"
#include "core/game/ranking/ranking.h"
#include "platform/render/ui/ui_widgets.h"

#define GRADES 6u
/* Time in seconds in which the displayed number of fish rises from 0 to the number of caught
 * fish. */
#define COUNT_UP_S 1.0f
#define CALL_TIME_S 1.3f

struct grade {
    uint32_t at_least; /* Minimum number of caught fish for this grade of the result. A visitor of a
                          festival stall catches three to five fish. Winners of national
                          championships caught 35 to 87 fish. */
    enum text_key praise, words;
};

static const struct grade *grade_of(uint8_t mode, uint32_t caught)
{
    static const struct grade stall[GRADES] = {
        { 0, TEXT_GRADE_0, TEXT_GRADE_0_WORDS },  { 1, TEXT_GRADE_1, TEXT_GRADE_1_WORDS },
        { 3, TEXT_GRADE_2, TEXT_GRADE_2_WORDS },  { 6, TEXT_GRADE_3, TEXT_GRADE_3_WORDS },
        { 10, TEXT_GRADE_4, TEXT_GRADE_4_WORDS }, { 15, TEXT_GRADE_5, TEXT_GRADE_5_WORDS },
    };
    static const struct grade contest[GRADES] = {
        { 0, TEXT_GRADE_0, TEXT_GRADE_0_WORDS },  { 1, TEXT_GRADE_1, TEXT_GRADE_1_WORDS },
        { 5, TEXT_GRADE_2, TEXT_GRADE_2_WORDS },  { 12, TEXT_GRADE_3, TEXT_GRADE_3_WORDS },
        { 20, TEXT_GRADE_4, TEXT_GRADE_4_WORDS }, { 35, TEXT_GRADE_5, TEXT_GRADE_5_WORDS },
    };
    const struct grade *const grades = rules_of(mode)->counts_fouls ? contest : stall;
    uint32_t grade = 0;
    while (grade + 1u < GRADES && caught >= grades[grade + 1u].at_least) {
        grade++;
    }
    return &grades[grade];
}

static uint32_t counted_up(const struct scene *scene, uint32_t player)
{
    CORE_ASSERT(player < POI_MAX);
    const float share = f_smoothstep(0.2f, 0.2f + COUNT_UP_S, scene->phase_s);
    const uint32_t caught = scene->caught[player];
    return share < 1.0f ? (uint32_t)((double)share * (double)caught) : caught;
}

/* Times in seconds, after the result appears, at which the present (a fish that is given to the
 * player) starts to swim and at which it reaches the bowl. */
#define PRESENT_FROM_S 1.2f
#define PRESENT_TO_S 3.2f

/* Draws a bowl with a bow. The bowl is centred at (x, y) and `width` pixels wide. A fish, which is
 * a present, swims in an arc from the x coordinate `from_x` into the bowl. */
static void present_bowl(const struct ui_frame *frame, float x, float y, float width, float from_x)
{
    const float share = f_smoothstep(PRESENT_FROM_S, PRESENT_TO_S, frame->scene->phase_s);
    const float height = 0.46f * width, arc = 1.1f * height * sinf(F_PI * share);
    const struct ui_box bowl = { x - 0.5f * width, y - 0.5f * height, width, height };
    const struct ui_box rim = { bowl.x - 0.04f * width, bowl.y - 0.04f * width, 1.08f * width,
                                0.09f * width };
    ui_water(frame, bowl, 0.45f * height, frame->time_s, 0x1c6ea4ffu);
    if (share > 0.0f) {
        ui_fish_sign(frame, f_lerp(from_x, x, share), y - arc, 0.56f * width);
    }
    ui_panel(frame, UI_PANEL, rim, 0.045f * width, 0.0f, UI_VERMILION, 0);
    ui_bow(frame, bowl.x + 0.92f * width, rim.y + 0.5f * rim.height, 0.5f * width);
}

/* Draws the number of fish that the only player caught, beside a fish. Below the number, draws the
 * praise, and the fouls if the mode counts fouls. */
static void one_players_result(const struct ui_frame *frame, struct ui_box box)
{
    const struct scene *const scene = frame->scene;
    const float u = frame->unit, x = box.x + 0.5f * box.width;
    const uint32_t player = ui_first_player(scene);
    char number[12];
    snprintf(number, sizeof number, "%u", counted_up(scene, player));
    const char *const words = ui_words(frame, TEXT_UNIT);
    const struct ui_text digits = ui_style(frame, FONT_STALL, 116.0f, 0.0f, UI_INK, 320.0f * u);
    const struct ui_text unit = ui_style(frame, FONT_STALL, 48.0f, 0.0f, UI_INK_SOFT, 0.0f);
    const float fish = 164.0f * u, gap = 20.0f * u, number_width = ui_text_width(digits, number);
    const float whole = fish + number_width + ui_text_width(unit, words) + 2.0f * gap;
    const bool has_present = scene->player[player].has_present;
    const float count_x = x - 0.5f * whole + (has_present ? 80.0f * u : 0.0f);
    const float count_y = box.y + 128.0f * u;
    const float baseline = ui_text_middle(digits, count_y);
    ui_fish_sign(frame, count_x + 0.5f * fish, count_y, fish);
    ui_text(frame->batch, digits, count_x + fish + gap, baseline, number);
    ui_text(frame->batch, unit, count_x + fish + number_width + 2.0f * gap, baseline, words);
    const struct grade *const grade = grade_of(scene->mode, scene->caught[player]);
    struct ui_text praise = ui_brush(frame, 104.0f, 76.0f, -0.10f, 0xc8301effu);
    praise.align = 0.5f;
    praise.fit_px = box.width - 60.0f * u;
    frame->batch->opacity = f_smoothstep(1.1f, 1.5f, scene->phase_s);
    ui_text_at(frame, praise, x, box.y + 252.0f * u, ui_words(frame, grade->praise));
    ui_text(frame->batch, ui_style(frame, FONT_BODY, 27.0f, 0.5f, UI_INK, praise.fit_px), x,
            box.y + 338.0f * u, ui_words(frame, has_present ? TEXT_PRESENT : grade->words));
    frame->batch->opacity = 1.0f;
    if (has_present) {
        present_bowl(frame, box.x + 110.0f * u, count_y + 10.0f * u, 130.0f * u,
                     box.x + box.width - 90.0f * u);
    }
    if (rules_of(scene->mode)->counts_fouls) {
        const float left = box.x + 26.0f * u, y = box.y + box.height - 37.0f * u;
        const float width =
            ui_text_at(frame, ui_style(frame, FONT_STALL, 24.0f, 0.0f, UI_INK_SOFT, 0.0f), left, y,
                       ui_words(frame, TEXT_FOUL));
        ui_foul_lamps(frame, left + width + 22.0f * u, y, 9.5f * u, 25.0f * u,
                      scene->player[player].fouls);
    }
}

static void ranked(const struct ui_frame *frame, uint32_t player, uint32_t place, struct ui_box row)
{
    const struct scene *const scene = frame->scene;
    const float u = frame->unit, y = row.y + 0.5f * row.height;
    char words[TEXT_LINE_MAX];
    text_number(words, sizeof words, ui_words(frame, TEXT_PLACE), place + 1u);
    ui_panel(frame, UI_PANEL, row, 10.0f * u, 2.0f * u,
             ui_fade(ui_player_colours[player], place == 0 ? 0.42f : 0.20f),
             ui_fade(ui_player_colours[player], place == 0 ? 1.0f : 0.5f));
    const struct ui_text digits = ui_style(frame, FONT_STALL, 44.0f, 1.0f, UI_INK, 150.0f * u);
    ui_text_at(frame, ui_style(frame, FONT_STALL, 36.0f, 0.0f, UI_INK, 92.0f * u),
               row.x + 24.0f * u, y, words);
    ui_player_mark(frame, row.x + 148.0f * u, y, 22.0f * u, player);
    ui_fish_sign(frame, row.x + 226.0f * u, y, 74.0f * u);
    const float digits_x = row.x + 428.0f * u;
    ui_number_at(frame, digits, digits_x, y, counted_up(scene, player));
    ui_text(frame->batch, ui_style(frame, FONT_STALL, 27.0f, 0.0f, UI_INK_SOFT, 0.0f),
            digits_x + 14.0f * u, ui_text_middle(digits, y), ui_words(frame, TEXT_UNIT));
    if (scene->player[player].has_present) {
        present_bowl(frame, row.x + 300.0f * u, y + 6.0f * u, 70.0f * u, row.x + 400.0f * u);
    }
    if (rules_of(scene->mode)->has_levels) {
        ui_level_tag(frame,
                     (struct ui_box){ row.x + row.width - 66.0f * u, row.y + 4.0f * u, 48.0f * u,
                                      row.height - 8.0f * u },
                     scene->player[player].level);
    }
    if (rules_of(scene->mode)->counts_fouls) {
        ui_foul_lamps(frame, row.x + row.width - 84.0f * u, y, 10.0f * u, 29.0f * u,
                      scene->player[player].fouls);
    }
}

/* Draws a row for each player, with the best player first. A player's place is the number of
 * players who caught more fish, so that players with equal catches have the same place. */
static void draw_result_ranking(const struct ui_frame *frame, struct ui_box box)
{
    const struct scene *const scene = frame->scene;
    const float u = frame->unit, pitch = 70.0f * u, first = box.y + 76.0f * u;
    uint32_t place[POI_MAX] = { 0 }, shown = 0;
    for (uint32_t i = 0; i < POI_MAX * POI_MAX; i++) {
        const uint32_t a = i / POI_MAX, b = i % POI_MAX;
        place[a] += scene->player[b].plays && scene->caught[b] > scene->caught[a];
    }
    for (uint32_t i = 0; i < POI_MAX * POI_MAX; i++) {
        const uint32_t player = i % POI_MAX;
        if (scene->player[player].plays && place[player] == i / POI_MAX) {
            ranked(frame, player, place[player],
                   (struct ui_box){ box.x + 26.0f * u, first + pitch * (float)shown++,
                                    box.width - 52.0f * u, pitch - 8.0f * u });
        }
    }
}

/* Draws a seal such as "Best of the day!" or "No. 3 this week" for the player with the best place
 * on the leaderboard. Draws nothing if no player has a place. */
static void place_seal(const struct ui_frame *frame, struct ui_box box)
{
    const float u = frame->unit, in = f_smoothstep(1.6f, 1.8f, frame->scene->phase_s);
    const float x = box.x + box.width - 130.0f * u, y = box.y - 8.0f * u;
    const struct scene_player *best = NULL;
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct scene_player *const player = &frame->scene->player[i];
        best = player->place != 0 && (!best || player->place < best->place) ? player : best;
    }
    if (in <= 0.0f || !best) {
        return;
    }
    char words[TEXT_LINE_MAX];
    const bool is_first = best->place == 1 && best->period == RANK_DAY;
    text_number(
        words, sizeof words,
        ui_words(frame, is_first ? TEXT_NEW_BEST : ui_leaderboard_period(best->period)->place),
        best->place);
    const struct ui_text text = { .font = FONT_STALL,
                                  .size_px = 27.0f * u * (2.0f - in),
                                  .align = 0.5f,
                                  .fill = 0xfff1ddffu,
                                  .fit_px = 216.0f * u * (2.0f - in) };
    const float width = ui_text_width(text, words) + 34.0f * u, height = 50.0f * u * (2.0f - in);
    frame->batch->opacity = in;
    ui_panel(frame, UI_WASHI, (struct ui_box){ x - 0.5f * width, y - 0.5f * height, width, height },
             8.0f * u, 2.5f * u, 0xc92c1cffu, 0xfff1ddb0u);
    ui_text_at(frame, text, x, y, words);
    frame->batch->opacity = 1.0f;
}

/* Draws the content of the result card for a round that was not refunded. */
static void draw_result_card(const struct ui_frame *frame, struct ui_box box)
{
    const struct scene *const scene = frame->scene;
    const float u = frame->unit;
    if (ui_player_count(scene) > 1u) {
        draw_result_ranking(frame, box);
    } else {
        one_players_result(frame, box);
    }
    if (rules_of(scene->mode)->has_levels) {
        /* All scores of the round rank at this level, the easiest one of the players. */
        ui_level_tag(frame,
                     (struct ui_box){ box.x + 30.0f * u, box.y - 12.0f * u, 74.0f * u, 88.0f * u },
                     scene->level);
    }
    /* The last line is the day's best score in the mode of the round. After a practice round, the
     * line is a comment of the stallkeeper instead. */
    const bool is_scored = rules_of(scene->mode)->keeps_score;
    char best[TEXT_LINE_MAX];
    ui_best_words(scene, best, sizeof best);
    ui_text(frame->batch,
            ui_style(frame, is_scored ? FONT_STALL : FONT_BODY, 25.0f, 0.5f, 0x8a5a1cffu,
                     box.width - 60.0f * u),
            box.x + 0.5f * box.width, box.y + box.height - 28.0f * u,
            is_scored ? best : ui_words(frame, TEXT_PRACTICE_WORDS));
    place_seal(frame, box);
}

#define CARD_WIDTH 680.0f
#define CARD_HEIGHT 416.0f
/* Width, in layout units, of the card that shows why the paper tore, if it is beside the result
 * card. */
#define TEAR_WIDTH 274.0f
/* Height, in layout units, of the card that shows why the paper tore, if it is below the result
 * card. */
#define TEAR_HEIGHT 190.0f
#define CARD_GAP 14.0f

/* Returns the box of the result's card. If `has_tear` is true, writes the box of the card that
 * shows a tear to `tear`: to the right of the result's card, or below it on a narrow screen. */
static struct ui_box card_box(const struct ui_frame *frame, bool has_tear, struct ui_box *tear)
{
    const float u = frame->unit, gap = CARD_GAP * u, margin = 20.0f * u;
    const bool is_beside = frame->width > 1.1f * frame->height;
    const float aside = has_tear && is_beside ? TEAR_WIDTH * u + gap : 0.0f;
    const float below = has_tear && !is_beside ? TEAR_HEIGHT * u + gap : 0.0f;
    const float width = fminf(CARD_WIDTH * u, frame->width - 2.0f * margin - aside);
    const struct ui_box box = { 0.5f * (frame->width - width - aside),
                                0.45f * frame->height - 0.5f * (CARD_HEIGHT * u + below), width,
                                CARD_HEIGHT * u };
    *tear = is_beside ? (struct ui_box){ box.x + width + gap, box.y, aside - gap, box.height }
                      : (struct ui_box){ box.x, box.y + box.height + gap, width, below - gap };
    return box;
}

void ui_result(const struct ui_frame *frame)
{
    const struct scene *const scene = frame->scene;
    /* The announcement "time!" is visible for CALL_TIME_S seconds before the card fades in. */
    const float after_call = scene->call == CALL_TIME
                                 ? f_smoothstep(CALL_TIME_S, CALL_TIME_S + 0.4f, scene->call_s)
                                 : 1.0f;
    const float u = frame->unit, in = f_smoothstep(0.0f, 0.45f, scene->phase_s) * after_call;
    const uint32_t torn = scene->credit.came_back ? POI_MAX : ui_torn_player(scene);
    struct ui_box tear, box = card_box(frame, torn < POI_MAX, &tear);
    box.y += 40.0f * u * (1.0f - in);
    tear.y += 40.0f * u * (1.0f - in);
    char words[2u * TEXT_LINE_MAX];
    ui_umpire(frame);
    if (after_call <= 0.0f) {
        return;
    }
    frame->batch->opacity = in;
    ui_card(frame, box);
    if (torn < POI_MAX) {
        ui_tear(frame, torn, tear);
    }
    /* The heading is a line such as "Championship: that's all!" */
    snprintf(words, sizeof words, "%s  %s", ui_mode_name(frame->language, scene->mode),
             ui_words(frame, TEXT_RESULT));
    ui_text(frame->batch,
            ui_style(frame, FONT_STALL, 30.0f, 0.5f, UI_INK_SOFT, box.width - 60.0f * u),
            box.x + 0.5f * box.width, box.y + 56.0f * u, words);
    frame->batch->opacity = 1.0f;
    if (scene->credit.came_back) {
        /* A refunded round does not count. Therefore its card shows no score, place or seal. */
        const float x = box.x + 0.5f * box.width, room = box.width - 60.0f * u;
        ui_fish_sign(frame, x, box.y + 138.0f * u, 124.0f * u);
        ui_text_at(frame, ui_style(frame, FONT_STALL, 64.0f, 0.5f, 0xc8301effu, room), x,
                   box.y + 238.0f * u, ui_words(frame, TEXT_GIVEN_BACK));
        ui_text(frame->batch, ui_style(frame, FONT_BODY, 27.0f, 0.5f, UI_INK, room), x,
                box.y + 338.0f * u, ui_words(frame, TEXT_GIVEN_BACK_WORDS));
    } else {
        draw_result_card(frame, box);
    }
    if (scene->hint == HINT_START) {
        ui_start_ribbon(frame, frame->height - 58.0f * u,
                        scene->name.waits != 0 ? TEXT_NAME_CALL : TEXT_AGAIN);
    } else {
        ui_hint_ribbon(frame);
    }
}
