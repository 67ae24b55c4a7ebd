/* morph_flips.c -- counts flipped triangles. A triangle of the body or of an eye is flipped if it
 * faces inward. A triangle of a fin is flipped if it reverses its direction between two moments.
 *
 * The fin of a hatchling unfolds. A correct fin may therefore turn by a large angle between two
 * moments. If a fin triangle has turned by more than a right angle, the interval between the two
 * moments is sampled in small steps. A correct fin turns a little in each step, but a flipped
 * triangle reverses in a single step. The result is therefore independent of the number of
 * moments. */
#include "platform/ctl/morph/morph_walk.h"

/* Length of the cross product of two edges (twice the area) below which a triangle has no
 * defined direction. */
#define AREA_MIN 1e-9f
/* Height of a triangle, in quantization steps of the mesh tables, below which rounding errors
 * determine the direction. */
#define THIN_COUNTS 4.0f
/* Step of progress for sampling between two moments. */
#define CLOSELY 4e-5f

static vec3 face_of(const struct morph_walk *w, uint32_t triangle)
{
    const uint16_t *c = &w->mesh->indices[3u * triangle];
    return v3_cross(v3_sub(w->positions[c[1]], w->positions[c[0]]),
                    v3_sub(w->positions[c[2]], w->positions[c[0]]));
}

static bool is_thin(const struct morph_walk *w, uint32_t triangle, vec3 face)
{
    const uint16_t *c = &w->mesh->indices[3u * triangle];
    float longest = 0.0f;
    for (uint32_t i = 0; i < 3; i++) {
        const vec3 edge = v3_sub(w->positions[c[(i + 1u) % 3u]], w->positions[c[i]]);
        longest = f_max(longest, v3_length(edge));
    }
    return v3_length(face) <= longest * THIN_COUNTS * w->mesh->reach / 32767.0f;
}

static void mark_flipped(struct morph_walk *w, uint32_t triangle, uint32_t *count)
{
    if (!w->flipped[triangle]) {
        w->flipped[triangle] = true;
        w->out->flipped_at =
            w->out->flipped_skin + w->out->flipped_fins == 0 ? w->progress : w->out->flipped_at;
        (*count)++;
    }
}

static void measure_skin(struct morph_walk *w, uint32_t triangle, vec3 face)
{
    const uint16_t *c = &w->mesh->indices[3u * triangle];
    const vec3 outward = v3_add(w->normals[c[0]], v3_add(w->normals[c[1]], w->normals[c[2]]));
    if (v3_length(face) >= AREA_MIN && v3_dot(face, outward) < 0.0f) {
        mark_flipped(w, triangle, &w->out->flipped_skin);
    }
}

static bool is_fin(const struct morph_walk *w, uint32_t triangle)
{
    return w->mesh->vertices[w->mesh->indices[3u * triangle]].part >= PART_TAIL;
}

static void shape_at(struct morph_walk *w, float progress)
{
    morph_pose(w->rig, w->mesh, progress, &w->pose);
    morph_shape(w->mesh, w->rig->key_count, &w->pose, w->positions, w->normals);
}

/* Checks one small step of the fin triangles that may be flipped. */
static void morph_flips_check_step(struct morph_walk *w)
{
    for (uint32_t t = 0; t < w->mesh->index_count / 3u; t++) {
        const vec3 face = face_of(w, t);
        if (w->doubtful[t] && !is_thin(w, t, face)) {
            if (v3_dot(face, w->facing[t]) < 0.0f) {
                mark_flipped(w, t, &w->out->flipped_fins);
            }
            w->facing[t] = face;
        }
    }
}

static void look_closely(struct morph_walk *w)
{
    const float till = w->progress, from = w->before;
    const uint32_t steps = 1u + (uint32_t)((till - from) / CLOSELY);
    for (uint32_t i = 1; i <= steps; i++) {
        w->progress = i == steps ? till : f_lerp(from, till, (float)i / (float)steps);
        shape_at(w, w->progress);
        morph_flips_check_step(w);
    }
}

void morph_flips_measure(struct morph_walk *w)
{
    bool any = false;
    for (uint32_t t = 0; t < w->mesh->index_count / 3u; t++) {
        const vec3 face = face_of(w, t);
        w->doubtful[t] = false;
        if (!is_fin(w, t)) {
            measure_skin(w, t, face);
        } else if (!is_thin(w, t, face)) {
            w->doubtful[t] = !w->flipped[t] && v3_dot(face, w->facing[t]) < 0.0f;
            w->facing[t] = w->doubtful[t] ? w->facing[t] : face;
            any = any || w->doubtful[t];
        }
    }
    if (any) {
        look_closely(w);
    }
    w->before = w->progress;
}
