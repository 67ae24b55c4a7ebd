/* morph_flaws.h -- the state of a survey (morph_survey.h), and the functions that measure the flaws
 * of the fish at one moment: penetrations and flipped triangles. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_MORPH_FLAWS_H
#define KINGYO_PLATFORM_CTL_MORPH_MORPH_FLAWS_H

#include "platform/ctl/morph/morph_skin.h"
#include "platform/ctl/morph/morph_survey.h"

struct morph_walk { /* State of a survey. The structure has about 10 MiB. */
    const struct species *species;
    const struct species_mesh *mesh;
    const struct morph_rig *rig;
    struct morph_survey *out;
    float progress;
    struct morph_pose pose, key_pose;
    vec3 positions[MESH_VERTEX_MAX], normals[MESH_VERTEX_MAX];
    vec3 key_positions[MESH_VERTEX_MAX];
    /* Normal of each fin triangle, measured at the last moment at which the triangle was large
     * enough. */
    vec3 facing[MESH_INDEX_MAX / 3];
    bool flipped[MESH_INDEX_MAX / 3], doubtful[MESH_INDEX_MAX / 3];
    /* Progress at the previous moment. While the first moment is measured, `before` is at least as
     * large as `progress`. */
    float before;
    uint32_t root[MESH_VERTEX_MAX]; /* For each fin vertex, the vertex at the root of the same fin
                                       ray. */
    bool key_alone[MORPH_KEY_MAX];
    float key_volume[MORPH_KEY_MAX];
    struct morph_skin body, eye[2];
    bool body_closed, eye_closed[2];
};

/* Stores `value` in `finding`, with the present progress and `vertex`, if `value` exceeds the
 * stored value. */
static inline void morph_walk_keep(const struct morph_walk *w, struct finding *finding, float value,
                                   uint32_t vertex)
{
    if (value > finding->value) {
        *finding = (struct finding){ value, w->progress, vertex };
    }
}

/* morph_inside_find_roots() finds the root of each fin ray, and is called once before the first
 * moment. The two functions after it are called at every moment for which a shape is computed. */
void morph_inside_find_roots(struct morph_walk *w);
void morph_inside_build_skins(struct morph_walk *w);
void morph_inside_measure(struct morph_walk *w);

/* morph_flips_measure() is called at every moment for which a shape is computed. Progress must
 * increase from call to call. */
void morph_flips_measure(struct morph_walk *w);

#endif
