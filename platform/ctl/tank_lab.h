/* tank_lab.h -- a tank without a stall around it, and everything that is measured of it.
 *
 * A poi that follows a path is the game's own (core/poi: the hand's spring, water, paper, fish that
 * ride on it), in the game's order of a tick; only the rules, the bot and the bowl are missing. */
#ifndef KINGYO_PLATFORM_CTL_TANK_LAB_H
#define KINGYO_PLATFORM_CTL_TANK_LAB_H

#include <stdint.h>

#include "core/output.h"
#include "core/poi/bowl.h"
#include "core/poi/poi.h"
#include "core/tank/tank.h"
#include "platform/ctl/overlap.h"
#include "platform/ctl/tank_meetings.h"
#include "platform/ctl/tank_path.h"
#include "platform/ctl/tank_plan.h"

/* Sums over all observed ticks. */
struct lab_sums {
    uint64_t fish_ticks;
    uint64_t gait_ticks[GAIT_COUNT];
    double stamina;
    uint64_t swim_ticks; /* Of fish that swim: a poi or the air moves the others. */
    double speed_m_s, speed_max_m_s;
};

struct tank_lab {
    const struct tank_plan *plan;
    struct tank tank;
    struct poi poi;   /* While path.count > 0. */
    struct bowl bowl; /* Never present: a poi without a game has none. */
    struct output output;
    struct tank_path path;
    uint32_t tick; /* Ticks done. */

    struct overlap overlap;
    struct overlap_count overlaps;
    struct lab_sums sums;
    struct meetings meetings;
    float oxygen_start_mg_l;
    uint32_t observe_every; /* Ticks from one observation to the next one. */
    uint32_t observed_tick; /* Tick count at the last observation. */
    uint32_t timed_count;   /* Entries of tick_ns that are in use. */
    float *tick_ns; /* [plan->tick_count]: CPU time of the tank's tick alone, for each timed tick.
                       With `observe_every` of at most CROWD_LOOK_TICKS every tick is timed. */
    uint32_t *shade_count;  /* [tank_lab_seconds()]: fish within the shades ... */
    uint32_t *surfacing_count; /* ... and at the surface, at the start and after each second. */
};

/* How many whole seconds there are to count at, the start included. */
uint32_t tank_lab_seconds(const struct tank_plan *plan);

/* Opens the tank that the plan asks for and reads the plan's files. `lab` must be zero. The plan
 * must outlive the lab. Returns EXIT_OK; after an error one line is on standard error. */
enum exit_code tank_lab_open(struct tank_lab *lab, const struct tank_plan *plan);

/* Advances the tank by one tick and measures its time. After every `observe_every`th tick and after
 * the last one of the plan, also measures overlaps, encounters, gaits and speeds. */
void tank_lab_tick(struct tank_lab *lab);

/* Dissolved in the water now. */
float tank_lab_oxygen_mg_l(const struct tank_lab *lab);

uint64_t tank_lab_hash(const struct tank_lab *lab);

void tank_lab_close(struct tank_lab *lab);

#endif
