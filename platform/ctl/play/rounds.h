/* rounds.h -- rounds that bots play without a screen, each in its own simulated kiosk, on all CPU
 * cores.
 *
 * A round is played from outside, as a person would play it: the bot moves the controller of the
 * first poi from the START in attract mode to the result. A round shares nothing with other rounds.
 * Its kiosk, its fish, its paper and the bot's random numbers all come from the round's own seed.
 * The result is therefore the same alone and among thousands of rounds. Two techniques with the
 * same seed get the same fish and the same paper. */
#ifndef KINGYO_PLATFORM_CTL_PLAY_ROUNDS_H
#define KINGYO_PLATFORM_CTL_PLAY_ROUNDS_H

#include <stdint.h>

#include "core/game/bot/technique.h"
#include "platform/config/options.h"

#define ROUNDS_MAX 100000u
#define ROUNDS_WORKERS_MAX 64u

struct round_plan {
    struct technique technique;
    uint32_t seed;
    uint8_t mode;        /* Game mode, enum game_mode. */
    uint8_t grade;       /* Paper grade 4 .. 7. A value of 0 selects the grade of the mode. */
    uint32_t fish_count; /* Number of fish. A value of 0 selects the number of the tank preset. */
    /* Length of the round in seconds, 10 .. 600. A value of 0 selects the length of the mode. */
    uint32_t round_s;
    /* Path of the recording to create, or null for no recording. The file must not exist. The
     * caller owns the string. */
    const char *record;
};

struct round_result {
    /* Exit code of the round, or EXIT_NOT_SO until the round has ended. If the code is not EXIT_OK,
     * only `error` and `is_refused` are valid. */
    enum exit_code code;
    int error; /* errno of the recording if `code` is EXIT_IO. */
    /* 1 if `code` is EXIT_NOT_SO because the core returned CORE_ERR_FLOAT. */
    uint8_t is_refused;
    uint32_t caught; /* Number of caught fish that count. */
    uint32_t scoops; /* Number of times the ring entered the water. */
    uint32_t fouls;
    uint8_t torn;     /* 1 if the first paper tore so far that it could not hold a fish. */
    double torn_at_s; /* Second of the round in which the first paper tore. */
    /* Number of papers that the player used. A torn paper is replaced in a practice round. */
    uint32_t sheets;
    uint32_t hole_area_mm2; /* Hole area of the last paper at the end of the round. */
    double length_s;        /* Length of the round in seconds. */
    uint64_t state_hash;    /* Hash of the core (core_hash()) at the end of the round. */
};

struct rounds {
    const struct round_plan *plans;
    struct round_result *results; /* Results, one for each plan. */
    uint32_t count;               /* Number of rounds, at most ROUNDS_MAX. */
    uint32_t workers;             /* Number of worker threads, 1 .. ROUNDS_WORKERS_MAX. */
    /* Callback after each round, or null. Rounds may end in any order, but the calls never
     * overlap. */
    void (*done)(void *self, uint32_t index);
    void *self;
};

/* Returns the number of rounds that this machine plays in parallel, one for each CPU core. */
uint32_t rounds_workers(void);

/* Plays all rounds. Returns EXIT_OK, or the code of the first round that failed. Later rounds may
 * then not have been played and have the code EXIT_NOT_SO. The function prints nothing. */
enum exit_code rounds_play(const struct rounds *rounds);

#endif
