/* growth_hash.h -- prints one line for each species with the hash of its shapes at all stages of
 * growth. */
#ifndef KINGYO_TESTS_REPLAY_GROWTH_HASH_H
#define KINGYO_TESTS_REPLAY_GROWTH_HASH_H

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "core/base/hash.h"
#include "core/morph/morph.h"

#define GROWTH_STEPS 40

/* Returns `hash` updated with the bits of `count` floats. */
static uint64_t hash_floats(uint64_t hash, const float *values, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        uint32_t bits;
        memcpy(&bits, &values[i], sizeof bits);
        hash = hash_u32(hash, bits);
    }
    return hash;
}

static uint64_t hash_vec3(uint64_t hash, vec3 value)
{
    return hash_floats(hash, (const float[]){ value.x, value.y, value.z }, 3);
}

/* Adds the weights and the anchors of a pose to the hash. */
static uint64_t hash_pose(uint64_t hash, const struct morph_pose *pose, uint32_t anchor_count)
{
    hash = hash_floats(hash, &pose->weight[0][0], MORPH_CURVE_MAX * MORPH_KEY_MAX);
    for (uint32_t i = 0; i < anchor_count; i++) {
        const struct quat turn = pose->anchor[i].turn;
        const float parts[4] = { turn.x, turn.y, turn.z, turn.w };
        hash = hash_floats(hash_vec3(hash, pose->anchor[i].position), parts, 4);
    }
    return hash;
}

/* Adds the shape of the species at the growth progress `progress` (0 .. 1) to the hash, in all
 * levels of detail. */
static uint64_t hash_moment(uint64_t hash, const struct species *species,
                            const struct morph_rig *rig, float progress)
{
    static struct morph_pose pose;
    static vec3 positions[MESH_VERTEX_MAX], normals[MESH_VERTEX_MAX];
    for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
        const struct species_mesh *mesh = &species->lod[lod];
        morph_pose(rig, mesh, progress, &pose);
        morph_shape(mesh, rig->key_count, &pose, positions, normals);
        hash = hash_pose(hash, &pose, mesh->anchor_count);
        for (uint32_t i = 0; i < mesh->vertex_count; i++) {
            hash = hash_vec3(hash_vec3(hash, positions[i]), normals[i]);
        }
    }
    const float age_days = life_age_days(&species->card, progress);
    const float length_m = life_length_m(&species->card, progress);
    const float life[] = { age_days, length_m, life_progress(&species->card, age_days),
                           morph_progress(&species->card, length_m) };
    return hash_floats(hash, life, 4);
}

/* Prints the growth hashes of each species for three sets of blend curves: the species' own curves,
 * the smooth template, and the method of the 2005 thesis. */
static void print_growth_hashes(void)
{
    static struct straight_memory memory;
    static struct species thesis;
    for (uint32_t i = 0; i < species_table_count; i++) {
        struct morph_rig rig[3];
        uint64_t hash = HASH_START;
        straight_thesis(species_table[i], &memory, &thesis);
        morph_rig_init(&rig[0], &species_table[i]->card, TEMPLATE_OWN);
        morph_rig_init(&rig[1], &species_table[i]->card, TEMPLATE_SMOOTH);
        morph_rig_init(&rig[2], &thesis.card, TEMPLATE_OWN);
        for (uint32_t step = 0; step <= GROWTH_STEPS; step++) {
            for (uint32_t k = 0; k < 3; k++) {
                hash = hash_moment(hash, k < 2 ? species_table[i] : &thesis, &rig[k],
                                   (float)step / GROWTH_STEPS);
            }
        }
        printf("%016" PRIx64 "  %s\n", hash, species_table[i]->card.id);
    }
}

#endif
