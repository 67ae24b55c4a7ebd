/* tear.c -- computes the stress factors and the loose paper of a sheet from bit masks of its
 * holes. */
#include "core/poi/paper/tear.h"

/* Number of directions from a cell to its neighbours. The directions are counted clockwise from the
 * right, as seen from above. */
#define WAYS 8u
/* Stress factor of a diagonal step: 2^(-1/20). Damage grows with the tenth power of the stress
 * (SHEET_DAMAGE_EXPONENT), and therefore a diagonal step takes sqrt(2) times as long as a straight
 * step. */
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
    tear_measure(&map);
    return map;
}

void tear_measure(struct tear_map *map)
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
        const uint32_t slant = up << 1 | up >> 1 | down << 1 | down >> 1; /* Two hole cells that
                                                                             touch at a corner are
                                                                             2.8 cells long from
                                                                             corner to corner. */
        map->pair[row] = here & (left | right | up | down);
        map->wide[row] = here & (across | along | slant);
    }
}

static uint32_t wider(uint32_t bits)
{
    return bits | bits << 1 | bits >> 1;
}

uint32_t tear_front(const struct tear_map *map, uint32_t row)
{
    const uint32_t above = row > 0 ? map->hole[row - 1u] : 0u;
    const uint32_t below = row + 1u < SHEET_SIDE ? map->hole[row + 1u] : 0u;
    return map->paper[row] & (wider(above) | wider(map->hole[row]) | wider(below));
}

/* ---- Stress at the tips of tears ------------------------------------------------------------- */

static float factor_of(const struct tear_map *map, uint32_t row, uint32_t column)
{
    if (map->wide[row] >> column & 1u) {
        return TEAR_FACTOR_MAX;
    }
    return map->pair[row] >> column & 1u ? TEAR_FACTOR * 1.41421356f : TEAR_FACTOR;
}

float tear_factor(const struct tear_map *map, const struct sheet *sheet, uint32_t row,
                  uint32_t column)
{
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
            worst = f_max(worst, factor_of(map, r, c) * grain * step);
        }
    }
    return worst;
}

/* ---- Removal of loose paper ----------------------------------------------------------------- */

/* Returns the word `bits` of an adjacent row, shifted so that bit i of the result is bit i + column
 * of `bits`. `column` is -1, 0 or 1. */
static uint32_t aside(uint32_t bits, int32_t column)
{
    return column > 0 ? bits >> 1 : column < 0 ? bits << 1 : bits;
}

/* Returns the bits `open` extended along a row over contiguous paper. `column` is the direction (1
 * or -1) from a cell toward the ring, and the bits are extended in the opposite direction. Each
 * pass of the loop doubles the distance. */
static uint32_t spread(uint32_t open, uint32_t paper, int32_t column)
{
    for (uint32_t step = 1; step < SHEET_SIDE; step *= 2u) {
        open |= paper & (column > 0 ? open >> step : open << step);
        paper &= column > 0 ? paper >> step : paper << step;
    }
    return open;
}

/* Writes to `open` the paper cells from which a straight line of paper cells in the direction `way`
 * reaches the ring. */
static void find_open_cells(const struct tear_map *map, const struct way *way,
                            uint32_t open[SHEET_SIDE])
{
    for (uint32_t i = 0; i < SHEET_SIDE; i++) {
        const uint32_t row = way->row > 0 ? SHEET_SIDE - 1u - i : i;
        const uint32_t next = row + (uint32_t)way->row;
        const uint32_t inside = next < SHEET_SIDE ? map->paper[next] | map->hole[next] : 0u;
        const uint32_t at_ring = map->paper[row] & ~aside(inside, way->column);
        if (way->row == 0) {
            open[row] = spread(at_ring, map->paper[row], way->column);
        } else {
            const uint32_t seen = next < SHEET_SIDE ? open[next] : 0u;
            open[row] = at_ring | (map->paper[row] & aside(seen, way->column));
        }
    }
}

static uint32_t loose_of_row(uint32_t open[WAYS][SHEET_SIDE], uint32_t paper, uint32_t row)
{
    uint32_t held = 0;
    for (uint32_t way = 0; way < WAYS; way++) {
        held |= open[way][row] & (open[(way + 3u) % WAYS][row] | open[(way + 4u) % WAYS][row] |
                                  open[(way + 5u) % WAYS][row]);
    }
    return paper & ~held;
}

static uint32_t drop_row(struct tear_map *map, struct sheet *sheet, uint32_t row, uint32_t loose)
{
    uint32_t count = 0;
    map->paper[row] &= ~loose;
    map->hole[row] |= loose;
    for (uint32_t column = 0; loose != 0 && column < SHEET_SIDE; column++) {
        if (loose >> column & 1u) {
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
        dropped += drop_row(map, sheet, row, loose_of_row(open, map->paper[row], row));
    }
    tear_measure(map);
    return dropped;
}
