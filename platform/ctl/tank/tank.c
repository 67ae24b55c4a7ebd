/* tank.c -- `kingyoctl tank`, which simulates and measures a tank of fish without a screen. */
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "core/base/float_env.h"
#include "platform/ctl/lib/ctl.h"
#include "platform/ctl/tank/tank_lab.h"
#include "platform/ctl/tank/tank_report.h"
#include "platform/huge_pages.h"
#include "platform/os/print.h"

#define PROGRESS_TICKS (2u * CORE_TICK_HZ)

/* Runs the whole simulation. Once per second, checks that the floating-point settings are still
 * suitable for the core. Returns EXIT_OK, or prints one line to standard error and returns
 * EXIT_NOT_SO if the settings have changed. */
static enum exit_code run_tank_simulation(struct tank_lab *lab, struct tank_trace *trace)
{
    const struct tank_options *plan = lab->plan;
    if (trace->file) {
        tank_trace_add(trace, &lab->tank, 0);
    }
    while (lab->tick < plan->tick_count) {
        if (lab->tick % CORE_TICK_HZ == 0 && !float_env_is_standard()) {
            return ctl_float("tank");
        }
        tank_lab_tick(lab);
        if (trace->file && lab->tick % plan->trace_every == 0) {
            tank_trace_add(trace, &lab->tank, lab->tick);
        }
        if (lab->tick % PROGRESS_TICKS == 0 && isatty(STDERR_FILENO)) {
            fprintf(stderr, "\r%u of %u s", lab->tick / CORE_TICK_HZ,
                    plan->tick_count / CORE_TICK_HZ);
            fputs(lab->tick + PROGRESS_TICKS > plan->tick_count ? "\n" : "", stderr);
        }
    }
    return EXIT_OK;
}

static enum exit_code tank_run(int argc, const char *const *argv)
{
    struct tank_options plan;
    enum exit_code code = tank_options_read(&plan, argc, argv);
    if (code != EXIT_OK) {
        return code;
    }
    struct tank_lab *lab = huge_pages_alloc(sizeof *lab);
    if (!lab) {
        return print_fail(EXIT_IO, "kingyoctl tank: out of memory");
    }
    code = tank_lab_open(lab, &plan);
    if (code == EXIT_OK) {
        struct tank_trace trace = { 0 };
        code = plan.trace ? tank_trace_open(&trace, plan.trace) : EXIT_OK;
        code = code == EXIT_OK ? run_tank_simulation(lab, &trace) : code;
        const enum exit_code closed = trace.file ? tank_trace_close(&trace) : EXIT_OK;
        code = code == EXIT_OK ? closed : code;
        if (code == EXIT_OK) {
            const struct tank_figures figures = tank_figures_of(lab);
            (plan.as_json ? tank_report_json : tank_report_text)(lab, &figures);
        }
        tank_lab_close(lab);
    }
    free(lab);
    return code;
}

const struct ctl_command ctl_tank = {
    .name = "tank",
    .summary = "a tank of fish without a screen: figures as text or JSON, trajectories as CSV",
    .options = &tank_options_table,
    .notes = tank_options_notes,
    .run = tank_run,
};
