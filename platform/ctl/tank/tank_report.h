/* tank_report.h -- the results of a run, as JSON for programs and as text with bars for people. */
#ifndef KINGYO_PLATFORM_CTL_TANK_TANK_REPORT_H
#define KINGYO_PLATFORM_CTL_TANK_TANK_REPORT_H

#include "platform/ctl/tank/tank_lab.h"

/* Results of a run. */
struct tank_figures {
    double ns_per_fish_tick, tick_ms_median, tick_ms_p99;
    double share[GAIT_COUNT]; /* Share of each gait in all fish-ticks. */
    double other_share;       /* Share of escape, surface and held together. */
    double speed_mean_cm_s, speed_max_cm_s, stamina_mean, surfacing_share;
};

/* Computes the results and sorts the lab's tick times in place. */
struct tank_figures tank_figures_of(struct tank_lab *lab);

/* Prints the results as JSON to standard output. */
void tank_report_json(const struct tank_lab *lab, const struct tank_figures *figures);

/* Prints the results as text with bars to standard output. */
void tank_report_text(const struct tank_lab *lab, const struct tank_figures *figures);

#endif
