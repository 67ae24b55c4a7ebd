/* morph_outline.c -- draws the triangles that face the viewer as one filled SVG path for each
 * layer. A single path has no visible seams between the triangles, and a drawing program can edit
 * the path. */
#include "platform/ctl/morph/morph_outline.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/key_colour.h"

/* Distance in body lengths below which two vertices are treated as one vertex. The distance is less
 * than a quantization step of the mesh tables. */
#define JOIN_LENGTHS 1e-5f

/* Layers of the drawing, from back to front. */
enum layer { LAYER_FAR_FINS, LAYER_MEDIAN_FINS, LAYER_BODY, LAYER_NEAR_FINS, LAYER_EYES, LAYERS };

const char *morph_outline_key_colour(const struct species_card *card, uint32_t key)
{
    CORE_ASSERT(key < card->key_count);
    static char colours[MORPH_KEY_MAX][8];
    snprintf(colours[key], sizeof colours[key], "#%06x",
             key_colour(card->key_count, key) & 0xffffffu);
    return colours[key];
}

/* Converts a body point to the axes of the view: right, up and toward the viewer. */
static vec3 point_in_view_axes(enum morph_outline_view view, vec3 p)
{
    switch (view) {
    case MORPH_OUTLINE_SIDE:
        return v3(p.z, p.y, -p.x);
    case MORPH_OUTLINE_FRONT:
        return v3(-p.x, p.y, -p.z);
    default:
        return v3(p.z, p.x, p.y);
    }
}

struct outline_point morph_outline_project(const struct morph_outline *outline, vec3 p)
{
    const vec3 s = point_in_view_axes(outline->view, p);
    return (struct outline_point){ outline->x + outline->length_px * (double)s.x,
                                   outline->y - outline->length_px * (double)s.y };
}

void morph_outline_point(struct svg *svg, const struct morph_outline *outline, vec3 p)
{
    const struct outline_point at = morph_outline_project(outline, p);
    svg_point(svg, at.x, at.y);
}

static enum layer layer_of(uint8_t part, float toward)
{
    switch (part) {
    case PART_BODY:
        return LAYER_BODY;
    case PART_EYE:
        return LAYER_EYES;
    case PART_PECTORAL:
    case PART_PELVIC:
        return toward < 0.0f ? LAYER_FAR_FINS : LAYER_NEAR_FINS;
    default:
        return LAYER_MEDIAN_FINS;
    }
}

/* Returns true if the triangle at `corner` belongs to the layer and is visible. Triangles that face
 * away from the viewer are hidden. The side view also hides the eye on the far side. The front view
 * also hides the median fins, because only their edges would be visible. */
static bool is_triangle_visible(const struct morph_outline *outline, const vec3 *positions,
                                const uint16_t *corner, enum layer layer)
{
    const struct species_mesh *mesh = &outline->species->lod[0];
    const vec3 a = point_in_view_axes(outline->view, positions[corner[0]]);
    const vec3 b = point_in_view_axes(outline->view, positions[corner[1]]);
    const vec3 c = point_in_view_axes(outline->view, positions[corner[2]]);
    /* `toward` is positive if the triangle is on the viewer's side of the fish's middle plane. */
    const float toward = a.z + b.z + c.z;
    const float area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    const bool is_hidden = outline->view == MORPH_OUTLINE_FRONT ? layer == LAYER_MEDIAN_FINS
                           : outline->view == MORPH_OUTLINE_SIDE
                               ? layer == LAYER_EYES && toward < 0.0f
                               : false;
    return area > 0.0f && !is_hidden && layer_of(mesh->vertices[corner[0]].part, toward) == layer;
}

static void put_point(struct svg *svg, const struct morph_outline *outline, char verb, vec3 p)
{
    const struct outline_point at = morph_outline_project(outline, p);
    svg_put(svg, "%c%.1f %.1f", verb, at.x, at.y);
}

/* Draws the contour: each edge of a visible triangle that has no visible triangle on its other
 * side. */
static void draw_contour(struct svg *svg, const struct morph_outline *outline,
                         const vec3 *positions, const uint16_t *joined, enum layer layer)
{
    /* has[a][b] is true if a visible triangle has an edge from vertex a to vertex b. */
    static bool has[MESH_VERTEX_MAX][MESH_VERTEX_MAX];
    const struct species_mesh *mesh = &outline->species->lod[0];
    const uint16_t *at = mesh->indices;
    memset(has, 0, sizeof has);
    for (uint32_t i = 0; i + 2 < mesh->index_count; i += 3) {
        for (uint32_t j = 0; is_triangle_visible(outline, positions, &at[i], layer) && j < 3; j++) {
            has[joined[at[i + j]]][joined[at[i + (j + 1) % 3]]] = true;
        }
    }
    svg_put(svg,
            "<path fill=\"none\" stroke=\"%s\" stroke-width=\"%g\" "
            "stroke-opacity=\"0.7\" stroke-linecap=\"round\" d=\"",
            outline->colour, outline->line_px);
    for (uint32_t from = 0; from < mesh->vertex_count; from++) {
        for (uint32_t to = 0; to < mesh->vertex_count; to++) {
            if (has[from][to] && !has[to][from]) {
                put_point(svg, outline, 'M', positions[from]);
                put_point(svg, outline, 'L', positions[to]);
            }
        }
    }
    svg_put(svg, "\"/>\n");
}

static void blend(const struct morph_outline *outline, vec3 positions[MESH_VERTEX_MAX])
{
    static struct morph_pose pose;
    const struct species *species = outline->species;
    morph_pose(outline->rig, &species->lod[0], outline->progress, &pose);
    morph_shape(&species->lod[0], species->card.key_count, &pose, positions, NULL);
}

void morph_outline_measure(const struct morph_outline *outline, double low[2], double high[2])
{
    static vec3 positions[MESH_VERTEX_MAX];
    blend(outline, positions);
    for (uint32_t i = 0; i < outline->species->lod[0].vertex_count; i++) {
        const struct outline_point at = morph_outline_project(outline, positions[i]);
        low[0] = fmin(low[0], at.x);
        low[1] = fmin(low[1], at.y);
        high[0] = fmax(high[0], at.x);
        high[1] = fmax(high[1], at.y);
    }
}

void morph_outline_draw(struct svg *svg, const struct morph_outline *outline)
{
    CORE_ASSERT(outline->species && outline->rig);
    CORE_ASSERT(outline->length_px > 0.0);
    static vec3 positions[MESH_VERTEX_MAX];
    static uint16_t joined[MESH_VERTEX_MAX];
    blend(outline, positions);
    /* Finds vertices at the same position. Such vertices count as one vertex, so that no contour is
     * drawn along the texture seam of the body. */
    for (uint32_t i = 0; i < outline->species->lod[0].vertex_count; i++) {
        uint32_t first = 0;
        while (v3_length(v3_sub(positions[first], positions[i])) > JOIN_LENGTHS) {
            first++;
        }
        joined[i] = (uint16_t)first;
    }
    for (enum layer layer = LAYER_FAR_FINS; layer < LAYERS; layer++) {
        const struct species_mesh *mesh = &outline->species->lod[0];
        const bool fins = layer != LAYER_BODY && layer != LAYER_EYES;
        const bool dark = layer == LAYER_EYES && outline->opacity > 0.5;
        svg_put(svg, "<path fill=\"%s\" fill-opacity=\"%.2f\" d=\"",
                dark ? SVG_INK : outline->colour, outline->opacity * (fins ? 0.55 : 1.0));
        for (uint32_t i = 0; i + 2 < mesh->index_count; i += 3) {
            if (is_triangle_visible(outline, positions, &mesh->indices[i], layer)) {
                for (uint32_t j = 0; j < 3; j++) {
                    put_point(svg, outline, j == 0 ? 'M' : 'L', positions[mesh->indices[i + j]]);
                }
                svg_put(svg, "Z");
            }
        }
        svg_put(svg, "\"/>\n");
        if (outline->line_px > 0.0) {
            draw_contour(svg, outline, positions, joined, layer);
        }
    }
}
