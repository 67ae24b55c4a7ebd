/* scores_verify.c -- verifies the replays of ranked rounds without a screen, or writes a replay to
 * a file. */
#include "platform/ctl/operator/scores_verify.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

#include "platform/cpu.h"
#include "platform/kiosk/replay_verifier.h"
#include "platform/kiosk/session_recorder.h"
#include "platform/os/file.h"
#include "platform/os/print.h"

#define ROUNDS_MAX (MODE_COUNT * RANK_PERIOD_COUNT * RANK_ROWS)

static struct replay_verifier judge;
static uint8_t bytes[SESSION_RECORDER_SIZE];

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

enum exit_code scores_verify(const struct scores_request *request, struct ledger_file *file)
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

enum exit_code scores_write_replay(const struct scores_request *request, struct ledger_file *file)
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
        print_error("kingyoctl scores: %s: cannot be written: %s", request->out, strerror(-error));
        return EXIT_IO;
    }
    return EXIT_OK;
}
