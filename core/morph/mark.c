/* mark.c -- the painted marks of a fish: spots, rows, bars, lines, margins, patches, and the slits
 * of mouth and gill.
 *
 * The cover of a mark is the share [0, 1] of a point that the mark paints. Each mark is a function
 * of the body coordinates of a point, with soft edges. Marks therefore move with the skin as the
 * fish grows and need no texture. Lengths are in body lengths, and `flank` of a point converts
 * distances around the girth into body lengths. */
#include "core/morph/mark.h"

#include "core/base/fmath.h"
#include "core/morph/morph.h"

#define PI 3.14159265f
#define SOFT_U 0.006f /* Half the width of a soft edge along the body, in body lengths. */
/* Half the width of a soft edge across the flank, as a share of the height. */
#define SOFT_HEIGHT 0.03f
#define UNEVEN 0.35f /* Random variation of the radius of a spot, as a share. */
/* Width of the rim of a spot's cell that never holds the centre of the spot, as a share of the
 * cell. */
#define CELL_RIM 0.2f
/* Height of a flank in body lengths, which gives the bow of the gill cover. */
#define BOW_HEIGHT 0.35f
/* Sine of the angle around the girth at which the soft edge of a flank begins. */
#define SIDE_RIM 0.25f
/* Factor from the width of a slit in body lengths to a share of the head's height, for a head 0.14
 * body lengths high. */
#define SLIT_HEIGHT 7.0f

/* Size of a flank for each body form: the distance from back to belly in body lengths, and the
 * share by which the distance is smaller at the tail root. Marks do not read the mesh, because
 * these values make spots round enough. */
static const struct {
    float lengths, taper;
} flanks[] = {
    [FORM_FUSIFORM] = { 0.36f, 0.60f },  [FORM_COMPRESSED] = { 0.42f, 0.70f },
    [FORM_DEPRESSED] = { 0.50f, 0.85f }, [FORM_EEL] = { 0.09f, 0.40f },
    [FORM_PUFFER] = { 0.52f, 0.75f },
};

struct mark_point mark_point_of(const struct species_vertex *at, enum body_form form)
{
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

/* Returns 1 within [from, to] and 0 outside, with edges of half width `soft`. An end at 0 or 1 has
 * no edge. */
static float soft_interval(float x, float from, float to, float soft)
{
    const float above = from <= 0.0f ? 1.0f : f_smoothstep(from - soft, from + soft, x);
    const float below = to >= 1.0f ? 1.0f : 1.0f - f_smoothstep(to - soft, to + soft, x);
    return above * below;
}

/* Returns 1 within `radius` and 0 outside. The width of the soft edge is proportional to the
 * radius. */
static float disc(float distance, float radius)
{
    const float soft = 0.2f * radius + 0.001f;
    return 1.0f - f_smoothstep(radius - soft, radius + soft, distance);
}

/* Returns the position `down` around the flank (0 at the back, 1 at the belly) for a height on the
 * body. */
static float down_of(const struct mark_point *at, float height)
{
    if (at->part >= PART_TAIL || height <= 0.0f || height >= 1.0f) {
        return 1.0f - height; /* Most marks reach the full height, which needs no arc cosine. */
    }
    return f_acos(2.0f * height - 1.0f) / PI;
}

/* Returns a pseudo-random number in [0, 1) for a cell of a mark (a 32-bit mixer). `purpose` selects
 * one of several numbers of the cell. */
static float chance(uint32_t cell, uint32_t seed, uint32_t purpose)
{
    uint32_t h = cell * 0x9e3779b1u ^ seed * 0x85ebca77u ^ purpose * 0xc2b2ae3du;
    h = (h ^ h >> 15) * 0x2c1b3c6du;
    h = (h ^ h >> 12) * 0x297a2d39u;
    return (float)((h ^ h >> 15) >> 8) / 16777216.0f;
}

/* Returns the distance from `x` to the nearest possible centre of a spot, where `x` is the position
 * within a cell, in cells. */
static float to_middle(float x)
{
    return f_max(f_max(CELL_RIM - x, x - (1.0f - CELL_RIM)), 0.0f);
}

/* Returns the cover of a mark of `count` cells over one flank, each with a spot at a random place.
 * The function tests only the nine cells around the point. Toward the tail, the number of cells
 * stays constant, but cells are lower and spots are smaller, so that no spot is cut off. */
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
    const float reach = shrunk * (1.0f + UNEVEN) * 1.2f + 0.001f; /* Largest reach of a spot,
                                                                     including its soft edge. */
    float cover = 0.0f;
    if (x < -1.0f || y < -1.0f || x > columns + 1.0f || y > rows + 1.0f) {
        return 0.0f;
    }
    for (int i = 0; i < 9; i++) {
        const float cx = f_floor(x) + (float)(i % 3 - 1), cy = f_floor(y) + (float)(i / 3 - 1);
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

/* Returns the cover of rows of dots. In this kind of mark, `seed` is the number of rows, and
 * `count` is the number of dots in a row. Every other row is offset by half a step. Toward the
 * tail, rows are closer, and dots are smaller and flatter, so that no dot is cut off. */
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

static float bands(const struct species_mark *m, const struct mark_point *at)
{
    const float count = f_max((float)m->count, 1.0f);
    const float step = f_max(m->to - m->from, 1e-3f) / count;
    const float x = (at->u - m->slant * (at->height - 0.5f) - m->from) / step;
    const float bar = f_clamp(f_floor(x), 0.0f, count - 1.0f);
    return disc(f_abs(bar + 0.5f - x) * step, 0.5f * m->width) *
           soft_interval(at->height, m->low, m->high, SOFT_HEIGHT);
}

static float stripes(const struct species_mark *m, const struct mark_point *at)
{
    const float count = f_max((float)m->count, 1.0f);
    const float step = f_max(m->high - m->low, 1e-3f) / count;
    const float y = (at->height - m->slant * (at->u - m->from) - m->low) / step;
    const float line = f_clamp(f_floor(y), 0.0f, count - 1.0f);
    return disc(f_abs(line + 0.5f - y) * step, 0.5f * m->width) *
           soft_interval(at->u, m->from, m->to, 4.0f * SOFT_U);
}

static float edge(const struct species_mark *m, const struct mark_point *at)
{
    const float inner = 1.0f - m->width, soft = 0.25f * m->width + 0.005f;
    return f_smoothstep(inner - soft, inner + soft, at->height) *
           soft_interval(at->u, m->from, m->to, SOFT_HEIGHT);
}

static float side(const struct species_mark *m, const struct mark_point *at)
{
    const float toward = m->count == SIDE_RIGHT ? at->right : -at->right;
    const float soft = f_max(m->width, 0.02f);
    return f_smoothstep(SIDE_RIM, SIDE_RIM + 2.0f * soft, toward) *
           soft_interval(at->u, m->from, m->to, SOFT_HEIGHT);
}

/* Returns the cover of the slit of the mouth. The slit runs from the snout at height `high` to the
 * corner at (`to`, `low`) and is thinner toward the corner. */
static float mouth(const struct species_mark *m, const struct mark_point *at)
{
    const float along = at->u / f_max(m->to, 1e-3f);
    const float line = f_lerp(m->high, m->low, f_clamp(along, 0.0f, 1.0f));
    const float width = 0.5f * m->width * SLIT_HEIGHT * (1.0f - 0.5f * f_clamp(along, 0.0f, 1.0f));
    return disc(f_abs(at->height - line), width) * (1.0f - f_smoothstep(0.92f, 1.06f, along));
}

/* Returns the cover of the slit of the gill: an arc whose middle bows backward. */
static float gill(const struct species_mark *m, const struct mark_point *at)
{
    const float half = f_max(0.5f * (m->high - m->low), 1e-3f);
    const float t = (at->height - 0.5f * (m->low + m->high)) / half;
    const float bow = m->slant * 2.0f * half * BOW_HEIGHT;
    const float ends = 1.0f - f_smoothstep(0.7f, 1.0f, f_abs(t));
    return disc(f_abs(at->u - m->to + bow * t * t), 0.5f * m->width) * ends;
}

float mark_cover(const struct species_mark *m, const struct mark_point *at)
{
    if (m->kind == MARK_SIDE) { /* A mark on one side also covers the paired fins of that side. */
        const bool paired = at->part == PART_PECTORAL || at->part == PART_PELVIC;
        return at->part == PART_BODY || paired ? side(m, at) : 0.0f;
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
        return bands(m, at);
    case MARK_STRIPES:
        return stripes(m, at);
    case MARK_EDGE:
        return edge(m, at);
    case MARK_PATCH:
        return soft_interval(at->u, m->from, m->to, m->width) *
               soft_interval(at->height, m->low, m->high, m->width);
    case MARK_MOUTH:
        return mouth(m, at);
    case MARK_GILL:
        return gill(m, at);
    default:
        return 0.0f;
    }
}
