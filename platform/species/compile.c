/* compile.c -- converts a species text and its meshes to the data that the core uses: card, coats
 * and tables. */
#include "platform/species/shape.h"

#include <math.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/morph/morph.h"

void species_pack(const struct loft *loft, uint32_t key_count, struct mesh_tables *tables,
                  struct species_mesh *mesh)
{
    CORE_ASSERT(key_count <= MORPH_KEY_MAX);
    CORE_ASSERT(loft->vertex_count <= MESH_VERTEX_MAX);
    memcpy(tables->vertices, loft->vertices, sizeof loft->vertices);
    memcpy(tables->anchors, loft->anchors, sizeof loft->anchors);
    memcpy(tables->indices, loft->indices, sizeof loft->indices);
    *mesh = (struct species_mesh){ .vertex_count = loft->vertex_count,
                                   .index_count = loft->index_count,
                                   .anchor_count = loft->anchor_count,
                                   .grid_first = (uint16_t)loft->grid_first,
                                   .grid_rings = (uint16_t)loft->grid_rings,
                                   .grid_spokes = (uint16_t)loft->grid_spokes,
                                   .reach = loft->reach,
                                   .vertices = tables->vertices,
                                   .anchors = tables->anchors,
                                   .indices = tables->indices };
    for (uint32_t key = 0; key < key_count; key++) {
        for (uint32_t i = 0; i < loft->vertex_count; i++) {
            const vec3 p = loft->positions[key][i];
            CORE_ASSERT(fmaxf(fmaxf(fabsf(p.x), fabsf(p.y)), fabsf(p.z)) <= loft->reach);
            tables->points[key][i] = (struct species_point){
                .x = morph_count(p.x, loft->reach),
                .y = morph_count(p.y, loft->reach),
                .z = morph_count(p.z, loft->reach),
                .normal = morph_fold_normal(loft->normals[key][i]),
            };
        }
        mesh->points[key] = tables->points[key];
    }
}

void species_compile(const struct species_text *text, struct species *out)
{
    CORE_ASSERT(text->key_count <= MORPH_KEY_MAX);
    CORE_ASSERT(text->curve_count <= MORPH_CURVE_MAX);
    struct species_card *card = &out->card;
    *out = (struct species){ 0 };
    memcpy(card->id, text->id, sizeof card->id);
    card->key_count = (uint8_t)text->key_count;
    card->measure = text->measure;
    card->motion = text->motion;
    card->form = text->form;
    memcpy(card->thesis_key, text->thesis_key, sizeof card->thesis_key);
    card->thesis_template = text->thesis_template;
    card->growth = text->growth;
    card->scale_knot_count = (uint8_t)text->scale_knot_count;
    memcpy(card->scale_knots, text->scale_knots, sizeof card->scale_knots);
    card->curve_count = (uint8_t)text->curve_count;
    for (uint32_t i = 0; i < text->curve_count; i++) {
        memcpy(card->curve_names[i], text->curves[i].name, SPECIES_NAME_SIZE);
        card->curves[i] = text->curves[i].graph;
    }
    for (uint32_t key = 0; key < text->key_count; key++) {
        memcpy(card->key_names[key], text->keys[key].name, SPECIES_NAME_SIZE);
        card->key_length_m[key] = text->keys[key].length_m;
        card->key_age_days[key] = text->keys[key].age_days;
        /* A maker (a user who draws a species) writes the position of a mark along x. The paint
         * functions read body coordinates, so the positions are converted here. */
        struct species_coat coat = text->keys[key].coat;
        for (uint32_t i = 0; i < coat.mark_count; i++) {
            struct species_mark *mark = &coat.marks[i];
            if (mark->part == PART_BODY) {
                mark->from = (float)shape_body_u(&text->keys[key], (double)mark->from);
                mark->to = (float)shape_body_u(&text->keys[key], (double)mark->to);
            }
        }
        out->coats[key] = coat;
    }
}
