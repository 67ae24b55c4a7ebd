/* hints.c -- proves each aid of the lessons: a simulated player who follows it catches more than a
 * player with the same fault who ignores it.
 *
 * Usage: hints SEEDS LEVEL [SIGN]
 *
 * Both players of a pair (pupils.c) play the same seeds, under the conditions of `make
 * bench-players`. With SIGN, only the pair of this name plays. Returns exit status 1 if the mean
 * catch of a pair is not higher with the sign. With fewer than SEEDS_ENOUGH seeds, this is only
 * printed, because the means of few rounds vary too much. */
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/game/rules.h"
#include "platform/cpu.h"
#include "platform/ctl/play/rounds.h"
#include "platform/os/exit_code.h"
#include "platform/os/number.h"
#include "tests/bench/players/pupils.h"
#include "tests/bench/players/round.h"
#include "tests/bench/progress.h"

#define SEEDS_MAX 1000u
#define SEEDS_ENOUGH 12u

struct school {
    struct pupil pupils[PUPILS_MAX];
    uint32_t pupil_count, seeds;
    uint8_t level;
    const char *only;
    /* Rounds of each pair: for each seed, the round without and the round with the sign. */
    struct player_round *rounds;
    pthread_mutex_t lock;
    uint32_t next;
    bool failed;
    struct progress progress;
};

static bool is_wanted(const struct school *school, uint32_t pupil)
{
    return !school->only || strcmp(school->only, school->pupils[pupil].name) == 0;
}

static void *work(void *self)
{
    struct school *school = self;
    const uint32_t count = 2u * school->pupil_count * school->seeds;
    struct round_worker *worker = malloc(sizeof *worker);
    cpu_set_float();
    pthread_mutex_lock(&school->lock);
    school->failed |= worker == NULL;
    while (!school->failed && school->next < count) {
        const uint32_t index = school->next++, pupil = index / (2u * school->seeds);
        const struct habits *habits =
            index % 2u ? &school->pupils[pupil].follows : &school->pupils[pupil].ignores;
        if (!is_wanted(school, pupil)) {
            continue;
        }
        pthread_mutex_unlock(&school->lock);
        const bool is_played = round_play(worker, habits, school->level, index / 2u % school->seeds,
                                          &school->rounds[index]);
        pthread_mutex_lock(&school->lock);
        school->failed |= !is_played;
        progress_add(&school->progress);
    }
    pthread_mutex_unlock(&school->lock);
    free(worker);
    return NULL;
}

static bool play_all(struct school *school)
{
    pthread_t threads[ROUNDS_WORKERS_MAX];
    uint32_t helpers = 0;
    while (helpers + 1u < rounds_workers() &&
           pthread_create(&threads[helpers], NULL, work, school) == 0) {
        helpers++;
    }
    work(school);
    for (uint32_t i = 0; i < helpers; i++) {
        pthread_join(threads[i], NULL);
    }
    return !school->failed;
}

/* Prints the row of one pair. Returns true if the mean catch is higher with the sign. */
static bool print_pair(const struct school *school, uint32_t pupil)
{
    const struct player_round *rounds = &school->rounds[2u * pupil * school->seeds];
    double sum[2] = { 0 }, more = 0.0, squares = 0.0;
    uint32_t better = 0, worse = 0, torn[2] = { 0 };
    for (uint32_t i = 0; i < school->seeds; i++) {
        const struct player_round *pair = &rounds[2u * i];
        const double gain = (double)pair[1].caught - (double)pair[0].caught;
        for (uint32_t k = 0; k < 2u; k++) {
            sum[k] += (double)pair[k].caught;
            torn[k] += pair[k].torn;
        }
        more += gain;
        squares += gain * gain;
        better += gain > 0.0;
        worse += gain < 0.0;
    }
    const double count = (double)school->seeds, mean = more / count;
    const double error = sqrt(fmax(squares / count - mean * mean, 0.0) / fmax(count - 1.0, 1.0));
    printf("  %-7s %-44s %6.2f %6.2f %+6.2f +- %4.2f %5u %5u %4.0f %% %4.0f %%  %s\n",
           school->pupils[pupil].name, school->pupils[pupil].fault, sum[0] / count, sum[1] / count,
           mean, error, better, worse, 100.0 * torn[0] / count, 100.0 * torn[1] / count,
           mean > 0.0 ? "so" : "NOT SO");
    return mean > 0.0;
}

static enum exit_code report(const struct school *school)
{
    uint32_t missed = 0;
    printf("festival, %u fish, No. %u paper, at most %u s, level %s, %u seeds\n\n"
           "  %-7s %-44s %6s %6s %14s %5s %5s %6s %6s\n",
           ROUND_FISH_COUNT, ROUND_GRADE, ROUND_LENGTH_S, rules_of_level(school->level)->name,
           school->seeds, "sign", "fault", "without", "with", "more", "better", "worse", "torn",
           "with");
    for (uint32_t i = 0; i < school->pupil_count; i++) {
        missed += is_wanted(school, i) && !print_pair(school, i);
    }
    printf("\n%s: %u signs of level %s do not raise the catch\n", missed == 0 ? "so" : "NOT SO",
           missed, rules_of_level(school->level)->name);
    return missed == 0 || school->seeds < SEEDS_ENOUGH ? EXIT_OK : EXIT_NOT_SO;
}

int main(int argc, char **argv)
{
    struct school school = { .lock = PTHREAD_MUTEX_INITIALIZER, .level = LEVEL_COUNT };
    for (uint8_t level = 0; argc > 2 && level < LEVEL_COUNT; level++) {
        school.level = strcmp(argv[2], rules_of_level(level)->name) == 0 ? level : school.level;
    }
    if (argc < 3 || argc > 4 || school.level == LEVEL_COUNT ||
        !number_parse(argv[1], 1, SEEDS_MAX, &school.seeds)) {
        fprintf(stderr, "usage: hints SEEDS LEVEL [SIGN]; SEEDS is 1 to %u\n", SEEDS_MAX);
        return EXIT_USAGE;
    }
    school.only = argc == 4 ? argv[3] : NULL;
    school.pupil_count = pupils_init(school.pupils);
    const uint32_t count = 2u * school.pupil_count * school.seeds;
    school.rounds = calloc(count, sizeof *school.rounds);
    school.progress = progress_begin("hints", school.only ? 2u * school.seeds : count);
    const bool is_played = school.rounds && play_all(&school);
    progress_end(&school.progress);
    if (!is_played) {
        fprintf(stderr, "hints: a round did not come to its end\n");
    }
    const enum exit_code code = is_played ? report(&school) : EXIT_NOT_SO;
    free(school.rounds);
    return (int)code;
}
