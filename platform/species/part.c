/* part.c -- finds the vertex that represents a body part. This is the vertex nearest to the
 * reference coordinates of the part. */
#include "platform/species/part.h"

#include <math.h>
#include <string.h>

#include "platform/species/reader.h"

enum species_part part_of_vertex(const char *name)
{
    enum species_part part = PART_BODY;
    while (part < PART_COUNT && strcmp(part_names[part], name) != 0) {
        part++;
    }
    return part;
}

/* Returns the distance of vertex `at` from the reference coordinates of the part. If the part is
 * one of a pair, vertices on the wrong side are farther than all vertices on the correct side. */
static float unlikeness(const struct species_vertex *at, enum species_part part,
                        enum species_side side)
{
    const float other_side = at->side != SIDE_MIDDLE && at->side != side ? 10.0f : 0.0f;
    switch (part) {
    case PART_BODY:
        return fabsf(at->u - 0.4f) + fminf(at->v, 1.0f - at->v);
    case PART_EYE:
        return at->u + other_side;
    case PART_TAIL:
        return at->u + (1.0f - at->v);
    default:
        return at->u + at->v + other_side;
    }
}

uint32_t part_vertex_range(const struct species_mesh *mesh, enum species_part part,
                           enum species_side side)
{
    uint32_t best = mesh->vertex_count;
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        const struct species_vertex *at = &mesh->vertices[i];
        if (at->part == part &&
            (best == mesh->vertex_count ||
             unlikeness(at, part, side) < unlikeness(&mesh->vertices[best], part, side))) {
            best = i;
        }
    }
    return best;
}

vec3 part_of_place(const struct species *species, const struct morph_rig *rig, uint32_t vertex,
                   float progress)
{
    static vec3 positions[MESH_VERTEX_MAX];
    static struct morph_pose pose;
    morph_pose(rig, &species->lod[0], progress, &pose);
    morph_shape(&species->lod[0], species->card.key_count, &pose, positions, NULL);
    return positions[vertex];
}
