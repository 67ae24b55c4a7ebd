/* day.h -- a simulated day at one kiosk: the queue of the visitors, who plays when, and the sums of
 * the day.
 *
 * The kiosk itself is behind struct day_stall, so that a test can replace it. */
#ifndef KINGYO_TESTS_BENCH_DAY_DAY_H
#define KINGYO_TESTS_BENCH_DAY_DAY_H

#include <stdbool.h>
#include <stdint.h>

#include "core/input.h"
#include "core/scene.h"
#include "tests/bench/day/visitor.h"
#include "tests/bench/progress.h"

#define DAY_VISITORS_MAX 2000u
/* Time from the end of a result to the first press of START: the players change, insert a coin and
 * read the choice screen. */
#define DAY_CHANGE_S 10.0
/* Time for which the players look at the result. */
#define DAY_RESULT_S 6.0

struct day_options {
    uint32_t price;   /* Price of a round in units; 0 means free play. */
    uint32_t round_s; /* Length of a round in seconds. */
    uint8_t level;    /* Level of visitors who choose none (enum level). */
    uint32_t bowls;   /* Number of bowls, 1 .. POI_MAX. */
    uint32_t visitors, seed;
    uint32_t hours; /* Opening hours. */
    uint32_t goal;  /* Least share of the visitors who must get a fish, in per cent. */
};

struct day_round {
    uint32_t caught[POI_MAX]; /* Number of fish that each person of the group caught. */
    double took_s;            /* Time from the change of the players to the end of the result. */
};

/* What the core's accounts counted on the day. */
struct day_money {
    uint32_t units; /* Value of all inserted coins, in units of the price. */
    uint32_t paid_plays, free_plays, caught, refunds;
};

/* The kiosk of the day. Each function returns false if the kiosk failed. */
struct day_stall {
    /* Plays one round with the `count` persons of `group` at the level `level`. */
    bool (*play)(void *self, const struct visitor *const *group, uint32_t count, uint8_t level,
                 struct day_round *out);
    bool (*idle)(void *self, double seconds); /* Lets time pass while nobody is at the kiosk. */
    void *self;
};

struct day {
    const struct day_options *options;
    struct day_stall stall;
    struct progress *progress; /* Null if nothing is printed. */
    struct visitor visitors[DAY_VISITORS_MAX];
    uint32_t visitor_count;

    double now_s;
    uint32_t next;                    /* Number of visitors who have arrived. */
    uint32_t queue[DAY_VISITORS_MAX]; /* Indices of the visitors in the queue, first come first. */
    uint32_t queue_length;
    uint32_t queue_longest;   /* Largest number of visitors who waited when a round began. */
    uint32_t seated[POI_MAX]; /* Indices of the visitors at the bowls. */
    uint32_t seated_count;

    uint32_t rounds[LEVEL_COUNT]; /* Number of rounds at each level (enum level). */
    double busy_s;                /* Total time of the rounds, with the changes of the players. */
    double end_s;                 /* Time of the end of the last round. */
};

/* Draws the visitors. `options` is kept. */
void day_init(struct day *day, const struct day_options *options, struct day_stall stall);

/* Plays the day until the last visitor has left. Returns false if the kiosk failed. */
bool day_run(struct day *day);

#endif
