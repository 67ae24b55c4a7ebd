/* sheet.h -- the paper of a poi: cells that each carry wetness, strength and damage.
 *
 * A square of SHEET_SIDE x SHEET_SIDE cells spans the ring; cells outside the ring do not exist.
 * Column 0 is the left edge (-x of the poi), row 0 the far edge (-z). */
#ifndef KINGYO_CORE_POI_SHEET_H
#define KINGYO_CORE_POI_SHEET_H

#include <stdint.h>

#include "core/scene.h"

#define SHEET_CELL_COUNT (SHEET_SIDE * SHEET_SIDE)
#define SHEET_LOAD_MAX 16u /* Footprints a tick; more fish than this on one poi spill at the rim. */

enum sheet_cell_state {
    CELL_OUTSIDE = 0, /* Beyond the ring. */
    CELL_PAPER = 1,
    CELL_HOLE = 2,
};

/* A round patch that presses on the paper: a body, a tail, a snout. */
struct sheet_load {
    float x_m, z_m;     /* Of its centre, in the poi's plane. */
    float diameter_m;
    float force_n;      /* Along the normal, either sign. */
};

struct sheet {
    uint8_t grade;      /* 4 strong .. 7 weak. */
    float radius_m;
    float wetness[SHEET_CELL_COUNT];  /* [0, 1] */
    float damage[SHEET_CELL_COUNT];   /* [0, 1); a hole at 1. */
    float strength[SHEET_CELL_COUNT]; /* This specimen's factor on the grade's strength, near 1. */
    uint8_t state[SHEET_CELL_COUNT];  /* enum sheet_cell_state */
    uint32_t paper_cells;             /* CELL_PAPER left ... */
    uint32_t paper_cells_new;         /* ... and at the start. */
    float sag_m;                      /* From the last pressure; for the eye and for pooling water. */
};

/* What one tick did to the paper. */
struct sheet_events {
    uint32_t cells_torn;
    float tension_max_n_m;
};

void sheet_init(struct sheet *sheet, uint8_t grade, float radius_m, uint32_t seed);

/* One tick. `pressure_pa` acts along the normal on all paper. `wet` says which half-plane of the
 * poi's plane is under water: cells with wet.x * x + wet.z * z < wet.limit get wet. */
struct sheet_wetting {
    float x, z, limit_m;
};
struct sheet_events sheet_tick(struct sheet *sheet, float pressure_pa, struct sheet_wetting wet,
                               const struct sheet_load *loads, uint32_t load_count);

/* Whether a point of the poi's plane has paper under it; false outside the ring. */
int sheet_holds(const struct sheet *sheet, float x_m, float z_m);

float sheet_left(const struct sheet *sheet); /* [0, 1] of the area. */
uint64_t sheet_hash(uint64_t hash, const struct sheet *sheet);

#endif
