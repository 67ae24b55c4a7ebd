/* visitor.c -- the table of the kinds of visitors, and the random numbers of each visitor.
 *
 * The shares of the kinds are assumptions. No published counts of visitors by skill, patience or
 * number of plays are known. An operator can replace each number below by a number that was counted
 * at a real stall. If a source of a number exists, the comment below names the source. */
#include "tests/bench/day/visitor.h"

#include <math.h>
#include <stdlib.h>

#include "core/base/rng.h"
#include "core/scene.h"

/* Sources and reasons of the numbers in the table:
 *
 * Shares: goldfish scooping is first of all a game of children, and stalls keep stronger paper for
 * them (beamsite.net/1897). Most adults never learned the technique: "most people are doing well to
 * get just two or three" (meanwhile-in-japan.com).
 *
 * Levels: most visitors keep the level that the screen offers first. Seven of ten children choose
 * the tag with the picture of a child. Some beginners choose easy, and some practiced players
 * choose master.
 *
 * Patience in minutes: a person in a hurry leaves after two or three minutes. A person who came for
 * the stall waits for up to twenty minutes. A festival has another stall every few metres, so most
 * people wait less.
 *
 * Probability of another play: it is highest after one or two fish, because the player has seen
 * that the technique works and wants more. A child without a fish asks for another try more often
 * than an adult. A practiced player with many fish plays for the ranking. People who write about
 * their first day report several plays (a first-timer caught 15 fish after 6 tries, blog
 * yaruhapi-try). */
/* clang-format off */
const struct visitor_kind visitor_kinds[] = {
    /*  name            habits     share easy  master  patience    again after 0, 1..2, 3.. fish */
    { "child",          "child",   0.35, 0.70, 0.00,  4.0, 12.0, { 0.35, 0.45, 0.35 } },
    { "first-timer",    "clicks",  0.20, 0.25, 0.00,  3.0, 10.0, { 0.25, 0.35, 0.25 } },
    { "adult",          "waits",   0.20, 0.05, 0.00,  3.0, 10.0, { 0.20, 0.35, 0.20 } },
    { "hasty adult",    "chases",  0.05, 0.05, 0.00,  2.0,  6.0, { 0.30, 0.30, 0.15 } },
    { "plunging adult", "plunges", 0.05, 0.05, 0.00,  2.0,  6.0, { 0.30, 0.30, 0.15 } },
    { "careful person", "careful", 0.15, 0.00, 0.30,  5.0, 20.0, { 0.30, 0.40, 0.40 } },
};
/* clang-format on */
const uint32_t visitor_kind_count = sizeof visitor_kinds / sizeof visitor_kinds[0];

/* Every visitor accepts a price of up to three units, and no visitor accepts more than eight. A
 * unit is 100 yen in this model, because a play costs 100 to 400 yen at festivals
 * (meanwhile-in-japan.com). */
#define PRICE_MAX_LOW 3u
#define PRICE_MAX_HIGH 8u
/* Highest probability of another play, at any price. */
#define AGAIN_MAX 0.9
/* The rate of arrivals is constant except for an evening peak, which has the form of a normal
 * distribution. PEAK_AT is the time of the peak and PEAK_WIDTH its standard deviation, both as
 * fractions of the opening hours. At the peak, the rate is 1 + PEAK_GAIN times that of a calm
 * hour. */
#define PEAK_AT 0.7
#define PEAK_WIDTH 0.15
#define PEAK_GAIN 2.0
#define S_PER_HOUR 3600.0
#define S_PER_MIN 60.0

enum draw {
    DRAW_SEED = 0,
    DRAW_KIND,
    DRAW_LEVEL,
    DRAW_PATIENCE,
    DRAW_PRICE,
    DRAW_AGAIN,                                             /* First of the random numbers for
                                                               another play: one for each play. */
    DRAW_ARRIVAL = DRAW_AGAIN + (int)VISITOR_PLAYS_MAX + 1, /* First of the random numbers for the
                                                               arrival: two for each attempt to draw
                                                               a time. */
};

static double draw(uint32_t seed, uint32_t what)
{
    return (double)rng_unit((struct rng_key){ seed, what, 0, RNG_TEST });
}

/* Returns the rate of arrivals as a fraction of its maximum, at the time `share` (a fraction of the
 * opening hours). */
static double arrival_rate(double share)
{
    const double off = (share - PEAK_AT) / PEAK_WIDTH;
    return (1.0 + PEAK_GAIN * exp(-0.5 * off * off)) / (1.0 + PEAK_GAIN);
}

/* Returns a random arrival time in seconds, by rejection sampling: a time is drawn uniformly, and
 * is rejected with a probability that is higher where the rate of arrivals is lower. */
static double draw_arrival_s(uint32_t seed, double hours)
{
    uint32_t what = DRAW_ARRIVAL;
    double share = draw(seed, what);
    while (draw(seed, what + 1u) > arrival_rate(share)) {
        what += 2u;
        share = draw(seed, what);
    }
    return share * hours * S_PER_HOUR;
}

static uint8_t draw_kind(uint32_t seed)
{
    double left = draw(seed, DRAW_KIND);
    uint32_t kind = 0;
    while (kind + 1u < visitor_kind_count && left >= visitor_kinds[kind].share) {
        left -= visitor_kinds[kind++].share;
    }
    return (uint8_t)kind;
}

static uint8_t draw_level(const struct visitor_kind *kind, uint32_t seed, uint8_t level)
{
    const double chosen = draw(seed, DRAW_LEVEL);
    return chosen < kind->easy_share                        ? (uint8_t)LEVEL_EASY
           : chosen < kind->easy_share + kind->master_share ? (uint8_t)LEVEL_MASTER
                                                            : level;
}

static int compare_arrivals(const void *a, const void *b)
{
    const struct visitor *x = a, *y = b;
    return (x->arrival_s > y->arrival_s) - (x->arrival_s < y->arrival_s);
}

void visitors_draw(struct visitor *visitors, uint32_t count, const struct visitor_day *day)
{
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t seed = rng_u32((struct rng_key){ day->seed, DRAW_SEED, i, RNG_TEST });
        const uint8_t kind = draw_kind(seed);
        const struct visitor_kind *row = &visitor_kinds[kind];
        const double patience_min =
            row->patience_min_min +
            draw(seed, DRAW_PATIENCE) * (row->patience_max_min - row->patience_min_min);
        const double price_range = (double)(PRICE_MAX_HIGH - PRICE_MAX_LOW + 1u);
        visitors[i] = (struct visitor){
            .seed = seed,
            .kind = kind,
            .level = draw_level(row, seed, day->level),
            .arrival_s = draw_arrival_s(seed, day->hours),
            .patience_s = patience_min * S_PER_MIN,
            .price_max = PRICE_MAX_LOW + (uint32_t)(draw(seed, DRAW_PRICE) * price_range),
        };
    }
    qsort(visitors, count, sizeof *visitors, compare_arrivals);
}

/* The probability falls with the price as 2 / (1 + price). At a price of two units it is two thirds
 * of the probability at one unit, and in free play it is doubled. */
bool visitor_plays_again(const struct visitor *visitor, uint32_t price)
{
    const uint32_t class = visitor->caught_last > 2u ? 2u : visitor->caught_last > 0u;
    const double chance = visitor_kinds[visitor->kind].again[class] * 2.0 / (1.0 + (double)price);
    return visitor->plays < VISITOR_PLAYS_MAX &&
           draw(visitor->seed, DRAW_AGAIN + visitor->plays) < fmin(chance, AGAIN_MAX);
}
