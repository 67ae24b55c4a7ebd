/* morph_flaws.c -- measures how deep parts of a fish penetrate other parts.
 *
 * The following penetrations are errors, and the following overlaps are intended:
 *
 * - A body vertex is an error if a point just outside it (LIFT along its normal) is inside the
 * body, because the skin has folded there. The depth is the distance to the surface along the
 * normal.
 *
 * - A fin is rooted in the body, and a fin that has not grown yet lies completely inside the body.
 * The depth of a fin point is therefore its depth below the skin minus the depth of the root (v =
 * 0) of its fin ray.
 *
 * - An eye is a ball that is half inside the head. The rear of the ball (u >= 1) is not measured.
 * The visible part is measured, and the pupil (u <= PUPIL) also separately.
 *
 * - Penetrations between fins are not measured, because fins are sheets without thickness that bend
 * in the water. */
#include "platform/ctl/morph/morph_survey.h"

#include "core/base/panic.h"

#define LIFT 2e-4f /* Distance of the tested point from a body vertex, in body lengths. */
#define EYE_RIM 1.0f
#define PUPIL 0.5f

/* Finds the root of each fin ray. A fin ray consists of all points with the same u in one fin. The
 * root is the point with the least v. */
void morph_inside_find_roots(struct morph_walk *w)
{
    CORE_ASSERT(w->mesh->vertex_count <= MESH_VERTEX_MAX);
    const struct species_vertex *vertex = w->mesh->vertices;
    for (uint32_t i = 0; i < w->mesh->vertex_count; i++) {
        w->root[i] = i;
        for (uint32_t j = 0; j < w->mesh->vertex_count; j++) {
            if (vertex[j].part == vertex[i].part && vertex[j].side == vertex[i].side &&
                vertex[j].u == vertex[i].u && vertex[j].v < vertex[w->root[i]].v) {
                w->root[i] = j;
            }
        }
    }
}

static void measure_in(struct morph_walk *w, const struct morph_skin *skin, struct finding *finding,
                       uint32_t i)
{
    if (morph_skin_has(skin, w->positions[i])) {
        morph_walk_keep(w, finding, morph_skin_distance(skin, w->positions[i]), i);
    }
}

static float depth_of(const struct morph_walk *w, uint32_t i)
{
    return morph_skin_has(&w->body, w->positions[i])
               ? morph_skin_distance(&w->body, w->positions[i])
               : 0.0f;
}

void morph_inside_measure(struct morph_walk *w)
{
    morph_skin_build(&w->body, w->mesh, w->positions, PART_BODY, SIDE_MIDDLE);
    w->body_closed = morph_skin_is_closed(&w->body);
    w->out->moments_open += !w->body_closed;
    for (uint32_t eye = 0; eye < 2; eye++) {
        morph_skin_build(&w->eye[eye], w->mesh, w->positions, PART_EYE,
                         eye == 0 ? SIDE_RIGHT : SIDE_LEFT);
        w->eye_closed[eye] = morph_skin_is_closed(&w->eye[eye]);
    }
    for (uint32_t i = 0; i < w->mesh->vertex_count && w->body_closed; i++) {
        const struct species_vertex *vertex = &w->mesh->vertices[i];
        if (vertex->part == PART_BODY) {
            const vec3 lifted = v3_muladd(w->positions[i], w->normals[i], LIFT);
            if (morph_skin_has(&w->body, lifted)) {
                morph_walk_keep(w, &w->out->body_in_body,
                                morph_skin_way_out(&w->body, lifted, w->normals[i]), i);
            }
        } else if (vertex->part == PART_EYE && vertex->u < EYE_RIM) {
            measure_in(w, &w->body, &w->out->eye_in_body, i);
            if (vertex->u <= PUPIL) {
                measure_in(w, &w->body, &w->out->pupil_in_body, i);
            }
            if (w->eye_closed[0] && w->eye_closed[1]) {
                const uint32_t other = vertex->side == SIDE_RIGHT ? 1 : 0;
                measure_in(w, &w->eye[other], &w->out->eye_in_eye, i);
            }
        } else if (vertex->part != PART_EYE) {
            const bool inside = morph_skin_has(&w->body, w->positions[i]);
            if (w->root[i] != i && inside) {
                morph_walk_keep(w, &w->out->fin_in_body, depth_of(w, i) - depth_of(w, w->root[i]),
                                i);
            } else if (w->root[i] == i && !inside) {
                morph_walk_keep(w, &w->out->root_off_skin,
                                morph_skin_distance(&w->body, w->positions[i]), i);
            }
            for (uint32_t eye = 0; eye < 2; eye++) {
                if (w->eye_closed[eye]) {
                    measure_in(w, &w->eye[eye], &w->out->fin_in_eye, i);
                }
            }
        }
    }
}

/* ---- Flipped triangles ----------------------------------------------------------------------- */

/* This section counts flipped triangles. A triangle of the body or of an eye is flipped if it faces
 * inward. A triangle of a fin is flipped if it reverses its direction between two moments.
 *
 * The fin of a hatchling unfolds. A correct fin may therefore turn by a large angle between two
 * moments. If a fin triangle has turned by more than a right angle, the interval between the two
 * moments is sampled in small steps. A correct fin turns a little in each step, but a flipped
 * triangle reverses in a single step. The result is therefore independent of the number of
 * moments. */

/* Length of the cross product of two edges (twice the area) below which a triangle has no
 * defined direction. */
#define AREA_MIN 1e-9f
/* Height of a triangle, in quantization steps of the mesh tables, below which rounding errors
 * determine the direction. */
#define THIN_COUNTS 4.0f
/* Step of progress with which the interval between two moments is sampled. */
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

void morph_flips_measure(struct morph_walk *w)
{
    CORE_ASSERT(w->mesh->index_count <= MESH_INDEX_MAX);
    bool any = false;
    for (uint32_t t = 0; t < w->mesh->index_count / 3u; t++) {
        const vec3 face = face_of(w, t);
        w->doubtful[t] = false;
        if (w->mesh->vertices[w->mesh->indices[3u * t]].part < PART_TAIL) {
            const uint16_t *c = &w->mesh->indices[3u * t];
            const vec3 outward =
                v3_add(w->normals[c[0]], v3_add(w->normals[c[1]], w->normals[c[2]]));
            if (v3_length(face) >= AREA_MIN && v3_dot(face, outward) < 0.0f) {
                mark_flipped(w, t, &w->out->flipped_skin);
            }
        } else if (!is_thin(w, t, face)) {
            w->doubtful[t] = !w->flipped[t] && v3_dot(face, w->facing[t]) < 0.0f;
            w->facing[t] = w->doubtful[t] ? w->facing[t] : face;
            any = any || w->doubtful[t];
        }
    }
    if (any) {
        const float till = w->progress, from = w->before;
        const uint32_t steps = 1u + (uint32_t)((till - from) / CLOSELY);
        for (uint32_t i = 1; i <= steps; i++) {
            w->progress = i == steps ? till : f_lerp(from, till, (float)i / (float)steps);
            morph_pose(w->rig, w->mesh, w->progress, &w->pose);
            morph_shape(w->mesh, w->rig->key_count, &w->pose, w->positions, w->normals);
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
    }
    w->before = w->progress;
}
