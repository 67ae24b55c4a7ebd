/* straight.c -- the thesis' own method on the same drawings: straight paths, three keys. */
#include "core/morph/morph.h"

static const struct species_vertex *straight_vertices(const struct species_mesh *mesh,
                                                      struct species_vertex *out)
{
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        out[i] = mesh->vertices[i];
        out[i].anchor = ANCHOR_NONE;
        out[i].mask[0] = 255;
        for (uint32_t curve = 1; curve < MORPH_CURVE_MAX; curve++) {
            out[i].mask[curve] = 0;
        }
    }
    return out;
}

void species_straighten(const struct species *from, struct straight_memory *memory,
                        struct species *out)
{
    *out = *from;
    out->card.curve_count = 1;
    for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
        out->lod[lod].vertices = straight_vertices(&from->lod[lod], memory->vertices[lod]);
        out->lod[lod].anchor_count = 0;
    }
}

void species_thesis(const struct species *from, struct straight_memory *memory,
                    struct species *out)
{
    struct species_card *card = &out->card;
    species_straighten(from, memory, out);
    card->key_count = 3;
    for (uint32_t i = 0; i < 3; i++) {
        const uint32_t key = from->card.thesis_key[i];
        card->key_age_days[i] = from->card.key_age_days[key];
        card->key_length_m[i] = from->card.key_length_m[key];
        out->coats[i] = from->coats[key];
        for (uint32_t c = 0; c < SPECIES_NAME_SIZE; c++) {
            card->key_names[i][c] = from->card.key_names[key][c];
        }
        for (uint32_t lod = 0; lod < SPECIES_LOD_COUNT; lod++) {
            out->lod[lod].points[i] = from->lod[lod].points[key];
        }
        card->thesis_key[i] = (uint8_t)i;
    }
    graph_template(&card->curves[0], (enum graph_template)card->thesis_template, 3,
                   SIMULTANEOUS_PEAK);
}
