/* scores.c -- `kingyoctl scores`, which prints the kiosk's leaderboard of each game mode. */
#include <stdio.h>
#include <string.h>

#include "core/game/rules.h"
#include "platform/ctl/operator/books.h"
#include "platform/ctl/operator/scores_verify.h"
#include "platform/os/json_char.h"
#include "platform/os/print.h"
#include "platform/store/sqlite/day.h"

static const char name[] = "scores";
static const char *const periods[RANK_PERIOD_COUNT] = { "day", "week", "ever" };

struct request {
    struct books_words books;
    /* `mode` is the selected game mode, or MODE_COUNT for all modes. `period` is the selected
     * ranking period, or RANK_PERIOD_COUNT for all periods. */
    uint32_t mode, period;
};

/* ---- Command line ---------------------------------------------------------------------------- */

static uint32_t mode_of(const char *word)
{
    uint32_t mode = 0;
    while (mode < MODE_COUNT && strcmp(rules_of((uint8_t)mode)->name, word) != 0) {
        mode++;
    }
    return mode;
}

static uint32_t period_of(const char *word)
{
    uint32_t period = 0;
    while (period < RANK_PERIOD_COUNT && strcmp(periods[period], word) != 0) {
        period++;
    }
    return period;
}

static enum exit_code scores_read_words(struct request *request, int argc, const char *const *argv)
{
    *request = (struct request){ .mode = MODE_COUNT, .period = RANK_PERIOD_COUNT };
    for (int i = 0; i < argc; i++) {
        if (books_take(&request->books, argc, argv, &i)) {
            continue;
        }
        if (strcmp(argv[i], "--mode") == 0 && i + 1 < argc) {
            request->mode = mode_of(argv[++i]);
            if (request->mode == MODE_COUNT) {
                return ctl_usage(name, "--mode wants festival, championship or practice");
            }
        } else if (strcmp(argv[i], "--period") == 0 && i + 1 < argc) {
            request->period = period_of(argv[++i]);
            if (request->period == RANK_PERIOD_COUNT) {
                return ctl_usage(name, "--period wants day, week or ever");
            }
        } else {
            return ctl_usage(name, "'%.60s' is not understood; --help says more", argv[i]);
        }
    }
    return EXIT_OK;
}

/* ---- Output of the leaderboards -------------------------------------------------------------- */

struct place {
    uint32_t mode, period, place;
    const struct rank_row *row;
    int has_replay;
};

static void scores_print_text(const struct place *at)
{
    char day[DAY_TEXT_SIZE];
    day_text(at->row->day, day);
    if (at->place == 0) {
        printf("%s, %s\n", rules_of((uint8_t)at->mode)->name, periods[at->period]);
    }
    print_line(stdout, "  %2u  %4u fish  %-10s  round %-7u seat %u  %-6s  %s", at->place + 1u,
               at->row->caught, day, at->row->round_id, at->row->seat + 1u,
               at->has_replay ? "replay" : "", at->row->name[0] ? at->row->name : "-");
}

static void print_json(const struct place *at, int is_first)
{
    char day[DAY_TEXT_SIZE];
    day_text(at->row->day, day);
    printf("%s\n  {\"mode\": \"%s\", \"period\": \"%s\", \"place\": %u, \"caught\": %u, ",
           is_first ? "" : ",", rules_of((uint8_t)at->mode)->name, periods[at->period],
           at->place + 1u, at->row->caught);
    printf("\"round\": %u, \"seat\": %u, \"day\": \"%s\", \"replay\": %s, \"name\": ",
           at->row->round_id, at->row->seat + 1u, at->row->day ? day : "",
           at->has_replay ? "true" : "false");
    json_print(at->row->name);
    putchar('}');
}

static uint32_t print_rows(const struct request *request, struct ledger_file *file)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < MODE_COUNT * RANK_PERIOD_COUNT * RANK_ROWS; i++) {
        const uint32_t board = i / RANK_ROWS;
        struct place at = { board / RANK_PERIOD_COUNT, board % RANK_PERIOD_COUNT, i % RANK_ROWS,
                            NULL, 0 };
        at.row = &file->content.memory.ranking.row[at.mode][at.period][at.place];
        const int is_asked = (request->mode == MODE_COUNT || request->mode == at.mode) &&
                             (request->period == RANK_PERIOD_COUNT || request->period == at.period);
        if (is_asked && at.row->caught > 0) {
            at.has_replay = ledger_file_has_replay(file, at.row->round_id);
            if (request->books.as_json) {
                print_json(&at, count == 0);
            } else {
                scores_print_text(&at);
            }
            count++;
        }
    }
    return count;
}

static enum exit_code scores_run(int argc, const char *const *argv)
{
    struct request request;
    struct ledger_file file;
    if (argc > 0 && (strcmp(argv[0], "verify") == 0 || strcmp(argv[0], "replay") == 0)) {
        return scores_verify(argc, argv);
    }
    enum exit_code code = scores_read_words(&request, argc, argv);
    code = code == EXIT_OK ? books_open(name, &request.books, &file) : code;
    if (code != EXIT_OK) {
        return code;
    }
    fputs(request.books.as_json ? "[" : "", stdout);
    const uint32_t count = print_rows(&request, &file);
    if (request.books.as_json) {
        puts("\n]");
    } else if (count == 0) {
        puts("nobody has caught a fish yet");
    }
    ledger_file_close(&file);
    return EXIT_OK;
}

const struct ctl_command ctl_scores = {
    .name = name,
    .summary = "the best of each mode: today, this week, ever",
    .usage = "  kingyoctl scores [--mode MODE] [--period PERIOD] [--data DIR] [--json]\n"
             "  kingyoctl scores verify ROUND|--all [--data DIR] [--json]\n"
             "                   plays their replays again: is it genuine? (exit 1: it is not)\n"
             "  kingyoctl scores replay ROUND -o FILE [--with-pin] [--data DIR]\n"
             "                   takes a replay out, for 'kingyoctl replay' and 'kingyo --replay'\n"
             "\n"
             "  --mode MODE      festival, championship or practice\n"
             "  --period PERIOD  day, week or ever\n" BOOKS_USAGE,
    .run = scores_run,
};
