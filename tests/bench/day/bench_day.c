/* bench_day.c -- simulates a day of visitors at one kiosk, so that an operator can choose the
 * price, the length of a round, the level and the number of bowls.
 *
 * Usage: bench_day OUT [--price UNITS] [--round SECONDS] [--level LEVEL] [--players BOWLS]
 * [--visitors N] [--seed SEED] [--hours HOURS] [--goal PERCENT]
 *
 * OUT is the folder of visitors.tsv. Simulated persons (bench/players) play every round through the
 * decoders of their input devices and the frame loop of the kiosk. The core's accounts count the
 * payments. The result depends only on the options.
 *
 * Returns exit status 0 if at least PERCENT of all visitors have caught a fish, and 1 if the goal
 * is missed. */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "core/game/rules.h"
#include "platform/cpu.h"
#include "platform/os/number.h"
#include "tests/bench/day/report.h"
#include "tests/bench/day/table.h"

#define PATH_CHARS 1200u
#define HOURS_MAX 24u
#define ROUND_S_MIN 10u
#define ROUND_S_MAX 600u

static const char prefix[] = "bench_day";

static bool read_level(const char *value, uint8_t *out)
{
    for (uint8_t level = 0; level < LEVEL_COUNT; level++) {
        if (strcmp(value, rules_of_level(level)->name) == 0) {
            *out = level;
            return true;
        }
    }
    return false;
}

static bool read_option(const char *name, const char *value, struct day_options *options)
{
    const struct {
        const char *name;
        uint32_t min, max;
        uint32_t *out;
    } numbers[] = {
        { "--price", 0, CREDIT_COINS_MAX, &options->price },
        { "--round", ROUND_S_MIN, ROUND_S_MAX, &options->round_s },
        { "--players", 1, POI_MAX, &options->bowls },
        { "--visitors", 1, DAY_VISITORS_MAX, &options->visitors },
        { "--seed", 0, UINT32_MAX, &options->seed },
        { "--hours", 1, HOURS_MAX, &options->hours },
        { "--goal", 0, 100, &options->goal },
    };
    for (size_t i = 0; i < sizeof numbers / sizeof numbers[0]; i++) {
        if (strcmp(name, numbers[i].name) == 0) {
            return number_parse(value, numbers[i].min, numbers[i].max, numbers[i].out);
        }
    }
    return strcmp(name, "--level") == 0 && read_level(value, &options->level);
}

static bool read_options(int argc, char **argv, struct day_options *options)
{
    if (argc < 2 || argc % 2 != 0) {
        return false;
    }
    for (int i = 2; i < argc; i += 2) {
        if (!read_option(argv[i], argv[i + 1], options)) {
            return false;
        }
    }
    return true;
}

/* Writes visitors.tsv. Returns EXIT_OK, or EXIT_IO after an error message. */
static enum exit_code write_visitors(const struct day *day, const char *folder)
{
    char path[PATH_CHARS];
    snprintf(path, sizeof path, "%s/visitors.tsv", folder);
    FILE *file = fopen(path, "w");
    if (!file) {
        fprintf(stderr, "%s: %s: %s\n", prefix, path, strerror(errno));
        return EXIT_IO;
    }
    report_write(day, file);
    const bool failed = ferror(file) != 0;
    if (fclose(file) != 0 || failed) {
        fprintf(stderr, "%s: %s: cannot be written\n", prefix, path);
        return EXIT_IO;
    }
    return EXIT_OK;
}

/* Simulates the day and prints its tables. Returns the exit code of the program. */
static enum exit_code run(const struct day_options *options, const char *folder, struct day *day,
                          struct table *table)
{
    cpu_set_float();
    if (!table_open(table, options)) {
        fprintf(stderr, "%s: the kiosk did not start\n", prefix);
        return EXIT_NOT_SO;
    }
    struct progress progress = progress_begin(prefix, options->visitors);
    progress.unit = "visitors";
    day_init(day, options, table_kiosk(table));
    day->progress = &progress;
    const bool is_played = day_run(day);
    const double took_s = progress_end(&progress);
    if (!is_played) {
        fprintf(stderr, "%s: a round did not begin or did not come to its end\n", prefix);
        return EXIT_NOT_SO;
    }
    printf("%u visitors in %u h, bowls: %u, price: %u, round: %u s, default level: %s, seed: %u; "
           "took %.0f s, %.0f s of processor time\n\n",
           options->visitors, options->hours, options->bowls, options->price, options->round_s,
           rules_of_level(options->level)->name, options->seed, took_s,
           (double)clock() / CLOCKS_PER_SEC);
    const struct day_money money = table_money(table);
    const enum exit_code code = report_print(day, &money), written = write_visitors(day, folder);
    return written != EXIT_OK ? written : code;
}

int main(int argc, char **argv)
{
    struct day_options options = {
        .price = 1,
        .round_s = rules_of(MODE_FESTIVAL)->round_s,
        .level = LEVEL_NORMAL,
        .bowls = 1,
        .visitors = 200,
        .hours = 8,
        .goal = 90,
    };
    if (!read_options(argc, argv, &options)) {
        fprintf(
            stderr,
            "usage: bench_day OUT [--price 0..%u] [--round %u..%u] [--level easy|normal|master] "
            "[--players 1..%u] [--visitors 1..%u] [--seed N] [--hours 1..%u] [--goal 0..100]\n",
            CREDIT_COINS_MAX, ROUND_S_MIN, ROUND_S_MAX, POI_MAX, DAY_VISITORS_MAX, HOURS_MAX);
        return EXIT_USAGE;
    }
    struct day *day = malloc(sizeof *day);
    struct table *table = malloc(sizeof *table);
    const enum exit_code code = day && table ? run(&options, argv[1], day, table) : EXIT_NOT_SO;
    free(day);
    free(table);
    return (int)code;
}
