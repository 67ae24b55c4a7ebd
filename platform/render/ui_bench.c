/* ui_bench.c -- rigs and ways of the species on the table. */
#include "platform/render/ui_bench.h"

#include <string.h>

/* ---- Ways ----------------------------------------------------------------------------------- */

/* One vertex alone, as a mesh of its own that shares all tables. */
static vec3 point_at(struct ui_bench *bench, const struct species *species,
                     const struct morph_rig *rig, uint32_t vertex, float progress)
{
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

/* The foremost point of a part, where it is rooted; MESH_VERTEX_MAX when there is no such part. */
static uint32_t find_root(const struct species_mesh *mesh, uint8_t part, uint8_t side)
{
    uint32_t found = MESH_VERTEX_MAX;
    float least = 1e9f;
    for (uint32_t i = 0; i < mesh->vertex_count; i++) {
        const struct species_vertex *vertex = &mesh->vertices[i];
        const float place = vertex->u + (part == PART_EYE ? 0.0f : 8.0f * vertex->v);
        if (vertex->part == part && (side == SIDE_MIDDLE || vertex->side == side) &&
            place < least) {
            found = i;
            least = place;
        }
    }
    return found;
}

/* Of the endless line, as `kingyoctl morph path` and `check` measure it. */
static float away_from_line(vec3 point, vec3 from, vec3 to)
{
    const vec3 line = v3_sub(to, from), off = v3_sub(point, from);
    const float t = v3_dot(off, line) / f_max(v3_dot(line, line), 1e-12f);
    return v3_length(v3_mad(off, line, -t));
}

static void walk(struct ui_bench *bench, uint32_t vertex, struct bench_way *way)
{
    way->is_there = vertex < MESH_VERTEX_MAX;
    way->bow = 0.0f;
    for (uint32_t i = 0; way->is_there && i <= BENCH_STEPS; i++) {
        const float progress = (float)i / (float)BENCH_STEPS;
        way->at[i] = point_at(bench, bench->species, &bench->rig, vertex, progress);
        way->ordinary[i] =
            point_at(bench, &bench->ordinary, &bench->ordinary_rig, vertex, progress);
    }
    for (uint32_t i = 0; way->is_there && i <= BENCH_STEPS; i++) {
        way->bow = f_max(way->bow,
                         away_from_line(way->at[i], way->at[0], way->at[BENCH_STEPS]));
    }
}

/* The left eye is seen in a portrait; but where the right one travels, it is the one to follow. */
static void walk_eye(struct ui_bench *bench)
{
    const struct species_mesh *mesh = &bench->species->lod[0];
    struct bench_way *way = &bench->ways[BENCH_EYE];
    walk(bench, find_root(mesh, PART_EYE, SIDE_RIGHT), way);
    const vec3 last = way->at[BENCH_STEPS];
    const bool travels = way->is_there && way->at[0].x > 0.0f && last.x <= 0.0f;
    if (!travels) {
        walk(bench, find_root(mesh, PART_EYE, SIDE_LEFT), way);
    }
}

/* ---- Setting -------------------------------------------------------------------------------- */

static void set_species(struct ui_bench *bench, const struct species *species)
{
    bench->species = species;
    bench->edition++;
    species_straighten(species, &bench->memory, &bench->ordinary);
    morph_rig_init(&bench->ordinary_rig, &bench->ordinary.card, TEMPLATE_ORDINARY);
    morph_rig_init(&bench->rig, &species->card, TEMPLATE_OWN);
    struct specimen portrait = { .species = species, .length_px = 1.0f };
    specimen_portrait(&portrait);
    bench->bounds = specimen_bounds(&portrait);
}

void ui_bench_set(struct ui_bench *bench, const struct species *species,
                  const struct species_card *card)
{
    const bool is_new = species != bench->species;
    if (is_new) {
        set_species(bench, species);
    }
    if (is_new || memcmp(card, &bench->card, sizeof *card) != 0) {
        bench->card = *card;
        morph_rig_init(&bench->rig, card, TEMPLATE_OWN);
        walk(bench, find_root(&species->lod[0], PART_DORSAL, SIDE_MIDDLE),
             &bench->ways[BENCH_DORSAL]);
        walk_eye(bench);
    }
}
