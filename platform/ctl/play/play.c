/* play.c -- `kingyoctl play`, which plays rounds with bots (simulated players) at full speed and
 * without a screen. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "core/core.h"
#include "platform/ctl/lib/ctl.h"
#include "platform/ctl/lib/summary.h"
#include "platform/ctl/play/bot_file.h"
#include "platform/ctl/play/bot_keys.h"
#include "platform/ctl/play/play_report.h"
#include "platform/ctl/play/rounds.h"
#include "platform/os/directory.h"
#include "platform/os/number.h"
#include "platform/os/print.h"

static const char name[] = "play";
static const char speaker[] = "kingyoctl play";

#define PATH_MAX_CHARS (DIRECTORY_PATH_MAX + 32u)

struct play_options {
    const char *bot, *record;
    uint32_t rounds, seed, fish_count, round_s, grade, jobs;
    uint8_t mode;
    int as_json;
};

/* State of one run of `kingyoctl play`. */
struct evening {
    const struct play_options *options;
    struct round_plan *plans;
    struct round_result *results;
    char (*paths)[PATH_MAX_CHARS]; /* Path of the recording of each round. */
    /* Number of fish caught in each round. The array is sorted for the summary. */
    uint32_t *caught;
    /* `played` is the number of finished rounds. `told` is the number of printed rounds, which are
     * printed in the order of their numbers. */
    uint32_t played, told;
    int shows_progress;
};

/* ---- Output ---------------------------------------------------------------------------------- */

static void play_print_progress(const struct evening *evening)
{
    if (evening->shows_progress) {
        fprintf(stderr, "\r%u of %u rounds%s", evening->played, evening->options->rounds,
                evening->played == evening->options->rounds ? "\n" : "");
    }
}

/* Prints each round as soon as all rounds with lower numbers have finished. JSON is printed only
 * after all rounds have finished, so that a program receives complete JSON or no output. */
static void tell_round(void *self, uint32_t index)
{
    struct evening *evening = self;
    (void)index;
    evening->played++;
    while (!evening->options->as_json && evening->told < evening->options->rounds &&
           evening->results[evening->told].code == EXIT_OK) {
        const uint32_t at = evening->told++;
        play_report_round(at + 1u, evening->plans[at].seed, &evening->results[at]);
        fflush(stdout);
    }
    play_print_progress(evening);
}

static void tell_all(struct evening *evening)
{
    const struct play_options *options = evening->options;
    for (uint32_t i = 0; i < options->rounds; i++) {
        evening->caught[i] = evening->results[i].caught;
    }
    const struct summary summary = summary_of(evening->caught, options->rounds);
    if (options->as_json) {
        play_report_json(evening->results, options->rounds, &summary);
        return;
    }
    play_report_summary(&summary);
    print_line(stdout, "; %s, %u rounds of %s", options->bot, options->rounds,
               rules_of(options->mode)->name);
}

static enum exit_code tell_failure(const struct evening *evening)
{
    for (uint32_t i = 0; i < evening->options->rounds; i++) {
        const struct round_result *result = &evening->results[i];
        if (result->code == EXIT_IO) {
            print_error("%s: %s: cannot record: %s", speaker, evening->paths[i],
                        strerror(result->error));
            return EXIT_IO;
        }
        if (result->is_refused) {
            return ctl_float(name);
        }
    }
    print_error("%s: a round did not come to its end", speaker);
    return EXIT_NOT_SO;
}

/* ---- Playing the rounds ---------------------------------------------------------------------- */

static void plan_rounds(struct evening *evening, const struct technique *technique)
{
    const struct play_options *options = evening->options;
    for (uint32_t i = 0; i < options->rounds; i++) {
        evening->plans[i] = (struct round_plan){
            .technique = *technique,
            .seed = options->seed + i,
            .mode = options->mode,
            .grade = (uint8_t)options->grade,
            .fish_count = options->fish_count,
            .round_s = options->round_s,
        };
        if (options->record) {
            snprintf(evening->paths[i], sizeof evening->paths[i], "%s/round-%05u.kgr",
                     options->record, i + 1u);
            evening->plans[i].record = evening->paths[i];
        }
    }
}

static enum exit_code play(struct evening *evening)
{
    const struct play_options *options = evening->options;
    const struct rounds rounds = {
        .plans = evening->plans,
        .results = evening->results,
        .count = options->rounds,
        .workers = options->jobs ? options->jobs : rounds_workers(),
        .done = tell_round,
        .self = evening,
    };
    if (rounds_play(&rounds) != EXIT_OK) {
        return tell_failure(evening);
    }
    tell_all(evening);
    return EXIT_OK;
}

static enum exit_code hold_evening(const struct play_options *options,
                                   const struct technique *technique)
{
    struct evening evening = {
        .options = options,
        .plans = calloc(options->rounds, sizeof *evening.plans),
        .results = calloc(options->rounds, sizeof *evening.results),
        .caught = calloc(options->rounds, sizeof *evening.caught),
        .paths = calloc(options->record ? options->rounds : 1u, sizeof *evening.paths),
        .shows_progress = isatty(STDERR_FILENO) && (options->as_json || !isatty(STDOUT_FILENO)),
    };
    enum exit_code code = EXIT_NOT_SO;
    if (evening.plans && evening.results && evening.caught && evening.paths) {
        plan_rounds(&evening, technique);
        code = play(&evening);
    } else {
        print_error("%s: no memory for %u rounds", speaker, options->rounds);
    }
    free(evening.plans);
    free(evening.results);
    free(evening.caught);
    free(evening.paths);
    return code;
}

/* ---- Command line ---------------------------------------------------------------------------- */

static int parse_mode(const char *value, uint8_t *out)
{
    for (uint8_t mode = 0; value && mode < MODE_COUNT; mode++) {
        if (strcmp(value, rules_of(mode)->name) == 0) {
            *out = mode;
            return 1;
        }
    }
    return 0;
}

static int parse_text(const char *value, const char **out)
{
    *out = value;
    return value && value[0];
}

/* Parses `value` for `option`. Returns 1 if the value is valid, 0 if the value is invalid, and -1
 * if the option does not exist. */
static int take_value(struct play_options *options, const char *option, const char *value)
{
    if (strcmp(option, "--bot") == 0) {
        return parse_text(value, &options->bot);
    }
    if (strcmp(option, "--mode") == 0) {
        return parse_mode(value, &options->mode);
    }
    if (strcmp(option, "--grade") == 0) {
        return number_parse(value, SHEET_GRADE_MIN, SHEET_GRADE_MAX, &options->grade);
    }
    if (strcmp(option, "--rounds") == 0) {
        return number_parse(value, 1, ROUNDS_MAX, &options->rounds);
    }
    if (strcmp(option, "--seed") == 0) {
        return number_parse(value, 0, UINT32_MAX, &options->seed);
    }
    if (strcmp(option, "--fish") == 0) {
        return number_parse(value, 1, SCENE_FISH_MAX, &options->fish_count);
    }
    if (strcmp(option, "--round-s") == 0) {
        return number_parse(value, 10, 600, &options->round_s);
    }
    if (strcmp(option, "--jobs") == 0) {
        return number_parse(value, 1, ROUNDS_WORKERS_MAX, &options->jobs);
    }
    return strcmp(option, "--record") == 0 ? parse_text(value, &options->record) : -1;
}

/* Parses the option at argv[*index] and its value, and advances `*index`. Returns EXIT_OK, or
 * prints one line to standard error and returns another exit code. */
static enum exit_code play_take_option(struct play_options *options, int argc,
                                       const char *const *argv, int *index)
{
    const char *option = argv[*index];
    if (strcmp(option, "--json") == 0) {
        options->as_json = 1;
        return EXIT_OK;
    }
    const char *value = *index + 1 < argc ? argv[++*index] : NULL;
    const int right = take_value(options, option, value);
    if (right < 0) {
        return ctl_usage(name, "unknown option '%.100s'; --help lists them", option);
    }
    if (!right) {
        return ctl_usage(name, "%s: '%.100s' is not right; --help says what is", option,
                         value ? value : "");
    }
    return EXIT_OK;
}

/* Checks rules that concern several options. Returns EXIT_OK, or prints one line to standard error
 * and returns another exit code. */
static enum exit_code check_options(const struct play_options *options)
{
    const struct rules *rules = rules_of(options->mode);
    const struct core_config stall = { 0 };
    const struct tank_preset *preset = tank_preset(table_setup_preset(&stall, options->mode));
    const uint32_t fish_max = tank_preset_fish_max(preset, 1.0f);
    if (options->fish_count > fish_max) {
        return ctl_usage(name, "--fish: '%u' is not right; the water of a %s holds 1 to %u",
                         options->fish_count, rules->name, fish_max);
    }
    return EXIT_OK;
}

static enum exit_code open_folder(const struct play_options *options)
{
    const int error = options->record ? directory_make(options->record) : 0;
    if (error) {
        print_error("%s: %s: cannot record: %s", speaker, options->record, strerror(-error));
        return EXIT_IO;
    }
    return EXIT_OK;
}

static enum exit_code play_command_run(int argc, const char *const *argv)
{
    struct play_options options = { .bot = "expert", .rounds = 1 };
    struct technique technique;
    enum exit_code code = EXIT_OK;
    for (int i = 0; i < argc && code == EXIT_OK; i++) {
        code = play_take_option(&options, argc, argv, &i);
    }
    code = code == EXIT_OK ? check_options(&options) : code;
    code = code == EXIT_OK ? bot_file_named(speaker, options.bot, &technique) : code;
    code = code == EXIT_OK ? open_folder(&options) : code;
    return code == EXIT_OK ? hold_evening(&options, &technique) : code;
}

const struct ctl_command ctl_play = {
    .name = name,
    .summary = "rounds played by a bot, without a screen",
    .usage =
        "  --bot WHO        novice, expert, or a bot FILE: see below (expert)\n"
        "  --mode MODE      festival, championship or practice (festival)\n"
        "  --grade G        of the paper, 4 strong to 7 weak (festival and practice 6,\n"
        "                   championship 5)\n"
        "  --rounds N       how many rounds, 1 to 100000 (1)\n"
        "  --seed N         of everything random (0): the i-th round is played at a stall of its\n"
        "                   own with the seed N + i - 1, so it is the same alone, in any order,\n"
        "                   and for two bots that are to be compared\n"
        "  --fish N         how many fish, from 1 to what the water holds (the stall's own)\n"
        "  --round-s N      seconds a round, 10 to 600 (the mode's own: 60, 180, 180); what lies\n"
        "                   on the paper when time is called may be brought home, 3 s at most\n"
        "  --jobs N         rounds at a time, 1 to 64 (a core each)\n"
        "  --record DIR     write each round to DIR/round-00001.kgr and so on\n"
        "  --json           for programs: caught (what counts), scoops (times the ring went in),\n"
        "                   fouls, torn_at_s (second of the round from which its first paper\n"
        "                   holds no fish; null: it lasted), sheets (of paper; a torn one is\n"
        "                   renewed in practice alone), hole_area_mm2 (of the last of them,\n"
        "                   at the end; 5027 is all), state_hash of each round;\n"
        "                   median, ninth decile and maximum of all\n",
    .tell_more = bot_keys_print,
    .run = play_command_run,
};
