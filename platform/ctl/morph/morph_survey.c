/* morph_survey.c -- measures many moments of a fish's growth, and records the worst value of each
 * kind of error. */
#include "platform/ctl/morph/morph_survey.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/species/part.h"

static void measure_sum(const float *weight, float *error, float *least)
{
    double sum = 0.0;
    for (uint32_t key = 0; key < MORPH_KEY_MAX; key++) {
        sum += (double)weight[key];
        *least = f_min(*least, weight[key]);
    }
    *error = f_max(*error, (float)fabs(sum - 1.0));
}

/* Compares the fish with the drawn key to which all curves give the weight 1 at the present moment.
 * Does nothing if there is no such key. */
static void measure_key(struct morph_walk *w)
{
    uint32_t key = 0;
    bool alone = false;
    for (uint32_t i = 0; i < w->rig->key_count && !alone; i++) {
        key = i;
        alone = true;
        for (uint32_t curve = 0; curve < w->rig->curve_count; curve++) {
            alone = alone && w->pose.weight[curve][key] == 1.0f;
        }
    }
    if (!alone) {
        return;
    }
    w->key_alone[key] = true;
    morph_key_pose(w->mesh, w->rig->key_count, key, &w->key_pose);
    morph_shape(w->mesh, w->rig->key_count, &w->key_pose, w->key_positions, NULL);
    for (uint32_t i = 0; i < w->mesh->vertex_count; i++) {
        const bool carried = w->mesh->vertices[i].anchor != ANCHOR_NONE;
        const vec3 drawn = carried ? w->key_positions[i] : morph_position(w->mesh, key, i);
        morph_walk_keep(w, &w->out->key_error, v3_length(v3_sub(w->positions[i], drawn)), i);
    }
}

/* Computes the shape at `progress`. Returns the positions of its vertices. */
static const vec3 *shape_at(struct morph_walk *w, float progress)
{
    w->progress = progress;
    morph_pose(w->rig, w->mesh, progress, &w->pose);
    morph_shape(w->mesh, w->rig->key_count, &w->pose, w->positions, w->normals);
    return w->positions;
}

static float key_progress(const struct morph_walk *w, uint32_t key)
{
    return (float)key / (float)(w->rig->key_count - 1u);
}

/* Measures the volume and the size of the fish in each key.
 *
 * The standard length ends at the tail root, the foremost body point with u = 1. The point that
 * closes the body also has u = 1, but is farther behind. If the body has no point with u = 1, the
 * standard length ends at the rearmost body point. The fork length ends at the vertex that is
 * nearest to the middle of the tail fin's edge (u = 0.5, v = 1). */
static void measure_keys(struct morph_walk *w)
{
    for (uint32_t key = 0; key < w->rig->key_count; key++) {
        w->progress = key_progress(w, key);
        morph_key_pose(w->mesh, w->rig->key_count, key, &w->pose);
        morph_shape(w->mesh, w->rig->key_count, &w->pose, w->positions, w->normals);
        morph_skin_build(&w->body, w->mesh, w->positions, PART_BODY, SIDE_MIDDLE);
        w->key_volume[key] = morph_skin_volume(&w->body);
        float left = FLT_MAX, right = -FLT_MAX, front = FLT_MAX, rear = -FLT_MAX, end = -FLT_MAX;
        float root = FLT_MAX, fork = 0.0f, nearest = FLT_MAX;
        for (uint32_t i = 0; i < w->mesh->vertex_count; i++) {
            const struct species_vertex *at = &w->mesh->vertices[i];
            const vec3 p = w->positions[i];
            const float away = fabsf(at->u - 0.5f) + fabsf(at->v - 1.0f);
            if (at->part == PART_BODY) {
                left = f_min(left, p.x);
                right = f_max(right, p.x);
                front = f_min(front, p.z);
                rear = f_max(rear, p.z);
                root = at->u > 0.999f ? f_min(root, p.z) : root;
            } else if (at->part == PART_TAIL) {
                end = f_max(end, p.z);
                fork = away < nearest ? p.z : fork;
                nearest = f_min(nearest, away);
            }
        }
        const enum species_measure measure = (enum species_measure)w->species->card.measure;
        const float length = measure == MEASURE_TOTAL      ? f_max(end, rear) + 0.5f
                             : measure == MEASURE_STANDARD ? (root < FLT_MAX ? root : rear) + 0.5f
                             : measure == MEASURE_FORK     ? fork + 0.5f
                                                           : right - left;
        morph_walk_keep(w, &w->out->size_error, fabsf(length - 1.0f), MORPH_SURVEY_NOWHERE);
        morph_walk_keep(w, &w->out->size_error, fabsf(front + 0.5f), MORPH_SURVEY_NOWHERE);
    }
}

static void measure_moment(struct morph_walk *w, float progress)
{
    CORE_ASSERT(progress >= 0.0f && progress <= 1.0f);
    shape_at(w, progress);
    for (uint32_t curve = 0; curve < w->rig->curve_count; curve++) {
        float graph[MORPH_KEY_MAX];
        graph_weights(&w->rig->curves[curve], w->rig->key_count, w->progress, graph);
        measure_sum(graph, &w->out->sum_error, &w->out->weight_min);
        measure_sum(w->pose.weight[curve], &w->out->drawn_sum_error, &w->out->drawn_weight_min);
    }
    measure_key(w);
    morph_flips_measure(w);
    morph_inside_measure(w);
    const uint32_t last = w->rig->key_count - 1u;
    const uint32_t key = (uint32_t)fminf(w->progress * (float)last, (float)(last - 1u));
    const float least = f_min(w->key_volume[key], w->key_volume[key + 1u]);
    const float dip = 1.0f - morph_skin_volume(&w->body) / least;
    morph_walk_keep(w, &w->out->volume_dip, dip, MORPH_SURVEY_NOWHERE);
}

static float measure_path(struct morph_walk *w, enum species_part part, enum species_side side,
                          uint32_t steps)
{
    CORE_ASSERT(steps >= 1);
    const uint32_t vertex = part_vertex_range(w->mesh, part, side);
    float off = 0.0f;
    if (vertex == w->mesh->vertex_count) {
        return off;
    }
    const vec3 from = shape_at(w, 0.0f)[vertex], to = shape_at(w, 1.0f)[vertex];
    for (uint32_t i = 0; i <= steps; i++) {
        const vec3 p = shape_at(w, (float)i / (float)steps)[vertex];
        off = f_max(off, v3_from_line(p, from, to));
    }
    return off;
}

/* Checks the conversions between age, progress and length over the whole life of a fish. */
static void measure_ages(struct morph_walk *w, uint32_t steps)
{
    struct morph_survey *out = w->out;
    const struct species_card *card = &w->species->card;
    float before_days = -1.0f;
    for (uint32_t i = 0; i <= steps; i++) {
        w->progress = (float)i / (float)steps;
        const float age_days = life_age_days(card, w->progress);
        /* Counts the moments at which the fish is not older than at the previous moment, which is
         * an error. */
        if (!(age_days > before_days) && out->moments_not_older++ == 0) {
            out->age_stands_at = w->progress;
        }
        /* Compares the fish's length with the growth curve at its age, unless the author of the
         * species drew the sizes. */
        const float length_m = life_length_m(card, w->progress);
        const float again_m = life_length_m(card, morph_progress(card, length_m));
        morph_walk_keep(w, &out->length_lost, fabsf(again_m / length_m - 1.0f),
                        MORPH_SURVEY_NOWHERE);
        if (card->scale_knot_count == 0) {
            const float grown_m = growth_length_m(&card->growth, age_days);
            morph_walk_keep(w, &out->off_growth, fabsf(length_m / grown_m - 1.0f),
                            MORPH_SURVEY_NOWHERE);
        }
        const float back = fabsf(life_progress(card, age_days) - w->progress);
        morph_walk_keep(w, &out->progress_lost, back, MORPH_SURVEY_NOWHERE);
        before_days = age_days;
    }
}

void morph_survey(const struct species *species, const struct morph_rig *rig, uint32_t lod,
                  uint32_t steps, struct morph_survey *out)
{
    CORE_ASSERT(lod < SPECIES_LOD_COUNT);
    CORE_ASSERT(steps >= 1);
    CORE_ASSERT(rig->key_count == species->card.key_count);
    static struct morph_walk walk;
    struct morph_walk *w = &walk;
    memset(w, 0, sizeof *w);
    *out = (struct morph_survey){ .weight_min = FLT_MAX, .drawn_weight_min = FLT_MAX };
    w->species = species;
    w->mesh = &species->lod[lod];
    w->rig = rig;
    w->out = out;
    morph_inside_find_roots(w);
    measure_keys(w);
    uint32_t key = 0;
    for (uint32_t i = 0; i <= steps; i++) {
        const float progress = (float)i / (float)steps;
        for (; key < rig->key_count && key_progress(w, key) <= progress; key++) {
            if (key_progress(w, key) < progress) {
                measure_moment(w, key_progress(w, key));
            }
        }
        measure_moment(w, progress);
    }
    for (key = 0; key < rig->key_count; key++) {
        out->keys_alone += w->key_alone[key];
    }
    measure_ages(w, steps);
    out->dorsal_root = measure_path(w, PART_DORSAL, SIDE_MIDDLE, steps);
    out->eye_right = measure_path(w, PART_EYE, SIDE_RIGHT, steps);
    out->eye_left = measure_path(w, PART_EYE, SIDE_LEFT, steps);
}
