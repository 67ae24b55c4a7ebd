/* morph_survey.c -- measures many moments of a fish's growth, and records the worst value of each
 * kind of error. */
#include "platform/ctl/morph/morph_survey.h"

#include <float.h>
#include <math.h>
#include <string.h>

#include "platform/ctl/morph/morph_walk.h"
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

static void measure_weights(struct morph_walk *w)
{
    for (uint32_t curve = 0; curve < w->rig->curve_count; curve++) {
        float graph[MORPH_KEY_MAX];
        graph_weights(&w->rig->curves[curve], w->rig->key_count, w->progress, graph);
        measure_sum(graph, &w->out->sum_error, &w->out->weight_min);
        measure_sum(w->pose.weight[curve], &w->out->drawn_sum_error, &w->out->drawn_weight_min);
    }
}

/* Returns the key to which all curves give the weight 1 at the present moment, or MORPH_KEY_MAX if
 * there is no such key. */
static uint32_t lone_key(const struct morph_walk *w)
{
    for (uint32_t key = 0; key < w->rig->key_count; key++) {
        bool alone = true;
        for (uint32_t curve = 0; curve < w->rig->curve_count; curve++) {
            alone = alone && w->pose.weight[curve][key] == 1.0f;
        }
        if (alone) {
            return key;
        }
    }
    return MORPH_KEY_MAX;
}

static void measure_key(struct morph_walk *w)
{
    const uint32_t key = lone_key(w);
    if (key == MORPH_KEY_MAX) {
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

static void measure_volume(struct morph_walk *w)
{
    const uint32_t last = w->rig->key_count - 1u;
    const uint32_t key = (uint32_t)fminf(w->progress * (float)last, (float)(last - 1u));
    const float least = f_min(w->key_volume[key], w->key_volume[key + 1u]);
    const float dip = 1.0f - morph_skin_volume(&w->body) / least;
    morph_walk_keep(w, &w->out->volume_dip, dip, MORPH_SURVEY_NOWHERE);
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

static void measure_size(struct morph_walk *w, enum species_measure measure)
{
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

static void measure_keys(struct morph_walk *w)
{
    for (uint32_t key = 0; key < w->rig->key_count; key++) {
        w->progress = key_progress(w, key);
        morph_key_pose(w->mesh, w->rig->key_count, key, &w->pose);
        morph_shape(w->mesh, w->rig->key_count, &w->pose, w->positions, w->normals);
        morph_skin_build(&w->body, w->mesh, w->positions, PART_BODY, SIDE_MIDDLE);
        w->key_volume[key] = morph_skin_volume(&w->body);
        measure_size(w, (enum species_measure)w->species->card.measure);
    }
    w->out->volume_first = w->key_volume[0];
    w->out->volume_last = w->key_volume[w->rig->key_count - 1u];
}

static void measure_moment(struct morph_walk *w, float progress)
{
    shape_at(w, progress);
    measure_weights(w);
    measure_key(w);
    morph_flips_measure(w);
    morph_inside_build_skins(w);
    morph_inside_measure(w);
    measure_volume(w);
}

static vec3 morph_survey_place_of(struct morph_walk *w, uint32_t vertex, float progress)
{
    shape_at(w, progress);
    return w->positions[vertex];
}

static void measure_path(struct morph_walk *w, enum species_part part, enum species_side side,
                         uint32_t steps, struct curvature *out)
{
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

void morph_survey(const struct species *species, const struct morph_rig *rig, uint32_t lod,
                  uint32_t steps, struct morph_survey *out)
{
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
    morph_ages_measure(w, steps);
    measure_path(w, PART_DORSAL, SIDE_MIDDLE, steps, &out->dorsal_root);
    measure_path(w, PART_EYE, SIDE_RIGHT, steps, &out->eye_right);
    measure_path(w, PART_EYE, SIDE_LEFT, steps, &out->eye_left);
}
