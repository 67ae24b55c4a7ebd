/* tank_lab.h -- a tank without a game, and the measurements of the tank.
 *
 * A poi that follows a path is the game's own poi (core/poi: hand spring, water, paper, carried
 * fish), in the game's order of a tick. Only the rules, the bot and the bowl are missing. */
#ifndef KINGYO_PLATFORM_CTL_TANK_TANK_LAB_H
#define KINGYO_PLATFORM_CTL_TANK_TANK_LAB_H

#include <stdint.h>

#include "core/output.h"
#include "core/poi/bowl/bowl.h"
#include "core/poi/poi.h"
#include "core/tank/tank.h"
#include "platform/ctl/tank/overlap.h"
#include "platform/ctl/tank/tank_meetings.h"
#include "platform/ctl/tank/tank_options.h"
#include "platform/ctl/tank/tank_path.h"

/* Sums over all observed ticks. */
struct lab_sums {
    uint64_t fish_ticks;
    uint64_t gait_ticks[GAIT_COUNT];
    double stamina;
    /* Fish-ticks of swimming fish. The other fish are moved by a poi or fall through the air. */
    uint64_t swim_ticks;
    double speed_m_s, speed_max_m_s;
};

struct tank_lab {
    const struct tank_options *plan;
    struct tank tank;
    struct poi poi;   /* Poi that follows the path. Used only if path.count > 0. */
    struct bowl bowl; /* Absent bowl, because a poi without a game has none. */
    struct output output;
    struct tank_path path;
    uint32_t tick; /* Number of completed ticks. */

    struct overlap overlap;
    struct overlap_count overlaps;
    struct lab_sums sums;
    struct tank_meetings meetings;
    float oxygen_start_mg_l;
    uint32_t observe_every; /* Ticks from one observation to the next. */
    uint32_t observed_tick; /* Tick count at the last observation. */
    uint32_t timed_count;   /* Number of used entries of tick_ns. */
    /* CPU time of the tank's tick alone in nanoseconds, for each timed tick. The array has
     * plan->tick_count elements. Every tick is timed if `observe_every` is at most
     * BROAD_PHASE_UPDATE_TICKS. */
    float *tick_ns;
    /* Fish within the shades at the start and after each second. The array has tank_lab_seconds()
     * elements. */
    uint32_t *shade_count;
    /* Fish at the surface at the start and after each second. The array has tank_lab_seconds()
     * elements. */
    uint32_t *surfacing_count;
};

/* Returns the number of elements of `shade_count`: the start and each whole second of the run. */
uint32_t tank_lab_seconds(const struct tank_options *plan);

/* Opens the tank of the plan and reads the plan's files. `lab` must be zero. The plan must outlive
 * the lab. Returns EXIT_OK, or prints one line to standard error and returns another code. */
enum exit_code tank_lab_open(struct tank_lab *lab, const struct tank_options *plan);

/* Advances the tank by one tick and measures its time. After every `observe_every`th tick and after
 * the last tick of the plan, the function also measures overlaps, encounters, gaits and speeds. */
void tank_lab_tick(struct tank_lab *lab);

/* Returns the dissolved oxygen of the water now, in mg/l. */
float tank_lab_oxygen_mg_l(const struct tank_lab *lab);

/* Returns the hash of the tank and of the poi, if there is one. */
uint64_t tank_lab_hash(const struct tank_lab *lab);

/* Frees the arrays of the lab. */
void tank_lab_close(struct tank_lab *lab);

#endif
