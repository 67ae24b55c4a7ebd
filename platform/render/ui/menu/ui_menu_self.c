/* ui_menu_self.c -- draws the self-test page. A row for each check shows the result and, if the
 * check failed, the remedy. A summary of all checks follows the rows. */
#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/game/menu/menu.h"
#include "platform/render/ui/menu/ui_menu.h"

#define ASK_PAINT 0xa85a12ffu
#define ROW_LINES 2u
#define ROW_FILL 0.88f /* Letter height as a fraction of the height of a text line. */

/* Layout of the page in canvas units. */
struct places {
    uint32_t rows; /* Number of rows in each column of the list of checks. Each column is filled
                      from top to bottom. */
    float x, y, width, height, gap, pitch;
    float name_width;
    struct layout_box verdict;
};

/* Layouts of a wide screen (index 0) and of an upright screen (index 1). */
static const struct places layouts[2] = {
    { 7, 40, 116, 592, 51, 16, 54, 160, { 40, 498, 1200, 96 } },
    { 14, 27, 176, 800, 62, 0, 67, 200, { 27, 1122, 800, 118 } },
};
_Static_assert(SELF_CHECKS == 14u, "both sheets have a row for each check");

/* A text key, and the number that replaces {} in the text. */
struct text {
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

/* Text of each check in each state, if the text contains no number. 0 means that the text contains
 * a number, which number_text() returns, or that the check never has the state. */
static const enum text_key plain[SELF_CHECKS][SELF_STATES] = {
    [SELF_STORE] = { [SELF_GOOD] = TEXT_CHECK_STORE_GOOD,
                     [SELF_WARN] = TEXT_CHECK_STORE_LOOK,
                     [SELF_BAD] = TEXT_CHECK_STORE_BAD },
    [SELF_FILES] = { [SELF_GOOD] = TEXT_CHECK_FILES_GOOD, [SELF_BAD] = TEXT_CHECK_FILES_BAD },
    [SELF_WATCHDOG] = { [SELF_GOOD] = TEXT_CHECK_WATCHDOG_GOOD,
                        [SELF_WARN] = TEXT_CHECK_WATCHDOG_LOOK,
                        [SELF_BAD] = TEXT_CHECK_WATCHDOG_BAD },
    [SELF_SOUND] = { [SELF_GOOD] = TEXT_CHECK_SOUND_GOOD,
                     [SELF_QUERY] = TEXT_CHECK_SOUND_ASK,
                     [SELF_BAD] = TEXT_CHECK_SOUND_BAD },
    [SELF_LAMP] = { [SELF_QUERY] = TEXT_CHECK_LAMP_ASK, [SELF_BAD] = TEXT_CHECK_LAMP_BAD },
    [SELF_BUTTONS] = { [SELF_GOOD] = TEXT_CHECK_BUTTONS_GOOD,
                       [SELF_QUERY] = TEXT_CHECK_BUTTONS_ASK },
    [SELF_COINS] = { [SELF_QUERY] = TEXT_CHECK_COINS_ASK },
    [SELF_POIS] = { [SELF_GOOD] = TEXT_CHECK_POIS_GOOD,
                    [SELF_QUERY] = TEXT_CHECK_POIS_ASK,
                    [SELF_BAD] = TEXT_CHECK_POIS_BAD },
};

/* Returns the text of a check whose text contains a number. */
static struct text number_text(const struct ui_frame *frame, uint32_t check, uint8_t state)
{
    const struct scene *const scene = frame->scene;
    const struct scene_machine *const machine = &scene->devices.machine;
    switch (check) {
    case SELF_BACKUP: {
        const uint32_t minutes = machine->backup_min;
        return state == SELF_GOOD    ? (struct text){ TEXT_CHECK_BACKUP_GOOD, minutes }
               : machine->has_backup ? (struct text){ TEXT_CHECK_BACKUP_LOOK, minutes / 60u }
                                     : (struct text){ TEXT_CHECK_BACKUP_NONE, 0 };
    }
    case SELF_DATA: {
        static const enum text_key keys[] = {
            [KEEPS_UNKNOWN] = TEXT_CHECK_SILENT,     [KEEPS_PROVEN] = TEXT_CHECK_DATA_GOOD,
            [KEEPS_FOLDER] = TEXT_CHECK_DATA_FOLDER, [KEEPS_MEMORY] = TEXT_CHECK_DATA_MEMORY,
            [KEEPS_NOT] = TEXT_CHECK_DATA_BAD,       [KEEPS_NOWHERE] = TEXT_CHECK_DATA_NOWHERE,
        };
        return (struct text){
            keys[machine->keeps <= KEEPS_NOWHERE ? machine->keeps : (uint8_t)KEEPS_UNKNOWN], 0
        };
    }
    case SELF_ROOM:
        return state != SELF_GOOD ? (struct text){ TEXT_CHECK_ROOM_LOOK, machine->room_mib }
               : machine->room_mib < 10240u
                   ? (struct text){ TEXT_CHECK_ROOM_GOOD, machine->room_mib }
                   : (struct text){ TEXT_CHECK_ROOM_AMPLE, machine->room_mib / 1024u };
    case SELF_HEAT: {
        const uint32_t margin_c =
            machine->heat_margin_c > 0 ? (uint32_t)machine->heat_margin_c : 0u;
        return !machine->has_heat   ? (struct text){ TEXT_CHECK_HEAT_NONE, 0 }
               : state == SELF_GOOD ? (struct text){ TEXT_CHECK_HEAT_GOOD, margin_c }
               : state == SELF_WARN ? (struct text){ TEXT_CHECK_HEAT_LOOK, margin_c }
                                    : (struct text){ TEXT_CHECK_HEAT_BAD, 0 };
    }
    case SELF_CLOCK:
        return (struct text){ machine->is_clock_back ? TEXT_CHECK_CLOCK_BACK
                                                     : TEXT_CHECK_CLOCK_LOOK,
                              0 };
    case SELF_DISPLAY:
        return (struct text){ state == SELF_GOOD ? TEXT_CHECK_DISPLAY_GOOD : TEXT_CHECK_DISPLAY_BAD,
                              scene->devices.frames_a_second };
    case SELF_LAMP:
        return (struct text){ scene->menu.self.lamp_answer == SELF_UNANSWERED
                                  ? TEXT_CHECK_LAMP_NONE
                                  : TEXT_CHECK_LAMP_GOOD,
                              0 };
    default:
        return (struct text){ scene->menu.test_coins > 0 ? TEXT_CHECK_COINS_GOOD
                                                         : TEXT_CHECK_COINS_FREE,
                              scene->menu.test_coins };
    }
}

static void row_words(const struct ui_frame *frame, uint32_t check, uint8_t state, char *out,
                      size_t out_size)
{
    CORE_ASSERT(check < SELF_CHECKS && state < SELF_STATES);
    const struct scene *const scene = frame->scene;
    const bool needs_machine =
        check >= SELF_BACKUP && check <= SELF_HEAT && check != SELF_FILES && check != SELF_CLOCK;
    enum text_key key = plain[check][state];
    if (state == SELF_WAITS) {
        key = TEXT_CHECK_WAITS;
    } else if (needs_machine && !scene->devices.machine.is_checked) {
        key = TEXT_CHECK_SILENT;
    } else if (check == SELF_CLOCK && state == SELF_GOOD) {
        /* The row shows the date and the time of the clock, such as "2026-08-15 18:30", so that the
         * operator can compare the clock with the true time. */
        static const uint8_t months[12] = { 31, 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31 };
        uint32_t year = 2000, month = 0, day = scene->menu.self.day, length = 366;
        for (; day >= length; length = year % 4u == 0 ? 366u : 365u) {
            /* From 2000 to 2099, every fourth year is a leap year. */
            day -= length;
            year++;
        }
        const uint32_t leap_day = length == 366u ? 1u : 0u;
        while (day >= months[month] + (month == 1u ? leap_day : 0u)) {
            day -= months[month] + (month == 1u ? leap_day : 0u);
            month++;
        }
        snprintf(out, out_size, "%u-%02u-%02u %02u:%02u", year, month + 1u, day + 1u,
                 scene->menu.self.minute / 60u, scene->menu.self.minute % 60u);
        return;
    }
    const struct text text = key ? (struct text){ key, 0 } : number_text(frame, check, state);
    text_number(out, out_size, ui_words(frame, text.key), text.number);
}

/* ---- Rows, one for each check --------------------------------------------------------------- */

static uint32_t state_paint(uint8_t state)
{
    return state == SELF_GOOD ? MENU_GOOD : state == SELF_BAD ? MENU_BAD : ASK_PAINT;
}

/* Draws the sign of a check. A tick means passed, a cross means failed, and an exclamation mark
 * means a warning. A question mark means that the operator must do the check. Three dots mean that
 * the check has no result yet. */
static void draw_mark(const struct ui_frame *frame, float x, float y, uint8_t state)
{
    /* The two strokes of a tick and of a cross. Each row has x and y of both ends of a stroke, in
     * units of `r`. */
    static const float tick[2][4] = { { -1.0f, 0.1f, -0.3f, 0.8f }, { -0.3f, 0.8f, 1.0f, -0.9f } };
    static const float cross[2][4] = { { -1.0f, -0.9f, 1.0f, 0.9f }, { -1.0f, 0.9f, 1.0f, -0.9f } };
    const float u = frame->unit, r = 13.0f * u;
    if (state != SELF_GOOD && state != SELF_BAD) {
        ui_words_at(frame, x, y, 3.0f * r, 0.5f, ui_body(frame, 36.0f, ASK_PAINT),
                    state == SELF_WARN    ? "!"
                    : state == SELF_QUERY ? "?"
                                          : "...");
        return;
    }
    for (uint32_t i = 0; i < 2u; i++) {
        const float *const stroke = state == SELF_GOOD ? tick[i] : cross[i];
        const float from[2] = { x + stroke[0] * r, y + stroke[1] * r };
        const float to[2] = { x + stroke[2] * r, y + stroke[3] * r };
        ui_segment(frame->batch, from, to, 5.0f * u, state_paint(state));
    }
}

static void draw_check_sheet(const struct ui_frame *frame, struct ui_box box, uint8_t state)
{
    const float u = frame->unit;
    ui_panel(frame, UI_WASHI, box, 8.0f * u, 2.0f * u, UI_WASHI_WHITE, state_paint(state));
}

/* Draws the text in one line if it fits. Otherwise draws two lines in a smaller size, and shrinks
 * the second line to fit. A Japanese text is broken after a comma or full stop if the rest of the
 * text then fits on the second line. If there are several such places, the last one is used. */
static void draw_wrapped_text(const struct ui_frame *frame, struct ui_box box, struct ui_text style,
                              const char *words)
{
    char line[2u * TEXT_LINE_MAX];
    const bool is_long = words[menu_fill_line(style, words, box.width)] != '\0';
    if (is_long) {
        style.size_px = fminf(style.size_px, ROW_FILL * box.height / (float)ROW_LINES);
    }
    const size_t fits = menu_fill_line(style, words, box.width);
    size_t first = fits;
    const char *at = words;
    for (uint32_t code = is_long ? printable_next(&at) : 0; code != 0; code = printable_next(&at)) {
        const bool ends = code == 0x3001u || code == 0x3002u;
        if (ends && *at && menu_fill_line(style, at, box.width) == strlen(at)) {
            first = (size_t)(at - words) < fits ? (size_t)(at - words) : fits;
        }
    }
    const uint32_t lines = words[first] ? ROW_LINES : 1u;
    for (uint32_t i = 0; i < lines; i++) {
        const size_t size = i + 1u < lines ? first : strlen(words);
        snprintf(line, sizeof line, "%.*s", (int)size, words);
        ui_words_at(frame, box.x, box.y + box.height * ((float)i + 0.5f) / (float)lines, box.width,
                    0.0f, style, line);
        words += size;
    }
}

static void draw_check_row(const struct ui_frame *frame, const struct places *places,
                           uint32_t index, uint8_t state)
{
    CORE_ASSERT(index < SELF_CHECKS && state < SELF_STATES);
    const float u = frame->unit;
    const float x = places->x + (float)(index / places->rows) * (places->width + places->gap);
    const float y = places->y + (float)(index % places->rows) * places->pitch;
    const struct ui_box box = ui_place(frame, canvas_box(x, y, places->width, places->height));
    const float left = box.x + (52.0f + places->name_width) * u, middle = box.y + 0.5f * box.height;
    char words[2u * TEXT_LINE_MAX];
    row_words(frame, index, state, words, sizeof words);
    draw_check_sheet(frame, box, state);
    draw_mark(frame, box.x + 28.0f * u, middle, state);
    ui_label_at(frame, box.x + 52.0f * u, middle, (places->name_width - 8.0f) * u, 26.0f, UI_INK,
                names[index]);
    draw_wrapped_text(frame,
                      (struct ui_box){ left, box.y + 4.0f * u, box.x + box.width - 10.0f * u - left,
                                       box.height - 8.0f * u },
                      ui_body(frame, 22.0f, state == SELF_GOOD ? UI_INK_SOFT : state_paint(state)),
                      words);
}

void menu_self_test(const struct ui_frame *frame)
{
    uint8_t state[SELF_CHECKS];
    const struct places *const places = &layouts[frame->is_upright];
    const uint32_t next = self_test_result(frame->scene, state);
    for (uint32_t i = 0; i < SELF_CHECKS; i++) {
        draw_check_row(frame, places, i, state[i]);
    }
    /* Draws the summary of all checks below the rows and, if a check has not passed, the next step
     * that the operator must take. */
    const float u = frame->unit;
    const bool is_ready = next == SELF_CHECKS;
    const uint8_t kind = is_ready ? (uint8_t)SELF_GOOD : state[next];
    const struct ui_box box = ui_place(frame, places->verdict);
    const float x = box.x + 0.5f * box.width, room = box.width - 40.0f * u;
    const uint32_t seconds = frame->scene->menu.self.seconds_left;
    const enum text_key key = is_ready      ? TEXT_CHECK_READY
                              : seconds > 0 ? TEXT_CHECK_RUNNING
                                            : TEXT_CHECK_LEFT;
    char words[2u * TEXT_LINE_MAX], line[3u * TEXT_LINE_MAX];
    draw_check_sheet(frame, box, kind);
    text_number(words, sizeof words, ui_words(frame, key),
                seconds > 0 ? seconds : self_test_left(state));
    ui_words_at(frame, x, box.y + (is_ready ? 0.5f : 0.3f) * box.height, room, 0.5f,
                ui_body(frame, 40.0f, state_paint(kind)), words);
    if (!is_ready) {
        row_words(frame, next, kind, words, sizeof words);
        snprintf(line, sizeof line, "%s  %s", ui_words(frame, names[next]), words);
        ui_words_at(frame, x, box.y + 0.75f * box.height, room, 0.5f, ui_body(frame, 28.0f, UI_INK),
                    line);
    }
}
