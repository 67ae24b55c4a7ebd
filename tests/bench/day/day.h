/* day.h -- a simulated day at one kiosk: the queue of the visitors, the order in which they play,
 * and the sums of the day. The day calls the kiosk only through struct day_kiosk, so that a test
 * can replace the kiosk. */
#ifndef KINGYO_TESTS_BENCH_DAY_DAY_H
#define KINGYO_TESTS_BENCH_DAY_DAY_H

#include <stdbool.h>
#include <stdint.h>

#include "core/input.h"
#include "core/scene.h"
#include "tests/bench/day/visitor.h"
#include "tests/bench/progress.h"

#define DAY_VISITORS_MAX 2000u
/* Time in seconds from the end of a result to the first press of START. In this time the players
 * change, insert a coin and read the choice screen. */
#define DAY_CHANGE_S 10.0
/* Time in seconds for which the players look at the result. */
#define DAY_RESULT_S 6.0

struct day_options {
    uint32_t price;   /* Price of a round in units; 0 means free play. */
    uint32_t round_s; /* Length of a round in seconds. */
    uint8_t level;    /* Level of visitors who choose none (enum level). */
    uint32_t bowls;   /* Number of bowls, 1 .. POI_MAX. */
    uint32_t visitors, seed;
    uint32_t hours; /* Opening hours. */
    /* Share of the visitors who must catch a fish, in per cent. */
    uint32_t goal;
};

struct day_round {
    uint32_t caught[POI_MAX]; /* Number of fish that each person of the group caught. */
    /* Length of the round in seconds, from the change of the players to the end of the result. */
    double took_s;
};

/* Sums that the core's accounts counted on the day. */
struct day_money {
    uint32_t units; /* Value of all inserted coins, in units of the price. */
    uint32_t paid_plays, free_plays, caught, refunds;
};

/* Functions of the kiosk that the day calls. Each function returns false if the kiosk failed. */
struct day_kiosk {
    /* Plays one round with the `count` persons of `group` at the level `level`, and writes the
     * result to `out`. */
    bool (*play)(void *self, const struct visitor *const *group, uint32_t count, uint8_t level,
                 struct day_round *out);
    /* Runs the kiosk for `seconds` while nobody plays. */
    bool (*idle)(void *self, double seconds);
    void *self;
};

struct day {
    const struct day_options *options;
    struct day_kiosk kiosk;
    /* Progress that is printed; null means that no progress is printed. */
    struct progress *progress;
    struct visitor visitors[DAY_VISITORS_MAX];
    uint32_t visitor_count;

    double now_s;
    uint32_t next;                    /* Number of visitors who have arrived. */
    uint32_t queue[DAY_VISITORS_MAX]; /* Indices of the visitors in the queue, first come first. */
    uint32_t queue_length;
    uint32_t queue_longest;    /* Largest number of visitors who waited in the queue when a round
                                 began. */
    uint32_t playing[POI_MAX]; /* Indices of the visitors at the bowls. */
    uint32_t playing_count;

    uint32_t rounds[LEVEL_COUNT]; /* Number of rounds at each level (enum level). */
    /* Total duration of the rounds in seconds, including the changes of the players. */
    double busy_s;
    /* Time in seconds at which the last round ended. */
    double end_s;
};

/* Draws the visitors of the day at random. The day keeps the pointer `options`. */
void day_init(struct day *day, const struct day_options *options, struct day_kiosk kiosk);

/* Plays the day until the last visitor has left. Returns false if the kiosk failed. */
bool day_run(struct day *day);

#endif
