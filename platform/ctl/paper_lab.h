/* paper_lab.h -- a poi on a carriage: led straight up at one speed, through water or air.
 *
 * The poi, its sheet, the water on it and the fish are the core's own; the carriage takes the
 * hand's place, since no hand keeps a speed from the first tick on. */
#ifndef KINGYO_PLATFORM_CTL_PAPER_LAB_H
#define KINGYO_PLATFORM_CTL_PAPER_LAB_H

#include "core/poi/catch.h"
#include "platform/ctl/paper_plan.h"

struct paper_lab {
    const struct paper_plan *plan; /* Borrowed. */
    struct tank tank;
    struct bowl bowl; /* None. */
    struct poi poi;
    float wetness[SHEET_CELL_COUNT]; /* As it is held. */
    uint32_t tick;
    /* Figures so far. */
    float force_n, tension_n_m, water_kg; /* The greatest each. */
    uint32_t tore_tick;                   /* In which paper tore first, counted from 1; 0: none. */
};

/* `plan` must outlive the lab. */
void paper_lab_open(struct paper_lab *lab, const struct paper_plan *plan);

void paper_lab_tick(struct paper_lab *lab);

/* Seconds till it tore, to a tick; < 0: it holds. */
double paper_lab_tore_s(const struct paper_lab *lab);
int paper_lab_is_instant(const struct paper_lab *lab);
double paper_lab_hole_mm2(const struct paper_lab *lab);

#endif
