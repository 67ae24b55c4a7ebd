/* scores.c -- `kingyoctl scores`, which prints the leaderboards of each game mode and level,
 * verifies the replays of ranked rounds without a screen, and writes a replay to a file. */
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include "core/base/panic.h"
#include "core/game/rules.h"
#include "platform/cpu.h"
#include "platform/ctl/operator/books.h"
#include "platform/kiosk/recorder/replay_verifier.h"
#include "platform/kiosk/recorder/session_recorder.h"
#include "platform/os/file.h"
#include "platform/os/json.h"
#include "platform/os/number.h"
#include "platform/os/print.h"
#include "platform/store/sqlite/sql.h"

#define ROUNDS_MAX (RANK_BOARD_COUNT * RANK_PERIOD_COUNT * RANK_ROWS)

/* Options of `kingyoctl scores` and of its subcommands. */
struct scores_request {
    struct books_words books;
    /* `mode` is the selected game mode, or MODE_COUNT for all modes. `level` is the selected level,
     * or LEVEL_COUNT for all levels. `period` is the selected ranking period, or RANK_PERIOD_COUNT
     * for all periods. */
    uint8_t mode, level, period;
    bool is_all;       /* True if all ranked rounds are verified. */
    bool with_pin;     /* True if the output file may contain the PIN of the operator's menu. */
    uint32_t round_id; /* Id of the selected round, or 0 if no round is selected. */
    const char *out;   /* Path of the output file for the replay, or null. */
};

static struct replay_verifier verifier;
static uint8_t bytes[SESSION_RECORDER_SIZE];

/* ---- Subcommand verify ----------------------------------------------------------------------- */

/* Result of the verification of one ranked round. */
struct finding {
    uint32_t round_id;
    bool has_replay;
    enum replay_verdict verdict;
    size_t size;
    double play_s, took_s;
};

static struct finding verify_round(struct ledger_file *file, uint32_t round_id)
{
    struct finding found = { .round_id = round_id, .verdict = REPLAY_VERDICT_DAMAGED };
    const uint64_t begin_ns = ctl_now_ns();
    struct ledger_entry kept;
    found.has_replay =
        ledger_file_get_replay(file, round_id, bytes, sizeof bytes, &found.size) == 0;
    if (!found.has_replay) {
        return found;
    }
    if (replay_verifier_begin(&verifier, bytes, found.size) == 0) {
        while (replay_verifier_tick(&verifier)) {
        }
        found.play_s = (double)verifier.replayer.totals.ticks / CORE_TICK_HZ;
    }
    ledger_file_round(file, round_id, &kept);
    found.verdict =
        replay_verifier_result(&verifier, &file->content.memory.ranking, round_id, &kept);
    found.took_s = 1e-9 * (double)(ctl_now_ns() - begin_ns);
    return found;
}

static void finding_text(const struct finding *found)
{
    const struct replay_problem *problem = &verifier.replayer.reader.problem;
    const struct core_status status = core_status(&verifier.core);
    if (!found->has_replay) {
        printf("round %u: no replay\n", found->round_id);
    } else if (found->verdict == REPLAY_VERDICT_GENUINE) {
        printf("round %u: genuine: %.1f s in %.0f kB, played again in %.1f s; a round of %u s "
               "among %u fish\n",
               found->round_id, found->play_s, 1e-3 * (double)found->size, found->took_s,
               status.round_s, status.fish_count);
    } else if (found->verdict == REPLAY_VERDICT_UNCHECKED) {
        printf("round %u: not checked: " CPU_FLOAT_WRONG "\n", found->round_id);
    } else if (found->verdict == REPLAY_VERDICT_DAMAGED) {
        printf("round %u: damaged: byte %llu: %s\n", found->round_id,
               (unsigned long long)problem->offset, problem->text);
    } else if (verifier.replayer.difference.found) {
        printf("round %u: not genuine: another play from tick %u on\n", found->round_id,
               verifier.replayer.difference.tick);
    } else {
        printf("round %u: not genuine: its replay ends with another score\n", found->round_id);
    }
}

static void finding_json(const struct finding *found, struct json *json)
{
    static const char *const verdicts[REPLAY_VERDICT_COUNT] = { "genuine", "not-genuine", "damaged",
                                                                "not-checked" };
    json_print(json, "\n  {round: %u, verdict: %s, seconds: %.3f, bytes: %zu, took_s: %.3f}",
               found->round_id, found->has_replay ? verdicts[found->verdict] : "no-replay",
               found->play_s, found->size, found->took_s);
}

/* Writes the id of each ranked round to `out`. A round that is in several rankings is written only
 * once. Returns the number of rounds. */
static uint32_t list_rounds(const struct ranking *ranking, uint32_t out[ROUNDS_MAX])
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < ROUNDS_MAX; i++) {
        const uint32_t board = i / RANK_ROWS;
        const struct rank_row *row =
            &ranking->row[board / RANK_PERIOD_COUNT][board % RANK_PERIOD_COUNT][i % RANK_ROWS];
        uint32_t k = 0;
        CORE_ASSERT(count <= i);
        while (k < count && out[k] != row->round_id) {
            k++;
        }
        if (row->caught > 0 && k == count) {
            out[count++] = row->round_id;
        }
    }
    return count;
}

/* Verifies the replay of the selected round, or of all ranked rounds if round_id is 0. A missing
 * replay is an error only if a round is selected. */
static enum exit_code verify(const struct scores_request *request, struct ledger_file *file)
{
    uint32_t rounds[ROUNDS_MAX] = { request->round_id };
    const bool is_all = request->round_id == 0, as_json = request->books.as_json;
    const uint32_t count = is_all ? list_rounds(&file->content.memory.ranking, rounds) : 1u;
    struct json json = { .file = stdout };
    uint32_t bad = 0;
    CORE_ASSERT(count <= ROUNDS_MAX);
    if (as_json) {
        json_open(&json, NULL, '[');
    } else if (count == 0) {
        puts("no player has caught a fish yet");
    }
    for (uint32_t i = 0; i < count; i++) {
        const struct finding found = verify_round(file, rounds[i]);
        if (as_json) {
            finding_json(&found, &json);
        } else {
            finding_text(&found);
        }
        bad += found.has_replay ? found.verdict != REPLAY_VERDICT_GENUINE : !is_all;
    }
    if (as_json) {
        json_print(&json, "\n]");
        json_end(&json);
    }
    return bad > 0 ? EXIT_NOT_SO : EXIT_OK;
}

/* ---- Subcommand replay ----------------------------------------------------------------------- */

static enum exit_code write_replay(const struct scores_request *request, struct ledger_file *file)
{
    static struct replay_reader reader;
    struct atomic_file out;
    size_t size;
    CORE_ASSERT(request->out && request->round_id != 0);
    if (ledger_file_get_replay(file, request->round_id, bytes, sizeof bytes, &size) != 0) {
        return print_fail(EXIT_NOT_SO, "kingyoctl scores: round %u has no replay",
                          request->round_id);
    }
    /* A replay that may contain a PIN is not written without --with-pin. A running kiosk removes
     * the PIN from such replays or deletes them when it has no other work
     * (platform/kiosk/recorder/pin_sweep.h). Replays of a newer version stay unchanged. */
    replay_open_in(&reader, bytes, size);
    if (!request->with_pin && session_recorder_may_contain_pin(&reader)) {
        return print_fail(
            EXIT_NOT_SO,
            "kingyoctl scores: the replay of round %u is damaged or of another version, "
            "and may hold the PIN of the menu: the kiosk removes the PIN while it runs; "
            "--with-pin takes the replay out now; change the PIN then",
            request->round_id);
    }
    int error = file_atomic_open(&out, request->out);
    if (error == 0) {
        if (!out.is_stream) {
            /* Only the owner may read the output file, because the replay contains settings and the
             * audit counters. */
            fchmod(fileno(out.file), S_IRUSR | S_IWUSR);
        }
        fwrite(bytes, 1, size, out.file);
        error = file_atomic_close(&out);
    }
    if (error) {
        return print_fail(EXIT_IO, "kingyoctl scores: %s: cannot be written: %s", request->out,
                          strerror(-error));
    }
    return EXIT_OK;
}

static const char name[] = "scores";
static const char *const periods[RANK_PERIOD_COUNT + 1] = { "day", "week", "ever", NULL };

/* ---- Output of the leaderboards -------------------------------------------------------------- */

struct place {
    struct rank_board board;
    uint32_t period, place;
    const struct rank_row *row;
    bool has_replay;
};

static void place_text(const struct place *at)
{
    char day[SQL_DAY_TEXT_SIZE];
    sql_day_text(at->row->day, day);
    if (at->place == 0) {
        printf("%s, %s, %s\n", rules_of(at->board.mode)->name,
               rules_of_level(at->board.level)->name, periods[at->period]);
    }
    print_line(stdout, "  %2u  %4u fish  %-10s  round %-7u seat %u  %-6s  %s", at->place + 1u,
               at->row->caught, day, at->row->round_id, at->row->slot + 1u,
               at->has_replay ? "replay" : "", at->row->name[0] ? at->row->name : "-");
}

static void place_json(const struct place *at, struct json *json)
{
    char day[SQL_DAY_TEXT_SIZE];
    sql_day_text(at->row->day, day);
    json_print(json,
               "\n  {mode: %s, level: %s, period: %s, place: %u, caught: %u, round: %u, seat: %u,"
               " day: %s, replay: %hhd, name: %s}",
               rules_of(at->board.mode)->name, rules_of_level(at->board.level)->name,
               periods[at->period], at->place + 1u, at->row->caught, at->row->round_id,
               at->row->slot + 1u, at->row->day ? day : "", at->has_replay, at->row->name);
}

static enum exit_code print_ranking(const struct scores_request *request, struct ledger_file *file)
{
    struct json json = { .file = stdout };
    const bool as_json = request->books.as_json;
    uint32_t count = 0;
    CORE_ASSERT(request->mode <= MODE_COUNT && request->period <= RANK_PERIOD_COUNT);
    if (as_json) {
        json_open(&json, NULL, '[');
    }
    for (uint32_t i = 0; i < ROUNDS_MAX; i++) {
        const uint32_t board = i / RANK_ROWS;
        struct place at = { .board = ranking_board_at(board / RANK_PERIOD_COUNT),
                            .row = &file->content.memory.ranking.row[0][0][0] + i,
                            .period = board % RANK_PERIOD_COUNT,
                            .place = i % RANK_ROWS };
        const bool is_requested =
            (request->mode == MODE_COUNT || request->mode == at.board.mode) &&
            (request->level == LEVEL_COUNT || request->level == at.board.level) &&
            (request->period == RANK_PERIOD_COUNT || request->period == at.period);
        if (!is_requested || at.row->caught == 0) {
            continue;
        }
        at.has_replay = ledger_file_has_replay(file, at.row->round_id);
        if (as_json) {
            place_json(&at, &json);
        } else {
            place_text(&at);
        }
        count++;
    }
    if (as_json) {
        json_print(&json, "\n]");
        json_end(&json);
    } else if (count == 0) {
        puts("no player has caught a fish yet");
    }
    return EXIT_OK;
}

/* ---- Command line ---------------------------------------------------------------------------- */

enum group { GROUP_RANKING = 1, GROUP_VERIFY = 2, GROUP_REPLAY = 4 };

static bool take_round(void *target, const struct option *option, const char *value, char *why)
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
    { "mode", "MODE", "game mode", OPTION_CHOICE, AT(mode), .choices = options_mode_names,
      .groups = GROUP_RANKING },
    { "level", "LEVEL", "level of the rounds; without this option, all levels", OPTION_CHOICE,
      AT(level), .choices = options_level_names, .groups = GROUP_RANKING },
    { "period", "PERIOD", "ranking period", OPTION_CHOICE, AT(period), .choices = periods,
      .groups = GROUP_RANKING },
    { "all", NULL, "verify all ranked rounds", OPTION_FLAG, AT(is_all), .groups = GROUP_VERIFY },
    { "o", "FILE", "output file of replay", OPTION_TEXT, AT(out), .groups = GROUP_REPLAY },
    { "with-pin", NULL, "write a replay even if it may contain the PIN of the operator's menu",
      OPTION_FLAG, AT(with_pin), .groups = GROUP_REPLAY },
};

static const struct option_table table = OPTION_TABLE(options, &books_options);

static enum exit_code scores_run(int argc, const char *const *argv)
{
    struct scores_request request = { .mode = MODE_COUNT,
                                      .level = LEVEL_COUNT,
                                      .period = RANK_PERIOD_COUNT };
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
        code = (group == GROUP_VERIFY   ? verify
                : group == GROUP_REPLAY ? write_replay
                                        : print_ranking)(&request, &file);
        ledger_file_close(&file);
    }
    return code;
}

const struct ctl_command ctl_scores = {
    .name = name,
    .summary = "the leaderboard of each mode and level: today, this week, ever",
    .usage =
        "  kingyoctl scores [--mode MODE] [--level LEVEL] [--period PERIOD] [--data DIR] [--json]\n"
        "  kingyoctl scores verify ROUND|--all [--data DIR] [--json]\n"
        "                   recomputes the replays; exit code 1: one is not genuine\n"
        "  kingyoctl scores replay ROUND -o FILE [--with-pin] [--data DIR]\n"
        "                   writes a replay for 'kingyoctl replay' and 'kingyo --replay'\n",
    .options = &table,
    .run = scores_run,
};
