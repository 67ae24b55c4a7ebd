/* play.c -- `kingyoctl play`, which plays rounds with bots (simulated players) at full speed and
 * without a screen. */
#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "core/base/panic.h"
#include "core/game/table_setup.h"
#include "platform/ctl/lib/ctl.h"
#include "platform/ctl/play/bot_file.h"
#include "platform/ctl/play/rounds.h"
#include "platform/os/file.h"
#include "platform/os/json.h"
#include "platform/os/number.h"
#include "platform/os/print.h"

static const char name[] = "play";
static const char prefix[] = "kingyoctl play";

struct play_options {
    const char *bot, *record;
    uint32_t rounds, seed, fish_count, round_s, grade, jobs;
    uint8_t mode, level;
    bool as_json;
};

static struct round_plan plans[ROUNDS_MAX];
static struct round_result results[ROUNDS_MAX];

/* State of one run of `kingyoctl play`. */
struct evening {
    const struct play_options *options;
    /* Numbers of finished and of printed rounds. Rounds are printed in the order of their
     * numbers. */
    uint32_t played, printed;
    bool shows_progress;
};

/* ---- Output ---------------------------------------------------------------------------------- */

/* Writes `value` with `decimals` digits after the decimal point. Returns `out`. */
static const char *fixed(char out[NUMBER_FIXED_MAX + 1u], double value, uint32_t decimals)
{
    out[number_print_fixed(out, value, decimals)] = '\0';
    return out;
}

/* Returns the number of decimals, 0 or 1, with which the median or quantile `value` is printed. */
static uint32_t decimals_of(double value)
{
    return value > (double)(uint64_t)value ? 1u : 0u;
}

static void report_round(uint32_t number, uint32_t seed, const struct round_result *result)
{
    char digits[NUMBER_FIXED_MAX + 1u];
    printf("round %-4u seed %-10u %3u caught in %s s, %u scoops, %u fouls,", number, seed,
           result->caught, fixed(digits, result->length_s, 1), result->scoops, result->fouls);
    if (result->torn) {
        printf(" torn at %s s,", fixed(digits, result->torn_at_s, 1));
        if (result->sheets > 1) {
            printf(" %u sheets,", result->sheets);
        }
    } else {
        fputs(" not torn,", stdout);
    }
    printf(" holes of %u mm2, hash %016llx\n", result->hole_area_mm2,
           (unsigned long long)result->state_hash);
}

static void report_json(uint32_t count, const struct summary *summary)
{
    struct json json = { .file = stdout };
    json_print(&json, "{rounds: [");
    for (uint32_t i = 0; i < count; i++) {
        const struct round_result *result = &results[i];
        json_print(&json,
                   "{caught: %u, scoops: %u, fouls: %u, torn_at_s: %.3f, sheets: %u,"
                   " hole_area_mm2: %u, state_hash: %016llx}",
                   result->caught, result->scoops, result->fouls,
                   result->torn ? result->torn_at_s : (double)NAN, result->sheets,
                   result->hole_area_mm2, (unsigned long long)result->state_hash);
    }
    json_print(&json, "]");
    json_value(&json, "caught_median", "%.*f", (int)decimals_of(summary->median), summary->median);
    json_value(&json, "caught_p90", "%.*f", (int)decimals_of(summary->p90), summary->p90);
    json_print(&json, "caught_max: %u}", summary->max);
    json_end(&json);
}

/* Prints each round as soon as all rounds with lower numbers have finished. JSON is printed only
 * after all rounds have finished, so that a program receives complete JSON or no output. */
static void print_round(void *self, uint32_t index)
{
    struct evening *evening = self;
    CORE_ASSERT(index < evening->options->rounds && evening->played < evening->options->rounds);
    evening->played++;
    while (!evening->options->as_json && evening->printed < evening->options->rounds &&
           results[evening->printed].code == EXIT_OK) {
        const uint32_t at = evening->printed++;
        report_round(at + 1u, plans[at].seed, &results[at]);
        fflush(stdout);
    }
    if (evening->shows_progress) {
        fprintf(stderr, "\r%u of %u rounds%s", evening->played, evening->options->rounds,
                evening->played == evening->options->rounds ? "\n" : "");
    }
}

static void report_all(const struct play_options *options)
{
    static uint32_t caught[ROUNDS_MAX];
    for (uint32_t i = 0; i < options->rounds; i++) {
        caught[i] = results[i].caught;
    }
    const struct summary summary = rounds_summary(caught, options->rounds);
    if (options->as_json) {
        report_json(options->rounds, &summary);
        return;
    }
    char median[NUMBER_FIXED_MAX + 1u], p90[NUMBER_FIXED_MAX + 1u];
    print_line(stdout, "caught: median %s, p90 %s, most %u; %s, %u rounds of %s",
               fixed(median, summary.median, decimals_of(summary.median)),
               fixed(p90, summary.p90, decimals_of(summary.p90)), summary.max, options->bot,
               options->rounds, rules_of(options->mode)->name);
}

static enum exit_code print_failure(const struct play_options *options)
{
    for (uint32_t i = 0; i < options->rounds; i++) {
        if (results[i].code == EXIT_IO) {
            char path[ROUNDS_PATH_MAX];
            rounds_record_path(path, options->record, i);
            return print_fail(EXIT_IO, "%s: %s: cannot record: %s", prefix, path,
                              strerror(results[i].error));
        }
        if (results[i].is_refused) {
            return ctl_float(name);
        }
    }
    return print_fail(EXIT_NOT_SO, "%s: a round did not end", prefix);
}

static enum exit_code play_rounds(const struct play_options *options,
                                  const struct technique *technique)
{
    CORE_ASSERT(options->rounds >= 1 && options->rounds <= ROUNDS_MAX);
    struct evening evening = {
        .options = options,
        .shows_progress = isatty(STDERR_FILENO) && (options->as_json || !isatty(STDOUT_FILENO)),
    };
    for (uint32_t i = 0; i < options->rounds; i++) {
        plans[i] = (struct round_plan){
            .technique = *technique,
            .seed = options->seed + i,
            .mode = options->mode,
            .level = options->level,
            .grade = (uint8_t)options->grade,
            .fish_count = options->fish_count,
            .round_s = options->round_s,
            .record = options->record,
        };
    }
    const struct rounds rounds = {
        .plans = plans,
        .results = results,
        .count = options->rounds,
        .workers = options->jobs ? options->jobs : rounds_workers(),
        .done = print_round,
        .self = &evening,
    };
    const enum exit_code code = rounds_play(&rounds);
    if (code != EXIT_OK) {
        return print_failure(options);
    }
    report_all(options);
    return EXIT_OK;
}

/* ---- Command line ---------------------------------------------------------------------------- */

#define AT(member) .offset = offsetof(struct play_options, member)

/* clang-format off */
static const struct option options_list[] = {
    { "bot", "WHO", "novice, expert, or a bot FILE; the keys of the file are listed below",
      OPTION_TEXT, AT(bot), .initial = "expert", .expects = "novice, expert or a bot FILE" },
    { "mode", "MODE", "game mode", OPTION_CHOICE, AT(mode), .choices = options_mode_names,
      .initial = "festival" },
    { "level", "LEVEL", "level of the festival and of practice; the championship has none",
      OPTION_CHOICE, AT(level), .choices = options_level_names, .initial = "master" },
    { "grade", "G",
      "grade of the paper, from strong to weak; without the option 6, and 5 in a championship",
      OPTION_WHOLE, AT(grade), SHEET_GRADE_MIN, SHEET_GRADE_MAX },
    { "rounds", "N", "number of rounds", OPTION_WHOLE, AT(rounds), 1, ROUNDS_MAX,
      .initial = "1" },
    { "seed", "N",
      "seed of all random numbers. Round i is played in a tank of its own with the seed N + i - 1. "
      "Its result is therefore the same if it is played alone, in any order, and for two bots that "
      "are compared",
      OPTION_WHOLE, AT(seed), 0, UINT32_MAX, .initial = "0" },
    { "fish", "N", "number of fish, up to the maximum of the tank; the default is the kiosk's",
      OPTION_WHOLE, AT(fish_count), 1, SCENE_FISH_MAX },
    { "round-s", "N",
      "seconds in a round; the defaults of the modes are 60, 180 and 180. Fish on the paper at the "
      "end may still be brought to the bowl, 3 s at most",
      OPTION_WHOLE, AT(round_s), 10, 600 },
    { "jobs", "N", "rounds that are played at the same time; the default is one for each core",
      OPTION_WHOLE, AT(jobs), 1, ROUNDS_WORKERS_MAX },
    { "record", "DIR", "record each round to DIR/round-00001.kgr and so on", OPTION_TEXT,
      AT(record) },
    { "json", NULL,
      "print as JSON: caught (fish that count), scoops (times that the ring entered the water), "
      "fouls, torn_at_s (second of the round from which its first paper holds no fish; null if the "
      "paper lasted), sheets (of paper; only practice replaces a torn sheet), hole_area_mm2 (of "
      "the last sheet at the end; 5027 is the whole sheet) and state_hash of each round; the "
      "median, 90 % quantile and maximum of all rounds",
      OPTION_FLAG, AT(as_json) },
};
/* clang-format on */

static const struct option_table table = OPTION_TABLE(options_list, NULL);

static enum exit_code play_command_run(int argc, const char *const *argv)
{
    struct play_options options = { .bot = NULL };
    struct technique technique;
    enum exit_code code = ctl_options(name, &table, 0, &options, argc, argv);
    if (code == EXIT_OK && options.level != LEVEL_MASTER && !rules_of(options.mode)->has_levels) {
        return ctl_usage(name, "--level: a %s has no levels", rules_of(options.mode)->name);
    }
    if (code == EXIT_OK) {
        const struct core_config stall = { 0 };
        const struct tank_preset *preset = tank_preset(table_setup_preset(&stall, options.mode));
        const uint32_t fish_max = tank_preset_fish_max(preset, 1.0f);
        if (options.fish_count > fish_max) {
            return ctl_usage(name, "--fish: '%u' is wrong; the water of a %s holds 1 to %u",
                             options.fish_count, rules_of(options.mode)->name, fish_max);
        }
    }
    code = code == EXIT_OK ? bot_file_read(prefix, options.bot, &technique) : code;
    const int error = code == EXIT_OK && options.record ? file_make_folder(options.record) : 0;
    if (error) {
        return print_fail(EXIT_IO, "%s: %s: cannot record: %s", prefix, options.record,
                          strerror(-error));
    }
    return code == EXIT_OK ? play_rounds(&options, &technique) : code;
}

const struct ctl_command ctl_play = {
    .name = name,
    .summary = "rounds played by a bot, without a screen",
    .options = &table,
    .print_more_help = bot_file_print_keys,
    .run = play_command_run,
};
