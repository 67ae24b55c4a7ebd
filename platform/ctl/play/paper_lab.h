/* paper_lab.h -- a poi on a carriage that moves straight up at constant speed, through water or
 * air.
 *
 * The poi, its sheet, the water on the sheet and the fish are those of the core. The carriage
 * replaces the player's hand, because no hand has a constant speed from the first tick. */
#ifndef KINGYO_PLATFORM_CTL_PLAY_PAPER_LAB_H
#define KINGYO_PLATFORM_CTL_PLAY_PAPER_LAB_H

#include "core/poi/catch/catch.h"
#include "platform/ctl/play/paper_options.h"

struct paper_lab {
    const struct paper_options *plan; /* Options of the run. The caller owns them. */
    struct tank tank;
    struct bowl bowl; /* Absent bowl, because the laboratory has none. */
    struct poi poi;
    float wetness[SHEET_CELL_COUNT]; /* Wetness of each cell, which is held constant. */
    uint32_t tick;
    /* Results so far. */
    /* Greatest force, tension and mass of carried water so far. */
    float force_n, tension_n_m, water_kg;
    /* Tick in which the paper first tore, counted from 1. A value of 0 means that the paper has not
     * torn. */
    uint32_t tore_tick;
};

/* Initializes the lab. `plan` must outlive the lab. */
void paper_lab_open(struct paper_lab *lab, const struct paper_options *plan);

/* Advances the lab by one tick and updates the results. */
void paper_lab_tick(struct paper_lab *lab);

/* Returns the time in seconds at which the paper tore, with the resolution of a tick. Returns a
 * negative value if the paper has not torn. */
double paper_lab_tore_s(const struct paper_lab *lab);

/* Returns whether the paper tore in the first 0.05 s. */
int paper_lab_is_instant(const struct paper_lab *lab);

/* Returns the present hole area of the paper in mm^2. */
double paper_lab_hole_mm2(const struct paper_lab *lab);

#endif
