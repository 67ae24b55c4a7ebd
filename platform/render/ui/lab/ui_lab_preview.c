/* ui_lab_preview.c -- computes two things for the species that the growth lab shows: its rigs
 * (deformation graphs, prepared for computing poses), and the trajectories of points of the
 * fish. */
#include "platform/render/ui/lab/ui_lab_preview.h"

#include <string.h>

#include "core/base/panic.h"
#include "platform/species/part.h"

/* ---- Trajectories --------------------------------------------------------------------------- */

/* Returns the position of one vertex at `progress` through life. To save time, the position is
 * computed with a mesh that has only this vertex and shares all other tables with the species'
 * mesh. */
static vec3 ui_lab_preview_point_at(struct ui_lab_preview *bench, const struct species *species,
                                    const struct morph_rig *rig, uint32_t vertex, float progress)
{
    CORE_ASSERT(progress >= 0.0f && progress <= 1.0f);
    struct species_mesh one = species->lod[0];
    vec3 position;
    morph_pose(rig, &one, progress, &bench->pose);
    one.vertices += vertex;
    one.vertex_count = 1;
    for (uint32_t key = 0; key < rig->key_count; key++) {
        one.points[key] += vertex;
    }
    morph_shape(&one, rig->key_count, &bench->pose, &position, NULL);
    return position;
}

static void trace_vertex_path(struct ui_lab_preview *bench, uint32_t vertex,
                              struct lab_preview_path *way)
{
    way->is_there = vertex < bench->species->lod[0].vertex_count;
    way->bow = 0.0f;
    for (uint32_t i = 0; way->is_there && i <= LAB_PREVIEW_STEPS; i++) {
        const float progress = (float)i / (float)LAB_PREVIEW_STEPS;
        way->at[i] = ui_lab_preview_point_at(bench, bench->species, &bench->rig, vertex, progress);
        way->ordinary[i] = ui_lab_preview_point_at(bench, &bench->ordinary, &bench->ordinary_rig,
                                                   vertex, progress);
    }
    for (uint32_t i = 0; way->is_there && i <= LAB_PREVIEW_STEPS; i++) {
        way->bow =
            f_max(way->bow, v3_from_line(way->at[i], way->at[0], way->at[LAB_PREVIEW_STEPS]));
    }
}

/* ---- Selection of the species --------------------------------------------------------------- */

void ui_lab_preview_set(struct ui_lab_preview *bench, const struct species *species,
                        const struct species_card *card)
{
    CORE_ASSERT(card->key_count == species->card.key_count);
    const bool is_new = species != bench->species;
    if (is_new) {
        bench->species = species;
        bench->edition++;
        straight_species(species, &bench->memory, &bench->ordinary);
        morph_rig_init(&bench->ordinary_rig, &bench->ordinary.card, TEMPLATE_ORDINARY);
        morph_rig_init(&bench->rig, &species->card, TEMPLATE_OWN);
        struct specimen portrait = { .species = species, .length_px = 1.0f };
        specimen_portrait(&portrait);
        bench->bounds = specimen_bounds(&portrait);
    }
    if (is_new || memcmp(card, &bench->card, sizeof *card) != 0) {
        bench->card = *card;
        morph_rig_init(&bench->rig, card, TEMPLATE_OWN);
        trace_vertex_path(bench, part_vertex_range(&species->lod[0], PART_DORSAL, SIDE_MIDDLE),
                          &bench->ways[LAB_PREVIEW_DORSAL]);
        /* If the right eye migrates to the left side, as in a flatfish, the right eye is traced.
         * Otherwise the left eye is traced, because a side view shows the left eye. */
        const struct species_mesh *mesh = &bench->species->lod[0];
        struct lab_preview_path *way = &bench->ways[LAB_PREVIEW_EYE];
        trace_vertex_path(bench, part_vertex_range(mesh, PART_EYE, SIDE_RIGHT), way);
        const vec3 last = way->at[LAB_PREVIEW_STEPS];
        const bool travels = way->is_there && way->at[0].x > 0.0f && last.x <= 0.0f;
        if (!travels) {
            trace_vertex_path(bench, part_vertex_range(mesh, PART_EYE, SIDE_LEFT), way);
        }
    }
}
