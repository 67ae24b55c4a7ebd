/* scores_verify.c -- verifies the replays of ranked rounds without a screen, or writes a replay to
 * a file. */
#include "platform/ctl/operator/scores_verify.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

#include "platform/cpu.h"
#include "platform/ctl/operator/books.h"
#include "platform/kiosk/replay_verifier.h"
#include "platform/kiosk/session_recorder.h"
#include "platform/os/atomic_file.h"
#include "platform/os/number.h"
#include "platform/os/print.h"

#define ROUNDS_MAX (MODE_COUNT * RANK_PERIOD_COUNT * RANK_ROWS)

static const char name[] = "scores";

struct request {
    struct books_words books;
    uint32_t round_id; /* Number of the selected round. 0 selects all ranked rounds. */
    const char *out;   /* Path of the output file for the replay, or null for the subcommand
                          `verify`. */
    int with_pin;      /* 1 if the output file may contain the PIN of the operator's menu, otherwise
                          0. */
};

static struct replay_verifier judge;
static uint8_t bytes[SESSION_RECORDER_SIZE];

/* ---- Command line ---------------------------------------------------------------------------- */

static enum exit_code scores_verify_read_words(struct request *request, int argc,
                                               const char *const *argv)
{
    const int takes_out = strcmp(argv[0], "replay") == 0;
    int is_all = 0;
    *request = (struct request){ .round_id = 0 };
    for (int i = 1; i < argc; i++) {
        if (books_take(&request->books, argc, argv, &i)) {
            continue;
        }
        if (!takes_out && strcmp(argv[i], "--all") == 0) {
            is_all = 1;
        } else if (takes_out && strcmp(argv[i], "-o") == 0 && i + 1 < argc) {
            request->out = argv[++i];
        } else if (takes_out && strcmp(argv[i], "--with-pin") == 0) {
            request->with_pin = 1;
        } else if (request->round_id != 0 ||
                   !number_parse(argv[i], 1, UINT32_MAX, &request->round_id)) {
            return ctl_usage(name, "%s: '%.60s' is not understood; --help says more", argv[0],
                             argv[i]);
        }
    }
    if (takes_out && (request->round_id == 0 || !request->out || request->books.as_json)) {
        return ctl_usage(name, "replay wants a ROUND and -o FILE");
    }
    if (!takes_out && (request->round_id != 0) == is_all) {
        return ctl_usage(name, "verify wants a ROUND or --all");
    }
    return EXIT_OK;
}

/* ---- Subcommand verify ----------------------------------------------------------------------- */

/* Result of the verification of one ranked round. */
struct finding {
    uint32_t round_id;
    int has_replay;
    enum replay_verdict verdict;
    size_t size;
    double play_s, took_s;
};

static double now_s(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static struct finding look_into(struct ledger_file *file, uint32_t round_id)
{
    struct finding found = { .round_id = round_id, .verdict = REPLAY_VERDICT_DAMAGED };
    const double begin_s = now_s();
    struct ledger_entry kept;
    found.has_replay =
        ledger_file_get_replay(file, round_id, bytes, sizeof bytes, &found.size) == 0;
    if (!found.has_replay) {
        return found;
    }
    if (replay_verifier_begin(&judge, bytes, found.size) == 0) {
        while (replay_verifier_tick(&judge)) {
        }
        found.play_s = (double)judge.replayer.totals.ticks / CORE_TICK_HZ;
    }
    ledger_file_round(file, round_id, &kept);
    found.verdict = replay_verifier_result(&judge, &file->content.memory.ranking, round_id, &kept);
    found.took_s = now_s() - begin_s;
    return found;
}

static void scores_verify_print_finding(const struct finding *found)
{
    const struct replay_problem *problem = &judge.replayer.reader.problem;
    if (!found->has_replay) {
        printf("round %u: no replay\n", found->round_id);
    } else if (found->verdict == REPLAY_VERDICT_GENUINE) {
        printf("round %u: genuine: %.1f s in %.0f kB, played again in %.1f s; a round of %u s "
               "among %u fish\n",
               found->round_id, found->play_s, 1e-3 * (double)found->size, found->took_s,
               judge.core.game.round_s, judge.core.world.tank.fish_count);
    } else if (found->verdict == REPLAY_VERDICT_UNCHECKED) {
        printf("round %u: not checked: " CPU_FLOAT_WRONG "\n", found->round_id);
    } else if (found->verdict == REPLAY_VERDICT_DAMAGED) {
        printf("round %u: damaged: byte %llu: %s\n", found->round_id,
               (unsigned long long)problem->offset, problem->text);
    } else if (judge.replayer.difference.found) {
        printf("round %u: not genuine: another play from tick %u on\n", found->round_id,
               judge.replayer.difference.tick);
    } else {
        printf("round %u: not genuine: its replay ends with another score\n", found->round_id);
    }
}

static void tell_json(const struct finding *found, int is_first)
{
    static const char *const verdicts[REPLAY_VERDICT_COUNT] = { "genuine", "not-genuine", "damaged",
                                                                "not-checked" };
    printf("%s\n  {\"round\": %u, \"verdict\": \"%s\", \"seconds\": %.3f, \"bytes\": %zu, "
           "\"took_s\": %.3f}",
           is_first ? "" : ",", found->round_id,
           found->has_replay ? verdicts[found->verdict] : "no-replay", found->play_s, found->size,
           found->took_s);
}

/* Writes the number of each ranked round to `out` once, because a round may be in several rankings.
 * Returns the number of rounds. */
static uint32_t list_rounds(const struct ranking *ranking, uint32_t out[ROUNDS_MAX])
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < ROUNDS_MAX; i++) {
        const uint32_t board = i / RANK_ROWS;
        const struct rank_row *row =
            &ranking->row[board / RANK_PERIOD_COUNT][board % RANK_PERIOD_COUNT][i % RANK_ROWS];
        uint32_t k = 0;
        while (k < count && out[k] != row->round_id) {
            k++;
        }
        if (row->caught > 0 && k == count) {
            out[count++] = row->round_id;
        }
    }
    return count;
}

/* Verifies one round or all ranked rounds. A missing replay is an error only if the user named the
 * round. */
static enum exit_code verify(const struct request *request, struct ledger_file *file)
{
    uint32_t rounds[ROUNDS_MAX] = { request->round_id };
    const int is_all = request->round_id == 0;
    const uint32_t count = is_all ? list_rounds(&file->content.memory.ranking, rounds) : 1u;
    uint32_t bad = 0;
    fputs(request->books.as_json ? "[" : "", stdout);
    for (uint32_t i = 0; i < count; i++) {
        const struct finding found = look_into(file, rounds[i]);
        if (request->books.as_json) {
            tell_json(&found, i == 0);
        } else {
            scores_verify_print_finding(&found);
        }
        bad += found.has_replay ? found.verdict != REPLAY_VERDICT_GENUINE : !is_all;
    }
    if (count == 0 && !request->books.as_json) {
        puts("nobody has caught a fish yet");
    }
    fputs(request->books.as_json ? "\n]\n" : "", stdout);
    return bad > 0 ? EXIT_NOT_SO : EXIT_OK;
}

/* ---- Subcommand replay ----------------------------------------------------------------------- */

/* Returns 1 if a replay contains the PIN of the operator's menu, otherwise 0. A replay begins with
 * a copy of the settings. Earlier versions of Kingyo included the PIN in the copy and in the hashes
 * of the replay, so the PIN cannot be removed. */
static int holds_pin(const uint8_t *replay, size_t size)
{
    static struct replay_reader reader;
    int holds = 0;
    if (replay_open_in(&reader, replay, size) == 0) {
        holds = session_recorder_start_has_pin(&reader.header.config);
        replay_close(&reader);
    }
    return holds;
}

static enum exit_code take_out(const struct request *request, struct ledger_file *file)
{
    struct atomic_file out;
    size_t size;
    if (ledger_file_get_replay(file, request->round_id, bytes, sizeof bytes, &size) != 0) {
        print_error("kingyoctl scores: round %u has no replay", request->round_id);
        return EXIT_NOT_SO;
    }
    if (!request->with_pin && holds_pin(bytes, size)) {
        print_error("kingyoctl scores: the replay of round %u holds the PIN of the menu: "
                    "--with-pin takes it out all the same; change the PIN then",
                    request->round_id);
        return EXIT_NOT_SO;
    }
    int error = atomic_file_open(&out, request->out);
    if (error == 0) {
        if (!out.is_stream) {
            /* Only the owner may read the output file, because the replay contains settings and the
             * audit counters. */
            fchmod(fileno(out.file), S_IRUSR | S_IWUSR);
        }
        fwrite(bytes, 1, size, out.file);
        error = atomic_file_close(&out);
    }
    if (error) {
        print_error("kingyoctl scores: %s: cannot be written: %s", request->out, strerror(-error));
        return EXIT_IO;
    }
    return EXIT_OK;
}

enum exit_code scores_verify(int argc, const char *const *argv)
{
    struct request request;
    struct ledger_file file;
    enum exit_code code = scores_verify_read_words(&request, argc, argv);
    code = code == EXIT_OK ? books_open(name, &request.books, &file) : code;
    if (code != EXIT_OK) {
        return code;
    }
    code = (request.out ? take_out : verify)(&request, &file);
    ledger_file_close(&file);
    return code;
}
