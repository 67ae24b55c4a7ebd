/* paper_lab.h -- the options of `kingyoctl paper`, and the simulation of a poi (a paper scoop) on a
 * carriage that moves straight up at constant speed, through water or air.
 *
 * The poi, its paper sheet, the water on the sheet and the fish are simulated by the core. The
 * carriage replaces the player's hand, because a hand cannot have a constant speed from the first
 * tick. A tick is 1/120 s. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/poi/catch/catch.h"
#include "platform/config/options.h"

#define PAPER_WEIGHTS_MAX 64u

struct paper_options {
    uint8_t grade; /* Grade of the paper, SHEET_GRADE_MIN .. SHEET_GRADE_MAX. */
    float wetness; /* Wetness of the wet part of the paper, in [0, 1]. */
    /* Share of the paper that is wet, in [0, 1]. A straight line separates the wet part from the
     * dry part. */
    float wet_fraction;
    /* Angle between the plane of the paper and the direction of motion, in [0, pi / 2] rad. At pi /
     * 2, the paper is perpendicular to the motion. */
    float tilt_rad;
    float speed_m_s; /* Speed of the carriage that moves the poi, in [0, 5] m/s. */
    bool in_air;     /* True if the poi moves in air. False if the poi moves deep under water. */
    bool upside_down;
    bool still; /* True if the fish on the paper do not slap the paper with their tails. */
    /* True for the membrane formula alone, false for the full paper model. The full model varies
     * the strength over the paper and includes stress concentration. */
    bool ideal;
    bool as_json;
    uint32_t fish_count; /* Number of fish on the paper, 0 .. POI_CARRIED_MAX. */
    float fish_m;
    uint32_t tick_count; /* Length of the simulation in ticks of 1/120 s, at least 1. */
    double seconds;      /* Length of the simulation in seconds, as given by the option. */
    uint32_t seed;
    /* Number of weights in `weights_kg`. 0 selects the simulation of a moving poi. Any other value
     * selects the computation of paper strength from hung weights. */
    uint32_t weight_count;
    double weights_kg[PAPER_WEIGHTS_MAX];
    /* `footprint_m` is the size of the area on which each weight rests, in m. `hang_s` is the time
     * in seconds for which each weight hung on the paper. */
    double footprint_m, hang_s;
};

struct paper_lab {
    /* Options of the simulation. The caller owns the structure. */
    const struct paper_options *plan;
    struct tank tank;
    /* Bowl that the functions of the core expect as an argument. The simulation does not use the
     * bowl, so all fields are zero. */
    struct bowl bowl;
    struct poi poi;
    /* Wetness of each cell of the sheet, in [0, 1]. The wetness is held constant. */
    float wetness[SHEET_CELL_COUNT];
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

/* Returns true if the paper tore in the first 0.05 s. */
bool paper_lab_is_instant(const struct paper_lab *lab);

/* Returns the present area of all holes in the paper, in mm^2. */
double paper_lab_hole_mm2(const struct paper_lab *lab);
