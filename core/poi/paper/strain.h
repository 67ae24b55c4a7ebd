/* strain.h -- the load, the tears and the wetness of every cell of a sheet in one tick. Only the
 * sources of core/poi/paper include this file.
 *
 * struct tear_map stores one bit for each cell and one 32-bit word for each row; bit 0 is the
 * leftmost column. A shift of a word therefore gives the neighbouring cells. The map is computed
 * from the states of the cells in each tick.
 *
 * The functions strain_*() on rows use SIMD code (core/base/simd.h). A row has 32 cells. The
 * functions are compiled only for four lanes, because four lanes are fast enough on every
 * machine. */
#pragma once

#include "core/base/simd.h"
#include "core/poi/paper/sheet.h"

_Static_assert(SHEET_SIDE == 32u, "a row is a word");

/* Stress factor of a paper cell beside a hole of one cell: the stress in the cell, relative to the
 * stress without the hole. For a longer hole, the factor grows with the square root of the hole's
 * length. */
#define TEAR_FACTOR 2.5f
/* Upper limit of the stress factor, reached beside a hole that is 2.56 cells long. */
#define TEAR_FACTOR_MAX 4.0f
/* Fraction by which the stress factor is higher for a tear along the fibres, and lower for a tear
 * across the fibres. */
#define TEAR_FIBRE_SHARE 0.08f
#define TEAR_FACTOR_WORST (TEAR_FACTOR_MAX * (1.0f + TEAR_FIBRE_SHARE))
/* Number of rows above and below a changed hole in which the stress factors of cells can change. */
#define TEAR_REACH 3u

struct tear_map {
    uint32_t paper[SHEET_SIDE];
    uint32_t hole[SHEET_SIDE];
    uint32_t pair[SHEET_SIDE]; /* Bits of hole cells that share a side with another hole cell. */
    /* Bits of the hole cells that belong to a hole long enough for TEAR_FACTOR_MAX. Such a hole has
     * three cells in a straight line, or two cells that touch at a corner. */
    uint32_t wide[SHEET_SIDE];
};

struct tear_map tear_map_of(const struct sheet *sheet);

/* Returns the bits of the paper cells in row `row` that touch a hole cell at a side or a corner.
 * `row` must be less than SHEET_SIDE. */
uint32_t tear_front(const struct tear_map *map, uint32_t row);

/* Returns the stress factor of a cell beside a hole, at most TEAR_FACTOR_WORST. Returns 0 if no
 * hole touches the cell.
 *
 * A hole carries no load, and the rim of the hole carries the load instead. As in fracture
 * mechanics, the factor increases with the square root of the hole's length. The length is measured
 * along the longest straight line of hole cells through the adjacent hole cell. The factor is
 * higher if the tear would grow along the fibres. The factor is lower for a diagonal step, because
 * the tear then grows by a longer distance. */
float tear_factor(const struct tear_map *map, const struct sheet *sheet, uint32_t row,
                  uint32_t column);

/* Changes cells of row `row` into holes, in the map and in the sheet. Bit i of `torn` selects cell
 * i. Returns the number of changed cells. */
uint32_t tear_open_row(struct tear_map *map, struct sheet *sheet, uint32_t row, uint32_t torn);

/* Removes loose paper once: changes paper cells that carry no load into holes. A paper cell carries
 * load only if straight lines of paper connect it to the ring in two directions that are at least
 * 135 degrees apart. A removal can make more paper loose, and therefore the caller repeats the call
 * until the result is 0. Returns the number of removed cells. */
uint32_t tear_drop_loose(struct tear_map *map, struct sheet *sheet);

/* Load of a cell (tension divided by strength) below which the load counts as 0, because the tenth
 * power of the load would be a denormal number. */
#define STRAIN_NIL 0.02f
#define STRAIN_EDGE 1.5f /* Stress concentration factor of the cells along the ring. */

struct footprint {
    float x_m, z_m;
    float own_m; /* Radius of the footprint. */
    /* Distance from the centre of the footprint beyond which its tension is ignored. */
    float reach_m;
    /* Force of the footprint divided by 2 * pi. This value divided by the distance from the
     * footprint's centre is the tension. */
    float pull_n_m_m;
};

struct strain {
    const struct paper_grade *grade;
    /* Tension of the membrane at the centre and at the edge of the sheet. */
    float centre_n_m, edge_n_m;
    float cell_m;
    uint32_t load_count;
    struct footprint footprints[SHEET_LOAD_MAX];
    struct tear_map map;
    /* Tension of each cell divided by its strength; 0 if the cell is not paper. */
    float load[SHEET_CELL_COUNT];
    /* `load` of each cell multiplied by the stress concentration factor of the cell. */
    float ratio[SHEET_CELL_COUNT];
};

/* Writes the members `load` and `ratio` of the cells in a row. `ratio` does not yet contain the
 * stress factors of tears and of the line between wet and dry paper. Returns the highest tension of
 * the paper in the row, in N/m. */
float strain_row(struct strain *strain, const struct sheet *sheet, uint32_t row);

/* Returns true if any cell of the row would tear within `seconds` under its present load. */
bool strain_tears(const struct strain *strain, const struct sheet *sheet, uint32_t row,
                  float seconds);

/* Increases the damage of a row over `seconds` at the rate (1 / SHEET_DAMAGE_TAU_S) * ratio^10 per
 * second. Returns a word in which bit i is set if the damage of cell i has reached 1. */
uint32_t strain_wear(const struct strain *strain, struct sheet *sheet, uint32_t row, float seconds);

/* Writes sheet.stress[] of a row, which is used for display only. */
void strain_show(const struct strain *strain, struct sheet *sheet, uint32_t row);

/* Advances the wetness of a sheet by one tick (1/120 s). Paper in the half-plane `wet` is under
 * water and becomes wet, dry paper wicks water from wet paper, and wet paper becomes softer for one
 * minute. */
void paper_wetting_tick(struct sheet *sheet, struct sheet_wetting wet);

/* Returns how strongly the line between wet and dry paper is developed at a cell, from 0 (no line)
 * to 1 (fully developed line). */
float paper_wetting_line(const struct sheet *sheet, uint32_t row, uint32_t column);
