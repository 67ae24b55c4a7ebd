/* straight.c -- converts a species to the method of the 2005 thesis, for comparison with
 * core/morph. In that method, vertices move in straight lines, and a species has only three keys.
 * The key shapes are those of the species. */
#include "core/morph/morph.h"

#include <stddef.h>

#include "core/base/mem.h"
#include "core/base/panic.h"

#define REACH_MAX 4.0f

/* Writes the points of key `key`, with the coordinates of all vertices in the body frame. If
 * `reach` equals the reach of the mesh, a vertex without an anchor is copied unchanged. */
static void bake_key(const struct species_mesh *mesh, uint32_t key_count, uint32_t key, float reach,
                     struct straight_memory *memory, struct species_point *out)
{
    morph_key_pose(mesh, key_count, key, &memory->pose);
    morph_shape(mesh, key_count, &memory->pose, memory->positions, memory->normals);
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        const vec3 p = memory->positions[i];
        out[i] = mesh->points[key][i];
        if (reach != mesh->reach || mesh->vertices[i].anchor != ANCHOR_NONE) {
            out[i] = (struct species_point){
                .x = morph_count(p.x, reach),
                .y = morph_count(p.y, reach),
                .z = morph_count(p.z, reach),
                .normal = morph_fold_normal(memory->normals[i]),
            };
        }
    }
}

static void straighten_mesh(const struct species_mesh *from, uint32_t key_count, uint32_t lod,
                            struct straight_memory *memory, struct species_mesh *out)
{
    CORE_ASSERT(lod < SPECIES_LOD_COUNT && from->vertex_count <= MESH_VERTEX_MAX);
    /* `reach` is the largest coordinate that the 16-bit integers of struct species_point can store.
     * The loop doubles `reach` until every coordinate of every key in the body frame fits, but not
     * beyond REACH_MAX. */
    float reach = from->reach;
    for (uint32_t key = 0; key < key_count && from->anchor_count > 0; key++) {
        morph_key_pose(from, key_count, key, &memory->pose);
        morph_shape(from, key_count, &memory->pose, memory->positions, NULL);
        float farthest = 0.0f;
        for (uint32_t i = 0; i < from->vertex_count; i++) {
            const vec3 p = memory->positions[i];
            farthest = f_max(farthest, f_max(f_abs(p.x), f_max(f_abs(p.y), f_abs(p.z))));
        }
        while (reach < REACH_MAX && farthest > reach) {
            reach *= 2.0f;
        }
    }
    for (uint32_t key = 0; key < key_count && from->anchor_count > 0; key++) {
        bake_key(from, key_count, key, reach, memory, memory->points[lod][key]);
        out->points[key] = memory->points[lod][key];
    }
    for (uint32_t i = 0; i < from->vertex_count; i++) {
        struct species_vertex *vertex = &memory->vertices[lod][i];
        *vertex = from->vertices[i];
        vertex->anchor = ANCHOR_NONE;
        for (uint32_t curve = 0; curve < MORPH_CURVE_MAX; curve++) {
            vertex->mask[curve] = curve == 0 ? 255 : 0;
        }
    }
    out->vertices = memory->vertices[lod];
    out->anchor_count = 0;
    out->reach = reach;
}

void straight_species(const struct species *from, struct straight_memory *memory,
                      struct species *out)
{
    CORE_ASSERT(out != from && from->card.key_count <= MORPH_KEY_MAX);
    *out = *from;
    out->card.curve_count = 1;
    for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
        straighten_mesh(&from->lod[lod], from->card.key_count, lod, memory, &out->lod[lod]);
    }
}

void straight_thesis(const struct species *from, struct straight_memory *memory,
                     struct species *out)
{
    struct species_card *card = &out->card;
    straight_species(from, memory, out);
    const struct species_mesh straight[SPECIES_LOD_COUNT] = { out->lod[0], out->lod[1] };
    card->growth = growth_shifted(&from->card.growth);
    card->key_count = 3;
    for (uint32_t i = 0; i < 3; i++) {
        const uint32_t key = from->card.thesis_key[i];
        CORE_ASSERT(key < from->card.key_count);
        card->key_age_days[i] = from->card.key_age_days[key];
        card->key_length_m[i] = growth_length_m(&card->growth, from->card.key_age_days[key]);
        out->coats[i] = from->coats[key];
        MEM_COPY(card->key_names[i], from->card.key_names[key], SPECIES_NAME_SIZE);
        for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
            out->lod[lod].points[i] = straight[lod].points[key];
        }
        card->thesis_key[i] = (uint8_t)i;
    }
    card->scale_knot_count = 0; /* The hand-drawn size curve is removed, because the progress of its
                                   knots refers to all keys of the species. The species has only
                                   three keys now, so its progress has another meaning. */
    graph_from_template(&card->curves[0], (enum graph_template)card->thesis_template, 3,
                        SIMULTANEOUS_PEAK);
}
