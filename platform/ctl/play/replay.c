/* replay.c -- `kingyoctl replay`, which prints the content of a recording and verifies the
 * recording. */
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "core/base/panic.h"
#include "core/core.h"
#include "core/game/table_setup.h"
#include "platform/cpu.h"
#include "platform/ctl/lib/ctl.h"
#include "platform/kiosk/recorder/replayer.h"
#include "platform/os/file.h"
#include "platform/os/json.h"
#include "platform/os/panic.h"
#include "platform/os/print.h"

static const char name[] = "replay";
static const char prefix[] = "kingyoctl replay";

/* Scans a recording like replay_scan(), but without validating the inputs. The recording of a panic
 * (a failed assertion) may end with an input that violates the core's contract. Returns 0, or -1
 * after an error. */
static int scan(struct replay_reader *reader, const char *path, struct replay_totals *totals)
{
    if (replay_open(reader, path)) {
        return -1;
    }
    reader->as_is = 1;
    return replay_scan_on(reader, totals);
}

/* ---- Subcommand info ------------------------------------------------------------------------- */

/* Returns true if a mode with levels was played. Recordings older than format 9 have no levels. */
static bool has_levels(const struct replay_header *header, const struct replay_totals *totals)
{
    bool has = false;
    for (uint32_t mode = 0; mode < MODE_COUNT; mode++) {
        has |= (totals->modes >> mode & 1u) && rules_of((uint8_t)mode)->has_levels;
    }
    return has && config_has_rules(&header->config, 9);
}

/* Returns the name of the level of players who chose none. The recording contains the choices of
 * players only as motions of their pois. */
static const char *level_name(const struct replay_header *header,
                              const struct replay_totals *totals)
{
    const uint8_t level = header->config.level;
    const bool is_known = level < LEVEL_COUNT && has_levels(header, totals);
    return rules_of_level(is_known ? level : (uint8_t)LEVEL_MASTER)->name;
}

static void info_json(const struct replay_header *header, const struct replay_totals *totals)
{
    const struct core_config *config = &header->config;
    struct json json = { .file = stdout };
    json_print(&json,
               "{format: %u, program: %s, seed: %u, fish: %u, round_s: %u, ticks: %u,"
               " seconds: %.3f, modes: [",
               header->version, header->program, config->seed, config->fish_count, config->round_s,
               totals->ticks, (double)totals->ticks / CORE_TICK_HZ);
    for (uint32_t mode = 0; mode < MODE_COUNT; mode++) {
        if (totals->modes >> mode & 1u) {
            json_print(&json, "{mode: %s, grade: %u}", rules_of((uint8_t)mode)->name,
                       table_setup_grade(config, (uint8_t)mode));
        }
    }
    json_print(&json,
               "], level: %s, players: %d, rounds: %u, caught: %u, fouls: %u, hash: %016llx}",
               level_name(header, totals), __builtin_popcount(totals->players), totals->rounds,
               totals->caught, totals->fouls, (unsigned long long)totals->hash);
    json_end(&json);
}

static void info_text(const struct replay_header *header, const struct replay_totals *totals)
{
    const char *gap = "";
    printf("recorded by  Kingyo %s, format %u\nseed         %u\nlength       %.1f s, %u ticks\n"
           "played       ",
           header->program, header->version, header->config.seed,
           (double)totals->ticks / CORE_TICK_HZ, totals->ticks);
    for (uint32_t mode = 0; mode < MODE_COUNT; mode++) {
        if (totals->modes >> mode & 1u) {
            printf("%s%s with No. %u paper", gap, rules_of((uint8_t)mode)->name,
                   table_setup_grade(&header->config, (uint8_t)mode));
            gap = ", ";
        }
    }
    printf("%s\nlevel        %s%s\nplayers      %d\nrounds       %u\ncaught       %u\n"
           "fouls        %u\nstate hash   %016llx\n",
           totals->modes ? "" : "nothing", level_name(header, totals),
           has_levels(header, totals) ? ", unless a player chose another" : "",
           __builtin_popcount(totals->players), totals->rounds, totals->caught, totals->fouls,
           (unsigned long long)totals->hash);
}

static enum exit_code print_replay_info(const char *path, bool as_json)
{
    static struct replay_reader reader;
    struct replay_totals totals;
    if (scan(&reader, path, &totals)) {
        return replayer_print_problem(prefix, path, &reader.problem);
    }
    (as_json ? info_json : info_text)(&reader.header, &totals);
    return EXIT_OK;
}

/* ---- Subcommand verify ----------------------------------------------------------------------- */

/* Recomputes the recording tick by tick. Returns CORE_OK, or CORE_ERR_FLOAT if the core rejected a
 * tick. */
static enum core_error recompute(struct replayer *replayer, struct core *core, uint32_t total)
{
    static struct input input;
    static struct output output;
    const struct kiosk_source source = replayer_source(replayer);
    const struct kiosk_tap tap = replayer_tap(replayer);
    while (!replayer->difference.found && source.next(source.self, &input)) {
        output.sound_count = 0;
        if (core_tick(core, &input, &output) != CORE_OK) {
            return CORE_ERR_FLOAT;
        }
        tap.tick(tap.self, &input, core);
        /* Prints the progress after every ten minutes of simulated time. */
        if (replayer->totals.ticks % (600u * CORE_TICK_HZ) == 0 && isatty(STDERR_FILENO)) {
            fprintf(stderr, "\r%u of %u s", replayer->totals.ticks / CORE_TICK_HZ,
                    total / CORE_TICK_HZ);
        }
    }
    return CORE_OK;
}

/* State of the verification that is in progress. The panic handler reads this state. */
static struct {
    const char *path;
    const struct core *core;
    uint32_t first_tick, total;
} verified;

/* Panic handler for the verification. The recording of a panic reproduces the panic, and the
 * handler prints the reason. Async-signal-safe. */
static void print_panic(void *self, const char *reason)
{
    struct panic_text text = { 0 };
    (void)self;
    panic_put(&text, verified.path);
    panic_put(&text, ": panic in tick ");
    panic_put_number(&text, core_status(verified.core).tick - verified.first_tick);
    panic_put(&text, " of ");
    panic_put_number(&text, verified.total);
    panic_put(&text, ": ");
    panic_put(&text, reason);
    panic_put_end(&text);
    file_write(STDOUT_FILENO, text.out, text.used);
    _exit(EXIT_NOT_SO);
}

static enum exit_code print_result(const char *path, const struct replayer *replayer, double took_s)
{
    const struct replay_difference *difference = &replayer->difference;
    const struct replay_totals *totals = &replayer->totals;
    if (replayer->damaged) {
        return replayer_print_problem(prefix, path, &replayer->reader.problem);
    }
    if (difference->found) {
        print_line(stdout,
                   "%s: tick %u (second %.3f) is the first that differs: "
                   "recorded %s %0*llx, computed %0*llx",
                   path, difference->tick, (double)difference->tick / CORE_TICK_HZ,
                   difference->is_full ? "state" : "digest", difference->is_full ? 16 : 8,
                   (unsigned long long)difference->recorded, difference->is_full ? 16 : 8,
                   (unsigned long long)difference->computed);
        return EXIT_NOT_SO;
    }
    if (replayer_is_interrupted(replayer)) {
        print_line(
            stdout,
            "%s: true up to tick %u, in which a signal ended the recording; that tick causes "
            "no panic",
            path, totals->ticks - 1u);
        return EXIT_OK;
    }
    print_line(stdout,
               "%s: true: %u ticks, %u rounds, %u caught, %u fouls, hash %016llx, "
               "%.0f times real time",
               path, totals->ticks, totals->rounds, totals->caught, totals->fouls,
               (unsigned long long)replayer->reader.totals.hash,
               took_s > 0.0 ? (double)totals->ticks / CORE_TICK_HZ / took_s : 0.0);
    return EXIT_OK;
}

static enum exit_code verify(const char *path)
{
    static struct replayer replayer;
    static struct core core;
    CORE_ASSERT(path);
    struct core_config config;
    struct replay_totals totals;
    const uint64_t begin_ns = ctl_now_ns();
    if (scan(&replayer.reader, path, &totals) || replayer_begin(&replayer, path, &config)) {
        return replayer_print_problem(prefix, path, &replayer.reader.problem);
    }
    replayer.reader.as_is = 1;
    config.lanes = cpu_lanes();
    const enum core_error error = core_init(&core, &config);
    if (error == CORE_ERR_RANGE) {
        return print_fail(
            EXIT_BAD_DATA,
            "kingyoctl replay: %s: byte 32: this version has no such tank or game mode", path);
    }
    if (strcmp(replayer.reader.header.program, KINGYO_VERSION) != 0) {
        print_error("kingyoctl replay: %s: recorded by version %s, recomputed by %s", path,
                    replayer.reader.header.program, KINGYO_VERSION);
    }
    verified.path = path;
    verified.core = &core;
    verified.first_tick = core_status(&core).tick;
    verified.total = totals.ticks;
    panic_prepare(print_panic, NULL);
    const enum core_error refused =
        error == CORE_OK ? recompute(&replayer, &core, totals.ticks) : error;
    replayer_end(&replayer);
    if (refused != CORE_OK) {
        return ctl_float(name);
    }
    return print_result(path, &replayer, 1e-9 * (double)(ctl_now_ns() - begin_ns));
}

struct request {
    const char *path;
    bool as_json;
};

enum group { GROUP_INFO = 1, GROUP_VERIFY = 2 };

static const struct option options[] = {
    { NULL, "FILE", "recording", OPTION_ARGUMENT, .offset = offsetof(struct request, path) },
    { "json", NULL, "print the content of the recording as JSON", OPTION_FLAG,
      .offset = offsetof(struct request, as_json), .groups = GROUP_INFO },
};

static const struct option_table table = OPTION_TABLE(options, NULL);

static enum exit_code replay_run(int argc, const char *const *argv)
{
    struct request request = { .path = NULL };
    if (argc < 1 || (strcmp(argv[0], "info") != 0 && strcmp(argv[0], "verify") != 0)) {
        return ctl_usage(name, "expected 'info FILE' or 'verify FILE'; --help explains them");
    }
    const bool is_info = strcmp(argv[0], "info") == 0;
    const enum exit_code code = ctl_options(name, &table, is_info ? GROUP_INFO : GROUP_VERIFY,
                                            &request, argc - 1, argv + 1);
    if (code == EXIT_OK && !request.path) {
        return ctl_usage(name, "%s: a FILE is missing", argv[0]);
    }
    return code != EXIT_OK ? code
           : is_info       ? print_replay_info(request.path, request.as_json)
                           : verify(request.path);
}

const struct ctl_command ctl_replay = {
    .name = name,
    .summary = "prints the content of a recording, or verifies the recording",
    .usage =
        "  kingyoctl replay info FILE [--json]   prints length, modes with their paper, players,\n"
        "                                        rounds, catch, fouls and hash\n"
        "  kingyoctl replay verify FILE          recomputes the recording at full speed and\n"
        "                                        prints the first tick that differs, or in which\n"
        "                                        the core panics (exit code 1)\n",
    .run = replay_run,
};
