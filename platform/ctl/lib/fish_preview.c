/* fish_preview.c -- computes the camera, the light and the skin of a fish picture. */
#include "platform/ctl/lib/fish_preview.h"

#include <math.h>

#include "core/base/panic.h"

#define FIN_ROOT_HIDES 0.92f
#define FIN_TIP_HIDES 0.55f
#define FIN_RAYS 13.0f /* Number of fin rays, equal to the number that the kiosk draws. */
/* A fin is less opaque between two fin rays than on a fin ray. This is the loss of opacity halfway
 * between two rays, as a fraction of the opacity on a ray. */
#define RAY_HIDES 0.22f
/* A fin is darker between two fin rays than on a fin ray. This is the loss of brightness halfway
 * between two rays, as a fraction of the brightness on a ray. */
#define RAY_LIGHT 0.18f
/* A transparent body is less transparent where its surface is seen edge-on, because the surface
 * reflects light there. This is the lost fraction of the transparency. */
#define GLASS_RIM 0.55f

const char *const fish_preview_view_names[] = { "side", "above", "aslant", NULL };

const struct fish_preview_bounds fish_preview_nowhere = { 1e9f, -1e9f, 1e9f, -1e9f };

/* Returns the axes of the camera for a view, in the fish's body frame. */
static const struct basis *camera(enum fish_preview_view view)
{
    static const struct basis cameras[VIEW_COUNT] = {
        [VIEW_SIDE] = { { 0.0f, 0.0f, 1.0f }, { 0.0f, 1.0f, 0.0f }, { -1.0f, 0.0f, 0.0f } },
        [VIEW_ABOVE] = { { 0.0f, 0.0f, 1.0f }, { 1.0f, 0.0f, 0.0f }, { 0.0f, 1.0f, 0.0f } },
        /* The camera is turned by 35 degrees toward the fish's nose, and is 35 degrees above the
         * fish. */
        [VIEW_ASLANT] = { { -0.57358f, 0.0f, 0.81915f },
                          { 0.46985f, 0.81915f, 0.32899f },
                          { -0.67101f, 0.57358f, -0.46985f } },
    };
    CORE_ASSERT(view < VIEW_COUNT);
    return &cameras[view];
}

void fish_preview_pose(struct fish_preview *preview, const struct species *species,
                       const struct morph_rig *rig, float progress)
{
    CORE_ASSERT(progress >= 0.0f && progress <= 1.0f);
    preview->species = species;
    preview->mesh = &species->lod[0];
    morph_pose(rig, preview->mesh, progress, &preview->pose);
    morph_shape(preview->mesh, species->card.key_count, &preview->pose, preview->positions,
                preview->normals);
}

void fish_preview_measure(const struct fish_preview *preview, enum fish_preview_view view,
                          struct fish_preview_bounds *bounds)
{
    for (uint32_t i = 0; i < preview->mesh->vertex_count; i++) {
        const vec3 p = vec_basis_to_body(camera(view), preview->positions[i]);
        bounds->left = f_min(bounds->left, p.x);
        bounds->right = f_max(bounds->right, p.x);
        bounds->low = f_min(bounds->low, p.y);
        bounds->high = f_max(bounds->high, p.y);
    }
}

float fish_preview_hides(const struct paint *paint, const struct species_vertex *at)
{
    const bool is_fin = at->part >= PART_TAIL;
    const float up = f_clamp(at->v, 0.0f, 1.0f);
    return (1.0f - paint->clear) * (is_fin ? f_lerp(FIN_ROOT_HIDES, FIN_TIP_HIDES, up) : 1.0f);
}

/* ---- Skin and light -------------------------------------------------------------------------- */

struct corners {
    const struct fish_preview *preview;
    uint16_t at[3];
    vec3 normals[3]; /* Normals of the three corners, in the axes of the camera. */
};

/* Returns the brightness at a point with the normal `n`. The light comes from a large soft lamp at
 * the upper left, from the sky and from the ground. */
static float light_on(vec3 n, bool is_fin)
{
    const vec3 lamp = v3(-0.42f, 0.71f, 0.565f);
    const float turned = v3_dot(n, lamp);
    const float from_lamp = is_fin ? 0.35f + 0.65f * f_abs(turned) : (turned + 0.3f) / 1.3f;
    const float from_sky = 0.5f + 0.5f * n.y;
    return 0.26f + 0.34f * from_sky + 0.66f * f_max(from_lamp, 0.0f);
}

static struct raster_colour fish_preview_colour_at(const void *triangle, const float part[3])
{
    const struct corners *c = triangle;
    const struct species_vertex *vertices = c->preview->mesh->vertices;
    struct species_vertex at = vertices[c->at[0]];
    at.u = at.v = 0.0f;
    for (uint32_t i = 0; i < 3; i++) {
        at.u += vertices[c->at[i]].u * part[i];
        at.v += vertices[c->at[i]].v * part[i];
    }
    const bool is_fin = at.part >= PART_TAIL;
    vec3 n = v3_scale(c->normals[0], part[0]);
    n = v3_muladd(v3_muladd(n, c->normals[1], part[1]), c->normals[2], part[2]);
    n = v3_normalize_or(n, v3(0.0f, 0.0f, 1.0f));
    n = is_fin && n.z < 0.0f ? v3_scale(n, -1.0f) : n;
    const struct paint paint = paint_at(c->preview->species, c->preview->pose.weight[0], &at);
    const float rim = powf(1.0f - f_clamp(n.z, 0.0f, 1.0f), 3.0f);
    const float ray =
        is_fin ? f_abs(2.0f * (at.u * FIN_RAYS - floorf(at.u * FIN_RAYS)) - 1.0f) : 1.0f;
    float hides = fish_preview_hides(&paint, &at) * (1.0f - RAY_HIDES * (1.0f - ray));
    hides += (1.0f - hides) * rim * (is_fin ? 0.0f : GLASS_RIM);
    /* The highlight is brightest where the normal points half way between the directions to the
     * lamp and to the camera. The vector has this direction. */
    const float turned = f_max(v3_dot(n, v3(-0.2373f, 0.4012f, 0.8844f)), 0.0f);
    const float shine = at.part == PART_EYE ? 1.0f : paint.shine;
    const float gloss =
        is_fin ? 0.0f : (0.04f + 0.30f * shine) * powf(turned, 18.0f + 40.0f * shine);
    const float light = light_on(n, is_fin) * (1.0f - RAY_LIGHT * (1.0f - ray));
    const vec3 lit = v3_scale(canvas_linear(paint.colour), light);
    return (struct raster_colour){ v3_add(lit, v3(gloss, gloss, gloss)),
                                   f_clamp(hides + gloss, 0.0f, 1.0f) };
}

void fish_preview_draw(const struct fish_preview *preview, enum fish_preview_view view, float x,
                       float y, float scale_px, struct raster *raster)
{
    const struct species_mesh *mesh = preview->mesh;
    const float middle_x = 0.5f * (float)raster->width, middle_y = 0.5f * (float)raster->height;
    for (uint32_t i = 0; i < mesh->index_count; i += 3) {
        struct corners corners = { .preview = preview };
        vec3 screen[3];
        for (uint32_t k = 0; k < 3; k++) {
            const uint16_t at = mesh->indices[i + k];
            const vec3 p = vec_basis_to_body(camera(view), preview->positions[at]);
            screen[k] = v3(middle_x + (p.x - x) * scale_px, middle_y - (p.y - y) * scale_px,
                           p.z * scale_px);
            corners.at[k] = at;
            corners.normals[k] = vec_basis_to_body(camera(view), preview->normals[at]);
        }
        raster_triangle(raster, screen, (struct raster_skin){ fish_preview_colour_at, &corners });
    }
}
