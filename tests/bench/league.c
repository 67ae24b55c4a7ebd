/* league.c -- implementation of league.h: plans the rounds of a benchmark and plays them on all
 * processor cores. */
#include "tests/bench/league.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "tests/bench/progress.h"

#define PATH_CHARS 1200u

/* Prints the progress after each round. */
static void print_progress(void *self, uint32_t index)
{
    (void)index;
    progress_add(self);
}

/* ---- Arms of an experiment ------------------------------------------------------------------ */

static int same_plan(const struct round_plan *a, const struct round_plan *b)
{
    return memcmp(&a->technique, &b->technique, sizeof a->technique) == 0 && a->mode == b->mode &&
           a->grade == b->grade && a->fish_count == b->fish_count && a->round_s == b->round_s;
}

uint32_t league_arm(struct league *league, const char *name, const struct round_plan *plan)
{
    for (uint32_t i = 0; i < league->arm_count; i++) {
        if (same_plan(&league->arms[i].plan, plan)) {
            return i;
        }
    }
    if (league->arm_count == LEAGUE_ARMS_MAX) {
        fprintf(stderr, "%s: more than %u arms\n", league->prefix, LEAGUE_ARMS_MAX);
        /* No benchmark adds more than LEAGUE_ARMS_MAX arms, so this is a programming error. */
        abort();
    }
    league->arms[league->arm_count] = (struct arm){ .name = name, .plan = *plan };
    return league->arm_count++;
}

/* Plans all rounds: first a round of each arm (way to play) with the first seed, then a round of
 * each arm with the second seed, and so on. Because the arms alternate, the remaining time can be
 * estimated from the rounds played so far. */
static struct round_plan *plan_all(const struct league *league)
{
    struct round_plan *plans = calloc((size_t)league->seeds * league->arm_count, sizeof *plans);
    for (uint32_t i = 0; plans && i < league->seeds * league->arm_count; i++) {
        plans[i] = league->arms[i % league->arm_count].plan;
        plans[i].seed = league->first + i / league->arm_count;
    }
    return plans;
}

/* Sorts the results by arm (way to play) and then by seed. */
static struct round_result *sort_results(const struct league *league,
                                         const struct round_result *played)
{
    const uint32_t count = league->seeds * league->arm_count;
    struct round_result *sorted = calloc(count, sizeof *sorted);
    for (uint32_t i = 0; sorted && i < count; i++) {
        sorted[i % league->arm_count * league->seeds + i / league->arm_count] = played[i];
    }
    return sorted;
}

enum exit_code league_play(struct league *league)
{
    const uint32_t count = league->seeds * league->arm_count;
    struct progress progress = progress_begin(league->prefix, count);
    struct round_plan *plans = plan_all(league);
    struct round_result *played = calloc(count, sizeof *played);
    const struct rounds rounds = { .plans = plans,
                                   .results = played,
                                   .count = count,
                                   .workers = rounds_workers(),
                                   .done = print_progress,
                                   .self = &progress };
    const enum exit_code code = plans && played ? rounds_play(&rounds) : EXIT_NOT_SO;
    struct round_result *sorted = code == EXIT_OK ? sort_results(league, played) : NULL;
    free(plans);
    free(played);
    league->took_s = progress_end(&progress);
    if (!sorted) {
        fprintf(stderr, "%s: a round did not come to its end\n", league->prefix);
        return EXIT_NOT_SO;
    }
    for (uint32_t i = 0; i < league->arm_count; i++) {
        league->arms[i].results = sorted + (size_t)i * league->seeds;
    }
    return EXIT_OK;
}

void league_end(struct league *league)
{
    free((void *)(uintptr_t)league->arms[0].results);
    league->arm_count = 0;
}

void league_caught(const struct league *league, uint32_t index, uint32_t *caught)
{
    for (uint32_t i = 0; i < league->seeds; i++) {
        caught[i] = league->arms[index].results[i].caught;
    }
}

/* ---- Files ---------------------------------------------------------------------------------- */

FILE *league_file(const struct league *league, const char *folder, const char *name)
{
    char path[PATH_CHARS];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE *file = fopen(path, "w");
    if (!file) {
        fprintf(stderr, "%s: %s: %s\n", league->prefix, path, strerror(errno));
    }
    return file;
}

enum exit_code league_close(const struct league *league, FILE *file, const char *name)
{
    const int failed = ferror(file);
    if (fclose(file) != 0 || failed) {
        fprintf(stderr, "%s: %s: cannot be written\n", league->prefix, name);
        return EXIT_IO;
    }
    return EXIT_OK;
}

static void write_round(FILE *file, const char *arm, uint32_t seed,
                        const struct round_result *result)
{
    fprintf(file, "%s\t%u\t%u\t%u\t%u\t", arm, seed, result->caught, result->scoops, result->fouls);
    if (result->torn) {
        fprintf(file, "%.3f", result->torn_at_s);
    }
    fprintf(file, "\t%u\t%016llx\n", result->hole_area_mm2, (unsigned long long)result->state_hash);
}

enum exit_code league_write_rounds(const struct league *league, const char *folder,
                                   const char *name)
{
    FILE *file = league_file(league, folder, name);
    if (!file) {
        return EXIT_IO;
    }
    fputs("arm\tseed\tcaught\tscoops\tfouls\ttorn_at_s\thole_area_mm2\tstate_hash\n", file);
    for (uint32_t a = 0; a < league->arm_count; a++) {
        for (uint32_t i = 0; i < league->seeds; i++) {
            write_round(file, league->arms[a].name, league->first + i, &league->arms[a].results[i]);
        }
    }
    return league_close(league, file, name);
}
