/* tear.c -- computes the stress factors and the loose paper of a sheet from bit masks of its holes,
 * and the wetness of the paper cell by cell. */
#include "core/poi/paper/strain.h"

#include "core/base/panic.h"

/* Number of directions from a cell to its eight neighbours. Seen from above, the directions go
 * clockwise around the cell and begin at the right. */
#define WAYS 8u
/* Factor of the stress in a paper cell that touches the hole cell only at a corner: 2^(-1/20). A
 * tear that spreads from cell to cell moves sqrt(2) times as far to a diagonal neighbour as to a
 * straight neighbour, and should take sqrt(2) times as long. Damage grows with the tenth power of
 * the stress (SHEET_DAMAGE_EXPONENT), so the stress must be lower by the tenth root of sqrt(2). */
#define CORNER_SHARE 0.966f

struct way {
    int32_t row, column;
    float x, z; /* Components of the unit vector of the direction. */
};

#define SLANT 0.70710678f
static const struct way ways[WAYS] = {
    { 0, 1, 1.0f, 0.0f },     { 1, 1, SLANT, SLANT },   { 1, 0, 0.0f, 1.0f },
    { 1, -1, -SLANT, SLANT }, { 0, -1, -1.0f, 0.0f },   { -1, -1, -SLANT, -SLANT },
    { -1, 0, 0.0f, -1.0f },   { -1, 1, SLANT, -SLANT },
};

/* Computes the members `pair` and `wide` of `map` from its member `hole`. */
static void measure_holes(struct tear_map *map)
{
    for (uint32_t row = 0; row < SHEET_SIDE; row++) {
        const uint32_t here = map->hole[row];
        const uint32_t up = row > 0 ? map->hole[row - 1u] : 0u;
        const uint32_t up2 = row > 1u ? map->hole[row - 2u] : 0u;
        const uint32_t down = row + 1u < SHEET_SIDE ? map->hole[row + 1u] : 0u;
        const uint32_t down2 = row + 2u < SHEET_SIDE ? map->hole[row + 2u] : 0u;
        const uint32_t left = here << 1, left2 = here << 2, right = here >> 1, right2 = here >> 2;
        const uint32_t across = (left & left2) | (left & right) | (right & right2);
        const uint32_t along = (up & up2) | (up & down) | (down & down2);
        /* Two hole cells that touch at a corner are 2.8 cells long from corner to corner, which is
         * long enough for TEAR_FACTOR_MAX. */
        const uint32_t slant = up << 1 | up >> 1 | down << 1 | down >> 1;
        map->pair[row] = here & (left | right | up | down);
        map->wide[row] = here & (across | along | slant);
    }
}

struct tear_map tear_map_of(const struct sheet *sheet)
{
    struct tear_map map = { 0 };
    for (uint32_t row = 0; row < SHEET_SIDE; row++) {
        const uint8_t *state = &sheet->state[row * SHEET_SIDE];
        for (uint32_t column = 0; column < SHEET_SIDE; column++) {
            map.paper[row] |= (uint32_t)(state[column] == CELL_PAPER) << column;
            map.hole[row] |= (uint32_t)(state[column] == CELL_HOLE) << column;
        }
    }
    measure_holes(&map);
    return map;
}

uint32_t tear_front(const struct tear_map *map, uint32_t row)
{
    CORE_ASSERT(row < SHEET_SIDE);
    const uint32_t above = row > 0 ? map->hole[row - 1u] : 0u;
    const uint32_t below = row + 1u < SHEET_SIDE ? map->hole[row + 1u] : 0u;
    const uint32_t holes = above | map->hole[row] | below;
    return map->paper[row] & (holes | holes << 1 | holes >> 1);
}

/* ---- Stress at the tips of tears ------------------------------------------------------------- */

float tear_factor(const struct tear_map *map, const struct sheet *sheet, uint32_t row,
                  uint32_t column)
{
    CORE_ASSERT(row < SHEET_SIDE && column < SHEET_SIDE);
    float worst = 0.0f;
    for (uint32_t way = 0; way < WAYS; way++) {
        const uint32_t r = row + (uint32_t)ways[way].row; /* If `row` is 0, the sum row - 1 wraps to
                                                             a very large unsigned number, which the
                                                             following test rejects. */
        const uint32_t c = column + (uint32_t)ways[way].column;
        if (r < SHEET_SIDE && c < SHEET_SIDE && map->hole[r] >> c & 1u) {
            const float along = ways[way].x * sheet->fibre_x + ways[way].z * sheet->fibre_z;
            const float grain = 1.0f + TEAR_FIBRE_SHARE * (2.0f * along * along - 1.0f);
            const float step = way % 2u ? CORNER_SHARE : 1.0f;
            const float factor = map->wide[r] >> c & 1u   ? TEAR_FACTOR_MAX
                                 : map->pair[r] >> c & 1u ? TEAR_FACTOR * 1.41421356f
                                                          : TEAR_FACTOR;
            worst = f_max(worst, factor * grain * step);
        }
    }
    return worst;
}

/* ---- Removal of loose paper ----------------------------------------------------------------- */

/* Returns the word `bits` of an adjacent row, shifted so that bit i of the result is bit i + column
 * of `bits`. `column` is -1, 0 or 1. */
static uint32_t shift_row_word(uint32_t bits, int32_t column)
{
    CORE_ASSERT(column >= -1 && column <= 1);
    return column > 0 ? bits >> 1 : column < 0 ? bits << 1 : bits;
}

/* Writes to `open` the paper cells from which a straight line of paper cells in the direction `way`
 * reaches the ring. */
static void find_open_cells(const struct tear_map *map, const struct way *way,
                            uint32_t open[SHEET_SIDE])
{
    CORE_ASSERT(way->row != 0 || way->column != 0);
    for (uint32_t i = 0; i < SHEET_SIDE; i++) {
        const uint32_t row = way->row > 0 ? SHEET_SIDE - 1u - i : i;
        const uint32_t next = row + (uint32_t)way->row;
        const uint32_t inside = next < SHEET_SIDE ? map->paper[next] | map->hole[next] : 0u;
        const uint32_t at_ring = map->paper[row] & ~shift_row_word(inside, way->column);
        if (way->row == 0) {
            /* open[row] holds the cells of this row that paper connects to the ring. Extends these
             * cells along the row, away from the ring, as far as the paper has no gap. Each pass
             * of the loop doubles the distance. */
            const bool is_right = way->column > 0;
            uint32_t paper = map->paper[row];
            open[row] = at_ring;
            for (uint32_t step = 1; step < SHEET_SIDE; step *= 2u) {
                open[row] |= paper & (is_right ? open[row] >> step : open[row] << step);
                paper &= is_right ? paper >> step : paper << step;
            }
        } else {
            const uint32_t seen = next < SHEET_SIDE ? open[next] : 0u;
            open[row] = at_ring | (map->paper[row] & shift_row_word(seen, way->column));
        }
    }
}

uint32_t tear_open_row(struct tear_map *map, struct sheet *sheet, uint32_t row, uint32_t torn)
{
    CORE_ASSERT(row < SHEET_SIDE);
    uint32_t count = 0;
    map->paper[row] &= ~torn;
    map->hole[row] |= torn;
    for (uint32_t column = 0; torn != 0 && column < SHEET_SIDE; column++) {
        if (torn >> column & 1u) {
            sheet->state[row * SHEET_SIDE + column] = CELL_HOLE;
            count++;
        }
    }
    return count;
}

uint32_t tear_drop_loose(struct tear_map *map, struct sheet *sheet)
{
    uint32_t open[WAYS][SHEET_SIDE];
    uint32_t dropped = 0;
    for (uint32_t way = 0; way < WAYS; way++) {
        find_open_cells(map, &ways[way], open[way]);
    }
    for (uint32_t row = 0; row < SHEET_SIDE; row++) {
        uint32_t held = 0;
        for (uint32_t way = 0; way < WAYS; way++) {
            held |= open[way][row] & (open[(way + 3u) % WAYS][row] | open[(way + 4u) % WAYS][row] |
                                      open[(way + 5u) % WAYS][row]);
        }
        dropped += tear_open_row(map, sheet, row, map->paper[row] & ~held);
    }
    measure_holes(map);
    return dropped;
}

/* ---- Wetting --------------------------------------------------------------------------------- */

#define WET_TAU_S 1.0f /* Time constant with which a cell becomes wet under water. */
/* Wetness from which a cell counts as completely wet. The sheet is soaked if all its cells are
 * completely wet. */
#define SOAKED 0.9999f
/* Diffusivity of water in the paper. The wet front moves about 1.4 mm in the first second, and its
 * distance is proportional to sqrt(t). */
#define WICK_M2_S 1.0e-6f
/* Wetness above which paper becomes softer. Drier paper keeps its strength. */
#define SOFTENS_FROM 0.5f
/* Difference of wetness between the two neighbours of a cell at which the line between wet and dry
 * paper counts as fully developed. */
#define LINE_STEP 0.5f

/* Returns the wetness of `other` minus the wetness of `cell`, which drives the flow of water
 * between the two cells. Returns 0 if `other` is not paper. */
static float creep(const struct sheet *sheet, uint32_t cell, uint32_t other)
{
    return sheet->state[other] == CELL_PAPER ? sheet->wetness[other] - sheet->wetness[cell] : 0.0f;
}

void paper_wetting_tick(struct sheet *sheet, struct sheet_wetting wet)
{
    CORE_ASSERT(sheet->radius_m > 0.0f);
    /* Sets `touched` if any point of the round sheet is under water. This test takes much less time
     * than a test of each cell. */
    if (-sheet->radius_m * f_sqrt(wet.x * wet.x + wet.z * wet.z) < wet.limit_m) {
        sheet->touched = true;
    }
    if (!sheet->touched) {
        return;
    }
    const float soak = 1.0f - f_exp(-CORE_TICK_S / WET_TAU_S);
    const float spread = WICK_M2_S * CORE_TICK_S / (sheet_cell_m(sheet) * sheet_cell_m(sheet));
    float driest = 1.0f;
    /* Makes the cells under water wetter, and moves water in air from wet cells to drier
     * neighbours. */
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT && !sheet->soaked; cell++) {
        const uint32_t row = cell / SHEET_SIDE, column = cell % SHEET_SIDE;
        if (sheet->state[cell] != CELL_PAPER) {
            continue;
        }
        if (wet.x * sheet_line_m(sheet, column) + wet.z * sheet_line_m(sheet, row) < wet.limit_m) {
            sheet->wetness[cell] += soak * (1.0f - sheet->wetness[cell]);
        } else if (row > 0 && column > 0 && row < SHEET_SIDE - 1u && column < SHEET_SIDE - 1u) {
            /* A cell in the outermost rows and columns has no neighbour on one side and wicks no
             * water. Few of these cells contain paper. */
            const float flow = creep(sheet, cell, cell - 1u) + creep(sheet, cell, cell + 1u) +
                               creep(sheet, cell, cell - SHEET_SIDE) +
                               creep(sheet, cell, cell + SHEET_SIDE);
            sheet->wetness[cell] += f_max(0.0f, spread * flow);
        }
        driest = f_min(driest, sheet->wetness[cell]);
    }
    sheet->soaked = sheet->soaked || driest >= SOAKED;
    /* Cells that are wet become softer under water and in air, because their fibres swell in both
     * cases. */
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        const uint16_t ticks = sheet->soak_ticks[cell];
        const uint16_t more = sheet->wetness[cell] >= SOFTENS_FROM && ticks < SHEET_SOAK_TICKS;
        sheet->soak_ticks[cell] = (uint16_t)(ticks + more);
    }
}

/* Returns the difference of wetness between the cells `before` and `after`. Returns 0 if one of the
 * cells is not paper. */
static float step_between(const struct sheet *sheet, uint32_t before, uint32_t after)
{
    const bool is_paper = sheet->state[before] == CELL_PAPER && sheet->state[after] == CELL_PAPER;
    return is_paper ? f_abs(sheet->wetness[before] - sheet->wetness[after]) : 0.0f;
}

float paper_wetting_line(const struct sheet *sheet, uint32_t row, uint32_t column)
{
    CORE_ASSERT(row < SHEET_SIDE && column < SHEET_SIDE);
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
