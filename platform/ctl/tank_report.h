/* tank_report.h -- the figures of a run: JSON for programs, bars for people. */
#ifndef KINGYO_PLATFORM_CTL_TANK_REPORT_H
#define KINGYO_PLATFORM_CTL_TANK_REPORT_H

#include "platform/ctl/tank_lab.h"

/* What a run comes to. */
struct tank_figures {
    double ns_per_fish_tick, tick_ms_median, tick_ms_p99;
    double share[GAIT_COUNT]; /* Of all fish-ticks ... */
    double other_share;       /* ... and of escape, surface and held together. */
    double speed_mean_cm_s, speed_max_cm_s, stamina_mean, surfacing_share;
};

/* Sorts the lab's tick times. */
struct tank_figures tank_figures_of(struct tank_lab *lab);

void tank_report_json(const struct tank_lab *lab, const struct tank_figures *figures);
void tank_report_text(const struct tank_lab *lab, const struct tank_figures *figures);

#endif
