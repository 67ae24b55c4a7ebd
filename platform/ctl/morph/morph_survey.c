/* morph_survey.c -- measures many moments of a fish's growth, and records the worst value of each
 * kind of error. */
#include "platform/ctl/morph/morph_survey.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/ctl/morph/morph_flaws.h"
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

static void shape_at(struct morph_walk *w, float progress)
{
    w->progress = progress;
    morph_pose(w->rig, w->mesh, progress, &w->pose);
    morph_shape(w->mesh, w->rig->key_count, &w->pose, w->positions, w->normals);
}

static float key_progress(const struct morph_walk *w, uint32_t key)
{
    return (float)key / (float)(w->rig->key_count - 1u);
}

/* Returns the z coordinate of the tail root, where the standard length of a fish ends. The tail
 * root is the foremost body point with u = 1. The point that closes the body also has u = 1, but is
 * farther behind. Returns `rearmost` if the body has no point with u = 1. */
static float standard_end(const struct morph_walk *w, float rearmost)
{
    float end = FLT_MAX;
    for (uint32_t i = 0; i < w->mesh->vertex_count; i++) {
        const struct species_vertex *at = &w->mesh->vertices[i];
        if (at->part == PART_BODY && at->u > 0.999f) {
            end = f_min(end, w->positions[i].z);
        }
    }
    return end < FLT_MAX ? end : rearmost;
}

static float fork_end(const struct morph_walk *w)
{
    float end = 0.0f, nearest = FLT_MAX;
    for (uint32_t i = 0; i < w->mesh->vertex_count; i++) {
        const struct species_vertex *at = &w->mesh->vertices[i];
        const float away = fabsf(at->u - 0.5f) + fabsf(at->v - 1.0f);
        if (at->part == PART_TAIL && away < nearest) {
            nearest = away;
            end = w->positions[i].z;
        }
    }
    return end;
}

static void measure_keys(struct morph_walk *w)
{
    for (uint32_t key = 0; key < w->rig->key_count; key++) {
        w->progress = key_progress(w, key);
        morph_key_pose(w->mesh, w->rig->key_count, key, &w->pose);
        morph_shape(w->mesh, w->rig->key_count, &w->pose, w->positions, w->normals);
        morph_skin_build(&w->body, w->mesh, w->positions, PART_BODY, SIDE_MIDDLE);
        w->key_volume[key] = morph_skin_volume(&w->body);
        const enum species_measure measure = (enum species_measure)w->species->card.measure;
        vec3 low = { FLT_MAX, 0.0f, FLT_MAX }, high = { -FLT_MAX, 0.0f, -FLT_MAX };
        float end = -FLT_MAX;
        for (uint32_t i = 0; i < w->mesh->vertex_count; i++) {
            const uint8_t part = w->mesh->vertices[i].part;
            const vec3 p = w->positions[i];
            if (part == PART_BODY) {
                low = v3(f_min(low.x, p.x), 0.0f, f_min(low.z, p.z));
                high = v3(f_max(high.x, p.x), 0.0f, f_max(high.z, p.z));
            }
            end = part == PART_BODY || part == PART_TAIL ? f_max(end, p.z) : end;
        }
        const float length = measure == MEASURE_TOTAL      ? end + 0.5f
                             : measure == MEASURE_STANDARD ? standard_end(w, high.z) + 0.5f
                             : measure == MEASURE_FORK     ? fork_end(w) + 0.5f
                                                           : high.x - low.x;
        morph_walk_keep(w, &w->out->size_error, fabsf(length - 1.0f), MORPH_SURVEY_NOWHERE);
        morph_walk_keep(w, &w->out->size_error, fabsf(low.z + 0.5f), MORPH_SURVEY_NOWHERE);
    }
    w->out->volume_first = w->key_volume[0];
    w->out->volume_last = w->key_volume[w->rig->key_count - 1u];
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
    morph_inside_build_skins(w);
    morph_inside_measure(w);
    const uint32_t last = w->rig->key_count - 1u;
    const uint32_t key = (uint32_t)fminf(w->progress * (float)last, (float)(last - 1u));
    const float least = f_min(w->key_volume[key], w->key_volume[key + 1u]);
    const float dip = 1.0f - morph_skin_volume(&w->body) / least;
    morph_walk_keep(w, &w->out->volume_dip, dip, MORPH_SURVEY_NOWHERE);
}

static vec3 morph_survey_place_of(struct morph_walk *w, uint32_t vertex, float progress)
{
    shape_at(w, progress);
    return w->positions[vertex];
}

static void measure_path(struct morph_walk *w, enum species_part part, enum species_side side,
                         uint32_t steps, struct curvature *out)
{
    CORE_ASSERT(steps >= 1);
    const uint32_t vertex = part_vertex_range(w->mesh, part, side);
    *out = (struct curvature){ .vertex = MORPH_SURVEY_NOWHERE };
    if (vertex == w->mesh->vertex_count) {
        return;
    }
    out->vertex = vertex;
    const vec3 from = morph_survey_place_of(w, vertex, 0.0f),
               to = morph_survey_place_of(w, vertex, 1.0f);
    for (uint32_t i = 0; i <= steps; i++) {
        const vec3 p = morph_survey_place_of(w, vertex, (float)i / (float)steps);
        out->from_chord = f_max(out->from_chord, v3_from_line(p, from, to));
    }
}

/* ---- Ages and lengths ------------------------------------------------------------------------ */

/* This section checks the conversions between age, progress and length over the whole life of a
 * fish. */

/* ---- Survey of a whole life ------------------------------------------------------------------ */

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
    const struct species_card *card = &w->species->card;
    float before_days = -1.0f;
    for (uint32_t i = 0; i <= steps; i++) {
        w->progress = (float)i / (float)steps;
        const float age_days = life_age_days(card, w->progress);
        /* The fish must be older at each moment than at the previous moment. */
        if (!(age_days > before_days)) {
            w->out->age_stands_at =
                w->out->moments_not_older == 0 ? w->progress : w->out->age_stands_at;
            w->out->moments_not_older++;
        }
        /* The fish's length is compared with the growth curve at its age, unless the author of the
         * species drew the sizes. */
        const float length_m = life_length_m(card, w->progress);
        const float again_m = life_length_m(card, morph_progress(card, length_m));
        morph_walk_keep(w, &w->out->length_lost, fabsf(again_m / length_m - 1.0f),
                        MORPH_SURVEY_NOWHERE);
        if (card->scale_knot_count == 0) {
            const float grown_m = growth_length_m(&card->growth, age_days);
            morph_walk_keep(w, &w->out->off_growth, fabsf(length_m / grown_m - 1.0f),
                            MORPH_SURVEY_NOWHERE);
        }
        const float back = fabsf(life_progress(card, age_days) - w->progress);
        morph_walk_keep(w, &w->out->progress_lost, back, MORPH_SURVEY_NOWHERE);
        before_days = age_days;
    }
    measure_path(w, PART_DORSAL, SIDE_MIDDLE, steps, &out->dorsal_root);
    measure_path(w, PART_EYE, SIDE_RIGHT, steps, &out->eye_right);
    measure_path(w, PART_EYE, SIDE_LEFT, steps, &out->eye_left);
}
