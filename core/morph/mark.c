/* mark.c -- computes the painted marks of a fish: spots, rows of dots, bars, lines, fin margins,
 * patches, marks on one side, and the slits of mouth and gill.
 *
 * The coverage of a mark at a point is the opacity of the mark, from 0 (not painted) to 1 (fully
 * painted). Each mark is a function of the body coordinates of a point and has soft edges. Marks
 * therefore move with the skin as the fish grows and need no texture. Lengths are in body lengths.
 * The member `flank` of a point converts distances around the girth to body lengths. */
#include "core/morph/mark.h"

#include "core/base/fmath.h"
#include "core/base/panic.h"
#include "core/morph/morph.h"

#define PI 3.14159265f
/* Half the width of a soft edge, measured along the body, in body lengths. */
#define SOFT_U 0.006f
/* Half the width of a soft edge, measured from belly to back, as a fraction of the height of the
 * body. */
#define SOFT_HEIGHT 0.03f
#define UNEVEN 0.35f /* Largest random deviation of a spot's radius, as a fraction of the radius. */
/* Width of the margin along each edge of a spot's cell, as a fraction of the cell. The spot's
 * centre lies at a random place in the rest of the cell, never in the margin. */
#define CELL_RIM 0.2f
/* Assumed height of a flank in body lengths, which converts the height of the gill slit to body
 * lengths. */
#define BOW_HEIGHT 0.35f
/* Value of mark_point.right (-1 to 1) at which the soft edge of a mark on only one side begins. */
#define SIDE_RIM 0.25f
/* Factor that converts the width of the mouth slit from body lengths to a fraction of the head's
 * height. The head is assumed to be 0.14 body lengths high. */
#define SLIT_HEIGHT 7.0f

/* Size of a flank for each body form. `lengths` is the distance from back to belly in body lengths,
 * and `taper` is the fraction by which this distance is smaller at the tail root. The marks use
 * these constants and not the mesh, because the constants are accurate enough to make spots look
 * round. */
static const struct {
    float lengths, taper;
} flanks[] = {
    [FORM_FUSIFORM] = { 0.36f, 0.60f },  [FORM_COMPRESSED] = { 0.42f, 0.70f },
    [FORM_DEPRESSED] = { 0.50f, 0.85f }, [FORM_EEL] = { 0.09f, 0.40f },
    [FORM_PUFFER] = { 0.52f, 0.75f },
};

struct mark_point mark_point_of(const struct species_vertex *at, enum body_form form)
{
    CORE_ASSERT(at->part < PART_COUNT && at->side <= SIDE_LEFT && form <= FORM_PUFFER);
    struct mark_point point = { .part = at->part, .side = at->side, .u = at->u };
    if (at->part >= PART_TAIL) {
        point.height = at->v;
        point.down = 1.0f - at->v;
        point.flank = point.broad = 1.0f;
        point.right = at->side == SIDE_RIGHT ? 1.0f : at->side == SIDE_LEFT ? -1.0f : 0.0f;
        return point;
    }
    point.height = 0.5f + 0.5f * f_cos(2.0f * PI * at->v);
    point.down = 1.0f - f_abs(at->v * 2.0f - 1.0f);
    point.right = f_sin(2.0f * PI * at->v);
    point.broad = flanks[form].lengths;
    point.flank =
        flanks[form].lengths * (1.0f - flanks[form].taper * f_smoothstep(0.45f, 1.0f, at->u));
    return point;
}

/* Returns 1 for x within [from, to] and 0 outside. Around each limit, the result changes smoothly
 * over the distance `soft` on both sides. A limit of 0 or 1 has no soft edge. */
static float soft_interval(float x, float from, float to, float soft)
{
    const float above = from <= 0.0f ? 1.0f : f_smoothstep(from - soft, from + soft, x);
    const float below = to >= 1.0f ? 1.0f : 1.0f - f_smoothstep(to - soft, to + soft, x);
    return above * below;
}

/* Returns 1 if `distance` is within `radius`, otherwise 0, with a soft edge between. The width of
 * the soft edge is proportional to the radius. */
static float disc(float distance, float radius)
{
    const float soft = 0.2f * radius + 0.001f;
    return 1.0f - f_smoothstep(radius - soft, radius + soft, distance);
}

/* Converts a height in [0, 1] to the coordinate mark_point.down (0 at the back, 1 at the belly). */
static float down_of(const struct mark_point *at, float height)
{
    if (at->part >= PART_TAIL || height <= 0.0f || height >= 1.0f) {
        return 1.0f - height; /* The heights 0 and 1, which most marks use as limits, need no arc
                                 cosine. */
    }
    return f_acos(2.0f * height - 1.0f) / PI;
}

/* Returns a pseudo-random number in [0, 1) for a cell of a mark, by 32-bit integer hashing. A
 * different `purpose` gives an independent number for the same cell. */
static float chance(uint32_t cell, uint32_t seed, uint32_t purpose)
{
    uint32_t h = cell * 0x9e3779b1u ^ seed * 0x85ebca77u ^ purpose * 0xc2b2ae3du;
    h = (h ^ h >> 15) * 0x2c1b3c6du;
    h = (h ^ h >> 12) * 0x297a2d39u;
    return (float)((h ^ h >> 15) >> 8) / 16777216.0f;
}

/* Returns by how much a coordinate of a point is outside the range of a spot's centre. `x` is the
 * coordinate in the cell of the spot, in which 0 and 1 are the edges. The centre lies in [CELL_RIM,
 * 1 - CELL_RIM], and for `x` in this range the result is 0. */
static float to_middle(float x)
{
    return f_max(f_max(CELL_RIM - x, x - (1.0f - CELL_RIM)), 0.0f);
}

/* Returns the coverage of a mark with about `count` spots on each flank. A grid divides the area of
 * the mark into cells, and each cell has one spot at a random place. Only the spots of the nine
 * cells around the point are tested.
 *
 * Every column of the grid has the same number of cells. Toward the tail, the distance from back to
 * belly is shorter, and therefore the cells are lower. The spots are smaller there, so that no spot
 * is cut off. */
static float spots(const struct species_mark *m, const struct mark_point *at)
{
    const float top = down_of(at, m->high), bottom = down_of(at, m->low);
    const float length = f_max(m->to - m->from, 1e-3f);
    const float broad = f_max((bottom - top) * at->broad, 1e-3f);
    const float girth = f_max((bottom - top) * at->flank, 1e-3f);
    const float cell = f_sqrt(length * broad / f_max((float)m->count, 1.0f));
    const float columns = f_max(f_floor(length / cell + 0.5f), 1.0f);
    const float rows = f_max(f_floor(broad / cell + 0.5f), 1.0f);
    const float shrunk = m->width * f_sqrt(girth / broad);
    const float x = (at->u - m->from) / length * columns;
    const float y = (at->down - top) / f_max(bottom - top, 1e-3f) * rows;
    const float reach = shrunk * (1.0f + UNEVEN) * 1.2f + 0.001f; /* Largest radius of a spot plus
                                                                     its soft edge. */
    float cover = 0.0f;
    if (x < -1.0f || y < -1.0f || x > columns + 1.0f || y > rows + 1.0f) {
        return 0.0f;
    }
    for (int i = 0; i < 9; i++) {
        const int column = i % 3 - 1, row = i / 3 - 1;
        const float cx = f_floor(x) + (float)column, cy = f_floor(y) + (float)row;
        if (cx < 0.0f || cy < 0.0f || cx >= columns || cy >= rows ||
            to_middle(x - cx) * length > reach * columns ||
            to_middle(y - cy) * girth > reach * rows) {
            continue;
        }
        const uint32_t id = (uint32_t)cx * 64u + (uint32_t)cy + (at->right < 0.0f ? 8192u : 0u);
        const float sx = CELL_RIM + (1.0f - 2.0f * CELL_RIM) * chance(id, m->seed, 1u);
        const float sy = CELL_RIM + (1.0f - 2.0f * CELL_RIM) * chance(id, m->seed, 2u);
        const float dx = (cx + sx - x) * length / columns, dy = (cy + sy - y) * girth / rows;
        const float radius = shrunk * (1.0f + UNEVEN * (2.0f * chance(id, m->seed, 3u) - 1.0f));
        cover = f_max(cover, disc(f_sqrt(dx * dx + dy * dy), radius));
    }
    return cover;
}

/* Returns the coverage of a mark that consists of rows of dots. For this mark, `seed` is the number
 * of rows, and `count` is the number of dots in each row. Odd rows are offset from even rows by
 * half a step. Toward the tail, the rows are closer together, and the dots are smaller and flatter.
 * Therefore no dot is cut off. */
static float rows(const struct species_mark *m, const struct mark_point *at)
{
    const float row_count = f_max((float)m->seed, 1.0f), count = f_max((float)m->count, 1.0f);
    const float top = down_of(at, m->high), bottom = down_of(at, m->low);
    const float y = (at->down - top) / f_max(bottom - top, 1e-3f) * row_count;
    const float row = f_clamp(f_floor(y), 0.0f, row_count - 1.0f);
    const float shift = (uint32_t)row % 2u == 1u ? 0.25f : -0.25f;
    const float step = f_max(m->to - m->from, 1e-3f) / count;
    const float x = (at->u - m->from) / step + shift;
    const float dot = f_clamp(f_floor(x), 0.0f, count - 1.0f);
    const float dx = (dot + 0.5f - x) * step;
    const float dy = (row + 0.5f - y) / row_count * (bottom - top);
    const float thinner = f_sqrt(at->flank / at->broad), lower = at->broad * thinner;
    return disc(f_sqrt(dx * dx + dy * dy * lower * lower), m->width * thinner);
}

/* Returns the coverage of a mark that consists of `count` equally spaced lines. `extent` is the
 * distance between the first and the last limit of the mark, across the lines. `offset` is the
 * distance of the point from the first limit. */
static float lines(const struct species_mark *m, float offset, float extent)
{
    const float count = f_max((float)m->count, 1.0f);
    const float step = f_max(extent, 1e-3f) / count;
    const float x = offset / step;
    const float line = f_clamp(f_floor(x), 0.0f, count - 1.0f);
    return disc(f_abs(line + 0.5f - x) * step, 0.5f * m->width);
}

float mark_cover(const struct species_mark *m, const struct mark_point *at)
{
    CORE_ASSERT(at->part < PART_COUNT && at->side <= SIDE_LEFT);
    if (m->kind == MARK_SIDE) { /* A mark on only one side also covers the paired fins on that
                                   side. */
        const bool paired = at->part == PART_PECTORAL || at->part == PART_PELVIC;
        const float toward = m->count == SIDE_RIGHT ? at->right : -at->right;
        const float soft = f_max(m->width, 0.02f);
        return at->part != PART_BODY && !paired
                   ? 0.0f
                   : f_smoothstep(SIDE_RIM, SIDE_RIM + 2.0f * soft, toward) *
                         soft_interval(at->u, m->from, m->to, SOFT_HEIGHT);
    }
    if (m->part != at->part) {
        return 0.0f;
    }
    switch (m->kind) {
    case MARK_SPOTS:
        return spots(m, at);
    case MARK_ROWS:
        return rows(m, at);
    case MARK_BANDS:
        return lines(m, at->u - m->slant * (at->height - 0.5f) - m->from, m->to - m->from) *
               soft_interval(at->height, m->low, m->high, SOFT_HEIGHT);
    case MARK_STRIPES:
        return lines(m, at->height - m->slant * (at->u - m->from) - m->low, m->high - m->low) *
               soft_interval(at->u, m->from, m->to, 4.0f * SOFT_U);
    case MARK_EDGE: {
        const float inner = 1.0f - m->width, soft = 0.25f * m->width + 0.005f;
        return f_smoothstep(inner - soft, inner + soft, at->height) *
               soft_interval(at->u, m->from, m->to, SOFT_HEIGHT);
    }
    case MARK_PATCH:
        return soft_interval(at->u, m->from, m->to, m->width) *
               soft_interval(at->height, m->low, m->high, m->width);
    case MARK_MOUTH: { /* The mouth slit runs from the snout at the height `high` to the corner of
                          the mouth at u = `to` and height `low`, and narrows toward the corner. */
        const float along = at->u / f_max(m->to, 1e-3f), part = f_clamp(along, 0.0f, 1.0f);
        const float width = 0.5f * m->width * SLIT_HEIGHT * (1.0f - 0.5f * part);
        return disc(f_abs(at->height - f_lerp(m->high, m->low, part)), width) *
               (1.0f - f_smoothstep(0.92f, 1.06f, along));
    }
    case MARK_GILL: { /* The gill slit is an arc, and the middle of the arc is farthest toward the
                         tail. */
        const float half = f_max(0.5f * (m->high - m->low), 1e-3f);
        const float t = (at->height - 0.5f * (m->low + m->high)) / half;
        const float bow = m->slant * 2.0f * half * BOW_HEIGHT;
        return disc(f_abs(at->u - m->to + bow * t * t), 0.5f * m->width) *
               (1.0f - f_smoothstep(0.7f, 1.0f, f_abs(t)));
    }
    default:
        return 0.0f;
    }
}
