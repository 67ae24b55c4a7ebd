/* visitor.h -- the visitors of a simulated day: their arrival, their level, their patience, the
 * price that they accept, and whether they play again. All numbers of a visitor depend only on the
 * seed of the day and the index of the visitor. */
#ifndef KINGYO_TESTS_BENCH_DAY_VISITOR_H
#define KINGYO_TESTS_BENCH_DAY_VISITOR_H

#include <stdbool.h>
#include <stdint.h>

/* Largest number of plays of one visitor. */
#define VISITOR_PLAYS_MAX 4u
#define VISITOR_CATCH_CLASSES 3u

/* A kind of visitor. The shares of all kinds sum to 1. */
struct visitor_kind {
    const char *name;
    const char *habits; /* Row of sim_player_table that describes how the visitor plays. */
    double share;       /* Fraction of all visitors who are of this kind. */
    /* Fractions of the visitors of this kind who choose the level easy or master. The others play
     * at the level that the operator chose. */
    double easy_share, master_share;
    double patience_min_min, patience_max_min; /* Shortest and longest patience, in minutes. */
    /* Probability of another play at a price of one unit. The elements are for no fish, one or two
     * fish, and more fish in the last play. */
    double again[VISITOR_CATCH_CLASSES];
};

extern const struct visitor_kind visitor_kinds[];
extern const uint32_t visitor_kind_count;

enum visitor_fate {
    VISITOR_COMES = 0, /* The visitor has not arrived yet, waits in the queue, or plays for the
                          first time. */
    VISITOR_PLAYED,    /* The visitor played at least once. */
    /* The visitor left the queue, because the visitor's patience ended. */
    VISITOR_LEFT,
    /* The visitor did not join the queue, because the price was too high. */
    VISITOR_DECLINED,
};

struct visitor {
    uint32_t seed; /* Seed of the visitor's random numbers. */
    uint8_t kind;  /* Index in visitor_kinds. */
    uint8_t level; /* Level that the visitor chooses (enum level). */
    double arrival_s;
    double patience_s;  /* Waiting time for one play after which the visitor leaves the queue. */
    uint32_t price_max; /* Highest price that the visitor pays, in units. */

    uint8_t fate;    /* enum visitor_fate */
    double joined_s; /* Time at which the visitor last joined the queue. */
    double wait_s;   /* Waiting time before the first play. */
    /* Numbers of plays, of fish caught in all plays, and of fish caught in the last play. */
    uint32_t plays, caught, caught_last;
};

/* Properties of the day for which the visitors are drawn. */
struct visitor_day {
    /* Length of the opening hours. No visitor arrives later. */
    double hours;
    /* Level that the operator chose (enum level). Visitors who choose no level play at this
     * level. */
    uint8_t level;
    uint32_t seed;
};

/* Fills `visitors` with `count` visitors in the order of their arrival. */
void visitors_draw(struct visitor *visitors, uint32_t count, const struct visitor_day *day);

/* Returns true if the visitor plays again after a play at the price `price`, in units. */
bool visitor_plays_again(const struct visitor *visitor, uint32_t price);

#endif
