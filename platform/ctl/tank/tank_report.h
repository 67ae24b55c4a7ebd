/* tank_report.h -- the output of a tank simulation: the trace, a CSV file with the pose of every
 * fish, and the results as JSON or as text with bar charts.
 *
 * With the trace, published results of the tank can be checked independently. */
#pragma once

#include <stdint.h>
#include <stdio.h>

#include "core/tank/tank.h"
#include "platform/config/options.h"
#include "platform/ctl/tank/tank_lab.h"
#include "platform/os/file.h"

struct tank_trace {
    const char *path;
    struct atomic_file out;
    /* Stream that writes to `out` while the trace is open. Null if there is no trace. */
    FILE *file;
};

/* Creates the file at `path` and writes the header row. `path` must outlive `trace`. Returns
 * EXIT_OK, or prints one line to standard error and returns EXIT_IO. */
enum exit_code tank_trace_open(struct tank_trace *trace, const char *path);

/* Writes one row for each fish of the tank. */
void tank_trace_add(struct tank_trace *trace, const struct tank *tank, uint32_t tick);

/* Closes the file. Returns EXIT_OK. If any row could not be written, prints one line to standard
 * error and returns EXIT_IO. */
enum exit_code tank_trace_close(struct tank_trace *trace);

/* Results of a tank simulation. */
struct tank_figures {
    double ns_per_fish_tick, tick_ms_median, tick_ms_p99;
    /* Share of each gait (mode of swimming) in all fish-ticks. A fish-tick is one fish in one
     * observed tick. */
    double share[GAIT_COUNT];
    double other_share; /* Sum of the shares of the gaits escape, surface and held. */
    double speed_mean_cm_s, speed_max_cm_s, stamina_mean, surfacing_share;
};

/* Computes the results. Sorts the tick times of `lab` in place. */
struct tank_figures tank_figures_of(struct tank_lab *lab);

/* Prints the results as JSON on standard output. */
void tank_report_json(const struct tank_lab *lab, const struct tank_figures *figures);

/* Prints the results as text with bar charts on standard output. */
void tank_report_text(const struct tank_lab *lab, const struct tank_figures *figures);
