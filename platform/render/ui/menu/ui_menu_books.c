/* ui_menu_books.c -- draws the pages of the account books, which are the operator's counters:
 * earnings, plays, plays by hour, and faults. Also draws the operator's leaderboard page, with a
 * wooden board for each score, and the page of one score. */
#include <math.h>
#include <stdio.h>

#include "core/base/panic.h"
#include "core/game/accounting/audits.h"
#include "platform/render/ui/menu/ui_menu.h"
#include "platform/render/ui/ui_widgets.h"

#define RULE_PAINT 0xb5762f70u
#define BAR_PAINT 0x2b4c8cffu
#define NUMBER_SIZE 24u

/* A line of an account book shows a name, and a counter or the quotient of two counters. */
struct book_line {
    enum text_key name;
    /* `audit` is the index of the shown counter, or AUDIT_COUNT + a level for the number of rounds
     * at this level. `by` is the index of the counter by which the shown counter is divided. A `by`
     * of 0 means no division, because counter 0 is never a divisor. */
    uint8_t audit, by;
    /* Constant by which the value is divided in addition, for example 3600 to convert seconds to
     * hours. 0 means no division. */
    uint16_t over;
};

static void draw_book_rule(const struct ui_frame *frame, float x, float y, float width)
{
    const float u = frame->unit;
    ui_fill(frame, (struct ui_box){ x, y - u, width, 2.0f * u }, RULE_PAINT);
}

/* Draws a sheet of paper at one of two places on the canvas (ui_place_either()). Returns the box of
 * the sheet on the screen. */
static struct ui_box draw_book_sheet(const struct ui_frame *frame, struct layout_box wide,
                                     struct layout_box upright)
{
    const struct ui_box box = ui_place_either(frame, wide, upright);
    menu_paper(frame, box);
    return box;
}

/* Writes a count with separators, such as "1,234,567". */
static void write_count(char out[NUMBER_SIZE], uint32_t count)
{
    char digits[12];
    const int length = snprintf(digits, sizeof digits, "%u", count);
    int at = 0;
    for (int i = 0; i < length; i++) {
        if (i > 0 && (length - i) % 3 == 0) {
            out[at++] = ',';
        }
        out[at++] = digits[i];
    }
    out[at] = 0;
}

/* Draws the lines of an account book in `columns` columns. Each column is filled from top to
 * bottom. */
static void draw_book_lines(const struct ui_frame *frame, struct ui_box box, uint32_t columns,
                            const struct book_line *line, uint32_t count)
{
    CORE_ASSERT(columns > 0 && count > 0);
    const float u = frame->unit;
    const uint32_t rows = (count + columns - 1u) / columns;
    const uint32_t *const audit = frame->scene->menu.audit;
    const float pitch = fminf((box.height - 24.0f * u) / (float)rows, 76.0f * u);
    const float column = box.width / (float)columns, width = column - 56.0f * u;
    char words[NUMBER_SIZE];
    for (uint32_t i = 0; i < count; i++) {
        const float x = box.x + (float)(i / rows) * column + 28.0f * u;
        const float y = box.y + 12.0f * u + ((float)(i % rows) + 0.5f) * pitch;
        /* The value of a line is a count, a quotient with one decimal place, or a dash. A dash
         * means that the divisor is 0. */
        if (line[i].by != 0 && audit[line[i].by] == 0) {
            snprintf(words, NUMBER_SIZE, "-");
        } else if (line[i].by != 0 || line[i].over != 0) {
            const double by = line[i].by != 0 ? (double)audit[line[i].by] : 1.0;
            snprintf(words, NUMBER_SIZE, "%.1f",
                     (double)audit[line[i].audit] / by /
                         (line[i].over != 0 ? (double)line[i].over : 1.0));
        } else {
            write_count(words, line[i].audit < AUDIT_COUNT
                                   ? audit[line[i].audit]
                                   : audits_rounds_at(audit, line[i].audit - AUDIT_COUNT));
        }
        ui_label_at(frame, x, y, 0.62f * width, 25.0f, UI_INK_SOFT, line[i].name);
        ui_words_at(frame, x + width, y, 0.36f * width, 1.0f, ui_body(frame, 30.0f, UI_INK), words);
        if (i % rows + 1u < rows && i + 1u < count) {
            /* The last line of a column needs no separating rule, because the border of the paper
             * sheet is below this line. */
            draw_book_rule(frame, x, y + 0.5f * pitch, width);
        }
    }
}

/* ---- Pages of earnings and faults ----------------------------------------------------------- */

/* Draws a page with a single sheet, which has two columns on a wide screen. */
static void draw_book_page(const struct ui_frame *frame, const struct book_line *book,
                           uint32_t count)
{
    const struct ui_box sheet =
        draw_book_sheet(frame, canvas_box(100, 124, 1080, 464), canvas_box(27, 200, 800, 1010));
    draw_book_lines(frame, sheet, frame->is_upright ? 1u : 2u, book, count);
}

void menu_earnings(const struct ui_frame *frame)
{
    static const struct book_line book[] = {
        { TEXT_AUD_COINS_1, AUDIT_COINS_1, 0, 0 },
        { TEXT_AUD_COINS_2, AUDIT_COINS_2, 0, 0 },
        { TEXT_AUD_COINS_3, AUDIT_COINS_3, 0, 0 },
        { TEXT_AUD_UNITS, AUDIT_UNITS, 0, 0 },
        { TEXT_AUD_TEST_COINS, AUDIT_TEST_COINS, 0, 0 },
        { TEXT_AUD_TILTS, AUDIT_TILTS, 0, 0 },
        { TEXT_AUD_CREDITS_PAID, AUDIT_CREDITS_PAID, 0, 0 },
        { TEXT_AUD_CREDITS_BONUS, AUDIT_CREDITS_BONUS, 0, 0 },
        { TEXT_AUD_CREDITS_SERVICE, AUDIT_CREDITS_SERVICE, 0, 0 },
        { TEXT_AUD_REFUNDS, AUDIT_REFUNDS, 0, 0 },
        { TEXT_AUD_EXPIRED, AUDIT_EXPIRED, 0, 0 },
        { TEXT_AUD_TICKETS, AUDIT_TICKETS, 0, 0 },
        { TEXT_AUD_TICKETS_OUT, AUDIT_TICKETS_OUT, 0, 0 },
    };
    draw_book_page(frame, book, sizeof book / sizeof book[0]);
}

void menu_machine(const struct ui_frame *frame)
{
    static const struct book_line book[] = {
        { TEXT_AUD_BOOTS, AUDIT_BOOTS, 0, 0 },
        { TEXT_AUD_CRASHED, AUDIT_CRASHED_ROUNDS, 0, 0 },
        { TEXT_AUD_UP, AUDIT_UP_S, 0, 3600 },
        { TEXT_AUD_UP_MAX, AUDIT_UP_S_MAX, 0, 3600 },
        { TEXT_AUD_DROPPED, AUDIT_DROPPED_TICKS, 0, 0 },
        { TEXT_AUD_FAULTS, AUDIT_DEVICE_FAULTS, 0, 0 },
        { TEXT_AUD_RESETS, AUDIT_RESETS, 0, 0 },
        { TEXT_AUD_LOST_1, AUDIT_LOST_AGAIN, 0, 0 },
        { TEXT_AUD_LOST_2, AUDIT_LOST_AGAIN + 1, 0, 0 },
        { TEXT_AUD_LOST_3, AUDIT_LOST_AGAIN + 2, 0, 0 },
        { TEXT_AUD_LOST_4, AUDIT_LOST_AGAIN + 3, 0, 0 },
    };
    draw_book_page(frame, book, sizeof book / sizeof book[0]);
}

/* ---- Page of the numbers of plays ----------------------------------------------------------- */

/* Draws a table of the numbers of plays, with a row for each game mode and a column for each paper
 * grade. */
static void by_mode(const struct ui_frame *frame, struct ui_box box)
{
    static const enum text_key modes[MODE_COUNT] = { TEXT_FESTIVAL, TEXT_CHAMPIONSHIP,
                                                     TEXT_PRACTICE };
    const float u = frame->unit, head = 96.0f * u;
    const float pitch = (box.height - head - 12.0f * u) / (float)MODE_COUNT;
    const float first = box.x + 0.36f * box.width;
    const float column = (box.x + box.width - 24.0f * u - first) / (float)AUDIT_GRADES;
    const struct ui_text name = ui_body(frame, 24.0f, UI_INK_SOFT);
    const struct ui_text number = ui_body(frame, 22.0f, UI_INK); /* Style of the numbers in the
                                                                    table. A number of four digits
                                                                    fits in one column. */
    char words[TEXT_LINE_MAX];
    ui_words_at(frame, box.x + 0.5f * box.width, box.y + 28.0f * u, box.width - 40.0f * u, 0.5f,
                name, ui_words(frame, TEXT_AUD_BY_MODE));
    for (uint32_t grade = 0; grade < AUDIT_GRADES; grade++) {
        text_number(words, sizeof words, ui_words(frame, TEXT_VAL_GRADE), grade + SHEET_GRADE_MIN);
        ui_words_at(frame, first + ((float)grade + 1.0f) * column, box.y + 72.0f * u,
                    0.92f * column, 1.0f, name, words);
    }
    for (uint32_t mode = 0; mode < MODE_COUNT; mode++) {
        const float y = box.y + head + ((float)mode + 0.5f) * pitch;
        draw_book_rule(frame, box.x + 24.0f * u, y - 0.5f * pitch, box.width - 48.0f * u);
        ui_words_at(frame, box.x + 28.0f * u, y, 0.36f * box.width - 40.0f * u, 0.0f, name,
                    ui_words(frame, modes[mode]));
        for (uint32_t grade = 0; grade < AUDIT_GRADES; grade++) {
            write_count(words, frame->scene->menu.audit[AUDIT_PLAYS + mode * AUDIT_GRADES + grade]);
            ui_words_at(frame, first + ((float)grade + 1.0f) * column, y, 0.80f * column, 1.0f,
                        number, words);
        }
    }
}

void menu_plays(const struct ui_frame *frame)
{
    static const struct book_line book[] = {
        { TEXT_AUD_PLAYS_PAID, AUDIT_PLAYS_PAID, 0, 0 },
        { TEXT_AUD_PLAYS_SERVICE, AUDIT_PLAYS_SERVICE, 0, 0 },
        { TEXT_AUD_PLAYS_FREE, AUDIT_PLAYS_FREE, 0, 0 },
        { TEXT_AUD_ROUNDS_EASY, AUDIT_COUNT + LEVEL_EASY, 0, 0 },
        { TEXT_AUD_ROUNDS_NORMAL, AUDIT_COUNT + LEVEL_NORMAL, 0, 0 },
        { TEXT_AUD_ROUNDS_MASTER, AUDIT_COUNT + LEVEL_MASTER, 0, 0 },
        { TEXT_AUD_PLAYERS, AUDIT_PLAYERS, 0, 0 },
        { TEXT_AUD_CAUGHT, AUDIT_CAUGHT, 0, 0 },
        { TEXT_AUD_CATCH_MEAN, AUDIT_CAUGHT, AUDIT_PLAYERS, 0 },
        { TEXT_AUD_PAPERS, AUDIT_PAPERS, 0, 0 },
        { TEXT_AUD_PAPERS_TORN, AUDIT_PAPERS_TORN, 0, 0 },
        { TEXT_AUD_PAPER_MEAN, AUDIT_PAPER_LIFE_S, AUDIT_PAPERS_TORN, 0 },
        { TEXT_AUD_FOULS, AUDIT_FOULS, 0, 0 },
    };
    draw_book_lines(
        frame, draw_book_sheet(frame, canvas_box(40, 124, 560, 464), canvas_box(27, 200, 800, 640)),
        1u, book, sizeof book / sizeof book[0]);
    by_mode(frame,
            draw_book_sheet(frame, canvas_box(620, 124, 620, 464), canvas_box(27, 860, 800, 350)));
}

/* ---- Page of plays by hour and weekday ------------------------------------------------------ */

/* Draws a bar chart of `count` counters, beginning with counter `first`. The highest bar fills the
 * height of the chart. The label below a bar is the name in `names`. If `names` is null, the label
 * is the bar's number, and only every third bar has a label, because 24 labels would be too small
 * to read. */
static void bars(const struct ui_frame *frame, struct ui_box box, enum text_key title,
                 uint32_t first, uint32_t count, const enum text_key *names)
{
    CORE_ASSERT(count > 0);
    const float u = frame->unit, left = box.x + 24.0f * u;
    const float pitch = (box.width - 48.0f * u) / (float)count;
    const float base = box.y + box.height - 44.0f * u, room = box.height - 124.0f * u;
    const struct ui_text label = ui_body(frame, 22.0f, UI_INK_SOFT);
    const uint32_t *const audit = frame->scene->menu.audit + first;
    uint32_t most = 1;
    bool has_value = false;
    char words[NUMBER_SIZE];
    for (uint32_t i = 0; i < count; i++) {
        most = audit[i] > most ? audit[i] : most;
    }
    ui_label_at(frame, left, box.y + 28.0f * u, 0.6f * box.width, 24.0f, UI_INK_SOFT, title);
    for (uint32_t i = 0; i < count; i++) {
        const float x = left + ((float)i + 0.5f) * pitch;
        const float height = room * (float)audit[i] / (float)most;
        if (audit[i] > 0) {
            ui_panel(frame, UI_PANEL,
                     (struct ui_box){ x - 0.34f * pitch, base - height, 0.68f * pitch, height },
                     3.0f * u, 0.0f, BAR_PAINT, 0);
        }
        /* The value of a bar is written only at the first of the highest bars. */
        if (audit[i] == most && !has_value) {
            has_value = true;
            write_count(words, audit[i]);
            ui_words_at(frame, x, base - height - 18.0f * u, 3.0f * pitch, 0.5f,
                        ui_body(frame, 22.0f, UI_INK), words);
        }
        words[0] = '\0';
        if (i % 3u == 0) {
            snprintf(words, sizeof words, "%u", i);
        }
        ui_words_at(frame, x, base + 22.0f * u, 1.6f * pitch, 0.5f, label,
                    names ? ui_words(frame, names[i]) : words);
    }
    draw_book_rule(frame, left, base, box.width - 48.0f * u);
}

void menu_hours(const struct ui_frame *frame)
{
    static const enum text_key days[7] = { TEXT_DAY_MON, TEXT_DAY_TUE, TEXT_DAY_WED, TEXT_DAY_THU,
                                           TEXT_DAY_FRI, TEXT_DAY_SAT, TEXT_DAY_SUN };
    const struct ui_box by_hour =
        draw_book_sheet(frame, canvas_box(40, 124, 720, 424), canvas_box(27, 200, 800, 490));
    const struct ui_box by_day =
        draw_book_sheet(frame, canvas_box(780, 124, 460, 424), canvas_box(27, 710, 800, 440));
    bars(frame, by_hour, TEXT_AUD_BY_HOUR, AUDIT_HOUR, 24, NULL);
    bars(frame, by_day, TEXT_AUD_BY_WEEKDAY, AUDIT_WEEKDAY, 7, days);
    menu_note(frame, canvas_box(60, 558, 1160, 36), canvas_box(27, 1170, 800, 40),
              ui_body(frame, 22.0f, MENU_NOTE), ui_words(frame, TEXT_AUD_NO_CLOCK));
}

/* ---- Leaderboard page, and the page of one score --------------------------------------------- */

/* Draws the name of the shown leaderboard beside the page's title. On an upright screen the name is
 * below the title. */
static void board_words(const struct ui_frame *frame)
{
    const struct scene_leaderboard *const board = &frame->scene->leaderboard;
    char words[TEXT_LINE_MAX];
    menu_note(frame, canvas_box(60, 30, 250, 36), canvas_box(127, 152, 250, 44),
              ui_style(frame, FONT_STALL, 27.0f, 0.0f, UI_GOLD, 0.0f),
              ui_leaderboard_name(frame, words));
    menu_note(frame, canvas_box(60, 68, 250, 40), canvas_box(397, 152, 330, 44),
              ui_style(frame, FONT_STALL, 31.0f, 0.0f, UI_CREAM, 0.0f),
              ui_words(frame, ui_leaderboard_period(board->period)->title));
}

/* Draws a score such as "3.  きんぎょ  12 fish" on a wooden board. */
static void score_words(const struct ui_frame *frame, uint32_t index, struct ui_box box)
{
    CORE_ASSERT(index < SCENE_LEADERBOARD_ROWS);
    const struct scene_row *const row = &frame->scene->leaderboard.row[index];
    const float u = frame->unit, y = box.y + 0.5f * box.height;
    ui_number_at(frame, ui_style(frame, FONT_STALL, 28.0f, 1.0f, MENU_INK_SOFT, 0.0f),
                 box.x + 70.0f * u, y, index + 1u);
    ui_text_at(frame, ui_style(frame, FONT_STALL, 32.0f, 0.0f, MENU_INK, box.width - 320.0f * u),
               box.x + 100.0f * u, y, row->name[0] ? row->name : "---");
    ui_score(frame, ui_style(frame, FONT_STALL, 32.0f, 1.0f, MENU_INK, 0.0f),
             ui_style(frame, FONT_STALL, 22.0f, 1.0f, MENU_INK_SOFT, 0.0f),
             box.x + box.width - 24.0f * u, y, 10.0f * u, row->caught);
    if (row->is_sealed) {
        ui_genuine_seal(frame, box.x + box.width - 190.0f * u, y, 30.0f * u);
    }
}

void menu_ranking(const struct ui_frame *frame)
{
    const uint16_t tags = frame->scene->menu.tags;
    board_words(frame);
    for (uint32_t row = 0; row < SCENE_LEADERBOARD_ROWS; row++) {
        if (tags >> row & 1u) {
            score_words(frame, row, menu_tag_board(frame, row));
        }
    }
    if (!(tags & 1u)) {
        menu_note(frame, canvas_box(160, 320, 960, 60), canvas_box(60, 600, 734, 60),
                  ui_body(frame, 30.0f, MENU_NOTE), ui_words(frame, TEXT_RANKING_EMPTY));
    }
}

/* Draws the page of one score. The tags below the score, which other functions draw, are actions
 * that the operator can select. */
void menu_score(const struct ui_frame *frame)
{
    const float u = frame->unit;
    const struct ui_box box =
        ui_place_either(frame, canvas_box(190, 134, 900, 72), canvas_box(27, 260, 800, 110));
    board_words(frame);
    ui_panel(frame, UI_WASHI, box, 8.0f * u, 1.5f * u, UI_WASHI_WHITE, 0xb5762fffu);
    score_words(frame, frame->scene->menu.score, box);
}
