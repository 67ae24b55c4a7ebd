/* rounds.h -- rounds played by bots without a screen, each at a stall of its own, on every core.
 *
 * A round is played from outside, as by a person: a hand that holds the controller of the first
 * poi, from the START in attract mode to the result. It shares nothing with any other round: its
 * stall, its fish, its paper and its player's luck all come of its own seed. So it is
 * the same alone and among thousands, and two techniques that get the same seed face the same
 * fish with the same paper. */
#ifndef KINGYO_PLATFORM_CTL_ROUNDS_H
#define KINGYO_PLATFORM_CTL_ROUNDS_H

#include <stdint.h>

#include "core/game/technique.h"
#include "platform/kiosk/options.h"

#define ROUNDS_MAX 100000u
#define ROUNDS_WORKERS_MAX 64u

struct round_plan {
    struct technique technique;
    uint32_t seed;
    uint8_t mode;        /* enum game_mode */
    uint8_t grade;       /* 0: the mode's own; else 4 .. 7. */
    uint32_t fish_count; /* 0: the tank's own. */
    uint32_t round_s;    /* 0: the mode's own; else 10 .. 600. */
    const char *record;  /* Path of a recording that is not there yet, or null. Borrowed. */
};

struct round_result {
    enum exit_code code;    /* EXIT_NOT_SO until it is over. Not EXIT_OK: only `error` holds. */
    int error;              /* EXIT_IO: the errno of the recording. */
    uint8_t is_refused;     /* EXIT_NOT_SO: the core returned CORE_ERR_FLOAT. */
    uint32_t caught;        /* What counts of what came to the bowl. */
    uint32_t scoops;        /* Times the ring went in. */
    uint32_t fouls;
    uint8_t torn;           /* Its first paper could hold nothing any more ... */
    double torn_at_s;       /* ... from this second of the round on. */
    uint32_t sheets;        /* Papers that it got: in practice a torn one is renewed. */
    uint32_t hole_area_mm2; /* Of the last of them, at the end. */
    double length_s;        /* Of the round. */
    uint64_t state_hash;    /* core_hash when the round was over. */
};

struct rounds {
    const struct round_plan *plans;
    struct round_result *results; /* One a plan. */
    uint32_t count;               /* <= ROUNDS_MAX */
    uint32_t workers;             /* At a time, a thread each, 1 .. ROUNDS_WORKERS_MAX. */
    /* After each round, one call at a time, whichever order they end in; may be null. */
    void (*done)(void *self, uint32_t index);
    void *self;
};

/* How many this machine plays at a time: a core each. */
uint32_t rounds_workers(void);

/* Plays them all. EXIT_OK; or, of the first that failed, its code: those behind it may not have
 * been played then, and their code is EXIT_NOT_SO. Tells nothing. */
enum exit_code rounds_play(const struct rounds *rounds);

#endif
