/* part.c -- names the body parts, and finds the vertex that represents a body part. Each part has
 * reference coordinates (u, v). The part's vertex nearest to these coordinates represents the
 * part. */
#include "platform/species/part.h"

#include <math.h>
#include <string.h>

#include "core/base/panic.h"

const char *const species_measure_names[] = { "total", "standard", "fork", "disc", NULL };
const char *const species_motion_names[] = { "tail", "eel", "fins", "tuna", "wing", NULL };
const char *const species_form_names[] = { "fusiform", "compressed", "depressed",
                                           "eel",      "puffer",     NULL };

const char *const part_names[OWNED_COUNT] = {
    [PART_BODY] = "body",
    [PART_EYE] = "eye",
    [PART_TAIL] = "tail",
    [PART_DORSAL] = "dorsal",
    [PART_ANAL] = "anal",
    [PART_PECTORAL] = "pectoral",
    [PART_PELVIC] = "pelvic",
    [PART_DORSAL_2] = "dorsal2",
    [PART_FINLET_UPPER] = "finlets_upper",
    [PART_FINLET_LOWER] = "finlets_lower",
    [PART_HEAD] = "head",
    [PART_TRUNK] = "trunk",
};

enum species_part part_of_vertex(const char *name)
{
    enum species_part part = PART_BODY;
    while (part < PART_COUNT && strcmp(part_names[part], name) != 0) {
        part++;
    }
    return part;
}

/* Returns the distance in (u, v) coordinates from the vertex `at` to the point that represents
 * `part`, for example the pupil's centre for an eye (see part_vertex_range()). If the part is one
 * of a pair and the vertex is not on the side `side`, adds 10, which is more than any distance on
 * the same side. */
static float part_point_distance(const struct species_vertex *at, enum species_part part,
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
    CORE_ASSERT(part < PART_COUNT);
    CORE_ASSERT(side <= SIDE_LEFT);
    uint32_t best = mesh->vertex_count;
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        const struct species_vertex *at = &mesh->vertices[i];
        if (at->part == part && (best == mesh->vertex_count ||
                                 part_point_distance(at, part, side) <
                                     part_point_distance(&mesh->vertices[best], part, side))) {
            best = i;
        }
    }
    return best;
}

vec3 part_of_place(const struct species *species, const struct morph_rig *rig, uint32_t vertex,
                   float progress)
{
    CORE_ASSERT(vertex < species->lod[0].vertex_count);
    CORE_ASSERT(species->card.key_count == rig->key_count);
    static vec3 positions[MESH_VERTEX_MAX];
    static struct morph_pose pose;
    morph_pose(rig, &species->lod[0], progress, &pose);
    morph_shape(&species->lod[0], species->card.key_count, &pose, positions, NULL);
    return positions[vertex];
}
