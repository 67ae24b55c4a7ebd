/* paint_atlas.c -- computes which body part each texel of the paint atlas shows, and paints the
 * texels. */
#include "platform/render/paint_atlas.h"

#include <string.h>

#include "core/base/fmath.h"
#include "core/base/panic.h"

/* Maximum difference of a colour component (0 to 255) between neighbouring texels. If the
 * difference is larger, each of the two texels is painted as the mean of four points. */
#define EDGE 20
#define BAND_TEXELS (PAINT_BAND * PAINT_SIZE)

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
    /* Position, in texels from the upper left corner of the atlas, and size in texels of a body
     * part's area. */
    uint32_t x, y, width, height;
};

static const struct place body_place = { 0, 0, PAINT_SIZE, PAINT_BODY_HEIGHT };

static struct place place_of_cell(uint32_t cell)
{
    CORE_ASSERT(cell < CELL_COUNT);
    return (struct place){ cell % CELLS_A_ROW * PAINT_CELL_WIDTH,
                           PAINT_BODY_HEIGHT + cell / CELLS_A_ROW * PAINT_CELL_HEIGHT,
                           PAINT_CELL_WIDTH, PAINT_CELL_HEIGHT };
}

/* Returns an atlas coordinate [0, 1] between texel centres. `t` in [0, 1] runs from the centre of
 * texel row or column `first` (0) to the centre of the last of `count` rows or columns (1). */
static float texel_centre(uint32_t first, uint32_t count, float t)
{
    const float at = (float)first + 0.5f + f_clamp(t, 0.0f, 1.0f) * (float)(count - 1u);
    return at / (float)PAINT_SIZE;
}

/* An unpaired fin has one cell of the atlas, regardless of the vertex's side. A paired fin has one
 * cell for each side. A vertex of a paired fin whose side is neither left nor right uses the right
 * fin's cell. */
void paint_atlas_find(const struct species_vertex *vertex, float uv[2])
{
    uint32_t found = CELL_COUNT;
    CORE_ASSERT(vertex->part < PART_COUNT);
    for (uint32_t i = 0; i < CELL_COUNT; i++) {
        if (cells[i].part == vertex->part &&
            (found == CELL_COUNT || cells[i].side == vertex->side)) {
            found = i;
        }
    }
    CORE_ASSERT(found < CELL_COUNT || vertex->part == PART_BODY);
    const struct place place = vertex->part == PART_BODY ? body_place : place_of_cell(found);
    uv[0] = texel_centre(place.x, place.width, vertex->u);
    uv[1] = texel_centre(place.y, place.height, vertex->v);
}

/* Inverse of texel_centre(): returns `t` in [0, 1] for the position `at` in texels. */
static float share_along(float at, uint32_t first, uint32_t count)
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
    const struct place place = body ? body_place : place_of_cell(cell);
    *vertex = (struct species_vertex){
        .u = share_along(x, place.x, place.width),
        .v = share_along(y, place.y, place.height),
        .part = body ? PART_BODY : cells[cell].part,
        .side = body ? SIDE_MIDDLE : cells[cell].side,
        .anchor = ANCHOR_NONE,
        .mask = { 255 },
    };
    return true;
}

/* ---- Painting of a group of texel rows ------------------------------------------------------- */

uint8_t paint_atlas_byte(float x)
{
    return (uint8_t)(f_clamp(x, 0.0f, 1.0f) * 255.0f + 0.5f);
}

/* Computes the paint at (x, y), in texels. Returns false if no body part has texels there. */
static bool paint_point(const struct painting *painting, float x, float y, struct paint *paint)
{
    struct species_vertex at;
    if (!paint_atlas_at(x, y, &at)) {
        return false;
    }
    *paint = paint_at(painting->species, painting->weights, &at);
    return true;
}

static void put_texel(const struct painting *painting, uint32_t index, const struct paint *paint)
{
    CORE_ASSERT(index < BAND_TEXELS);
    const uint8_t texel[4] = { paint_atlas_byte(paint->colour.x), paint_atlas_byte(paint->colour.y),
                               paint_atlas_byte(paint->colour.z), paint_atlas_byte(paint->clear) };
    memcpy(painting->brush->paint[index], texel, sizeof texel);
    painting->brush->shine[index] = paint_atlas_byte(paint->shine);
}

void paint_atlas_coarse_points(const struct painting *painting)
{
    const float half = 0.5f * (float)PAINT_COARSE;
    for (uint32_t i = 0; i < PAINT_COARSE_SIZE * PAINT_COARSE_SIZE; i++) {
        struct paint paint = { .colour = { 0.0f, 0.0f, 0.0f } };
        float *const point = painting->brush->coarse[i];
        paint_point(painting, (float)(i % PAINT_COARSE_SIZE * PAINT_COARSE) + half,
                    (float)(i / PAINT_COARSE_SIZE * PAINT_COARSE) + half, &paint);
        point[0] = paint.colour.x;
        point[1] = paint.colour.y;
        point[2] = paint.colour.z;
        point[3] = paint.clear;
        point[4] = paint.shine;
    }
}

/* Finds the two points of the coarse painting between which texel number `at` lies along one axis,
 * and writes their indices to `points`. Both points are in the texel's atlas cell, which has `size`
 * texels along the axis. Returns the interpolation weight of the second point. */
static float find_coarse_points(uint32_t at, uint32_t size, uint32_t points[2])
{
    CORE_ASSERT(size >= PAINT_COARSE && size % PAINT_COARSE == 0);
    const float first = (float)(at - at % size) / (float)PAINT_COARSE;
    const float last = first + (float)(size / PAINT_COARSE) - 1.0f;
    const float x = f_clamp(((float)at + 0.5f) / (float)PAINT_COARSE - 0.5f, first, last);
    points[0] = (uint32_t)x;
    points[1] = (float)points[0] + 1.0f <= last ? points[0] + 1u : points[0];
    return x - (float)points[0];
}

void paint_atlas_coarse_band(const struct painting *painting, uint32_t first)
{
    CORE_ASSERT(first % PAINT_BAND == 0 && first < PAINT_SIZE);
    for (uint32_t index = 0; index < BAND_TEXELS; index++) {
        const uint32_t x = index % PAINT_SIZE, y = first + index / PAINT_SIZE;
        const bool body = y < PAINT_BODY_HEIGHT;
        uint32_t columns[2], rows[2];
        float value[5];
        const float right = find_coarse_points(x, body ? PAINT_SIZE : PAINT_CELL_WIDTH, columns);
        const float down =
            find_coarse_points(y, body ? PAINT_BODY_HEIGHT : PAINT_CELL_HEIGHT, rows);
        for (uint32_t i = 0; i < 5; i++) {
            float line[2];
            for (uint32_t k = 0; k < 2; k++) {
                const uint32_t row = rows[k] * PAINT_COARSE_SIZE;
                line[k] = f_lerp(painting->brush->coarse[row + columns[0]][i],
                                 painting->brush->coarse[row + columns[1]][i], right);
            }
            value[i] = f_lerp(line[0], line[1], down);
        }
        put_texel(painting, index,
                  &(struct paint){ .colour = { value[0], value[1], value[2] },
                                   .clear = value[3],
                                   .shine = value[4] });
    }
}

/* Returns true if a component of the two neighbouring texels `a` and `b` differs by more than
 * EDGE. */
static bool differ(const uint8_t a[4], const uint8_t b[4])
{
    int32_t most = 0;
    for (uint32_t i = 0; i < 4; i++) {
        const int32_t d = (int32_t)a[i] - (int32_t)b[i];
        most = d > most ? d : -d > most ? -d : most;
    }
    return most > EDGE;
}

/* Each texel first gets the paint at its centre. Then the edges of the paint's marks are smoothed,
 * because an edge that is sharper than a texel would look jagged. */
void paint_atlas_fine_band(const struct painting *painting, uint32_t first)
{
    struct paint paint = { .colour = { 0.0f, 0.0f, 0.0f } };
    bool edge[BAND_TEXELS] = { false };
    CORE_ASSERT(first % PAINT_BAND == 0 && first < PAINT_SIZE);
    for (uint32_t i = 0; i < BAND_TEXELS; i++) {
        const float x = (float)(i % PAINT_SIZE) + 0.5f;
        const float y = (float)(first + i / PAINT_SIZE) + 0.5f;
        if (paint_point(painting, x, y, &paint)) {
            put_texel(painting, i, &paint);
        }
    }
    for (uint32_t i = 0; i < BAND_TEXELS; i++) {
        const uint32_t right = i % PAINT_SIZE < PAINT_SIZE - 1u ? i + 1u : i;
        const uint32_t below = i + PAINT_SIZE < BAND_TEXELS ? i + PAINT_SIZE : i;
        const uint8_t(*const texels)[4] = (const uint8_t(*)[4])painting->brush->paint;
        if (differ(texels[i], texels[right])) {
            edge[i] = edge[right] = true;
        }
        if (differ(texels[i], texels[below])) {
            edge[i] = edge[below] = true;
        }
    }
    for (uint32_t i = 0; i < BAND_TEXELS; i++) {
        /* A texel at an edge is painted as the mean of the paint at four points. */
        struct paint mean = { .colour = { 0.0f, 0.0f, 0.0f } };
        for (uint32_t k = 0; k < 4 && edge[i]; k++) {
            const float x = (float)(i % PAINT_SIZE) + (0.25f + 0.5f * (float)(k & 1u));
            const float y = (float)(first + i / PAINT_SIZE) + (0.25f + 0.5f * (float)(k >> 1));
            edge[i] = paint_point(painting, x, y, &paint);
            mean.colour = v3_muladd(mean.colour, paint.colour, 0.25f);
            mean.clear += 0.25f * paint.clear;
            mean.shine += 0.25f * paint.shine;
        }
        if (edge[i]) {
            put_texel(painting, i, &mean);
        }
    }
}
