/* ui_menu_books.c -- draws the pages of the account books, which are the operator's counters:
 * earnings, plays, plays by hour, and faults. Also draws the operator's leaderboard page, with a
 * wooden board for each score, and the page of one score. */
#include <math.h>
#include <stdio.h>

#include "core/base/panic.h"
#include "core/game/accounting/audits.h"
#include "core/game/ranking/ranking.h"
#include "platform/render/ui/menu/ui_menu.h"
#include "platform/render/ui/ui_widgets.h"

#define RULE_PAINT 0xb5762f70u
#define BAR_PAINT 0x2b4c8cffu
#define NUMBER_SIZE 24u

/* A line of an account book shows a name, and a counter or the quotient of two counters. */
struct book_line {
    enum text_key name;
    uint8_t audit, by; /* `audit` is the index of the shown counter. `by` is the index of the
                          counter by which the shown counter is divided. A `by` of 0 means no
                          division, because counter 0 is never a divisor. */
    uint16_t over;     /* Additional constant divisor, for example 3600 to convert seconds to hours.
                          0 means no division. */
};

/* ---- Sheets of paper and numbers ------------------------------------------------------------ */

static struct ui_box draw_book_sheet(const struct menu_view *view, struct layout_box place)
{
    const float u = view->frame.unit;
    const struct ui_box box = menu_place(view, place);
    ui_panel(&view->frame, UI_WASHI, box, 10.0f * u, 2.0f * u, UI_WASHI_WHITE, 0xb5762fffu);
    return box;
}

static void draw_book_rule(const struct menu_view *view, float x, float y, float width)
{
    const float u = view->frame.unit;
    ui_panel(&view->frame, UI_PANEL, (struct ui_box){ x, y - u, width, 2.0f * u }, 0.0f, 0.0f,
             RULE_PAINT, 0);
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
static void draw_book_lines(const struct menu_view *view, struct ui_box box, uint32_t columns,
                            const struct book_line *line, uint32_t count)
{
    CORE_ASSERT(columns > 0 && count > 0);
    const float u = view->frame.unit;
    const uint32_t rows = (count + columns - 1u) / columns;
    const float pitch = fminf((box.height - 24.0f * u) / (float)rows, 76.0f * u);
    const float column = box.width / (float)columns;
    const struct ui_text name = menu_style(view, 25.0f, UI_INK_SOFT);
    const struct ui_text number = menu_style(view, 30.0f, UI_INK);
    char words[NUMBER_SIZE];
    for (uint32_t i = 0; i < count; i++) {
        const float x = box.x + (float)(i / rows) * column + 28.0f * u;
        const float y = box.y + 12.0f * u + ((float)(i % rows) + 0.5f) * pitch;
        const float width = column - 56.0f * u;
        /* The value of a line is a count, a quotient with one decimal place, or a dash. A dash
         * means that the divisor is 0. */
        const uint32_t *audit = view->menu->audit;
        if (line[i].by != 0 && audit[line[i].by] == 0) {
            snprintf(words, NUMBER_SIZE, "-");
        } else if (line[i].by != 0 || line[i].over != 0) {
            const double by = line[i].by != 0 ? (double)audit[line[i].by] : 1.0;
            snprintf(words, NUMBER_SIZE, "%.1f",
                     (double)audit[line[i].audit] / by /
                         (line[i].over != 0 ? (double)line[i].over : 1.0));
        } else {
            write_count(words, audit[line[i].audit]);
        }
        menu_words_at(view, x, y, 0.62f * width, 0.0f, &name, menu_text(view, line[i].name));
        menu_words_at(view, x + width, y, 0.36f * width, 1.0f, &number, words);
        if (i % rows + 1u < rows && i + 1u < count) {
            /* The last line of a column needs no separating rule, because the border of the paper
             * sheet is below this line. */
            draw_book_rule(view, x, y + 0.5f * pitch, width);
        }
    }
}

/* ---- Pages of earnings and faults ----------------------------------------------------------- */

static struct layout_box whole_sheet_place(const struct menu_view *view)
{
    return view->menu->upright ? (struct layout_box){ 27.0f, 200.0f, 800.0f, 1010.0f }
                               : (struct layout_box){ 100.0f, 124.0f, 1080.0f, 464.0f };
}

void menu_earnings(const struct menu_view *view)
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
    draw_book_lines(view, draw_book_sheet(view, whole_sheet_place(view)),
                    view->menu->upright ? 1u : 2u, book, sizeof book / sizeof book[0]);
}

void menu_machine(const struct menu_view *view)
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
    draw_book_lines(view, draw_book_sheet(view, whole_sheet_place(view)),
                    view->menu->upright ? 1u : 2u, book, sizeof book / sizeof book[0]);
}

/* ---- Page of the numbers of plays ----------------------------------------------------------- */

/* Draws a table of the numbers of plays, with a row for each game mode and a column for each paper
 * grade. */
static void by_mode(const struct menu_view *view, struct ui_box box)
{
    static const enum text_key modes[MODE_COUNT] = { TEXT_FESTIVAL, TEXT_CHAMPIONSHIP,
                                                     TEXT_PRACTICE };
    const float u = view->frame.unit, head = 96.0f * u;
    const float pitch = (box.height - head - 12.0f * u) / (float)MODE_COUNT;
    const float first = box.x + 0.36f * box.width;
    const float column = (box.x + box.width - 24.0f * u - first) / (float)AUDIT_GRADES;
    const struct ui_text name = menu_style(view, 24.0f, UI_INK_SOFT);
    const struct ui_text number = menu_style(view, 22.0f, UI_INK); /* Style of the numbers in the
                                                                      table. A number of four digits
                                                                      fits in one column. */
    char words[TEXT_LINE_MAX];
    menu_words_at(view, box.x + 0.5f * box.width, box.y + 28.0f * u, box.width - 40.0f * u, 0.5f,
                  &name, menu_text(view, TEXT_AUD_BY_MODE));
    for (uint32_t grade = 0; grade < AUDIT_GRADES; grade++) {
        text_number(words, sizeof words, menu_text(view, TEXT_VAL_GRADE), grade + SHEET_GRADE_MIN);
        menu_words_at(view, first + ((float)grade + 1.0f) * column, box.y + 72.0f * u,
                      0.92f * column, 1.0f, &name, words);
    }
    for (uint32_t mode = 0; mode < MODE_COUNT; mode++) {
        const float y = box.y + head + ((float)mode + 0.5f) * pitch;
        draw_book_rule(view, box.x + 24.0f * u, y - 0.5f * pitch, box.width - 48.0f * u);
        menu_words_at(view, box.x + 28.0f * u, y, 0.36f * box.width - 40.0f * u, 0.0f, &name,
                      menu_text(view, modes[mode]));
        for (uint32_t grade = 0; grade < AUDIT_GRADES; grade++) {
            write_count(words, view->menu->audit[AUDIT_PLAYS + mode * AUDIT_GRADES + grade]);
            menu_words_at(view, first + ((float)grade + 1.0f) * column, y, 0.80f * column, 1.0f,
                          &number, words);
        }
    }
}

void menu_plays(const struct menu_view *view)
{
    static const struct book_line book[] = {
        { TEXT_AUD_PLAYS_PAID, AUDIT_PLAYS_PAID, 0, 0 },
        { TEXT_AUD_PLAYS_SERVICE, AUDIT_PLAYS_SERVICE, 0, 0 },
        { TEXT_AUD_PLAYS_FREE, AUDIT_PLAYS_FREE, 0, 0 },
        { TEXT_AUD_PLAYERS, AUDIT_PLAYERS, 0, 0 },
        { TEXT_AUD_CAUGHT, AUDIT_CAUGHT, 0, 0 },
        { TEXT_AUD_CATCH_MEAN, AUDIT_CAUGHT, AUDIT_PLAYERS, 0 },
        { TEXT_AUD_PAPERS, AUDIT_PAPERS, 0, 0 },
        { TEXT_AUD_PAPERS_TORN, AUDIT_PAPERS_TORN, 0, 0 },
        { TEXT_AUD_PAPER_MEAN, AUDIT_PAPER_LIFE_S, AUDIT_PAPERS_TORN, 0 },
        { TEXT_AUD_FOULS, AUDIT_FOULS, 0, 0 },
    };
    const uint32_t count = sizeof book / sizeof book[0];
    if (view->menu->upright) {
        draw_book_lines(view,
                        draw_book_sheet(view, (struct layout_box){ 27.0f, 200.0f, 800.0f, 640.0f }),
                        1u, book, count);
        by_mode(view, draw_book_sheet(view, (struct layout_box){ 27.0f, 860.0f, 800.0f, 350.0f }));
    } else {
        draw_book_lines(view,
                        draw_book_sheet(view, (struct layout_box){ 40.0f, 124.0f, 560.0f, 464.0f }),
                        1u, book, count);
        by_mode(view, draw_book_sheet(view, (struct layout_box){ 620.0f, 124.0f, 620.0f, 464.0f }));
    }
}

/* ---- Page of plays by hour and weekday ------------------------------------------------------ */

/* Draws a bar chart with a name below each bar. The highest bar fills the height of the chart. */
static void bars(const struct menu_view *view, struct ui_box box, enum text_key title,
                 uint32_t first, uint32_t count,
                 void (*name)(const struct menu_view *view, uint32_t index, char *out,
                              size_t out_size))
{
    CORE_ASSERT(count > 0);
    const float u = view->frame.unit, left = box.x + 24.0f * u;
    const float pitch = (box.width - 48.0f * u) / (float)count;
    const float base = box.y + box.height - 44.0f * u, room = box.height - 124.0f * u;
    const struct ui_text heading = menu_style(view, 24.0f, UI_INK_SOFT);
    const struct ui_text label = menu_style(view, 22.0f, UI_INK_SOFT);
    const struct ui_text top = menu_style(view, 22.0f, UI_INK);
    uint32_t most = 1;
    char words[TEXT_LINE_MAX];
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t plays = view->menu->audit[first + i];
        most = plays > most ? plays : most;
    }
    menu_words_at(view, left, box.y + 28.0f * u, 0.6f * box.width, 0.0f, &heading,
                  menu_text(view, title));
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t plays = view->menu->audit[first + i];
        const float x = left + ((float)i + 0.5f) * pitch;
        const float height = room * (float)plays / (float)most;
        if (plays > 0) {
            ui_panel(&view->frame, UI_PANEL,
                     (struct ui_box){ x - 0.34f * pitch, base - height, 0.68f * pitch, height },
                     3.0f * u, 0.0f, BAR_PAINT, 0);
        }
        if (plays == most) { /* Only the highest bars have their value written as a number. */
            write_count(words, plays);
            menu_words_at(view, x, base - height - 18.0f * u, 3.0f * pitch, 0.5f, &top, words);
        }
        name(view, i, words, sizeof words);
        menu_words_at(view, x, base + 22.0f * u, 1.6f * pitch, 0.5f, &label, words);
    }
    draw_book_rule(view, left, base, box.width - 48.0f * u);
}

/* Writes the label of every third hour only, because 24 labels would be too small to read. */
static void name_hour(const struct menu_view *view, uint32_t index, char *out, size_t out_size)
{
    (void)view;
    out[0] = 0;
    if (index % 3u == 0) {
        snprintf(out, out_size, "%u", index);
    }
}

static void name_day(const struct menu_view *view, uint32_t index, char *out, size_t out_size)
{
    static const enum text_key days[7] = { TEXT_DAY_MON, TEXT_DAY_TUE, TEXT_DAY_WED, TEXT_DAY_THU,
                                           TEXT_DAY_FRI, TEXT_DAY_SAT, TEXT_DAY_SUN };
    snprintf(out, out_size, "%s", menu_text(view, days[index]));
}

void menu_hours(const struct menu_view *view)
{
    const int upright = view->menu->upright;
    const struct ui_box hours =
        draw_book_sheet(view, upright ? (struct layout_box){ 27.0f, 200.0f, 800.0f, 490.0f }
                                      : (struct layout_box){ 40.0f, 124.0f, 720.0f, 424.0f });
    const struct ui_box days =
        draw_book_sheet(view, upright ? (struct layout_box){ 27.0f, 710.0f, 800.0f, 440.0f }
                                      : (struct layout_box){ 780.0f, 124.0f, 460.0f, 424.0f });
    const struct ui_text style = menu_style(view, 22.0f, 0xc9d2eeffu);
    bars(view, hours, TEXT_AUD_BY_HOUR, AUDIT_HOUR, 24, name_hour);
    bars(view, days, TEXT_AUD_BY_WEEKDAY, AUDIT_WEEKDAY, 7, name_day);
    ui_words_in(&view->frame,
                menu_place(view, upright ? (struct layout_box){ 27.0f, 1170.0f, 800.0f, 40.0f }
                                         : (struct layout_box){ 60.0f, 558.0f, 1160.0f, 36.0f }),
                &style, menu_text(view, TEXT_AUD_NO_CLOCK));
}

/* ---- Leaderboard page, and the page of one score --------------------------------------------- */

/* Draws the name of the shown leaderboard beside the page's title. On an upright screen the name is
 * below the title. */
static void board_words(const struct menu_view *view)
{
    const int upright = view->menu->upright;
    const struct scene_leaderboard *board = &view->scene->leaderboard;
    const struct ui_text mode = ui_style(&view->frame, FONT_STALL, 27.0f, 0.0f, UI_GOLD, 0.0f);
    const struct ui_text period = ui_style(&view->frame, FONT_STALL, 31.0f, 0.0f, MENU_CREAM, 0.0f);
    ui_words_in(&view->frame,
                menu_place(view, upright ? (struct layout_box){ 127.0f, 152.0f, 250.0f, 44.0f }
                                         : (struct layout_box){ 60.0f, 30.0f, 250.0f, 36.0f }),
                &mode, ui_mode_name(view->frame.language, board->mode));
    ui_words_in(&view->frame,
                menu_place(view, upright ? (struct layout_box){ 397.0f, 152.0f, 330.0f, 44.0f }
                                         : (struct layout_box){ 60.0f, 68.0f, 250.0f, 40.0f }),
                &period, menu_text(view, ui_leaderboard_key(board->period)));
}

/* Draws a score such as "3.  きんぎょ  12 fish" on a wooden board. */
static void score_words(const struct menu_view *view, uint32_t index, struct ui_box box)
{
    CORE_ASSERT(index < SCENE_LEADERBOARD_ROWS);
    const struct scene_row *row = &view->scene->leaderboard.row[index];
    const float u = view->frame.unit, y = box.y + 0.5f * box.height;
    const struct ui_text place =
        ui_style(&view->frame, FONT_STALL, 28.0f, 1.0f, MENU_INK_SOFT, 0.0f);
    const struct ui_text name =
        ui_style(&view->frame, FONT_STALL, 32.0f, 0.0f, MENU_INK, box.width - 320.0f * u);
    const struct ui_text count = ui_style(&view->frame, FONT_STALL, 32.0f, 1.0f, MENU_INK, 0.0f);
    const struct ui_text unit =
        ui_style(&view->frame, FONT_STALL, 22.0f, 1.0f, MENU_INK_SOFT, 0.0f);
    char number[12];
    text_number(number, sizeof number, "{}", index + 1u);
    ui_text_at(&view->frame, &place, box.x + 70.0f * u, y, number);
    ui_text_at(&view->frame, &name, box.x + 100.0f * u, y, row->name[0] ? row->name : "---");
    const float right = box.x + box.width - 24.0f * u, baseline = ui_text_middle(&count, y);
    const char *fish = menu_text(view, TEXT_UNIT);
    text_number(number, sizeof number, "{}", row->caught);
    ui_text(view->frame.batch, &unit, right, baseline, fish);
    ui_text(view->frame.batch, &count, right - ui_text_width(&unit, fish) - 10.0f * u, baseline,
            number);
    if (row->is_sealed) {
        ui_genuine_seal(&view->frame, box.x + box.width - 190.0f * u, y, 30.0f * u);
    }
}

void menu_ranking(const struct menu_view *view)
{
    board_words(view);
    for (uint32_t row = 0; row < SCENE_LEADERBOARD_ROWS; row++) {
        if (view->menu->tags >> row & 1u) {
            score_words(view, row, menu_tag_board(view, row));
        }
    }
    if (!(view->menu->tags & 1u)) {
        const int upright = view->menu->upright;
        const struct ui_text style = menu_style(view, 30.0f, 0xc9d2eeffu);
        ui_words_in(&view->frame,
                    menu_place(view, upright
                                         ? (struct layout_box){ 60.0f, 600.0f, 734.0f, 60.0f }
                                         : (struct layout_box){ 160.0f, 320.0f, 960.0f, 60.0f }),
                    &style, menu_text(view, TEXT_RANKING_NOBODY));
    }
}

/* Draws the page of one score. The tags below the score are actions that the operator can
 * select. */
void menu_score(const struct menu_view *view)
{
    const int upright = view->menu->upright;
    const float u = view->frame.unit;
    const struct ui_box box =
        menu_place(view, upright ? (struct layout_box){ 27.0f, 260.0f, 800.0f, 110.0f }
                                 : (struct layout_box){ 190.0f, 134.0f, 900.0f, 72.0f });
    board_words(view);
    ui_panel(&view->frame, UI_WASHI, box, 8.0f * u, 1.5f * u, UI_WASHI_WHITE, 0xb5762fffu);
    score_words(view, view->menu->score, box);
}
