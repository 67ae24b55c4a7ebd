/* tank_options.h -- the options of `kingyoctl tank`, and the plan of a run. */
#ifndef KINGYO_PLATFORM_CTL_TANK_TANK_OPTIONS_H
#define KINGYO_PLATFORM_CTL_TANK_TANK_OPTIONS_H

#include <stdint.h>

#include "core/tank/tank.h"
#include "platform/config/options.h"

#define PLAN_SECONDS_MAX 36000u /* Maximum length of a run: ten hours. */

/* A round shade over the water from second `from_s` to second `to_s` of the run. */
struct plan_shade {
    double x_m, z_m, radius_m, from_s, to_s;
};

struct tank_options {
    struct tank_config config;
    double seconds;
    uint32_t tick_count;
    uint32_t shade_count;
    struct plan_shade shade[SHADE_MAX];
    /* Paths of the poi path, the start positions and the trace. Null if the option is absent. */
    const char *poi_path, *place, *trace;
    uint32_t trace_every; /* Interval of the trace in ticks. */
    /* Observation interval in ticks. A value of 0 selects the default, which depends on the number
     * of fish. */
    uint32_t observe_every;
    uint8_t has_fish; /* 1 if --fish was given. The files must then have the same number of fish. */
    uint8_t as_json;
};

/* Parses the options into `plan`, starting from the values of the preset. `plan` keeps pointers
 * into argv. Returns EXIT_OK, or prints one line to standard error and returns another code. */
enum exit_code tank_options_read(struct tank_options *plan, int argc, const char *const *argv);

/* Text that --help prints. */
extern const char tank_options_usage[];

#endif
