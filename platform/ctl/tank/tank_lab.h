/* tank_lab.h -- simulates a tank without a game, and measures the tank.
 *
 * A poi (a paper scoop) that follows a path is simulated by core/poi: the spring to the hand, the
 * water, the paper and the carried fish. The steps of a tick (1/120 s) have the same order as in
 * core_tick(). The rules of the game, the bot and the bowl are not simulated. */
#pragma once

#include <stdint.h>

#include "core/output.h"
#include "core/poi/bowl/bowl.h"
#include "core/poi/poi.h"
#include "core/tank/tank.h"
#include "platform/ctl/tank/overlap.h"
#include "platform/ctl/tank/tank_options.h"
#include "platform/ctl/tank/tank_files.h"

/* Sums over all ticks that were observed, and over all fish. A fish-tick is one fish in one
 * observed tick. */
struct lab_sums {
    uint64_t fish_ticks;
    uint64_t gait_ticks[GAIT_COUNT];
    double stamina;
    /* Fish-ticks of fish that swim. Fish that are moved by a poi or that fall through the air are
     * not counted. */
    uint64_t swim_ticks;
    double speed_m_s, speed_max_m_s;
};

struct tank_lab {
    const struct tank_options *plan;
    struct tank tank;
    struct poi poi; /* Poi that follows the path. Used only if `path.count` is above 0. */
    /* Bowl that the functions of the core expect as an argument. The simulation does not use the
     * bowl, so all fields are zero. */
    struct bowl bowl;
    struct output output;
    struct tank_path path;
    uint32_t tick; /* Number of ticks that were completed. */

    struct overlap overlap;
    struct overlap_count overlaps;
    struct lab_sums sums;
    struct tank_meetings meetings;
    float oxygen_start_mg_l;
    uint32_t observe_every; /* Number of ticks between two observations. */
    uint32_t observed_tick; /* Number of completed ticks at the last observation. */
    uint32_t timed_count;   /* Number of valid entries of `tick_ns`. */
    /* CPU time of tank_tick() in nanoseconds, for each timed tick. The array has plan->tick_count
     * elements. Every tick is timed if `observe_every` is at most BROAD_PHASE_UPDATE_TICKS. */
    float *tick_ns;
    /* Number of fish within the shades, at the start and after each second. The array has
     * tank_lab_seconds() elements. */
    uint32_t *shade_count;
    /* Number of fish that breathe at the water surface, at the start and after each second. The
     * array has tank_lab_seconds() elements. */
    uint32_t *surfacing_count;
};

/* Returns the number of elements of `shade_count` and of `surfacing_count`: one for the start and
 * one for each whole second of the simulation. */
uint32_t tank_lab_seconds(const struct tank_options *plan);

/* Opens the tank that `plan` describes and reads the files that the plan names. All fields of `lab`
 * must be 0 before the call. `plan` must outlive `lab`. Returns EXIT_OK, or prints one line to
 * standard error and returns another exit code. */
enum exit_code tank_lab_open(struct tank_lab *lab, const struct tank_options *plan);

/* Advances the tank by one tick and measures the CPU time. Every `observe_every` ticks and after
 * the last tick of the plan, also measures overlaps, encounters, gaits and speeds. */
void tank_lab_tick(struct tank_lab *lab);

/* Returns the hash of the tank's state. If a poi follows a path, the hash includes the poi. */
uint64_t tank_lab_hash(const struct tank_lab *lab);

/* Frees the arrays of the laboratory. */
void tank_lab_close(struct tank_lab *lab);
