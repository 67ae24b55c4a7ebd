/* goals.c -- implementation of goals.h: the table of the targets for the catches of the simulated
 * players, and the comparison with the catches. */
#include "tests/bench/players/goals.h"

#include <stdio.h>
#include <string.h>

#include "platform/ctl/play/rounds.h"

/* Required relation between a player's catches and those of the player `careful` with the same
 * seeds. Only statistically significant differences count. */
enum relation { RELATION_NONE = 0, RELATION_NOT_WORSE, RELATION_BETTER };
#define REFERENCE "careful"

struct goal {
    /* Smallest allowed median and mean of the number of fish caught in a round; 0 means no
     * target. */
    double median_min, mean_min;
    double empty_max; /* Largest allowed share of rounds without a fish; 0 means no target. */
    uint8_t relation;
};

static const struct {
    const char *player;
    struct goal levels[LEVEL_COUNT];
} goals[] = {
    { "clicks",
      { [LEVEL_EASY] = { .median_min = 1.0, .empty_max = 0.25 },
        [LEVEL_NORMAL] = { .mean_min = 0.5 } } },
    { "child",
      { [LEVEL_EASY] = { .median_min = 2.0, .empty_max = 0.10 },
        [LEVEL_NORMAL] = { .median_min = 1.0, .empty_max = 0.40 } } },
    { "waits",
      { [LEVEL_EASY] = { .median_min = 3.0, .empty_max = 0.05 },
        [LEVEL_NORMAL] = { .median_min = 2.0, .empty_max = 0.20 } } },
    { "careful",
      { [LEVEL_EASY] = { .median_min = 6.0 },
        [LEVEL_NORMAL] = { .median_min = 5.0 },
        [LEVEL_MASTER] = { .median_min = 4.0 } } },
    { "careful-tilt",
      { [LEVEL_EASY] = { .relation = RELATION_NOT_WORSE },
        [LEVEL_NORMAL] = { .relation = RELATION_NOT_WORSE },
        [LEVEL_MASTER] = { .relation = RELATION_BETTER } } },
};
#define GOAL_COUNT (sizeof goals / sizeof goals[0])

/* Players in ascending order of their mean catch. The benchmark requires this order at every
 * level. */
static const char *const order[] = { "clicks", "child", "waits", "careful", "expert-bot" };
#define ORDER_COUNT (sizeof order / sizeof order[0])

struct score goals_score(const char *player, const uint32_t *caught, uint32_t *sorted,
                         uint32_t count)
{
    struct score score = { .player = player, .caught = caught };
    for (uint32_t i = 0; i < count; i++) {
        sorted[i] = caught[i];
        score.mean += (double)caught[i] / (double)count;
        score.empty_share += (caught[i] == 0 ? 1.0 : 0.0) / (double)count;
    }
    score.median = rounds_summary(sorted, count).median;
    return score;
}

static const struct score *find_score(const struct score *scores, uint32_t count, const char *name)
{
    for (uint32_t i = 0; i < count; i++) {
        if (strcmp(scores[i].player, name) == 0) {
            return &scores[i];
        }
    }
    return NULL;
}

/* If `is_missed` is true, prints the missed target and returns 1. Otherwise returns 0. */
static uint32_t miss(bool is_missed, const char *player, const char *what, double found,
                     double target)
{
    if (is_missed) {
        printf("  MISSED: %s: %s %.2f, target %.2f\n", player, what, found, target);
    }
    return is_missed;
}

/* Checks all targets of one player at one level. `careful` is the score of the player REFERENCE, or
 * null if that player did not play. Returns the number of missed targets. */
static uint32_t check_goal(const struct goal *goal, const struct score *score,
                           const struct score *careful, uint32_t count)
{
    const char *name = score->player;
    uint32_t missed = miss(score->median < goal->median_min, name, "median at least", score->median,
                           goal->median_min);
    missed +=
        miss(score->mean < goal->mean_min, name, "mean at least", score->mean, goal->mean_min);
    missed += miss(goal->empty_max > 0.0 && score->empty_share > goal->empty_max, name,
                   "share of empty rounds at most", score->empty_share, goal->empty_max);
    if (goal->relation != RELATION_NONE && careful && count > 1) {
        const struct comparison found = statistics_compare(score->caught, careful->caught, count);
        const enum verdict verdict = statistics_verdict(&found);
        const bool is_missed = goal->relation == RELATION_BETTER ? verdict != VERDICT_PAYS
                                                                 : verdict == VERDICT_WRONG_WAY;
        missed += miss(is_missed, name,
                       goal->relation == RELATION_BETTER ? "mean better than careful,"
                                                         : "mean not worse than careful,",
                       score->mean, careful->mean);
    }
    return missed;
}

uint32_t goals_check(const struct score *scores, uint32_t score_count, uint32_t count,
                     uint8_t level)
{
    const struct score *careful = find_score(scores, score_count, REFERENCE);
    uint32_t missed = 0;
    for (size_t i = 0; i < GOAL_COUNT; i++) {
        const struct score *score = find_score(scores, score_count, goals[i].player);
        missed += score ? check_goal(&goals[i].levels[level], score, careful, count) : 0u;
    }
    for (size_t i = 0; i + 1u < ORDER_COUNT; i++) {
        const struct score *low = find_score(scores, score_count, order[i]);
        const struct score *high = find_score(scores, score_count, order[i + 1u]);
        if (low && high && low->mean >= high->mean) {
            printf("  MISSED: order: mean of %s %.2f, of %s %.2f\n", low->player, low->mean,
                   high->player, high->mean);
            missed++;
        }
    }
    return missed;
}
