/* morph_walk.h -- declarations that the parts of a survey share while they measure a fish's
 * growth. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_MORPH_WALK_H
#define KINGYO_PLATFORM_CTL_MORPH_MORPH_WALK_H

#include "platform/ctl/morph/morph_skin.h"
#include "platform/ctl/morph/morph_survey.h"

struct morph_walk { /* State of a survey. The size is about 10 MiB. */
    const struct species *species;
    const struct species_mesh *mesh;
    const struct morph_rig *rig;
    struct morph_survey *out;
    float progress;
    struct morph_pose pose, key_pose;
    vec3 positions[MESH_VERTEX_MAX], normals[MESH_VERTEX_MAX];
    vec3 key_positions[MESH_VERTEX_MAX];
    /* Direction of each fin triangle at the last moment when the triangle had an area. */
    vec3 facing[MESH_INDEX_MAX / 3];
    bool flipped[MESH_INDEX_MAX / 3], doubtful[MESH_INDEX_MAX / 3];
    /* Progress of the previous moment. At the first moment this value is not less than the present
     * progress. */
    float before;
    uint32_t root[MESH_VERTEX_MAX]; /* Vertex at the root of the ray, for each fin vertex. */
    bool key_alone[MORPH_KEY_MAX];
    float key_volume[MORPH_KEY_MAX];
    struct morph_skin body, eye[2];
    bool body_closed, eye_closed[2];
};

/* Stores `value` if it is greater than the finding's value. */
static inline void morph_walk_keep(const struct morph_walk *w, struct finding *finding, float value,
                                   uint32_t vertex)
{
    if (value > finding->value) {
        *finding = (struct finding){ value, w->progress, vertex };
    }
}

/* morph_inside.c: morph_inside_find_roots() runs once before the first moment. The other functions
 * run at every moment that has a shape. */
void morph_inside_find_roots(struct morph_walk *w);
void morph_inside_build_skins(struct morph_walk *w);
void morph_inside_measure(struct morph_walk *w);

/* morph_flips.c: call this function at every moment that has a shape, in the order of progress. */
void morph_flips_measure(struct morph_walk *w);

/* morph_ages.c: measures the whole life moment by moment, without shapes. */
void morph_ages_measure(struct morph_walk *w, uint32_t steps);

#endif
