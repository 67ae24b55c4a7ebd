/* tank_plan.h -- what a run of `kingyoctl tank` is to do, and what the options say of it. */
#ifndef KINGYO_PLATFORM_CTL_TANK_PLAN_H
#define KINGYO_PLATFORM_CTL_TANK_PLAN_H

#include <stdint.h>

#include "core/tank/tank.h"
#include "platform/kiosk/options.h"

#define PLAN_SECONDS_MAX 36000u /* Ten hours. */

/* A round shade over the water from `from_s` to `to_s` of the run. */
struct plan_shade {
    double x_m, z_m, radius_m, from_s, to_s;
};

struct tank_plan {
    struct tank_config config;
    double seconds;
    uint32_t tick_count;
    uint32_t shade_count;
    struct plan_shade shade[SHADE_MAX];
    const char *poi_path, *place, *trace; /* Null when not asked for. */
    uint32_t trace_every;                 /* Ticks. */
    uint32_t observe_every; /* Ticks; 0: the default, which depends on the number of fish. */
    uint8_t has_fish; /* --fish was given: files must agree. */
    uint8_t as_json;
};

/* Reads the options into `plan`, over the preset's own values. EXIT_OK, or told. `plan` keeps
 * pointers into argv. */
enum exit_code tank_plan_read(struct tank_plan *plan, int argc, const char *const *argv);

/* What --help prints. */
extern const char tank_plan_usage[];

#endif
