/* rounds.h -- plays rounds with bots (simulated players), without a screen and on all CPU cores.
 * Each round has its own simulated kiosk.
 *
 * The bot moves the controller of the first poi (paper scoop), from the press of START until the
 * result of the round, as a person would. Rounds share no state. All random numbers of a round, for
 * its fish, its paper and its bot, come from the seed of the round. The result of a round is
 * therefore independent of the other rounds. Two techniques with the same seed get the same fish
 * and the same paper. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/game/bot/technique.h"
#include "platform/config/options.h"
#include "platform/os/file.h"

#define ROUNDS_MAX 100000u
#define ROUNDS_WORKERS_MAX 64u

struct round_plan {
    struct technique technique;
    uint32_t seed;
    uint8_t mode;        /* Game mode (enum game_mode). */
    uint8_t level;       /* Level of the player (enum level). */
    uint8_t grade;       /* Paper grade, 4 .. 7. 0 selects the default grade of the game mode. */
    uint32_t fish_count; /* Number of fish. 0 selects the number of the tank preset. */
    /* Length of the round in seconds, 10 .. 600. 0 selects the default length of the game mode. */
    uint32_t round_s;
    /* Folder in which the recording is created (rounds_record_path()), or null for no recording.
     * The recording must not exist yet. The caller owns the string. */
    const char *record;
};

struct round_result {
    /* Exit code of the round, or EXIT_NOT_SO while the round has not ended. If the code is not
     * EXIT_OK, only `error` and `is_refused` are valid. */
    enum exit_code code;
    int error; /* Errno of the write error of the recording. Valid if `code` is EXIT_IO. */
    /* True if `code` is EXIT_NOT_SO because the core returned CORE_ERR_FLOAT. */
    bool is_refused;
    uint32_t caught; /* Number of caught fish that are counted in the result. */
    uint32_t scoops; /* Number of times that the poi's ring entered the water. */
    uint32_t fouls;
    bool torn; /* True if the first paper tore so far that it could no longer hold a fish. */
    /* Time in the round at which the first paper tore, in seconds. 0 if `torn` is false. */
    double torn_at_s;
    /* Number of papers that the player used. A torn paper is replaced only in a practice round. */
    uint32_t sheets;
    uint32_t hole_area_mm2; /* Hole area of the last paper at the end of the round, in mm^2. */
    double length_s;        /* Length of the round in seconds. */
    uint64_t state_hash;    /* Hash of the core (core_hash()) at the end of the round. */
};

struct rounds {
    const struct round_plan *plans;
    struct round_result *results; /* Array with one result for each plan. */
    uint32_t count;               /* Number of plans and of results, at most ROUNDS_MAX. */
    uint32_t workers;             /* Number of worker threads, 1 .. ROUNDS_WORKERS_MAX. */
    /* Callback after each round, or null. Rounds may end in any order. Only one thread at a time
     * calls the callback. */
    void (*done)(void *self, uint32_t index);
    void *self;
};

/* Size in bytes of the path of a recording. */
#define ROUNDS_PATH_MAX (FILE_FOLDER_MAX + 32u)

/* Writes the path of the recording of the round with the index `index` to `out`, for example
 * "FOLDER/round-00001.kgr" for the index 0. */
void rounds_record_path(char out[ROUNDS_PATH_MAX], const char *folder, uint32_t index);

/* Returns the number of rounds that this machine plays in parallel, which is the number of CPU
 * cores. */
uint32_t rounds_workers(void);

/* Plays all rounds and prints nothing. Returns EXIT_OK, or the exit code of the first round that
 * failed. After a failure, no further round is started, and rounds that were not played have the
 * code EXIT_NOT_SO. */
enum exit_code rounds_play(const struct rounds *rounds);

struct summary {
    /* `median` is the value that half of the values do not exceed (50 % quantile), and `p90` is the
     * 90 % quantile. A quantile between two values is interpolated linearly. */
    double median, p90;
    uint32_t max;
};

/* Computes the summary of `count` values. Sorts `values` in place. `count` must be at least 1. */
struct summary rounds_summary(uint32_t *values, uint32_t count);
