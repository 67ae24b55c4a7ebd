/* strain.h -- the loads of one tick on every cell of a sheet; internal to sheet.c.
 *
 * The row functions are SIMD kernels (core/base/simd.h). A row has 32 cells. Four lanes are fast
 * enough, so the core always uses four, whatever the machine supports. */
#ifndef KINGYO_CORE_POI_PAPER_STRAIN_H
#define KINGYO_CORE_POI_PAPER_STRAIN_H

#include "core/base/simd.h"
#include "core/poi/paper/sheet.h"
#include "core/poi/paper/tear.h"

/* Load ratios below this count as zero, because their tenth power would be denormal. */
#define STRAIN_NIL 0.02f
#define STRAIN_EDGE 1.5f /* Stress concentration along the ring. */

struct footprint {
    float x_m, z_m;
    float own_m;      /* Radius of the footprint. */
    float reach_m;    /* Distance beyond which the footprint has no effect. */
    float pull_n_m_m; /* F / (2 pi): tension times radius. */
};

struct strain {
    const struct paper_grade *grade;
    float centre_n_m, edge_n_m; /* Membrane tension. */
    float cell_m;
    uint32_t load_count;
    struct footprint footprints[SHEET_LOAD_MAX];
    struct tear_map map;
    float load[SHEET_CELL_COUNT];  /* Tension over strength; 0 where there is no paper. */
    float ratio[SHEET_CELL_COUNT]; /* `load` with stress concentration. */
};

SIMD_BEGIN
/* Fills the load of a row, and its ratio as far as membrane and ring determine it. Returns the
 * highest tension on paper. */
float strain_row_4(struct strain *strain, const struct sheet *sheet, uint32_t row);
float strain_row_8(struct strain *strain, const struct sheet *sheet, uint32_t row);

/* Returns 1 if a loaded cell of the row tears within `seconds`. */
int strain_tears_4(const struct strain *strain, const struct sheet *sheet, uint32_t row,
                   float seconds);
int strain_tears_8(const struct strain *strain, const struct sheet *sheet, uint32_t row,
                   float seconds);

/* Applies dD/dt = (1 / tau) ratio^10 for `seconds`. Returns one bit for each cell that is worn
 * through. */
uint32_t strain_wear_4(const struct strain *strain, struct sheet *sheet, uint32_t row,
                       float seconds);
uint32_t strain_wear_8(const struct strain *strain, struct sheet *sheet, uint32_t row,
                       float seconds);

/* Writes stress[] of the row. */
void strain_show_4(const struct strain *strain, struct sheet *sheet, uint32_t row);
void strain_show_8(const struct strain *strain, struct sheet *sheet, uint32_t row);
SIMD_END

#endif
