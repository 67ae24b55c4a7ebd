/* hints.c -- proves that each aid of the lessons helps: a simulated player who follows the aid
 * catches more than a player with the same fault who ignores the aid.
 *
 * Usage: hints SEEDS LEVEL [SIGN]
 *
 * Both players of a pair (pupils.c) play the same seeds, under the conditions of `make
 * bench-players`. With SIGN, only the pair of this name plays. Returns exit status 1 if the mean
 * catch of a pair is not significantly higher with the sign (statistics.h). With fewer than
 * SEEDS_ENOUGH seeds, this is only printed, because the means of few rounds vary too much. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/game/rules.h"
#include "platform/os/exit_code.h"
#include "platform/os/number.h"
#include "tests/bench/players/pupils.h"
#include "tests/bench/players/round_pool.h"
#include "tests/bench/statistics.h"

#define SEEDS_MAX 1000u
#define SEEDS_ENOUGH 30u

static const char prefix[] = "hints";

struct school {
    struct pupil pupils[PUPILS_MAX];
    uint32_t pupil_count, seeds;
    uint8_t level;
    const char *only;
    /* Rounds of each pair: for each seed, the round without and the round with the sign. */
    struct player_round *rounds;
};

static bool is_selected(const struct school *school, uint32_t pupil)
{
    return !school->only || strcmp(school->only, school->pupils[pupil].name) == 0;
}

/* Plays the rounds of all selected pairs. First all pairs play the first seed, then all pairs play
 * the second seed, and so on. Returns false if there is no memory, or if a round did not end. */
static bool play_all(struct school *school)
{
    const uint32_t count = 2u * school->pupil_count * school->seeds;
    struct pool_round *pool = calloc(count, sizeof *pool);
    uint32_t planned = 0;
    school->rounds = calloc(count, sizeof *school->rounds);
    for (uint32_t i = 0; pool && school->rounds && i < count; i++) {
        const uint32_t pupil = i / 2u % school->pupil_count, seed = i / 2u / school->pupil_count;
        const struct pupil *pair = &school->pupils[pupil];
        if (is_selected(school, pupil)) {
            pool[planned++] = (struct pool_round){
                .habits = i % 2u ? &pair->follows : &pair->ignores,
                .seed = seed,
                .result = &school->rounds[2u * (pupil * school->seeds + seed) + i % 2u],
            };
        }
    }
    double took_s;
    const bool is_played =
        pool && school->rounds && round_pool_play(prefix, pool, planned, school->level, &took_s);
    free(pool);
    return is_played;
}

/* Prints the row of one pair. Returns true if the mean catch is significantly higher with the
 * sign. */
static bool print_pair(const struct school *school, uint32_t pupil)
{
    const struct player_round *rounds = &school->rounds[2u * pupil * school->seeds];
    uint32_t caught[2][SEEDS_MAX], torn[2] = { 0 }, better = 0, worse = 0;
    for (uint32_t i = 0; i < school->seeds; i++) {
        const struct player_round *pair = &rounds[2u * i];
        for (uint32_t k = 0; k < 2u; k++) {
            caught[k][i] = pair[k].caught;
            torn[k] += pair[k].torn;
        }
        better += pair[1].caught > pair[0].caught;
        worse += pair[1].caught < pair[0].caught;
    }
    const struct comparison found = statistics_compare(caught[1], caught[0], school->seeds);
    const bool is_proved = statistics_verdict(&found) == VERDICT_PAYS;
    const double count = (double)school->seeds;
    printf("  %-7s %-44s %6.2f %6.2f %+6.2f %6.2f .. %-6.2f %5u %5u %4.0f %% %4.0f %%  %s\n",
           school->pupils[pupil].name, school->pupils[pupil].fault, found.mean_b, found.mean_a,
           found.difference, found.low, found.high, better, worse, 100.0 * torn[0] / count,
           100.0 * torn[1] / count, is_proved ? "so" : "NOT SO");
    return is_proved;
}

static enum exit_code report(const struct school *school)
{
    uint32_t missed = 0;
    printf("festival, %u fish, No. %u paper, at most %u s, level %s, %u seeds\n\n"
           "  %-7s %-44s %7s %5s %6s %16s %5s %5s %6s %6s\n",
           ROUND_FISH_COUNT, rules_grade_at_level(ROUND_GRADE, school->level), ROUND_LENGTH_S,
           rules_of_level(school->level)->name, school->seeds, "sign", "fault", "without", "with",
           "more", "95 % interval", "better", "worse", "torn", "with");
    for (uint32_t i = 0; i < school->pupil_count; i++) {
        missed += is_selected(school, i) && !print_pair(school, i);
    }
    printf("\n%s: %u signs of level %s are not shown to raise the catch\n",
           missed == 0 ? "so" : "NOT SO", missed, rules_of_level(school->level)->name);
    return missed == 0 || school->seeds < SEEDS_ENOUGH ? EXIT_OK : EXIT_NOT_SO;
}

int main(int argc, char **argv)
{
    struct school school = { .only = argc == 4 ? argv[3] : NULL };
    uint32_t selected = 0;
    school.pupil_count = pupils_init(school.pupils);
    for (uint32_t i = 0; i < school.pupil_count; i++) {
        selected += is_selected(&school, i);
    }
    if (argc < 3 || argc > 4 || !round_pool_level(argv[2], &school.level) ||
        !number_parse(argv[1], 1, SEEDS_MAX, &school.seeds)) {
        fprintf(stderr, "usage: hints SEEDS LEVEL [SIGN]; SEEDS is 1 to %u\n", SEEDS_MAX);
        return EXIT_USAGE;
    }
    if (selected == 0) {
        fprintf(stderr, "%s: no sign '%s'; the signs are", prefix, school.only);
        for (uint32_t i = 0; i < school.pupil_count; i++) {
            fprintf(stderr, " %s", school.pupils[i].name);
        }
        fprintf(stderr, "\n");
        return EXIT_USAGE;
    }
    const enum exit_code code = play_all(&school) ? report(&school) : EXIT_NOT_SO;
    free(school.rounds);
    return (int)code;
}
