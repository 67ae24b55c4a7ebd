/* paper_lab.h -- simulates a poi (a paper scoop) on a carriage that moves straight up at constant
 * speed, through water or air.
 *
 * The poi, its paper sheet, the water on the sheet and the fish are simulated by the core. The
 * carriage replaces the player's hand, because a hand cannot have a constant speed from the first
 * tick. A tick is 1/120 s. */
#ifndef KINGYO_PLATFORM_CTL_PLAY_PAPER_LAB_H
#define KINGYO_PLATFORM_CTL_PLAY_PAPER_LAB_H

#include "core/poi/catch/catch.h"
#include "platform/ctl/play/paper_options.h"

struct paper_lab {
    const struct paper_options *plan; /* Options of the simulation. The caller owns the
                                         structure. */
    struct tank tank;
    struct bowl bowl; /* Bowl that the core's functions require. The laboratory has no bowl, so all
                         fields are zero. */
    struct poi poi;
    float wetness[SHEET_CELL_COUNT]; /* Wetness of each cell of the sheet, in [0, 1]. The wetness is
                                        held constant. */
    uint32_t tick;
    /* The following fields are the results of the ticks so far. */
    /* Greatest force on the paper in N, greatest tension in N/m, and greatest mass of carried water
     * in kg so far. */
    float force_n, tension_n_m, water_kg;
    /* Tick in which the paper first tore, counted from 1. 0 means that the paper has not torn. */
    uint32_t tore_tick;
};

/* Initializes the laboratory for the options `plan`, which must outlive `lab`. */
void paper_lab_open(struct paper_lab *lab, const struct paper_options *plan);

/* Advances the simulation by one tick and updates the results. */
void paper_lab_tick(struct paper_lab *lab);

/* Returns the time in seconds after which the paper tore, with a resolution of one tick. A negative
 * value means that the paper has not torn. */
double paper_lab_tore_s(const struct paper_lab *lab);

/* Returns 1 if the paper tore in the first 0.05 s, otherwise 0. */
int paper_lab_is_instant(const struct paper_lab *lab);

/* Returns the present area of all holes in the paper, in mm^2. */
double paper_lab_hole_mm2(const struct paper_lab *lab);

#endif
