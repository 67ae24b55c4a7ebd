/* strain.h -- computes the load of every cell of a sheet in one tick. Internal to sheet.c.
 *
 * The functions on rows are SIMD kernels (core/base/simd.h), compiled for four and for eight lanes.
 * A row has 32 cells. The core always calls the kernels with four lanes, because four lanes are
 * fast enough on every machine. */
#ifndef KINGYO_CORE_POI_PAPER_STRAIN_H
#define KINGYO_CORE_POI_PAPER_STRAIN_H

#include "core/base/simd.h"
#include "core/poi/paper/sheet.h"
#include "core/poi/paper/tear.h"

/* Load ratio below which a load counts as 0, because the tenth power of the ratio would be a
 * denormal number. */
#define STRAIN_NIL 0.02f
#define STRAIN_EDGE 1.5f /* Stress concentration factor of the cells along the ring. */

struct footprint {
    float x_m, z_m;
    float own_m;      /* Radius of the footprint. */
    float reach_m;    /* Distance from the centre of the footprint beyond which its tension is
                         ignored. */
    float pull_n_m_m; /* Force of the footprint divided by 2 * pi. This value divided by the
                         distance from the footprint's centre is the tension. */
};

struct strain {
    const struct paper_grade *grade;
    float centre_n_m, edge_n_m; /* Tension of the membrane at the centre and at the edge of the
                                   sheet. */
    float cell_m;
    uint32_t load_count;
    struct footprint footprints[SHEET_LOAD_MAX];
    struct tear_map map;
    float load[SHEET_CELL_COUNT];  /* Tension of each cell divided by its strength; 0 if the cell is
                                      not paper. */
    float ratio[SHEET_CELL_COUNT]; /* `load` of each cell multiplied by the stress concentration
                                      factor of the cell. */
};

SIMD_BEGIN
/* Writes `load` of a row, and `ratio` of the row without the factors of the wet line and of tears.
 * Returns the highest tension of the paper in the row, in N/m. */
float strain_row_4(struct strain *strain, const struct sheet *sheet, uint32_t row);
float strain_row_8(struct strain *strain, const struct sheet *sheet, uint32_t row);

/* Returns 1 if any cell of the row would tear within `seconds` under its present load, otherwise
 * 0. */
int strain_tears_4(const struct strain *strain, const struct sheet *sheet, uint32_t row,
                   float seconds);
int strain_tears_8(const struct strain *strain, const struct sheet *sheet, uint32_t row,
                   float seconds);

/* Increases the damage of a row over `seconds` at the rate (1 / SHEET_DAMAGE_TAU_S) * ratio^10 per
 * second. Returns a word in which bit i is set if the damage of cell i has reached 1. */
uint32_t strain_wear_4(const struct strain *strain, struct sheet *sheet, uint32_t row,
                       float seconds);
uint32_t strain_wear_8(const struct strain *strain, struct sheet *sheet, uint32_t row,
                       float seconds);

/* Writes sheet.stress[] of a row, which is used for display only. */
void strain_show_4(const struct strain *strain, struct sheet *sheet, uint32_t row);
void strain_show_8(const struct strain *strain, struct sheet *sheet, uint32_t row);
SIMD_END

#endif
