/* ui_menu_self.c -- draws the self-test page. A row for each check shows the result and, if the
 * check failed, the remedy. A summary of all checks follows the rows. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/game/menu/menu.h"
#include "platform/render/ui/menu/ui_menu.h"

#define GOOD_PAINT 0x17754effu
#define BAD_PAINT 0xb3261effu
#define ASK_PAINT 0xa85a12ffu
#define ROW_LINES 2u
#define ROW_FILL 0.88f /* Letter height as a fraction of the height of a text line. */

struct places {
    uint32_t columns, rows; /* Number of columns (`columns`) and number of rows (`rows`) of the list
                               of checks. Each column is filled from top to bottom. */
    float x, y, width, height, gap, pitch;
    float name_width;
    struct layout_box verdict;
};

static const struct places wide = {
    .columns = 2,
    .rows = 7,
    .x = 40.0f,
    .y = 116.0f,
    .width = 592.0f,
    .height = 51.0f,
    .gap = 16.0f,
    .pitch = 54.0f,
    .name_width = 160.0f,
    .verdict = { 40.0f, 498.0f, 1200.0f, 96.0f },
};
static const struct places upright_places = {
    .columns = 1,
    .rows = 14,
    .x = 27.0f,
    .y = 176.0f,
    .width = 800.0f,
    .height = 62.0f,
    .gap = 0.0f,
    .pitch = 67.0f,
    .name_width = 200.0f,
    .verdict = { 27.0f, 1122.0f, 800.0f, 118.0f },
};
_Static_assert(SELF_CHECKS == 14u, "both sheets have a row for each check");

/* A text key, and the number that replaces {} in the text. */
struct said {
    enum text_key key;
    uint32_t number;
};

/* ---- Texts of the checks -------------------------------------------------------------------- */

static const enum text_key names[SELF_CHECKS] = {
    [SELF_STORE] = TEXT_CHECK_STORE,     [SELF_BACKUP] = TEXT_CHECK_BACKUP,
    [SELF_DATA] = TEXT_CHECK_DATA,       [SELF_ROOM] = TEXT_CHECK_ROOM,
    [SELF_FILES] = TEXT_CHECK_FILES,     [SELF_CLOCK] = TEXT_CHECK_CLOCK,
    [SELF_HEAT] = TEXT_CHECK_HEAT,       [SELF_WATCHDOG] = TEXT_CHECK_WATCHDOG,
    [SELF_DISPLAY] = TEXT_CHECK_DISPLAY, [SELF_SOUND] = TEXT_CHECK_SOUND,
    [SELF_LAMP] = TEXT_CHECK_LAMP,       [SELF_BUTTONS] = TEXT_CHECK_BUTTONS,
    [SELF_COINS] = TEXT_CHECK_COINS,     [SELF_POIS] = TEXT_CHECK_POIS,
};

/* Texts of each check in each state, for texts without a number. 0 means that figures_say() returns
 * the text, or that the check never has the state. */
static const enum text_key plain[SELF_CHECKS][SELF_STATES] = {
    [SELF_STORE] = { [SELF_GOOD] = TEXT_CHECK_STORE_GOOD,
                     [SELF_LOOK] = TEXT_CHECK_STORE_LOOK,
                     [SELF_BAD] = TEXT_CHECK_STORE_BAD },
    [SELF_FILES] = { [SELF_GOOD] = TEXT_CHECK_FILES_GOOD, [SELF_BAD] = TEXT_CHECK_FILES_BAD },
    [SELF_WATCHDOG] = { [SELF_GOOD] = TEXT_CHECK_WATCHDOG_GOOD,
                        [SELF_LOOK] = TEXT_CHECK_WATCHDOG_LOOK,
                        [SELF_BAD] = TEXT_CHECK_WATCHDOG_BAD },
    [SELF_SOUND] = { [SELF_GOOD] = TEXT_CHECK_SOUND_GOOD,
                     [SELF_ASKS] = TEXT_CHECK_SOUND_ASK,
                     [SELF_BAD] = TEXT_CHECK_SOUND_BAD },
    [SELF_LAMP] = { [SELF_ASKS] = TEXT_CHECK_LAMP_ASK, [SELF_BAD] = TEXT_CHECK_LAMP_BAD },
    [SELF_BUTTONS] = { [SELF_GOOD] = TEXT_CHECK_BUTTONS_GOOD,
                       [SELF_ASKS] = TEXT_CHECK_BUTTONS_ASK },
    [SELF_COINS] = { [SELF_ASKS] = TEXT_CHECK_COINS_ASK },
    [SELF_POIS] = { [SELF_GOOD] = TEXT_CHECK_POIS_GOOD,
                    [SELF_ASKS] = TEXT_CHECK_POIS_ASK,
                    [SELF_BAD] = TEXT_CHECK_POIS_BAD },
};

/* Returns the text of a check whose text contains a number. */
static struct said figures_say(const struct menu_view *view, uint32_t check, uint8_t state)
{
    const struct scene_machine *machine = &view->devices->machine;
    switch (check) {
    case SELF_BACKUP: {
        const uint32_t minutes = machine->backup_min;
        return state == SELF_GOOD    ? (struct said){ TEXT_CHECK_BACKUP_GOOD, minutes }
               : machine->has_backup ? (struct said){ TEXT_CHECK_BACKUP_LOOK, minutes / 60u }
                                     : (struct said){ TEXT_CHECK_BACKUP_NONE, 0 };
    }
    case SELF_DATA: {
        static const enum text_key keys[] = {
            [KEEPS_UNKNOWN] = TEXT_CHECK_SILENT,     [KEEPS_PROVEN] = TEXT_CHECK_DATA_GOOD,
            [KEEPS_FOLDER] = TEXT_CHECK_DATA_FOLDER, [KEEPS_MEMORY] = TEXT_CHECK_DATA_MEMORY,
            [KEEPS_NOT] = TEXT_CHECK_DATA_BAD,       [KEEPS_NOWHERE] = TEXT_CHECK_DATA_NOWHERE,
        };
        return (struct said){
            keys[machine->keeps <= KEEPS_NOWHERE ? machine->keeps : (uint8_t)KEEPS_UNKNOWN], 0
        };
    }
    case SELF_ROOM:
        return state != SELF_GOOD ? (struct said){ TEXT_CHECK_ROOM_LOOK, machine->room_mib }
               : machine->room_mib < 10240u
                   ? (struct said){ TEXT_CHECK_ROOM_GOOD, machine->room_mib }
                   : (struct said){ TEXT_CHECK_ROOM_AMPLE, machine->room_mib / 1024u };
    case SELF_HEAT: {
        const uint32_t margin_c =
            machine->heat_margin_c > 0 ? (uint32_t)machine->heat_margin_c : 0u;
        return !machine->has_heat   ? (struct said){ TEXT_CHECK_HEAT_NONE, 0 }
               : state == SELF_GOOD ? (struct said){ TEXT_CHECK_HEAT_GOOD, margin_c }
               : state == SELF_LOOK ? (struct said){ TEXT_CHECK_HEAT_LOOK, margin_c }
                                    : (struct said){ TEXT_CHECK_HEAT_BAD, 0 };
    }
    case SELF_CLOCK:
        return (struct said){ machine->is_clock_back ? TEXT_CHECK_CLOCK_BACK
                                                     : TEXT_CHECK_CLOCK_LOOK,
                              0 };
    case SELF_DISPLAY:
        return (struct said){ state == SELF_GOOD ? TEXT_CHECK_DISPLAY_GOOD : TEXT_CHECK_DISPLAY_BAD,
                              view->devices->frames_a_second };
    case SELF_LAMP:
        return (struct said){ view->menu->self.moved == SELF_UNSAID ? TEXT_CHECK_LAMP_NONE
                                                                    : TEXT_CHECK_LAMP_GOOD,
                              0 };
    default:
        return (struct said){ view->menu->test_coins > 0 ? TEXT_CHECK_COINS_GOOD
                                                         : TEXT_CHECK_COINS_FREE,
                              view->menu->test_coins };
    }
}

static void row_words(const struct menu_view *view, uint32_t check, uint8_t state, char *out,
                      size_t out_size)
{
    CORE_ASSERT(check < SELF_CHECKS && state < SELF_STATES);
    const enum text_key key = plain[check][state];
    const int is_asked_of_the_machine =
        check >= SELF_BACKUP && check <= SELF_HEAT && check != SELF_FILES && check != SELF_CLOCK;
    const int is_silent = is_asked_of_the_machine && !view->devices->machine.has_looked;
    if (state == SELF_WAITS || is_silent) {
        snprintf(out, out_size, "%s",
                 menu_text(view, state == SELF_WAITS ? TEXT_CHECK_WAITS : TEXT_CHECK_SILENT));
    } else if (check == SELF_CLOCK && state == SELF_GOOD) {
        /* The row shows the date and the time of the clock, such as "2026-08-15 18:30", so that the
         * operator can compare the clock with the true time. */
        static const uint8_t months[12] = { 31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31 };
        uint32_t year = 2000, month = 0, day = view->menu->self.day, length = 366;
        for (; day >= length; length = year % 4u == 0 ? 366u : 365u) {
            /* Every fourth year is a leap year until 2099. */
            day -= length;
            year++;
        }
        const uint32_t is_leap = length == 366u;
        while (day >= months[month] + (month == 1u ? is_leap : 0u)) {
            day -= months[month] + (month == 1u ? is_leap : 0u);
            month++;
        }
        snprintf(out, out_size, "%u-%02u-%02u %02u:%02u", year, month + 1u, day + 1u,
                 view->menu->self.minute / 60u, view->menu->self.minute % 60u);
    } else if (key) {
        snprintf(out, out_size, "%s", menu_text(view, key));
    } else {
        const struct said said = figures_say(view, check, state);
        text_number(out, out_size, menu_text(view, said.key), said.number);
    }
}

/* ---- Rows, one for each check --------------------------------------------------------------- */

static uint32_t ui_menu_self_paint_of(uint8_t state)
{
    return state == SELF_GOOD ? GOOD_PAINT : state == SELF_BAD ? BAD_PAINT : ASK_PAINT;
}

/* Draws the sign of a check. A tick means passed, a cross means failed, and an exclamation mark
 * means a warning. A question mark means that the operator must do the check. Three dots mean that
 * the check has no result yet. */
static void self_test_draw_mark(const struct menu_view *view, float x, float y, uint8_t state)
{
    const float u = view->frame.unit, r = 13.0f * u;
    const float low[2] = { x - 0.3f * r, y + 0.8f * r };
    const float left[2] = { x - r, y + (state == SELF_GOOD ? 0.1f : -0.9f) * r };
    const float right[2] = { x + r, y - 0.9f * r }, down[2] = { x - r, y + 0.9f * r };
    const float end[2] = { x + r, y + 0.9f * r };
    const struct ui_text sign = menu_style(view, 36.0f, ASK_PAINT);
    if (state == SELF_GOOD) {
        ui_segment(view->frame.batch, left, low, 5.0f * u, GOOD_PAINT);
        ui_segment(view->frame.batch, low, right, 5.0f * u, GOOD_PAINT);
    } else if (state == SELF_BAD) {
        ui_segment(view->frame.batch, left, end, 5.0f * u, BAD_PAINT);
        ui_segment(view->frame.batch, down, right, 5.0f * u, BAD_PAINT);
    } else {
        menu_words_at(view, x, y, 3.0f * r, 0.5f, &sign,
                      state == SELF_LOOK   ? "!"
                      : state == SELF_ASKS ? "?"
                                           : "...");
    }
}

static void draw_check_sheet(const struct menu_view *view, struct ui_box box, uint32_t edge)
{
    const float u = view->frame.unit;
    ui_panel(&view->frame, UI_WASHI, box, 8.0f * u, 2.0f * u, UI_WASHI_WHITE, edge);
}

/* Returns the byte position of the best line break in a Japanese text. The break is after the last
 * comma or full stop from which the remaining text fits on one line. 0 means that the text has no
 * such position. */
static size_t sentence_end(const struct ui_text *style, const char *words, float room_px)
{
    const char *at = words;
    size_t end = 0;
    for (uint32_t code = printable_next(&at); code != 0; code = printable_next(&at)) {
        const int ends = code == 0x3001u || code == 0x3002u;
        end = ends && *at && menu_fill_line(style, at, room_px) == strlen(at) ? (size_t)(at - words)
                                                                              : end;
    }
    return end;
}

/* Draws the text in one line if it fits. Otherwise draws two lines in a smaller size. The second
 * line is shrunk to fit. */
static void draw_wrapped_text(const struct menu_view *view, struct ui_box box,
                              const struct ui_text *style, const char *words)
{
    char line[2u * TEXT_LINE_MAX];
    struct ui_text each = *style;
    const bool is_long = words[menu_fill_line(style, words, box.width)] != '\0';
    if (is_long) {
        each.size_px = fminf(style->size_px, ROW_FILL * box.height / (float)ROW_LINES);
    }
    const size_t fits = menu_fill_line(&each, words, box.width);
    const size_t end = is_long ? sentence_end(&each, words, box.width) : 0;
    const size_t first = end > 0 && end < fits ? end : fits;
    const uint32_t lines = words[first] ? ROW_LINES : 1u;
    for (uint32_t i = 0; i < lines; i++) {
        const size_t size = i + 1u < lines ? first : strlen(words);
        snprintf(line, sizeof line, "%.*s", (int)size, words);
        menu_words_at(view, box.x, box.y + box.height * ((float)i + 0.5f) / (float)lines, box.width,
                      0.0f, &each, line);
        words += size;
    }
}

static void self_test_check_row(const struct menu_view *view, const struct places *places,
                                uint32_t index, uint8_t state)
{
    CORE_ASSERT(index < SELF_CHECKS && state < SELF_STATES);
    const float u = view->frame.unit;
    const float x = places->x + (float)(index / places->rows) * (places->width + places->gap);
    const float y = places->y + (float)(index % places->rows) * places->pitch;
    const struct ui_box box =
        menu_place(view, (struct layout_box){ x, y, places->width, places->height });
    const struct ui_text name = menu_style(view, 26.0f, UI_INK);
    const struct ui_text line =
        menu_style(view, 22.0f, state == SELF_GOOD ? UI_INK_SOFT : ui_menu_self_paint_of(state));
    const float left = box.x + (52.0f + places->name_width) * u;
    char words[2u * TEXT_LINE_MAX];
    row_words(view, index, state, words, sizeof words);
    draw_check_sheet(view, box, ui_menu_self_paint_of(state));
    self_test_draw_mark(view, box.x + 28.0f * u, box.y + 0.5f * box.height, state);
    menu_words_at(view, box.x + 52.0f * u, box.y + 0.5f * box.height,
                  (places->name_width - 8.0f) * u, 0.0f, &name, menu_text(view, names[index]));
    draw_wrapped_text(view,
                      (struct ui_box){ left, box.y + 4.0f * u, box.x + box.width - 10.0f * u - left,
                                       box.height - 8.0f * u },
                      &line, words);
}

/* ---- Summary of all checks ------------------------------------------------------------------ */

/* Draws the summary of all checks. Below the summary, draws the next step that the operator must
 * take. */
static void draw_check_verdict(const struct menu_view *view, const struct places *places,
                               uint32_t next, const uint8_t state[SELF_CHECKS])
{
    const float u = view->frame.unit;
    const uint8_t kind = next < SELF_CHECKS ? state[next] : (uint8_t)SELF_GOOD;
    const struct ui_box box = menu_place(view, places->verdict);
    const struct ui_text large = menu_style(view, 40.0f, ui_menu_self_paint_of(kind));
    const struct ui_text small = menu_style(view, 28.0f, UI_INK);
    char words[2u * TEXT_LINE_MAX], line[3u * TEXT_LINE_MAX];
    const float x = box.x + 0.5f * box.width, room = box.width - 40.0f * u;
    draw_check_sheet(view, box, ui_menu_self_paint_of(kind));
    const uint32_t seconds = view->menu->self.seconds_left;
    const uint32_t number = seconds > 0 ? seconds : self_test_left(state);
    const enum text_key key = next == SELF_CHECKS ? TEXT_CHECK_READY
                              : seconds > 0       ? TEXT_CHECK_RUNNING
                                                  : TEXT_CHECK_LEFT;
    text_number(words, sizeof words, menu_text(view, key), number);
    menu_words_at(view, x, box.y + (next < SELF_CHECKS ? 0.3f : 0.5f) * box.height, room, 0.5f,
                  &large, words);
    if (next < SELF_CHECKS) {
        row_words(view, next, kind, words, sizeof words);
        snprintf(line, sizeof line, "%s  %s", menu_text(view, names[next]), words);
        menu_words_at(view, x, box.y + 0.75f * box.height, room, 0.5f, &small, line);
    }
}

void menu_self_test(const struct menu_view *view)
{
    uint8_t state[SELF_CHECKS];
    const struct places *places = view->menu->upright ? &upright_places : &wide;
    const uint32_t next = self_test_judge(view->scene, state);
    for (uint32_t i = 0; i < SELF_CHECKS; i++) {
        self_test_check_row(view, places, i, state[i]);
    }
    draw_check_verdict(view, places, next, state);
}
