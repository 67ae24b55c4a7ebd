/* ui_leaderboard.c -- draws the leaderboard on a sheet of paper, in the style of a sumo ranking
 * list with the best player first. */
#include "core/base/panic.h"
#include "platform/render/ui/ui_widgets.h"

#include <math.h>
#include <stdio.h>

#include "core/game/ranking/ranking.h"
#include "core/game/rules.h"

/* Minimum number of rows on the sheet, because a sheet with a single row would look empty. */
#define ROWS_MIN 5u
#define COME_S 0.45f
#define GO_S 0.35f
/* Delay in seconds from the appearance of one row to the appearance of the next row. */
#define ROW_COMES_S 0.07f

const struct ui_period *ui_leaderboard_period(uint8_t period)
{
    static const struct ui_period periods[RANK_PERIOD_COUNT] = {
        { TEXT_BOARD_DAY, TEXT_PLACE_DAY },
        { TEXT_BOARD_WEEK, TEXT_PLACE_WEEK },
        { TEXT_BOARD_EVER, TEXT_PLACE_EVER },
    };
    return &periods[period < RANK_PERIOD_COUNT ? period : RANK_EVER];
}

const char *ui_leaderboard_name(const struct ui_frame *frame, char out[TEXT_LINE_MAX])
{
    static const enum text_key levels[LEVEL_COUNT] = {
        [LEVEL_MASTER] = TEXT_LEVEL_MASTER,
        [LEVEL_NORMAL] = TEXT_LEVEL_NORMAL,
        [LEVEL_EASY] = TEXT_LEVEL_EASY,
    };
    const struct scene_leaderboard *const board = &frame->scene->leaderboard;
    const char *mode = ui_mode_name(frame->language, board->mode);
    CORE_ASSERT(board->level < LEVEL_COUNT);
    if (board->mode >= MODE_COUNT || !rules_of(board->mode)->has_levels) {
        return mode;
    }
    snprintf(out, TEXT_LINE_MAX, "%s %s", mode, ui_words(frame, levels[board->level]));
    return out;
}

float ui_leaderboard_in(const struct scene_leaderboard *board)
{
    return board->shown ? f_smoothstep(0.0f, COME_S, board->shown_s) *
                              f_smoothstep(0.0f, GO_S, board->left_s)
                        : 0.0f;
}

/* Draws the vermilion seal of a score whose round can be replayed to verify the score. */
void ui_genuine_seal(const struct ui_frame *frame, float x, float y, float size)
{
    const struct ui_text word = { .font = FONT_STALL,
                                  .size_px = 0.74f * size,
                                  .fill = 0xfff1ddffu };
    const struct ui_box box = { x - 0.5f * size, y - 0.5f * size, size, size };
    ui_panel(frame, UI_PANEL, box, 5.0f * frame->unit, 1.5f * frame->unit, 0xc92c1cffu,
             0xfff1ddb0u);
    ui_words_in(frame, box, word, ui_words(frame, TEXT_BOARD_SEAL));
}

float ui_score(const struct ui_frame *frame, struct ui_text digits, struct ui_text unit,
               float right, float y, float gap, uint32_t caught)
{
    const char *const words = ui_words(frame, TEXT_UNIT);
    const float digits_right = right - ui_text_width(unit, words) - gap;
    ui_text(frame->batch, unit, right, ui_text_middle(digits, y), words);
    ui_number_at(frame, digits, digits_right, y, caught);
    return digits_right;
}

static void row_at(const struct ui_frame *frame, const struct scene_row *row, uint32_t place,
                   struct ui_box box)
{
    CORE_ASSERT(place < SCENE_LEADERBOARD_ROWS);
    static const uint32_t medals[] = { 0xe2a92fffu, 0xa9b0baffu, 0xb9794affu };
    const float u = frame->unit, y = box.y + 0.5f * box.height;
    if (row->is_new) {
        /* The background of a newly added row has the colour of the player's ring. */
        const uint32_t colour = ui_player_colours[row->slot < POI_MAX ? row->slot : 0];
        const float glow = 0.30f + 0.20f * ui_pulse(frame->time_s, 1.2f);
        ui_panel(frame, UI_PANEL, box, 9.0f * u, 2.0f * u, ui_fade(colour, glow), colour);
    }
    /* The numbers of the places 1 to 3 are drawn on a medal of gold, silver or bronze. */
    const float x = box.x + 34.0f * u, radius = 19.0f * u;
    const bool has_medal = place < sizeof medals / sizeof *medals;
    if (has_medal) {
        ui_disc(frame, x, y, radius, 1.5f * u, medals[place], 0x5a3a20ffu);
    }
    ui_number_at(
        frame,
        ui_style(frame, FONT_STALL, 26.0f, 0.5f, has_medal ? UI_INK : UI_INK_SOFT, 1.8f * radius),
        x, y, place + 1u);
    ui_text_at(frame,
               ui_style(frame, FONT_STALL, 31.0f, 0.0f, row->name[0] ? UI_INK : 0x5a464880u,
                        box.width - 300.0f * u),
               box.x + 74.0f * u, y, row->name[0] ? row->name : "---");
    const float score_x =
        ui_score(frame, ui_style(frame, FONT_STALL, 33.0f, 1.0f, UI_INK, 90.0f * u),
                 ui_style(frame, FONT_STALL, 22.0f, 1.0f, UI_INK_SOFT, 0.0f),
                 box.x + box.width - 18.0f * u, y, 8.0f * u, row->caught);
    ui_fish_sign(frame, score_x - 132.0f * u, y, 52.0f * u);
    if (row->is_sealed) {
        ui_genuine_seal(frame, score_x - 192.0f * u, y, 30.0f * u);
    }
}

void ui_leaderboard(const struct ui_frame *frame, float top, float bottom)
{
    const struct scene_leaderboard *const board = &frame->scene->leaderboard;
    const float u = frame->unit, in = ui_leaderboard_in(board);
    char words[TEXT_LINE_MAX];
    if (in <= 0.0f) {
        return;
    }
    uint32_t rows = 0;
    while (rows < SCENE_LEADERBOARD_ROWS && board->row[rows].caught > 0) {
        rows++;
    }
    const uint32_t room = rows > ROWS_MIN ? rows : ROWS_MIN;
    const float head = 86.0f * u, foot = 14.0f * u;
    const float pitch = fminf(58.0f * u, (bottom - top - head - foot) / (float)room);
    const float height = head + foot + pitch * (float)room;
    const float width = fminf(760.0f * u, frame->width - 40.0f * u);
    const struct ui_box box = { 0.5f * (frame->width - width),
                                0.5f * (top + bottom - height) + 30.0f * u * (1.0f - in), width,
                                height };
    frame->batch->opacity = in;
    ui_card(frame, box);
    /* The heading is a text such as "Festival: today's best" in white on a band of dyed cloth. */
    const float inset = 12.0f * u;
    const struct ui_box band = { box.x + inset, box.y + inset, box.width - 2.0f * inset,
                                 62.0f * u };
    const float y = band.y + 0.5f * band.height;
    ui_panel(frame, UI_WAVES, band, 9.0f * u, 1.5f * u, UI_INDIGO, 0x0b1030ffu);
    ui_text_at(frame, ui_style(frame, FONT_STALL, 27.0f, 0.0f, UI_GOLD, 0.38f * band.width),
               band.x + 20.0f * u, y, ui_leaderboard_name(frame, words));
    ui_text_at(frame, ui_style(frame, FONT_STALL, 36.0f, 1.0f, UI_CREAM, 0.52f * band.width),
               band.x + band.width - 20.0f * u, y,
               ui_words(frame, ui_leaderboard_period(board->period)->title));
    for (uint32_t i = 0; i < rows; i++) {
        const float since_s = board->shown_s - ROW_COMES_S * (float)(rows - i);
        frame->batch->opacity = in * f_smoothstep(0.1f, 0.35f, since_s);
        row_at(frame, &board->row[i], i,
               (struct ui_box){ box.x + 16.0f * u, box.y + head + pitch * (float)i + 2.0f * u,
                                box.width - 32.0f * u, pitch - 4.0f * u });
    }
    frame->batch->opacity = 1.0f;
}

void ui_ranking(const struct ui_frame *frame)
{
    const float u = frame->unit;
    ui_leaderboard(frame, 24.0f * u, frame->height - 110.0f * u);
    ui_start_ribbon(frame, frame->height - 58.0f * u, TEXT_AGAIN);
}
