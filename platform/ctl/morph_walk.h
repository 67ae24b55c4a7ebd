/* morph_walk.h -- what the parts of a survey share while they walk through a fish's growth. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_WALK_H
#define KINGYO_PLATFORM_CTL_MORPH_WALK_H

#include "platform/ctl/morph_skin.h"
#include "platform/ctl/morph_survey.h"

struct walk { /* About 10 MiB. */
    const struct species *species;
    const struct species_mesh *mesh;
    const struct morph_rig *rig;
    struct survey *out;
    float progress;
    struct morph_pose pose, key_pose;
    vec3 positions[MESH_VERTEX_MAX], normals[MESH_VERTEX_MAX];
    vec3 key_positions[MESH_VERTEX_MAX];
    vec3 facing[MESH_INDEX_MAX / 3]; /* Of a fin's triangle when it last had an area. */
    bool flipped[MESH_INDEX_MAX / 3], doubtful[MESH_INDEX_MAX / 3];
    float before; /* The moment before this one; not below it at the first. */
    uint32_t root[MESH_VERTEX_MAX]; /* Of a fin's point: where its ray is rooted. */
    bool key_alone[MORPH_KEY_MAX];
    float key_volume[MORPH_KEY_MAX];
    struct skin body, eye[2];
    bool body_closed, eye_closed[2];
};

/* Keeps `value` where it is more than what was found so far. */
static inline void walk_keep(const struct walk *w, struct finding *finding, float value,
                             uint32_t vertex)
{
    if (value > finding->value) {
        *finding = (struct finding){ value, w->progress, vertex };
    }
}

/* morph_inside.c: once, before the first moment; then at every moment that has a shape. */
void walk_find_roots(struct walk *w);
void walk_build_skins(struct walk *w);
void walk_measure_inside(struct walk *w);

/* morph_flips.c: at every moment that has a shape, in their order. */
void walk_measure_flips(struct walk *w);

/* morph_ages.c: the whole life of it, moment by moment, without any shape. */
void walk_measure_ages(struct walk *w, uint32_t steps);

#endif
