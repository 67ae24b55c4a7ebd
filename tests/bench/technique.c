/* technique.c -- checks that good technique catches more fish. In each of seven experiments, two
 * bots that differ in one habit play the same rounds.
 *
 * Usage: technique SEEDS BOTS OUT [FIRST]. BOTS is the folder of the *.bot files, OUT the folder of
 * technique.tsv, and FIRST the first seed (default 0).
 *
 * All rounds are played in the festival mode with 300 fish and No. 6 paper, and last at most 60 s.
 * Both bots of an experiment play the same seeds, so they get the same fish and the same paper. The
 * habits are those that stall keepers advise (tests/FIGURES.md has the results). A habit pays if
 * the first bot, which has the habit, catches significantly more than the second.
 *
 * Returns exit status 0 if all required habits pay and none of them is clearly worse
 * (PLAINLY_WRONG_P). With fewer than SEEDS_ENOUGH seeds, only PAYS_MIN of the required habits must
 * pay. Otherwise returns 1. */
#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "core/scene.h"
#include "platform/ctl/play/bot_file.h"
#include "platform/os/number.h"
#include "tests/bench/league.h"
#include "tests/bench/statistics.h"

#define SEEDS_ENOUGH 200u
/* Number of required habits that must pay if fewer than SEEDS_ENOUGH seeds are played. The effects
 * of a few habits are so large that few seeds are enough to show them. */
#define PAYS_MIN 2u
/* Significance level for a result that is clearly worse. The level of 5 % is for all six required
 * experiments together, so each experiment gets a sixth of it. Without this correction, one run in
 * four with few seeds would fail by chance. */
#define PLAINLY_WRONG_P (0.05 / 6.0)
#define FISH_COUNT 300u
#define ROUND_S 60u
#define GRADE 6u
#define PATH_CHARS 1200u

static const char prefix[] = "technique";

static const struct experiment {
    /* Names of the .bot files of the two bots. The first bot is expected to catch more. */
    const char *better, *worse;
    const char *title;
    /* True if the test fails unless the first bot catches more; false if the result is only
     * printed, in whichever direction it goes. */
    bool must_pay;
} experiments[] = {
    { "all-wet", "half-wet", "all wet over half wet", true },
    { "slanted", "flat", "slanted over flat entry", true },
    { "edge-leading", "broadside", "edge-leading over broadside glide", true },
    { "head-first", "tail-first", "head first over tail on", true },
    /* This habit is not required: scooping near the rim cannot catch more fish in the game, as
     * tests/FIGURES.md explains ("Why the rim does not pay"). */
    { "near-rim", "centre", "near the rim over the centre", false },
    { "drained-lift", "fast-lift", "level drained over fast flat lift", true },
    { "still-shade", "chase", "still shade over chasing", true },
};
#define EXPERIMENT_COUNT (sizeof experiments / sizeof experiments[0])

static const char *const verdict_names[VERDICT_COUNT] = { "pays", "not shown", "WRONG WAY" };

struct trial {
    uint32_t better, worse; /* Indices of the league arms of the better and the worse bot. */
    struct comparison found;
    enum verdict verdict;
};

/* ---- Arms of an experiment ------------------------------------------------------------------ */

static enum exit_code add_arm(struct league *league, const char *folder, const char *name,
                              uint32_t *out)
{
    struct round_plan plan = {
        .mode = MODE_FESTIVAL, .grade = GRADE, .fish_count = FISH_COUNT, .round_s = ROUND_S
    };
    char path[PATH_CHARS];
    snprintf(path, sizeof path, "%s/%s.bot", folder, name);
    const enum exit_code code = bot_file_read(prefix, path, &plan.technique);
    if (code == EXIT_OK) {
        *out = league_arm(league, name, &plan);
    }
    return code;
}

/* Adds the two bots of an experiment as arms. Equal plans of both bots are an error, because such
 * an experiment would test nothing. */
static enum exit_code add_experiment(struct league *league, const char *folder,
                                     const struct experiment *experiment, struct trial *trial)
{
    enum exit_code code = add_arm(league, folder, experiment->better, &trial->better);
    code = code == EXIT_OK ? add_arm(league, folder, experiment->worse, &trial->worse) : code;
    if (code == EXIT_OK && trial->better == trial->worse) {
        fprintf(stderr, "%s: %s.bot and %s.bot play alike\n", prefix, experiment->better,
                experiment->worse);
        return EXIT_BAD_DATA;
    }
    return code;
}

/* ---- Evaluation ------------------------------------------------------------------------------ */

static void evaluate(const struct league *league, struct trial *trial)
{
    uint32_t better[LEAGUE_SEEDS_MAX], worse[LEAGUE_SEEDS_MAX];
    league_caught(league, trial->better, better);
    league_caught(league, trial->worse, worse);
    trial->found = statistics_compare(better, worse, league->seeds);
    trial->verdict = statistics_verdict(&trial->found);
}

/* Returns true if enough required habits pay and none of them is clearly worse. With at least
 * SEEDS_ENOUGH seeds, all required habits must pay, each at the 5 % level. With fewer seeds,
 * PAYS_MIN habits must pay, because few seeds may not show a small effect. */
static bool all_is_well(const struct trial *trials, uint32_t seeds)
{
    uint32_t required = 0, paid = 0, wrong_way = 0, plainly_wrong = 0;
    for (size_t i = 0; i < EXPERIMENT_COUNT; i++) {
        required += experiments[i].must_pay;
        paid += experiments[i].must_pay && trials[i].verdict == VERDICT_PAYS;
        const bool is_wrong = experiments[i].must_pay && trials[i].verdict == VERDICT_WRONG_WAY;
        wrong_way += is_wrong;
        plainly_wrong += is_wrong && trials[i].found.p < PLAINLY_WRONG_P;
    }
    const uint32_t needed = seeds >= SEEDS_ENOUGH ? required : PAYS_MIN;
    const int well = paid >= needed && plainly_wrong == 0;
    printf("\n%s: %u of %u required habits pay; %u of them go the wrong way, %u of these plainly "
           "(p < %.4f). With %u seeds %u must pay and none may go plainly wrong. The other habits "
           "are not required (tests/FIGURES.md)\n",
           well ? "so" : "NOT SO", paid, required, wrong_way, plainly_wrong, PLAINLY_WRONG_P, seeds,
           needed);
    return well;
}

/* ---- Report --------------------------------------------------------------------------------- */

static void print_p(FILE *file, double p)
{
    fprintf(file, p < 1e-4 ? "%.0e" : "%.4f", p);
}

static void print_trials(const struct league *league, const struct trial *trials)
{
    printf("festival, %u fish, No. %u paper, at most %u s, %u paired seeds from %u on; "
           "%.0f s on %u cores\n"
           "95 %% confidence by paired t; p by the exact two-sided signed-rank test\n\n"
           "  %-34s %6s %6s  %7s  %-16s %-7s %s\n",
           FISH_COUNT, GRADE, ROUND_S, league->seeds, league->first, league->took_s,
           rounds_workers(), "catches per poi: A over B", "A", "B", "A - B", "95 %", "p",
           "verdict");
    for (size_t i = 0; i < EXPERIMENT_COUNT; i++) {
        const struct comparison *found = &trials[i].found;
        printf("  %-34s %6.2f %6.2f  %+7.2f  %+6.2f .. %+6.2f ", experiments[i].title,
               found->mean_a, found->mean_b, found->difference, found->low, found->high);
        print_p(stdout, found->p);
        printf("%*s%s\n", found->p < 1e-4 ? 3 : 2, "", verdict_names[trials[i].verdict]);
    }
}

static enum exit_code write_trials(const struct league *league, const struct trial *trials,
                                   const char *folder)
{
    FILE *file = league_file(league, folder, "technique.tsv");
    if (!file) {
        return EXIT_IO;
    }
    fputs("technique\tseeds\tmean_a\tmean_b\tdifference\tlow\thigh\tp\tverdict\n", file);
    for (size_t i = 0; i < EXPERIMENT_COUNT; i++) {
        const struct comparison *found = &trials[i].found;
        fprintf(file, "%s\t%u\t%.4f\t%.4f\t%.4f\t%.4f\t%.4f\t", experiments[i].title, league->seeds,
                found->mean_a, found->mean_b, found->difference, found->low, found->high);
        fprintf(file, "%.3g\t%s\n", found->p, verdict_names[trials[i].verdict]);
    }
    return league_close(league, file, "technique.tsv");
}

int main(int argc, char **argv)
{
    struct league league = { .prefix = prefix };
    struct trial trials[EXPERIMENT_COUNT] = { 0 };
    if (argc < 4 || argc > 5 || !number_parse(argv[1], 1, LEAGUE_SEEDS_MAX, &league.seeds) ||
        (argc == 5 && !number_parse(argv[4], 0, UINT32_MAX, &league.first))) {
        fprintf(stderr, "usage: technique SEEDS BOTS OUT [FIRST]; SEEDS is 1 to %u\n",
                LEAGUE_SEEDS_MAX);
        return EXIT_USAGE;
    }
    enum exit_code code = EXIT_OK;
    for (size_t i = 0; i < EXPERIMENT_COUNT && code == EXIT_OK; i++) {
        code = add_experiment(&league, argv[2], &experiments[i], &trials[i]);
    }
    code = code == EXIT_OK ? league_play(&league) : code;
    if (code != EXIT_OK) {
        return (int)code;
    }
    for (size_t i = 0; i < EXPERIMENT_COUNT; i++) {
        evaluate(&league, &trials[i]);
    }
    print_trials(&league, trials);
    code = write_trials(&league, trials, argv[3]);
    code = code == EXIT_OK ? league_write_rounds(&league, argv[3], "rounds.tsv") : code;
    const int well = all_is_well(trials, league.seeds);
    league_end(&league);
    return (int)(code != EXIT_OK ? code : well ? EXIT_OK : EXIT_NOT_SO);
}
