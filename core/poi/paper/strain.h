/* strain.h -- the load of every cell of a sheet in one tick; internal to sheet.c.
 *
 * The functions on rows are SIMD kernels (core/base/simd.h), compiled for four and for eight lanes.
 * A row has 32 cells. Four lanes are fast enough, so that the core always calls the functions with
 * four lanes on every machine. */
#ifndef KINGYO_CORE_POI_PAPER_STRAIN_H
#define KINGYO_CORE_POI_PAPER_STRAIN_H

#include "core/base/simd.h"
#include "core/poi/paper/sheet.h"
#include "core/poi/paper/tear.h"

/* Load ratio below which a load counts as zero, because its tenth power would be denormal. */
#define STRAIN_NIL 0.02f
#define STRAIN_EDGE 1.5f /* Stress concentration of the cells along the ring. */

struct footprint {
    float x_m, z_m;
    float own_m;      /* Radius of the footprint. */
    float reach_m;    /* Distance from the footprint's centre beyond which the footprint has no
                         effect. */
    float pull_n_m_m; /* Tension times distance from the footprint's centre: F / (2 pi). */
};

struct strain {
    const struct paper_grade *grade;
    float centre_n_m, edge_n_m; /* Membrane tension at the centre and at the edge of the sheet. */
    float cell_m;
    uint32_t load_count;
    struct footprint footprints[SHEET_LOAD_MAX];
    struct tear_map map;
    float load[SHEET_CELL_COUNT];  /* Tension of each cell divided by its strength; 0 where there is
                                      no paper. */
    float ratio[SHEET_CELL_COUNT]; /* `load` of each cell multiplied by the stress concentration. */
};

SIMD_BEGIN
/* Writes `load` of a row, and `ratio` of the row without wet line and tears. Returns the highest
 * tension of the row's paper in N/m. */
float strain_row_4(struct strain *strain, const struct sheet *sheet, uint32_t row);
float strain_row_8(struct strain *strain, const struct sheet *sheet, uint32_t row);

/* Returns 1 if a loaded cell of the row would tear within `seconds`, otherwise 0. */
int strain_tears_4(const struct strain *strain, const struct sheet *sheet, uint32_t row,
                   float seconds);
int strain_tears_8(const struct strain *strain, const struct sheet *sheet, uint32_t row,
                   float seconds);

/* Advances the damage of a row by `seconds`: dD/dt = (1 / SHEET_DAMAGE_TAU_S) ratio^10. Returns one
 * bit for each cell whose damage reached 1. */
uint32_t strain_wear_4(const struct strain *strain, struct sheet *sheet, uint32_t row,
                       float seconds);
uint32_t strain_wear_8(const struct strain *strain, struct sheet *sheet, uint32_t row,
                       float seconds);

/* Writes the display values sheet.stress[] of a row. */
void strain_show_4(const struct strain *strain, struct sheet *sheet, uint32_t row);
void strain_show_8(const struct strain *strain, struct sheet *sheet, uint32_t row);
SIMD_END

#endif
