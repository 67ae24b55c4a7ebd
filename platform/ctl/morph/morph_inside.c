/* morph_inside.c -- measures how deep parts of a fish penetrate other parts.
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
#include "platform/ctl/morph/morph_walk.h"

#define LIFT 2e-4f /* Distance of the tested point from a body vertex, in body lengths. */
#define EYE_RIM 1.0f
#define PUPIL 0.5f

/* Finds the root of each fin ray. A fin ray consists of all points with the same u in one fin. The
 * root is the point with the least v. */
void morph_inside_find_roots(struct morph_walk *w)
{
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

void morph_inside_build_skins(struct morph_walk *w)
{
    morph_skin_build(&w->body, w->mesh, w->positions, PART_BODY, SIDE_MIDDLE);
    w->body_closed = morph_skin_is_closed(&w->body);
    w->out->moments_open += !w->body_closed;
    for (uint32_t i = 0; i < 2; i++) {
        morph_skin_build(&w->eye[i], w->mesh, w->positions, PART_EYE,
                         i == 0 ? SIDE_RIGHT : SIDE_LEFT);
        w->eye_closed[i] = morph_skin_is_closed(&w->eye[i]);
    }
}

static void measure_body_vertex(struct morph_walk *w, uint32_t i)
{
    const vec3 lifted = v3_muladd(w->positions[i], w->normals[i], LIFT);
    if (morph_skin_has(&w->body, lifted)) {
        morph_walk_keep(w, &w->out->body_in_body,
                        morph_skin_way_out(&w->body, lifted, w->normals[i]), i);
    }
}

static void measure_in(struct morph_walk *w, const struct morph_skin *skin, struct finding *finding,
                       uint32_t i)
{
    if (morph_skin_has(skin, w->positions[i])) {
        morph_walk_keep(w, finding, morph_skin_distance(skin, w->positions[i]), i);
    }
}

static void measure_eye_vertex(struct morph_walk *w, uint32_t i)
{
    const struct species_vertex *vertex = &w->mesh->vertices[i];
    const uint32_t other = vertex->side == SIDE_RIGHT ? 1 : 0;
    if (vertex->u >= EYE_RIM) {
        return;
    }
    measure_in(w, &w->body, &w->out->eye_in_body, i);
    if (vertex->u <= PUPIL) {
        measure_in(w, &w->body, &w->out->pupil_in_body, i);
    }
    if (w->eye_closed[0] && w->eye_closed[1]) {
        measure_in(w, &w->eye[other], &w->out->eye_in_eye, i);
    }
}

static float depth_of(const struct morph_walk *w, uint32_t i)
{
    return morph_skin_has(&w->body, w->positions[i])
               ? morph_skin_distance(&w->body, w->positions[i])
               : 0.0f;
}

static void measure_fin_vertex(struct morph_walk *w, uint32_t i)
{
    const bool inside = morph_skin_has(&w->body, w->positions[i]);
    if (w->root[i] != i && inside) {
        morph_walk_keep(w, &w->out->fin_in_body, depth_of(w, i) - depth_of(w, w->root[i]), i);
    } else if (w->root[i] == i && !inside) {
        morph_walk_keep(w, &w->out->root_off_skin, morph_skin_distance(&w->body, w->positions[i]),
                        i);
    }
    for (uint32_t eye = 0; eye < 2; eye++) {
        if (w->eye_closed[eye]) {
            measure_in(w, &w->eye[eye], &w->out->fin_in_eye, i);
        }
    }
}

void morph_inside_measure(struct morph_walk *w)
{
    for (uint32_t i = 0; i < w->mesh->vertex_count && w->body_closed; i++) {
        const uint8_t part = w->mesh->vertices[i].part;
        if (part == PART_BODY) {
            measure_body_vertex(w, i);
        } else if (part == PART_EYE) {
            measure_eye_vertex(w, i);
        } else {
            measure_fin_vertex(w, i);
        }
    }
}
