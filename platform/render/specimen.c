/* specimen.c -- computes the projection and the size of a specimen (one fish on a screen). */
#include "platform/render/specimen.h"

#include <stddef.h>

#include "core/base/panic.h"

/* Angle in rad by which a fish in the portrait view turns toward the viewer. The turn makes the
 * depth of the fish visible. */
#define THREE_QUARTER_RAD (14.0f * F_DEG)

/* Rotates the pair of vectors (x, y) by an angle whose cosine is `c` and whose sine is `s`. */
static void specimen_rotate(vec3 *x, vec3 *y, float c, float s)
{
    const vec3 before = *x;
    *x = v3_muladd(v3_scale(before, c), *y, s);
    *y = v3_muladd(v3_scale(*y, c), before, -s);
}

struct specimen_axes specimen_axes(const struct specimen *specimen)
{
    struct specimen_axes axes = { .right = { 0.0f, 0.0f, 1.0f },
                                  .up = { 0.0f, 1.0f, 0.0f },
                                  .toward = { -1.0f, 0.0f, 0.0f } };
    specimen_rotate(&axes.right, &axes.toward, f_cos(specimen->yaw_rad), f_sin(specimen->yaw_rad));
    specimen_rotate(&axes.toward, &axes.up, f_cos(specimen->pitch_rad), f_sin(specimen->pitch_rad));
    specimen_rotate(&axes.up, &axes.right, f_cos(specimen->roll_rad), f_sin(specimen->roll_rad));
    return axes;
}

void specimen_project(const struct specimen *specimen, vec3 point, float out[2])
{
    const struct specimen_axes axes = specimen_axes(specimen);
    out[0] = specimen->x_px + specimen->length_px * v3_dot(axes.right, point);
    out[1] = specimen->y_px - specimen->length_px * v3_dot(axes.up, point);
}

struct specimen_bounds specimen_bounds(const struct specimen *specimen)
{
    CORE_ASSERT(specimen->species);
    vec3 positions[MESH_VERTEX_MAX];
    struct morph_pose pose;
    struct morph_rig rig;
    struct specimen_bounds bounds = { 0.0f, 0.0f, 0.0f, 0.0f };
    const struct species *const species = specimen->species;
    const struct species_mesh *const mesh = &species->lod[SPECIES_LOD_COUNT - 1u];
    const struct specimen_axes axes = specimen_axes(specimen);
    const uint32_t last = species->card.key_count - 1u;
    morph_rig_init(&rig, &species->card, TEMPLATE_PAIRWISE);
    for (uint32_t key = 0; key <= last; key++) {
        morph_pose(&rig, mesh, (float)key / (float)last, &pose);
        morph_shape(mesh, species->card.key_count, &pose, positions, NULL);
        for (uint32_t i = 0; i < mesh->vertex_count; i++) {
            const float x = v3_dot(axes.right, positions[i]), y = v3_dot(axes.up, positions[i]);
            bounds.left = f_max(bounds.left, -x);
            bounds.right = f_max(bounds.right, x);
            bounds.up = f_max(bounds.up, y);
            bounds.down = f_max(bounds.down, -y);
        }
    }
    return bounds;
}

void specimen_fit(struct specimen *specimen, float x_px, float y_px, float width_px,
                  float height_px)
{
    CORE_ASSERT(width_px > 0.0f && height_px > 0.0f);
    const struct specimen_bounds bounds = specimen_bounds(specimen);
    const float length_px =
        f_min(width_px / (bounds.left + bounds.right), height_px / (bounds.up + bounds.down));
    specimen->length_px = length_px;
    specimen->x_px = x_px + 0.5f * (width_px + (bounds.left - bounds.right) * length_px);
    specimen->y_px = y_px + 0.5f * (height_px + (bounds.up - bounds.down) * length_px);
}

void specimen_portrait(struct specimen *specimen)
{
    const struct species_card *card = &specimen->species->card;
    const bool wing = card->motion == MOTION_WING, eel = card->motion == MOTION_EEL;
    specimen->yaw_rad = wing ? 25.0f * F_DEG : THREE_QUARTER_RAD;
    specimen->pitch_rad = wing ? 48.0f * F_DEG : eel ? 20.0f * F_DEG : 0.5f * THREE_QUARTER_RAD;
}
