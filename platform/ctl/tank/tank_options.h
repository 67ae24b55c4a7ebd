/* tank_options.h -- the options of `kingyoctl tank`, which describe a simulation of a tank. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/tank/tank.h"
#include "platform/config/options.h"

#define PLAN_SECONDS_MAX 36000u /* Maximum length of a simulation in seconds, which is ten hours. */

/* A round shade over the water. The shade is cast from second `from_s` to second `to_s` of the
 * simulation. */
struct plan_shade {
    double x_m, z_m, radius_m, from_s, to_s;
};

struct tank_options {
    struct tank_config config;
    double seconds;
    uint32_t tick_count;
    uint32_t shade_count;
    struct plan_shade shade[SHADE_MAX];
    /* Paths of three files: the motion of a poi (a paper scoop), the start positions of the fish,
     * and the trace to write. A null pointer means that the option is absent. */
    const char *poi_path, *place, *trace;
    uint32_t trace_every; /* Number of ticks between two samples of the trace. */
    /* Number of ticks between two observations. 0 selects the default, which depends on the number
     * of fish. */
    uint32_t observe_every;
    /* True if --fish was given. The file of start positions must then have the same number of
     * fish. */
    bool has_fish;
    bool as_json;
};

/* Parses the options into `plan`. Options that are absent have the values of the tank preset.
 * `plan` keeps pointers into `argv`. Returns EXIT_OK, or prints one line to standard error and
 * returns another exit code. */
enum exit_code tank_options_read(struct tank_options *plan, int argc, const char *const *argv);

/* Options and further text that `kingyoctl tank --help` prints. */
extern const struct option_table tank_options_table;
extern const char tank_options_notes[];
