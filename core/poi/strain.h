/* strain.h -- one tick's loads on every cell of a sheet; what sheet.c works on.
 *
 * The rows' arithmetic is a lane kernel (core/base/lanes.h). A row is 32 cells: four at once are
 * fast enough that the core always takes those, whatever the machine could do. */
#ifndef KINGYO_CORE_POI_STRAIN_H
#define KINGYO_CORE_POI_STRAIN_H

#include "core/base/lanes.h"
#include "core/poi/sheet.h"
#include "core/poi/tear.h"

#define STRAIN_NIL 0.02f /* A load ratio below is none: its tenth power is no normal number. */
#define STRAIN_EDGE 1.5f /* Stress concentration along the ring. */

struct footprint {
    float x_m, z_m;
    float own_m;      /* Its radius. */
    float reach_m;    /* Beyond it is not felt. */
    float pull_n_m_m; /* F / (2 pi): tension times radius. */
};

struct strain {
    const struct paper_grade *grade;
    float centre_n_m, edge_n_m; /* Membrane tension. */
    float cell_m;
    uint32_t load_count;
    struct footprint footprints[SHEET_LOAD_MAX];
    struct tear_map map;
    float load[SHEET_CELL_COUNT];  /* Tension over strength, 0 where there is no paper; ... */
    float ratio[SHEET_CELL_COUNT]; /* ... raised where stress gathers. */
};

LANES_BEGIN
/* Fills a row's load, and its ratio as far as membrane and ring make it. Returns the greatest
 * tension on paper. */
float strain_row_4(struct strain *strain, const struct sheet *sheet, uint32_t row);
float strain_row_8(struct strain *strain, const struct sheet *sheet, uint32_t row);

/* Whether a cell of the row that is loaded tears within `seconds`. */
int strain_tears_4(const struct strain *strain, const struct sheet *sheet, uint32_t row,
                   float seconds);
int strain_tears_8(const struct strain *strain, const struct sheet *sheet, uint32_t row,
                   float seconds);

/* dD/dt = (1 / tau) ratio^10 for so long. Returns a bit for each cell that is worn through. */
uint32_t strain_wear_4(const struct strain *strain, struct sheet *sheet, uint32_t row,
                       float seconds);
uint32_t strain_wear_8(const struct strain *strain, struct sheet *sheet, uint32_t row,
                       float seconds);

/* Writes the row's stress[]. */
void strain_show_4(const struct strain *strain, struct sheet *sheet, uint32_t row);
void strain_show_8(const struct strain *strain, struct sheet *sheet, uint32_t row);
LANES_END

#endif
