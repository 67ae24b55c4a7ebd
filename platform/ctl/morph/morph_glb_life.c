/* morph_glb_life.c -- writes the glTF animation of a fish's growth: the size, the weights of the
 * keys, and the joints.
 *
 * The animation is a table of samples with linear interpolation. Samples are closer together where
 * a value changes nonlinearly, so that the error is at most TOLERANCE everywhere. */
#include <stdlib.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/ctl/lib/piecewise_fit.h"
#include "platform/ctl/morph/glb.h"

/* Maximum error of a weight, of the relative size, and of an anchor's position in body lengths. */
#define TOLERANCE 1e-5f
/* The first samples divide the life into this number of equal intervals. With fewer samples, a
 * short change of a value could be missed. */
#define EVEN_MARKS 32u
#define MARK_ROOM (EVEN_MARKS + 1u + MORPH_CURVE_MAX * GRAPH_KNOT_MAX)
/* Number of floats for an anchor: three for the position and four for the rotation quaternion. */
#define ANCHOR_WIDTH 7u

static void sample_size(const void *self, float progress, float *values)
{
    const struct morph_glb *fish = self;
    values[0] = values[1] = values[2] = life_length_m(&fish->pick->fish->card, progress);
}

static float relative_size_error(const void *self, const float *from, const float *to,
                                 const float *exact)
{
    (void)self;
    return f_abs(0.5f * (from[0] + to[0]) / exact[0] - 1.0f);
}

struct weight_list {
    const struct morph_rig *rig;
    const struct target_list *targets;
};

static void sample_weights(const void *self, float progress, float *values)
{
    const struct weight_list *list = self;
    float weights[MORPH_CURVE_MAX][MORPH_KEY_MAX];
    for (uint32_t curve = 0; curve < list->rig->curve_count; curve++) {
        graph_weights(&list->rig->curves[curve], list->rig->key_count, progress, weights[curve]);
    }
    for (uint32_t t = 0; t < list->targets->count; t++) {
        values[t] = weights[list->targets->curve[t]][list->targets->key[t]];
    }
}

static float weight_error(const void *self, const float *from, const float *to, const float *exact)
{
    const struct weight_list *list = self;
    float error = 0.0f;
    for (uint32_t t = 0; t < list->targets->count; t++) {
        error = f_max(error, f_abs(0.5f * (from[t] + to[t]) - exact[t]));
    }
    return error;
}

static void sample_anchors(const void *self, float progress, float *values)
{
    static struct morph_pose pose;
    const struct morph_glb *fish = self;
    morph_pose(&fish->pick->rig, fish->mesh, progress, &pose);
    for (uint32_t i = 0; i < fish->mesh->anchor_count; i++) {
        memcpy(&values[ANCHOR_WIDTH * i], &pose.anchor[i].position, 3 * sizeof *values);
        memcpy(&values[ANCHOR_WIDTH * i + 3], &pose.anchor[i].turn, 4 * sizeof *values);
    }
}

/* Returns the sign (1 or -1) by which the quaternion `b` must be multiplied to lie in the same
 * hemisphere as `a`. The quaternions q and -q are the same rotation. */
static float morph_glb_life_side_of(const float *a, const float *b)
{
    const float dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
    return dot < 0.0f ? -1.0f : 1.0f;
}

/* Returns the error if the mean of two rotations replaces the rotation `exact`. The mean of the two
 * quaternions is normalized before the comparison. */
static float turn_error(const float *from, const float *to, const float *exact)
{
    const float side = morph_glb_life_side_of(from, to),
                exact_side = morph_glb_life_side_of(from, exact);
    float middle[4], length = 0.0f, error = 0.0f;
    for (uint32_t i = 0; i < 4; i++) {
        middle[i] = 0.5f * (from[i] + side * to[i]);
        length += middle[i] * middle[i];
    }
    length = f_max(f_sqrt(length), 1e-6f);
    for (uint32_t i = 0; i < 4; i++) {
        error = f_max(error, f_abs(middle[i] / length - exact_side * exact[i]));
    }
    return error;
}

static float anchor_error(const void *self, const float *from, const float *to, const float *exact)
{
    const struct morph_glb *fish = self;
    float error = 0.0f;
    for (uint32_t i = 0; i < fish->mesh->anchor_count; i++) {
        const uint32_t at = ANCHOR_WIDTH * i;
        for (uint32_t k = at; k < at + 3; k++) {
            error = f_max(error, f_abs(0.5f * (from[k] + to[k]) - exact[k]));
        }
        if (fish->mesh->anchors[i].turns) {
            error = f_max(error, turn_error(&from[at + 3], &to[at + 3], &exact[at + 3]));
        }
    }
    return error;
}

static bool fit_life_track(const struct morph_glb *fish, struct piecewise_fit *track,
                           struct piecewise_fit_function function)
{
    float marks[MARK_ROOM];
    /* The first samples are at equal distances. A sample at every knot of the deformation graph is
     * then inserted in rising order. */
    const struct morph_rig *rig = &fish->pick->rig;
    uint32_t count = 0;
    for (uint32_t i = 0; i <= EVEN_MARKS; i++) {
        marks[count++] = (float)i / (float)EVEN_MARKS;
    }
    for (uint32_t curve = 0; curve < rig->curve_count; curve++) {
        for (uint32_t knot = 0; knot < rig->curves[curve].knot_count; knot++) {
            const float at = rig->curves[curve].knots[knot].progress;
            uint32_t place = 0;
            while (place < count && marks[place] < at) {
                place++;
            }
            if (place == count || marks[place] == at) {
                continue;
            }
            memmove(&marks[place + 1], &marks[place], (count - place) * sizeof *marks);
            marks[place] = at;
            count++;
        }
    }
    return piecewise_fit_fit(track, &function, marks, count, TOLERANCE);
}

/* ---- Writing to the file --------------------------------------------------------------------- */

static uint32_t add_times(struct morph_glb *fish, const struct piecewise_fit *track)
{
    for (uint32_t i = 0; i < track->count; i++) {
        track->progress[i] *= GLB_SECONDS;
    }
    return glb_array(&fish->file, GLB_FOR_TIMES, GLB_SCALAR, track->progress, track->count);
}

static uint32_t add_sampler(struct morph_glb *fish, uint32_t times, enum glb_type type,
                            const float *values, uint32_t count)
{
    const uint32_t output = glb_array(&fish->file, GLB_FOR_DATA, type, values, count);
    const uint32_t sampler = glb_next(&fish->file, GLB_SAMPLERS);
    json_print(&fish->file.lists[GLB_SAMPLERS], "{input: %u, output: %u, interpolation: %s}", times,
               output, "LINEAR");
    return sampler;
}

static void add_channel(struct morph_glb *fish, uint32_t sampler, uint32_t node, const char *path)
{
    glb_next(&fish->file, GLB_CHANNELS);
    json_print(&fish->file.lists[GLB_CHANNELS], "{sampler: %u, target: {node: %u, path: %s}}",
               sampler, node, path);
}

/* Copies `width` columns of the samples to `out`, from the column `column` on. A quaternion is
 * negated if necessary, so that neighbouring samples lie in the same hemisphere. */
static void pick_column(const struct piecewise_fit *track, uint32_t column, uint32_t width,
                        float *out)
{
    CORE_ASSERT(column + width <= track->width);
    CORE_ASSERT(width == 3 || width == 4);
    for (uint32_t i = 0; i < track->count; i++) {
        const float *from = &track->values[(size_t)i * track->width + column];
        float *to = &out[width * i];
        const float side = width == 4 && i > 0 ? morph_glb_life_side_of(to - 4, from) : 1.0f;
        for (uint32_t k = 0; k < width; k++) {
            to[k] = side * from[k];
        }
    }
}

static bool animate_anchors(struct morph_glb *fish)
{
    struct piecewise_fit track;
    if (fish->mesh->anchor_count == 0) {
        return true;
    }
    if (!fit_life_track(fish, &track,
                        (struct piecewise_fit_function){ ANCHOR_WIDTH * fish->mesh->anchor_count,
                                                         sample_anchors, anchor_error, fish })) {
        return false;
    }
    const uint32_t times = add_times(fish, &track);
    const uint32_t first = GLB_PIECE_NODE + fish->cut.piece_count;
    float *column = malloc((size_t)track.count * 4u * sizeof *column);
    for (uint32_t i = 0; column && i < fish->mesh->anchor_count; i++) {
        pick_column(&track, ANCHOR_WIDTH * i, 3, column);
        const uint32_t places = add_sampler(fish, times, GLB_VEC3, column, track.count);
        add_channel(fish, places, first + i, "translation");
        if (fish->mesh->anchors[i].turns) {
            pick_column(&track, ANCHOR_WIDTH * i + 3, 4, column);
            const uint32_t turns = add_sampler(fish, times, GLB_VEC4, column, track.count);
            add_channel(fish, turns, first + i, "rotation");
        }
    }
    free(column);
    const bool good = column != NULL;
    piecewise_fit_free(&track);
    return good;
}

bool morph_glb_animate(struct morph_glb *fish)
{
    CORE_ASSERT(fish->mesh->anchor_count <= ANCHOR_MAX);
    CORE_ASSERT(fish->cut.piece_count <= PIECE_MAX);
    struct piecewise_fit track;
    if (!fit_life_track(
            fish, &track,
            (struct piecewise_fit_function){ 3, sample_size, relative_size_error, fish })) {
        return false;
    }
    const uint32_t size_sampler =
        add_sampler(fish, add_times(fish, &track), GLB_VEC3, track.values, track.count);
    add_channel(fish, size_sampler, GLB_ROOT_NODE, "scale");
    piecewise_fit_free(&track);
    /* Index + 1 of the sampler for each bit mask of curves. 0 means that the sampler was not
     * written yet. */
    uint32_t samplers[1u << MORPH_CURVE_MAX] = { 0 };
    for (uint32_t piece = 0; piece < fish->cut.piece_count; piece++) {
        const struct weight_list list = { &fish->pick->rig, &fish->targets[piece] };
        uint32_t *sampler = &samplers[list.targets->curves];
        if (*sampler == 0) {
            if (!fit_life_track(fish, &track,
                                (struct piecewise_fit_function){
                                    list.targets->count, sample_weights, weight_error, &list })) {
                return false;
            }
            const uint32_t times = add_times(fish, &track);
            *sampler =
                1u + add_sampler(fish, times, GLB_SCALAR, track.values, track.count * track.width);
            piecewise_fit_free(&track);
        }
        add_channel(fish, *sampler - 1u, GLB_PIECE_NODE + piece, "weights");
    }
    return animate_anchors(fish);
}
