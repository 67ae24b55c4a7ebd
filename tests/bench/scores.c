/* scores.c -- checks that bots catch about as many fish as people do.
 *
 * Usage: scores ROUNDS OUT. OUT is the folder of scores.tsv.
 *
 * The bots play the festival with No. 6 paper and the championship with No. 5 paper, which are the
 * defaults of these game modes. The goals come from real events: most visitors of a festival catch
 * at most two or three fish, and a beginner at the championship catches one or two. The winners of
 * seven championships caught 35 to 87 fish, and the record is 107.
 *
 * Returns exit status 1 if a goal is missed. */
#include <stdbool.h>
#include <stdio.h>

#include "core/scene.h"
#include "platform/ctl/play/rounds.h"
#include "platform/os/number.h"
#include "tests/bench/league.h"

static const char prefix[] = "scores";

static const struct goal {
    const char *name;
    const struct technique *technique;
    uint8_t mode;
    double median_min, median_max;
    uint32_t max_below; /* The mean catch must be less than this number. 0 means no upper limit. */
} goals[] = {
    { "festival novice", &technique_novice, MODE_FESTIVAL, 1, 3, 0 },
    { "championship novice", &technique_novice, MODE_CHAMPIONSHIP, 0, 3, 0 },
    { "championship expert", &technique_expert, MODE_CHAMPIONSHIP, 35, 70, 120 },
};
#define GOAL_COUNT (sizeof goals / sizeof goals[0])

static bool is_met(const struct goal *goal, const struct summary *found)
{
    return found->median >= goal->median_min && found->median <= goal->median_max &&
           (goal->max_below == 0 || found->max < goal->max_below);
}

static double mean_scoops(const struct league *league, uint32_t arm)
{
    double sum = 0.0;
    for (uint32_t i = 0; i < league->seeds; i++) {
        sum += (double)league->arms[arm].results[i].scoops;
    }
    return sum / (double)league->seeds;
}

static uint32_t count_torn(const struct league *league, uint32_t arm)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < league->seeds; i++) {
        count += league->arms[arm].results[i].torn;
    }
    return count;
}

/* Prints the result of one goal as a line. Returns 1 if the goal is met. */
static int print_goal(const struct league *league, uint32_t arm, const struct goal *goal)
{
    uint32_t caught[LEAGUE_SEEDS_MAX];
    char target[64];
    league_caught(league, arm, caught);
    const struct summary found = rounds_summary(caught, league->seeds);
    const int met = is_met(goal, &found);
    snprintf(target, sizeof target,
             goal->max_below ? "median %g to %g, most under %u" : "median %g to %g",
             goal->median_min, goal->median_max, goal->max_below);
    printf("  %-20s %6.1f %6.1f %5u  %6.1f %5u  %-33s %s\n", goal->name, found.median, found.p90,
           found.max, mean_scoops(league, arm), count_torn(league, arm), target,
           met ? "so" : "NOT SO");
    return met;
}

int main(int argc, char **argv)
{
    struct league league = { .prefix = prefix };
    uint32_t arms[GOAL_COUNT];
    int well = 1;
    if (argc != 3 || !number_parse(argv[1], 1, LEAGUE_SEEDS_MAX, &league.seeds)) {
        fprintf(stderr, "usage: scores ROUNDS OUT; ROUNDS is 1 to %u\n", LEAGUE_SEEDS_MAX);
        return EXIT_USAGE;
    }
    for (size_t i = 0; i < GOAL_COUNT; i++) {
        const struct round_plan plan = { .technique = *goals[i].technique, .mode = goals[i].mode };
        arms[i] = league_arm(&league, goals[i].name, &plan);
    }
    enum exit_code code = league_play(&league);
    if (code != EXIT_OK) {
        return (int)code;
    }
    printf("%u rounds each, seeds 0 to %u; %.0f s on %u cores\n\n", league.seeds, league.seeds - 1u,
           league.took_s, rounds_workers());
    printf("  %-20s %6s %6s %5s  %6s %5s  %s\n", "fish caught", "median", "p90", "most", "scoops",
           "torn", "goal");
    for (size_t i = 0; i < GOAL_COUNT; i++) {
        well &= print_goal(&league, arms[i], &goals[i]);
    }
    code = league_write_rounds(&league, argv[2], "scores.tsv");
    league_end(&league);
    return (int)(code != EXIT_OK ? code : well ? EXIT_OK : EXIT_NOT_SO);
}
