/* tank_report.h -- prints the results of a tank simulation as JSON, or as text with bar charts. */
#ifndef KINGYO_PLATFORM_CTL_TANK_TANK_REPORT_H
#define KINGYO_PLATFORM_CTL_TANK_TANK_REPORT_H

#include "platform/ctl/tank/tank_lab.h"

/* Results of a tank simulation. */
struct tank_figures {
    double ns_per_fish_tick, tick_ms_median, tick_ms_p99;
    double share[GAIT_COUNT]; /* Share of each gait (mode of swimming) in all fish-ticks. A
                                 fish-tick is one fish in one observed tick. */
    double other_share;       /* Sum of the shares of the gaits escape, surface and held. */
    double speed_mean_cm_s, speed_max_cm_s, stamina_mean, surfacing_share;
};

/* Computes the results. Sorts the tick times of `lab` in place. */
struct tank_figures tank_figures_of(struct tank_lab *lab);

/* Prints the results as JSON on standard output. */
void tank_report_json(const struct tank_lab *lab, const struct tank_figures *figures);

/* Prints the results as text with bar charts on standard output. */
void tank_report_text(const struct tank_lab *lab, const struct tank_figures *figures);

#endif
