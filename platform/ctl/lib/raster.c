/* raster.c -- rasterizes triangles. Edge functions give the covered samples, and the layers of each
 * sample are sorted by depth. */
#include "platform/ctl/lib/raster.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/panic.h"

#define SAMPLE_COUNT 16u
/* Maximum number of layers of one sample. A fish has fewer layers at every point. */
#define PILE_MAX 32u
/* A ray that has passed layers keeps a share of its light. If the share is below this value, deeper
 * layers are skipped. The value is half a step of 256 grey levels. */
#define HIDDEN 0.002f
#define LAYERS_AT_FIRST 65536u

/* Positions of the sixteen samples, in sixteenths of a pixel from the centre. No two samples share
 * a row or a column, so that a nearly horizontal or vertical edge has sixteen grey levels instead
 * of four. */
static const int8_t sample_at[SAMPLE_COUNT][2] = {
    { 1, 1 },  { -1, -3 }, { -3, 2 },  { 4, -1 }, { -5, -2 }, { 2, 5 },  { 5, 3 }, { 3, -5 },
    { -2, 6 }, { 0, -7 },  { -4, -6 }, { -6, 4 }, { -8, 0 },  { 7, -4 }, { 6, 7 }, { -7, -8 },
};

struct edge {
    /* Coefficients of the edge function. A point (x, y) is inside if dx * x + dy * y + at > 0. */
    float dx, dy, at;
    /* True if a point exactly on the edge belongs to the triangle. The value is true for only one
     * of two triangles that share the edge. */
    bool owns;
};

static vec3 sample_offset(uint32_t s)
{
    return v3((float)sample_at[s][0] / 16.0f, (float)sample_at[s][1] / 16.0f, 0.0f);
}

bool raster_open(struct raster *raster, uint32_t width, uint32_t height)
{
    CORE_ASSERT(width >= 1 && width <= CANVAS_SIDE_MAX);
    CORE_ASSERT(height >= 1 && height <= CANVAS_SIDE_MAX);
    *raster = (struct raster){ .width = width, .height = height, .layer_room = LAYERS_AT_FIRST };
    raster->top = calloc((size_t)width * height, sizeof *raster->top);
    raster->layers = malloc(raster->layer_room * sizeof *raster->layers);
    return raster->top && raster->layers;
}

void raster_close(struct raster *raster)
{
    free(raster->top);
    free(raster->layers);
    *raster = (struct raster){ 0 };
}

static void raster_push(struct raster *raster, uint32_t x, uint32_t y, struct raster_layer layer)
{
    if (raster->layer_count == raster->layer_room) {
        struct raster_layer *more =
            realloc(raster->layers, 2u * raster->layer_room * sizeof *raster->layers);
        if (!more) {
            raster->failed = true;
            return;
        }
        raster->layers = more;
        raster->layer_room *= 2u;
    }
    uint32_t *top = &raster->top[(size_t)y * raster->width + x];
    layer.below = *top;
    raster->layers[raster->layer_count++] = layer;
    *top = (uint32_t)raster->layer_count;
}

/* ---- Coverage of a pixel --------------------------------------------------------------------- */

static float edge_at(const struct edge *e, float x, float y)
{
    return e->dx * x + e->dy * y + e->at;
}

struct triangle {
    struct edge edges[3]; /* Edge functions of the triangle. edges[i] belongs to the edge opposite
                             corner i. */
    float double_area;
    float depth_dx, depth_dy, depth_at; /* Coefficients of the depth plane through the three
                                           corners. */
};

static bool triangle_of(const vec3 c[3], struct triangle *t)
{
    /* With y downward, an edge function is positive inside a triangle whose corners appear
     * counter-clockwise. The coefficients are always computed from the same end of the edge. Two
     * triangles that share the edge therefore get exactly the same numbers with opposite signs. */
    for (uint32_t i = 0; i < 3; i++) {
        const vec3 a = c[(i + 1) % 3], b = c[(i + 2) % 3];
        const bool swap = a.x > b.x || (a.x == b.x && a.y > b.y);
        const vec3 from = swap ? b : a, to = swap ? a : b;
        const float sign = swap ? -1.0f : 1.0f;
        const float dx = to.y - from.y, dy = from.x - to.x;
        struct edge *e = &t->edges[i];
        *e = (struct edge){ .dx = sign * dx, .dy = sign * dy };
        e->at = -sign * (dx * from.x + dy * from.y);
        e->owns = e->dx > 0.0f || (e->dx == 0.0f && e->dy > 0.0f);
    }
    t->double_area = edge_at(&t->edges[0], c[0].x, c[0].y);
    if (!(t->double_area > 1e-6f)) {
        return false;
    }
    t->depth_dx = t->depth_dy = t->depth_at = 0.0f;
    for (uint32_t i = 0; i < 3; i++) {
        const float share = c[i].z / t->double_area;
        t->depth_dx += t->edges[i].dx * share;
        t->depth_dy += t->edges[i].dy * share;
        t->depth_at += t->edges[i].at * share;
    }
    return true;
}

/* Returns the bit mask of the samples of the pixel at (x, y) that lie inside the triangle. Sets
 * `*mean` to the mean position of these samples. */
static uint16_t covered_samples(const struct triangle *t, float x, float y, vec3 *mean)
{
    uint16_t samples = 0;
    float count = 0.0f;
    *mean = v3(0.0f, 0.0f, 0.0f);
    for (uint32_t s = 0; s < SAMPLE_COUNT; s++) {
        const vec3 offset = sample_offset(s);
        bool inside = true;
        for (uint32_t i = 0; i < 3; i++) {
            const float side = edge_at(&t->edges[i], x + offset.x, y + offset.y);
            inside = inside && (side > 0.0f || (side == 0.0f && t->edges[i].owns));
        }
        if (inside) {
            samples |= (uint16_t)(1u << s);
            *mean = v3_add(*mean, offset);
            count += 1.0f;
        }
    }
    *mean = v3(x + mean->x / f_max(count, 1.0f), y + mean->y / f_max(count, 1.0f), 0.0f);
    return samples;
}

static void draw_pixel(struct raster *raster, const struct triangle *t, uint32_t x, uint32_t y,
                       struct raster_skin skin)
{
    const float centre_x = (float)x + 0.5f, centre_y = (float)y + 0.5f;
    vec3 at;
    const uint16_t samples = covered_samples(t, centre_x, centre_y, &at);
    if (samples == 0) {
        return;
    }
    float part[3];
    for (uint32_t i = 0; i < 3; i++) {
        part[i] = edge_at(&t->edges[i], at.x, at.y) / t->double_area;
    }
    const struct raster_colour colour = skin.look(skin.triangle, part);
    raster_push(raster, x, y,
                (struct raster_layer){
                    .colour = colour.colour,
                    .hides = colour.hides,
                    .depth = t->depth_dx * centre_x + t->depth_dy * centre_y + t->depth_at,
                    .depth_dx = t->depth_dx,
                    .depth_dy = t->depth_dy,
                    .samples = samples,
                });
}

static uint32_t pixel_within(float x, uint32_t limit)
{
    return (uint32_t)f_clamp(x, 0.0f, (float)limit);
}

void raster_triangle(struct raster *raster, const vec3 c[3], struct raster_skin skin)
{
    struct triangle t;
    if (!triangle_of(c, &t)) {
        return;
    }
    const float left = floorf(f_min(c[0].x, f_min(c[1].x, c[2].x)) - 0.5f);
    const float right = ceilf(f_max(c[0].x, f_max(c[1].x, c[2].x)) + 0.5f);
    const float top = floorf(f_min(c[0].y, f_min(c[1].y, c[2].y)) - 0.5f);
    const float bottom = ceilf(f_max(c[0].y, f_max(c[1].y, c[2].y)) + 0.5f);
    const uint32_t x_end = pixel_within(right, raster->width);
    const uint32_t y_end = pixel_within(bottom, raster->height);
    for (uint32_t y = pixel_within(top, raster->height); y < y_end; y++) {
        for (uint32_t x = pixel_within(left, raster->width); x < x_end; x++) {
            draw_pixel(raster, &t, x, y, skin);
        }
    }
}

/* ---- Depth order ----------------------------------------------------------------------------- */

struct pile {
    /* Layers that cover the sample, sorted by depth, nearest layer first. */
    const struct raster_layer *layers[PILE_MAX];
    float depth[PILE_MAX];
    uint32_t count;
};

static vec3 sample_colour(const struct raster *raster, uint32_t top, uint32_t s, vec3 behind)
{
    const vec3 offset = sample_offset(s);
    struct pile pile;
    pile.count = 0;
    for (uint32_t i = top; i != 0; i = raster->layers[i - 1].below) {
        const struct raster_layer *layer = &raster->layers[i - 1];
        if (layer->samples >> s & 1u) {
            const float depth =
                layer->depth + layer->depth_dx * offset.x + layer->depth_dy * offset.y;
            if (pile.count == PILE_MAX && pile.depth[PILE_MAX - 1u] >= depth) {
                continue; /* The list of layers is full, and the new layer lies behind all stored
                             layers. */
            }
            uint32_t at = pile.count < PILE_MAX ? pile.count++ : PILE_MAX - 1u;
            for (; at > 0 && pile.depth[at - 1] < depth; at--) {
                pile.layers[at] = pile.layers[at - 1];
                pile.depth[at] = pile.depth[at - 1];
            }
            pile.layers[at] = layer;
            pile.depth[at] = depth;
        }
    }
    vec3 colour = v3(0.0f, 0.0f, 0.0f);
    float open = 1.0f;
    for (uint32_t i = 0; i < pile.count && open > HIDDEN; i++) {
        colour = v3_muladd(colour, pile.layers[i]->colour, open * pile.layers[i]->hides);
        open *= 1.0f - pile.layers[i]->hides;
    }
    return v3_muladd(colour, behind, open);
}

bool raster_finish(struct raster *raster, struct canvas *canvas, uint32_t left, uint32_t top)
{
    CORE_ASSERT(left + raster->width <= canvas->width);
    CORE_ASSERT(top + raster->height <= canvas->height);
    for (uint32_t y = 0; y < raster->height; y++) {
        for (uint32_t x = 0; x < raster->width; x++) {
            const uint32_t newest = raster->top[(size_t)y * raster->width + x];
            if (newest == 0) {
                continue;
            }
            vec3 *pixel = &canvas->pixels[(size_t)(top + y) * canvas->width + left + x];
            vec3 sum = v3(0.0f, 0.0f, 0.0f);
            for (uint32_t s = 0; s < SAMPLE_COUNT; s++) {
                sum = v3_add(sum, sample_colour(raster, newest, s, *pixel));
            }
            *pixel = v3_scale(sum, 1.0f / SAMPLE_COUNT);
        }
    }
    memset(raster->top, 0, (size_t)raster->width * raster->height * sizeof *raster->top);
    raster->layer_count = 0;
    return !raster->failed;
}
