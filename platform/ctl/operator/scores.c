/* scores.c -- `kingyoctl scores`, which prints the kiosk's leaderboard of each game mode. */
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include "core/game/rules.h"
#include "platform/ctl/operator/scores_verify.h"
#include "platform/os/json_char.h"
#include "platform/os/number.h"
#include "platform/os/print.h"
#include "platform/store/sqlite/day.h"

static const char name[] = "scores";
static const char *const periods[RANK_PERIOD_COUNT + 1] = { "day", "week", "ever", NULL };

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

static uint32_t print_rows(const struct scores_request *request, struct ledger_file *file)
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

static enum exit_code print_ranking(const struct scores_request *request, struct ledger_file *file)
{
    fputs(request->books.as_json ? "[" : "", stdout);
    const uint32_t count = print_rows(request, file);
    if (request->books.as_json) {
        puts("\n]");
    } else if (count == 0) {
        puts("nobody has caught a fish yet");
    }
    return EXIT_OK;
}

/* ---- Command line ---------------------------------------------------------------------------- */

enum group { GROUP_RANKING = 1, GROUP_VERIFY = 2, GROUP_REPLAY = 4 };

static const char *const modes[] = {
    [MODE_FESTIVAL] = "festival",
    [MODE_CHAMPIONSHIP] = "championship",
    [MODE_PRACTICE] = "practice",
    [MODE_COUNT] = NULL,
};

static int take_round(void *target, const struct option *option, const char *value, char *why)
{
    struct scores_request *request = target;
    (void)option;
    (void)why;
    return request->round_id == 0 && number_parse(value, 1, UINT32_MAX, &request->round_id);
}

#define AT(member) .offset = offsetof(struct scores_request, member)

static const struct option options[] = {
    { NULL, "ROUND", "number of a ranked round, for verify and replay", OPTION_ARGUMENT,
      .set = take_round, .groups = GROUP_VERIFY | GROUP_REPLAY },
    { "mode", "MODE", "game mode", OPTION_CHOICE, AT(mode), .choices = modes,
      .groups = GROUP_RANKING },
    { "period", "PERIOD", "ranking period", OPTION_CHOICE, AT(period), .choices = periods,
      .groups = GROUP_RANKING },
    { "all", NULL, "verify all ranked rounds", OPTION_FLAG, AT(is_all), .groups = GROUP_VERIFY },
    { "o", "FILE", "output file of replay", OPTION_TEXT, AT(out), .groups = GROUP_REPLAY },
    { "with-pin", NULL, "write a replay even if it contains the PIN of the operator's menu",
      OPTION_FLAG, AT(with_pin), .groups = GROUP_REPLAY },
};

static const struct option_table table = { options, sizeof options / sizeof options[0],
                                           &books_options };

static enum exit_code scores_run(int argc, const char *const *argv)
{
    struct scores_request request = { .mode = MODE_COUNT, .period = RANK_PERIOD_COUNT };
    struct ledger_file file;
    const enum group group = argc > 0 && strcmp(argv[0], "verify") == 0   ? GROUP_VERIFY
                             : argc > 0 && strcmp(argv[0], "replay") == 0 ? GROUP_REPLAY
                                                                          : GROUP_RANKING;
    const int skip = group != GROUP_RANKING;
    enum exit_code code = ctl_options(name, &table, group, &request, argc - skip, argv + skip);
    if (code == EXIT_OK && group == GROUP_REPLAY &&
        (request.round_id == 0 || !request.out || request.books.as_json)) {
        return ctl_usage(name, "replay needs a ROUND and -o FILE");
    }
    if (code == EXIT_OK && group == GROUP_VERIFY && (request.round_id != 0) == request.is_all) {
        return ctl_usage(name, "verify needs a ROUND or --all");
    }
    code = code == EXIT_OK ? books_open(name, &request.books, &file) : code;
    if (code == EXIT_OK) {
        code = (group == GROUP_VERIFY   ? scores_verify
                : group == GROUP_REPLAY ? scores_write_replay
                                        : print_ranking)(&request, &file);
        ledger_file_close(&file);
    }
    return code;
}

const struct ctl_command ctl_scores = {
    .name = name,
    .summary = "the leaderboard of each mode: today, this week, ever",
    .usage = "  kingyoctl scores [--mode MODE] [--period PERIOD] [--data DIR] [--json]\n"
             "  kingyoctl scores verify ROUND|--all [--data DIR] [--json]\n"
             "                   recomputes the replays; exit code 1: one is not genuine\n"
             "  kingyoctl scores replay ROUND -o FILE [--with-pin] [--data DIR]\n"
             "                   writes a replay for 'kingyoctl replay' and 'kingyo --replay'\n",
    .options = &table,
    .run = scores_run,
};
