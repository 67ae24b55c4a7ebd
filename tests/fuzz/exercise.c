/* exercise.c -- implementation of exercise.h: calls every function of core/morph on a species. */
#include "tests/fuzz/exercise.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/base/panic.h"
#include "core/morph/morph.h"

_Noreturn void core_panic(const char *condition, const char *file, int line)
{
    fprintf(stderr, "%s:%d: %s\n", file, line, condition);
    abort();
}

/* Ends the process unless `holds` is true. `what` describes the invalid result. */
static void demand(int holds, const char *what)
{
    if (!holds) {
        core_panic(what, __FILE__, __LINE__);
    }
}

static void grow(const struct species_card *card)
{
    for (uint32_t i = 0; i <= 8; i++) {
        const float age = 2000.0f * (float)i, progress = (float)i / 8.0f;
        const float length = growth_length_m(&card->growth, age);
        demand(isfinite(length), "lengths are finite");
        demand(growth_age_days(&card->growth, length) >= 0.0f, "ages are not negative");
        const float from_age = life_progress(card, age);
        demand(from_age >= 0.0f && from_age <= 1.0f, "progress is a share");
        demand(life_age_days(card, progress) >= 0.0f, "a progress has an age");
        demand(isfinite(life_length_m(card, progress)), "a progress has a length");
        const float back = morph_progress(card, card->key_length_m[i % card->key_count]);
        demand(back >= 0.0f && back <= 1.0f, "a length has a progress");
    }
}

static void blend(const struct species *species, enum graph_template template_id)
{
    static struct morph_rig rig;
    static struct morph_pose pose;
    static vec3 positions[MESH_VERTEX_MAX], normals[MESH_VERTEX_MAX];
    morph_rig_init(&rig, &species->card, template_id);
    for (uint32_t i = 0; i <= 4; i++) {
        const struct species_mesh *mesh = &species->lod[i % SPECIES_LOD_COUNT];
        morph_pose(&rig, mesh, (float)i / 4.0f, &pose);
        morph_shape(mesh, species->card.key_count, &pose, positions, normals);
        for (uint32_t v = 0; v < mesh->vertex_count; v++) {
            demand(isfinite(positions[v].x) && isfinite(positions[v].y) &&
                       isfinite(positions[v].z) && isfinite(normals[v].x),
                   "shapes are finite");
        }
        const struct paint paint = paint_at(species, pose.weight[0], &mesh->vertices[i]);
        demand(isfinite(paint.colour.x) && isfinite(paint.clear), "paint is finite");
    }
}

void exercise(const struct species *species)
{
    static struct straight_memory memory;
    static struct species made;
    grow(&species->card);
    for (int template_id = TEMPLATE_OWN; template_id < TEMPLATE_COUNT; template_id++) {
        blend(species, (enum graph_template)template_id);
    }
    straight_species(species, &memory, &made);
    blend(&made, TEMPLATE_OWN);
    straight_thesis(species, &memory, &made);
    blend(&made, TEMPLATE_OWN);
}
