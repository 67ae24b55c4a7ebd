/* wetting.c -- simulates the wetting of the paper cell by cell. */
#include "core/poi/paper/wetting.h"

#define WET_TAU_S 1.0f /* Time constant with which a cell becomes wet under water. */
/* Wetness from which a cell counts as completely wet. The sheet is soaked if all its cells are
 * completely wet. */
#define SOAKED 0.9999f
/* Diffusivity of water in the paper. The wet front moves about 1.4 mm in the first second, and its
 * distance is proportional to sqrt(t). */
#define WICK_M2_S 1.0e-6f
/* Wetness above which paper becomes softer. Drier paper keeps its strength. */
#define SOFTENS_FROM 0.5f
/* Difference of wetness between the two neighbours of a cell at which the wet line counts as fully
 * developed. */
#define LINE_STEP 0.5f

/* Returns the wetness of `other` minus the wetness of `cell`, which drives the wicking. Returns 0
 * if `other` is not paper. */
static float creep(const struct sheet *sheet, uint32_t cell, uint32_t other)
{
    return sheet->state[other] == CELL_PAPER ? sheet->wetness[other] - sheet->wetness[cell] : 0.0f;
}

/* Returns 1 for a cell in the outermost rows and columns, otherwise 0. Such a cell has no neighbour
 * on one side and wicks no water. Few of these cells contain paper. */
static int is_border(uint32_t row, uint32_t column)
{
    return row == 0 || column == 0 || row == SHEET_SIDE - 1u || column == SHEET_SIDE - 1u;
}

/* Makes the cells under water wetter, and moves water in air from wet cells to drier neighbours. */
static void wet_cells(struct sheet *sheet, struct sheet_wetting wet)
{
    const float soak = 1.0f - f_exp(-CORE_TICK_S / WET_TAU_S);
    const float spread = WICK_M2_S * CORE_TICK_S / (sheet_cell_m(sheet) * sheet_cell_m(sheet));
    float driest = 1.0f;
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        const uint32_t row = cell / SHEET_SIDE, column = cell % SHEET_SIDE;
        if (sheet->state[cell] != CELL_PAPER) {
            continue;
        }
        if (wet.x * sheet_line_m(sheet, column) + wet.z * sheet_line_m(sheet, row) < wet.limit_m) {
            sheet->wetness[cell] += soak * (1.0f - sheet->wetness[cell]);
        } else if (!is_border(row, column)) {
            const float flow = creep(sheet, cell, cell - 1u) + creep(sheet, cell, cell + 1u) +
                               creep(sheet, cell, cell - SHEET_SIDE) +
                               creep(sheet, cell, cell + SHEET_SIDE);
            sheet->wetness[cell] += f_max(0.0f, spread * flow);
        }
        driest = f_min(driest, sheet->wetness[cell]);
    }
    sheet->soaked = driest >= SOAKED;
}

/* Returns 1 if any part of the sheet may be under water, otherwise 0. The test is cheap, because it
 * treats the sheet as a disc. */
static int reaches_water(const struct sheet *sheet, struct sheet_wetting wet)
{
    return -sheet->radius_m * f_sqrt(wet.x * wet.x + wet.z * wet.z) < wet.limit_m;
}

/* Softens the wet cells under water and in air, because their fibres swell in both cases. */
static void soften(struct sheet *sheet)
{
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        const uint16_t ticks = sheet->soak_ticks[cell];
        const uint16_t more = sheet->wetness[cell] >= SOFTENS_FROM && ticks < SHEET_SOAK_TICKS;
        sheet->soak_ticks[cell] = (uint16_t)(ticks + more);
    }
}

void wetting_tick(struct sheet *sheet, struct sheet_wetting wet)
{
    sheet->touched |= (uint8_t)reaches_water(sheet, wet);
    if (sheet->touched && !sheet->soaked) {
        wet_cells(sheet, wet);
    }
    if (sheet->touched) {
        soften(sheet);
    }
}

/* Returns the difference of wetness between the cells `before` and `after`. Returns 0 if one of the
 * cells is not paper. */
static float step_between(const struct sheet *sheet, uint32_t before, uint32_t after)
{
    const int is_paper = sheet->state[before] == CELL_PAPER && sheet->state[after] == CELL_PAPER;
    return is_paper ? f_abs(sheet->wetness[before] - sheet->wetness[after]) : 0.0f;
}

float wetting_line(const struct sheet *sheet, uint32_t row, uint32_t column)
{
    const uint32_t cell = row * SHEET_SIDE + column, last = SHEET_SIDE - 1u;
    float step = 0.0f;
    if (column > 0 && column < last) {
        step = step_between(sheet, cell - 1u, cell + 1u);
    }
    if (row > 0 && row < last) {
        step = f_max(step, step_between(sheet, cell - SHEET_SIDE, cell + SHEET_SIDE));
    }
    return f_min(step / LINE_STEP, 1.0f);
}
