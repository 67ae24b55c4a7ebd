/* species_sheet.c -- species_sheet OUT.png: how a species grows, seen from four sides.
 *
 * A maker looks at this after each change of the text. A row is a stage, from the first key to the
 * last with one in-between each, then the far mesh; shapes come through the same graph and blend as
 * in the tank. The rasteriser is its own, so it needs neither screen nor graphics driver. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#include <stb/stb_image_write.h>

#include "core/base/panic.h"
#include "core/morph/morph.h"

#ifndef SPECIES /* The build names another. */
#define SPECIES species_wakin
#endif

#define CELL_WIDTH 400
#define CELL_HEIGHT 250
#define OVERSAMPLE 3
#define VIEW_COUNT 4
#define ROW_MAX (2 * MORPH_KEY_MAX)
#define FIN_ALPHA 0.72f

enum { EXIT_USAGE = 2, EXIT_IO = 74 };

/* A cell while it is drawn, OVERSAMPLE times as large as it will be. */
struct canvas {
    vec3 colour[CELL_HEIGHT * OVERSAMPLE][CELL_WIDTH * OVERSAMPLE];
    float depth[CELL_HEIGHT * OVERSAMPLE][CELL_WIDTH * OVERSAMPLE];
};

struct corner {
    vec3 screen, normal; /* Pixels and depth (larger is nearer); body frame. */
    struct species_vertex vertex;
};

static const struct angles view_angles[VIEW_COUNT] = {
    { .yaw_rad = 90.0f * F_DEG },  /* Its left side. */
    { .yaw_rad = 90.0f * F_DEG },  /* From above. */
    { .yaw_rad = 112.0f * F_DEG }, /* The stall's slant, swimming left ... */
    { .yaw_rad = -60.0f * F_DEG }, /* ... and right: no fin may vanish in either. */
};
static const float view_tilt_rad[VIEW_COUNT] = { 0.0f, 90.0f * F_DEG, 50.0f * F_DEG,
                                                 50.0f * F_DEG };

static vec3 tint(uint32_t rgb)
{
    return v3((float)(rgb >> 16 & 255) / 255.0f, (float)(rgb >> 8 & 255) / 255.0f,
              (float)(rgb & 255) / 255.0f);
}

static vec3 blend_tint(const struct species *s, const float *weights, int which)
{
    vec3 sum = v3(0.0f, 0.0f, 0.0f);
    for (uint32_t i = 0; i < s->card.key_count; i++) {
        const struct species_coat *t = &s->coats[i];
        const uint32_t rgb[] = { t->back, t->flank, t->belly, t->fin };
        sum = v3_mad(sum, tint(rgb[which]), weights[i]);
    }
    return sum;
}

/* The body turned for the view, then the camera tilted down over it. */
static vec3 look(int view, vec3 p)
{
    const struct basis basis = basis_from_angles(view_angles[view]);
    const vec3 w = basis_to_world(&basis, p);
    const float c = cosf(view_tilt_rad[view]), s = sinf(view_tilt_rad[view]);
    return v3(w.x, w.y * c - w.z * s, w.y * s + w.z * c);
}

static vec3 skin(const struct species *s, const float *weights, const struct species_vertex *v)
{
    if (v->part == PART_EYE) {
        return v->u < 0.5f ? v3(0.03f, 0.03f, 0.04f)
                           : v->u < 0.86f ? v3(0.86f, 0.66f, 0.28f) : v3(0.16f, 0.1f, 0.06f);
    }
    if (v->part != PART_BODY) {
        const float ray = 0.9f + 0.1f * cosf(v->u * 60.0f);
        return v3_scale(blend_tint(s, weights, 3), ray);
    }
    const float down = v->v < 0.5f ? 2.0f * v->v : 2.0f - 2.0f * v->v;
    const vec3 upper = v3_lerp(blend_tint(s, weights, 0), blend_tint(s, weights, 1),
                               f_smoothstep(0.1f, 0.5f, down));
    return v3_lerp(upper, blend_tint(s, weights, 2), f_smoothstep(0.5f, 0.95f, down));
}

static vec3 shade(int view, const struct species *s, const float *weights, struct corner at)
{
    const vec3 light = v3_normalize_or(v3(-0.35f, 0.8f, 0.5f), v3(0.0f, 1.0f, 0.0f));
    vec3 n = v3_normalize_or(look(view, at.normal), v3(0.0f, 0.0f, 1.0f));
    if (at.vertex.part >= PART_TAIL && n.z < 0.0f) {
        n = v3_scale(n, -1.0f);
    }
    const float facing = v3_dot(n, light); /* Light shines through a fin. */
    const float lit = at.vertex.part >= PART_TAIL ? 0.5f + 0.5f * f_abs(facing) : facing;
    const float diffuse = 0.42f + 0.62f * f_max(lit, 0.0f);
    const vec3 half = v3_normalize_or(v3_add(light, v3(0.0f, 0.0f, 1.0f)), n);
    const float gloss[PART_COUNT] = { [PART_BODY] = 0.25f, [PART_EYE] = 0.7f };
    const float shine = gloss[at.vertex.part] * powf(f_max(v3_dot(n, half), 0.0f), 48.0f);
    return v3_mad(v3_scale(skin(s, weights, &at.vertex), diffuse), v3(1.0f, 1.0f, 1.0f), shine);
}

static struct corner mix(const struct corner c[3], const float w[3])
{
    struct corner m = c[0];
    m.screen = v3_mad(v3_mad(v3_scale(c[0].screen, w[0]), c[1].screen, w[1]), c[2].screen, w[2]);
    m.normal = v3_mad(v3_mad(v3_scale(c[0].normal, w[0]), c[1].normal, w[1]), c[2].normal, w[2]);
    m.vertex.u = c[0].vertex.u * w[0] + c[1].vertex.u * w[1] + c[2].vertex.u * w[2];
    m.vertex.v = c[0].vertex.v * w[0] + c[1].vertex.v * w[1] + c[2].vertex.v * w[2];
    return m;
}

static float edge(vec3 a, vec3 b, float x, float y)
{
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

/* Front faces only: the sheet shows a wrong winding as a hole, as the kiosk would. */
static void draw_triangle(struct canvas *canvas, int view, const struct species *s,
                          const float *weights, const struct corner c[3])
{
    const float area = edge(c[0].screen, c[1].screen, c[2].screen.x, c[2].screen.y);
    if (area >= 0.0f) { /* Screen y goes down, so counter-clockwise is negative. */
        return;
    }
    const int x0 = (int)f_min(c[0].screen.x, f_min(c[1].screen.x, c[2].screen.x));
    const int x1 = (int)f_max(c[0].screen.x, f_max(c[1].screen.x, c[2].screen.x));
    const int y0 = (int)f_min(c[0].screen.y, f_min(c[1].screen.y, c[2].screen.y));
    const int y1 = (int)f_max(c[0].screen.y, f_max(c[1].screen.y, c[2].screen.y));
    for (int y = y0 < 0 ? 0 : y0; y <= y1 && y < CELL_HEIGHT * OVERSAMPLE; y++) {
        for (int x = x0 < 0 ? 0 : x0; x <= x1 && x < CELL_WIDTH * OVERSAMPLE; x++) {
            const float px = (float)x + 0.5f, py = (float)y + 0.5f;
            const float w[3] = { edge(c[1].screen, c[2].screen, px, py) / area,
                                 edge(c[2].screen, c[0].screen, px, py) / area,
                                 edge(c[0].screen, c[1].screen, px, py) / area };
            if (w[0] < 0.0f || w[1] < 0.0f || w[2] < 0.0f) {
                continue;
            }
            const struct corner at = mix(c, w);
            if (at.screen.z <= canvas->depth[y][x]) {
                continue;
            }
            const float alpha = at.vertex.part >= PART_TAIL ? FIN_ALPHA : 1.0f;
            canvas->colour[y][x] =
                v3_lerp(canvas->colour[y][x], shade(view, s, weights, at), alpha);
            canvas->depth[y][x] = at.screen.z;
        }
    }
}

static void draw_fish(struct canvas *canvas, int view, const struct species *s,
                      const struct species_mesh *mesh, const struct morph_pose *pose)
{
    const float *weights = pose->weight[0];
    static vec3 positions[MESH_VERTEX_MAX], normals[MESH_VERTEX_MAX];
    const float scale = (float)(CELL_WIDTH * OVERSAMPLE) * 0.92f;
    morph_shape(mesh, s->card.key_count, pose, positions, normals);
    for (int fins = 0; fins < 2; fins++) {
        for (uint32_t i = 0; i < mesh->index_count; i += 3) {
            struct corner c[3];
            for (int k = 0; k < 3; k++) {
                const uint16_t at = mesh->indices[i + (uint32_t)k];
                const vec3 p = look(view, positions[at]);
                c[k].screen = v3(p.x * scale + 0.5f * (float)(CELL_WIDTH * OVERSAMPLE),
                                 0.5f * (float)(CELL_HEIGHT * OVERSAMPLE) - p.y * scale, p.z);
                c[k].normal = normals[at];
                c[k].vertex = mesh->vertices[at];
            }
            if ((c[0].vertex.part >= PART_TAIL) == (fins == 1)) {
                draw_triangle(canvas, view, s, weights, c);
            }
        }
    }
}

static void clear(struct canvas *canvas)
{
    for (int y = 0; y < CELL_HEIGHT * OVERSAMPLE; y++) {
        for (int x = 0; x < CELL_WIDTH * OVERSAMPLE; x++) {
            canvas->colour[y][x] = v3(0.33f, 0.62f, 0.72f);
            canvas->depth[y][x] = -1e9f;
        }
    }
}

static uint8_t channel(float value)
{
    return (uint8_t)(f_clamp(value, 0.0f, 1.0f) * 255.0f + 0.5f);
}

static void copy_cell(const struct canvas *canvas, uint8_t *image, int column, int row)
{
    for (int y = 0; y < CELL_HEIGHT; y++) {
        for (int x = 0; x < CELL_WIDTH; x++) {
            vec3 sum = v3(0.0f, 0.0f, 0.0f);
            for (int k = 0; k < OVERSAMPLE * OVERSAMPLE; k++) {
                sum = v3_add(sum, canvas->colour[y * OVERSAMPLE + k / OVERSAMPLE]
                                                [x * OVERSAMPLE + k % OVERSAMPLE]);
            }
            sum = v3_scale(sum, 1.0f / (OVERSAMPLE * OVERSAMPLE));
            uint8_t *out = &image[3 * ((row * CELL_HEIGHT + y) * CELL_WIDTH * VIEW_COUNT +
                                       column * CELL_WIDTH + x)];
            out[0] = channel(sum.x);
            out[1] = channel(sum.y);
            out[2] = channel(sum.z);
        }
    }
}

/* The near mesh at each key and between; below them the far mesh at the middle key. */
static int draw_sheet(const struct species *s, const char *path)
{
    const int stages = (int)s->card.key_count * 2 - 1;
    const int rows = stages + 1;
    struct canvas *canvas = malloc(sizeof *canvas);
    uint8_t *image = malloc((size_t)(3 * CELL_WIDTH * VIEW_COUNT * CELL_HEIGHT * rows));
    struct morph_rig rig;
    morph_rig_init(&rig, &s->card, TEMPLATE_OWN);
    for (int row = 0; canvas && image && row < rows; row++) {
        static struct morph_pose pose;
        const float progress = row < stages ? (float)row / (float)(stages - 1) : 0.5f;
        const struct species_mesh *mesh = &s->lod[row < stages ? 0 : 1];
        morph_pose(&rig, mesh, progress, &pose);
        for (int view = 0; view < VIEW_COUNT; view++) {
            clear(canvas);
            draw_fish(canvas, view, s, mesh, &pose);
            copy_cell(canvas, image, view, row);
        }
    }
    const int done = canvas && image &&
                     stbi_write_png(path, CELL_WIDTH * VIEW_COUNT, CELL_HEIGHT * rows, 3, image,
                                    3 * CELL_WIDTH * VIEW_COUNT);
    free(canvas);
    free(image);
    if (!done) {
        fprintf(stderr, "%s: cannot be written\n", path);
        return EXIT_IO;
    }
    return 0;
}

_Noreturn void core_panic(const char *condition, const char *file, int line)
{
    fprintf(stderr, "%s:%d: %s\n", file, line, condition);
    abort();
}

int main(int argc, char **argv)
{
    if (argc != 2) {
        fprintf(stderr, "usage: %s OUT.png\n", argv[0]);
        return EXIT_USAGE;
    }
    return draw_sheet(&SPECIES, argv[1]);
}
