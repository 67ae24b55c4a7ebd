/* paint_atlas.c -- implementation of paint_atlas.h. */
#include "platform/render/paint_atlas.h"

#include "core/base/fmath.h"
#include "core/base/panic.h"

#define CELLS_A_ROW (PAINT_SIZE / PAINT_CELL_WIDTH)

static const struct cell {
    uint8_t part, side;
} cells[] = {
    { PART_EYE, SIDE_RIGHT },           { PART_EYE, SIDE_LEFT },
    { PART_PECTORAL, SIDE_RIGHT },      { PART_PECTORAL, SIDE_LEFT },
    { PART_PELVIC, SIDE_RIGHT },        { PART_PELVIC, SIDE_LEFT },
    { PART_TAIL, SIDE_MIDDLE },         { PART_DORSAL, SIDE_MIDDLE },
    { PART_ANAL, SIDE_MIDDLE },         { PART_DORSAL_2, SIDE_MIDDLE },
    { PART_FINLET_UPPER, SIDE_MIDDLE }, { PART_FINLET_LOWER, SIDE_MIDDLE },
};
#define CELL_COUNT ((uint32_t)(sizeof cells / sizeof *cells))

struct place {
    uint32_t x, y, width, height; /* Position in texels from the upper left corner of the atlas, and
                                     size in texels. */
};

static struct place paint_atlas_place_of(uint32_t cell)
{
    return (struct place){ cell % CELLS_A_ROW * PAINT_CELL_WIDTH,
                           PAINT_BODY_HEIGHT + cell / CELLS_A_ROW * PAINT_CELL_HEIGHT,
                           PAINT_CELL_WIDTH, PAINT_CELL_HEIGHT };
}

/* Returns the atlas cell of a vertex. A fin in the midplane has one cell, regardless of the
 * vertex's side. A vertex of a paired fin without a side uses the right fin's cell. */
static struct place paint_atlas_find_cell(const struct species_vertex *vertex)
{
    uint32_t found = CELL_COUNT;
    CORE_ASSERT(vertex->part < PART_COUNT);
    if (vertex->part == PART_BODY) {
        return (struct place){ 0, 0, PAINT_SIZE, PAINT_BODY_HEIGHT };
    }
    for (uint32_t i = 0; i < CELL_COUNT; i++) {
        if (cells[i].part == vertex->part &&
            (found == CELL_COUNT || cells[i].side == vertex->side)) {
            found = i;
        }
    }
    CORE_ASSERT(found < CELL_COUNT);
    return paint_atlas_place_of(found);
}

/* Returns the centre of a texel row or column, as a fraction of the atlas. `t` in [0, 1] selects
 * one of the `count` rows or columns that begin at number `first`. */
static float middle(uint32_t first, uint32_t count, float t)
{
    const float at = (float)first + 0.5f + f_clamp(t, 0.0f, 1.0f) * (float)(count - 1u);
    return at / (float)PAINT_SIZE;
}

void paint_atlas_find(const struct species_vertex *vertex, float uv[2])
{
    const struct place place = paint_atlas_find_cell(vertex);
    uv[0] = middle(place.x, place.width, vertex->u);
    uv[1] = middle(place.y, place.height, vertex->v);
}

static float paint_atlas_along(float at, uint32_t first, uint32_t count)
{
    return f_clamp((at - (float)first - 0.5f) / (float)(count - 1u), 0.0f, 1.0f);
}

bool paint_atlas_at(float x, float y, struct species_vertex *vertex)
{
    CORE_ASSERT(x >= 0.0f && x < (float)PAINT_SIZE);
    CORE_ASSERT(y >= 0.0f && y < (float)PAINT_SIZE);
    const bool body = y < (float)PAINT_BODY_HEIGHT;
    const uint32_t row = body ? 0 : ((uint32_t)y - PAINT_BODY_HEIGHT) / PAINT_CELL_HEIGHT;
    const uint32_t cell = row * CELLS_A_ROW + (uint32_t)x / PAINT_CELL_WIDTH;
    if (!body && cell >= CELL_COUNT) {
        return false;
    }
    const struct place place =
        body ? (struct place){ 0, 0, PAINT_SIZE, PAINT_BODY_HEIGHT } : paint_atlas_place_of(cell);
    *vertex = (struct species_vertex){
        .u = paint_atlas_along(x, place.x, place.width),
        .v = paint_atlas_along(y, place.y, place.height),
        .part = body ? PART_BODY : cells[cell].part,
        .side = body ? SIDE_MIDDLE : cells[cell].side,
        .anchor = ANCHOR_NONE,
        .mask = { 255 },
    };
    return true;
}
