/* morph_glb.c -- a whole life as one glTF 2.0 file: nodes, skin and animation.
 *
 * The scene: a node for the fish (its size is that node's animated scale; it faces +z as glTF's
 * things do) with the body under it, and a mesh for every other part. What rides on the skin is
 * skinned in glTF's sense: a joint an anchor, under the fish, each vertex on one joint alone. glTF
 * blends first and moves by joints then, as morph_shape() does, so the file is our formula and no
 * approximation; nodes instead of joints would not do, since a fin's rays have an anchor each and
 * share triangles.
 *
 * The animation "growth" runs SECONDS from progress 0 to 1: the graph's own weights (of solved
 * shapes where the graph is solved, so they stay in [0, 1]), size, and joints. Samples are dense
 * where something bends; between them everything is within TOLERANCE. */
#include "platform/ctl/morph_glb.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/ctl/plate.h"
#include "platform/ctl/track.h"

#define SECONDS 10.0f
#define TOLERANCE 1e-5f    /* Of a weight, of size as a ratio, of an anchor's place in lengths. */
#define EVEN_MARKS 32u
#define MARK_ROOM (EVEN_MARKS + 1u + MORPH_CURVE_MAX * GRAPH_KNOT_MAX)
#define ANCHOR_WIDTH 7u    /* Place and turn. */
#define ROOT_NODE 0u
#define NAME_SIZE 2048u    /* A list of PIECE_MAX node numbers, and to spare. */

static const char command[] = "export";

static struct fish_glb fish; /* Too large for a stack; one export at a time. */

/* ---- What is animated ------------------------------------------------------------------------ */

static void ask_size(const void *self, float progress, float *values)
{
    (void)self;
    values[0] = values[1] = values[2] = life_length_m(&fish.pick->fish->card, progress);
}

static float size_error(const void *self, const float *from, const float *to, const float *exact)
{
    (void)self;
    return f_abs(0.5f * (from[0] + to[0]) / exact[0] - 1.0f);
}

static void ask_weights(const void *self, float progress, float *values)
{
    const struct target_list *list = self;
    float weights[MORPH_CURVE_MAX][MORPH_KEY_MAX];
    for (uint32_t curve = 0; curve < fish.pick->rig.curve_count; curve++) {
        graph_weights(&fish.pick->rig.curves[curve], fish.pick->rig.key_count, progress,
                      weights[curve]);
    }
    for (uint32_t t = 0; t < list->count; t++) {
        values[t] = weights[list->curve[t]][list->key[t]];
    }
}

static float weight_error(const void *self, const float *from, const float *to,
                          const float *exact)
{
    const struct target_list *list = self;
    float error = 0.0f;
    for (uint32_t t = 0; t < list->count; t++) {
        error = f_max(error, f_abs(0.5f * (from[t] + to[t]) - exact[t]));
    }
    return error;
}

static void ask_anchors(const void *self, float progress, float *values)
{
    static struct morph_pose pose;
    (void)self;
    morph_pose(&fish.pick->rig, fish.mesh, progress, &pose);
    for (uint32_t i = 0; i < fish.mesh->anchor_count; i++) {
        memcpy(&values[ANCHOR_WIDTH * i], &pose.anchor[i].position, 3 * sizeof *values);
        memcpy(&values[ANCHOR_WIDTH * i + 3], &pose.anchor[i].turn, 4 * sizeof *values);
    }
}

/* q and -q are the same turn: `b` so that it lies on the side of `a`. */
static float side_of(const float *a, const float *b)
{
    const float dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
    return dot < 0.0f ? -1.0f : 1.0f;
}

/* A turn's middle is not that of its numbers, but of their direction: the mean is made unit. */
static float turn_error(const float *from, const float *to, const float *exact)
{
    const float side = side_of(from, to), exact_side = side_of(from, exact);
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

static float anchor_error(const void *self, const float *from, const float *to,
                          const float *exact)
{
    float error = 0.0f;
    (void)self;
    for (uint32_t i = 0; i < fish.mesh->anchor_count; i++) {
        const uint32_t at = ANCHOR_WIDTH * i;
        for (uint32_t k = at; k < at + 3; k++) {
            error = f_max(error, f_abs(0.5f * (from[k] + to[k]) - exact[k]));
        }
        if (fish.mesh->anchors[i].turns) {
            error = f_max(error, turn_error(&from[at + 3], &to[at + 3], &exact[at + 3]));
        }
    }
    return error;
}

/* Steps that are fine enough to see every bend, and every knot exactly. */
static uint32_t make_marks(float marks[MARK_ROOM])
{
    const struct morph_rig *rig = &fish.pick->rig;
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
    return count;
}

static bool fit(struct track *track, struct track_function function)
{
    float marks[MARK_ROOM];
    const uint32_t count = make_marks(marks);
    return track_fit(track, &function, marks, count, TOLERANCE);
}

/* ---- Into the file --------------------------------------------------------------------------- */

static uint32_t add_times(const struct track *track)
{
    for (uint32_t i = 0; i < track->count; i++) {
        track->progress[i] *= SECONDS;
    }
    return glb_floats(&fish.file, GLB_FOR_TIMES, GLB_SCALAR, track->progress, track->count);
}

static uint32_t add_sampler(uint32_t times, enum glb_type type, const float *values,
                            uint32_t count)
{
    const uint32_t output = glb_floats(&fish.file, GLB_FOR_DATA, type, values, count);
    const uint32_t sampler = glb_next(&fish.file, GLB_SAMPLERS);
    bytes_print(&fish.file.lists[GLB_SAMPLERS],
                "{\"input\":%u,\"output\":%u,\"interpolation\":\"LINEAR\"}", times, output);
    return sampler;
}

static void add_channel(uint32_t sampler, uint32_t node, const char *path)
{
    glb_next(&fish.file, GLB_CHANNELS);
    bytes_print(&fish.file.lists[GLB_CHANNELS],
                "{\"sampler\":%u,\"target\":{\"node\":%u,\"path\":\"%s\"}}", sampler, node, path);
}

static bool animate_size(void)
{
    struct track track;
    const bool good = fit(&track, (struct track_function){ 3, ask_size, size_error, NULL });
    if (good) {
        const uint32_t times = add_times(&track);
        add_channel(add_sampler(times, GLB_VEC3, track.values, track.count), ROOT_NODE, "scale");
        track_free(&track);
    }
    return good;
}

static bool animate_weights(void)
{
    uint32_t samplers[1u << MORPH_CURVE_MAX] = { 0 }; /* By the curves they tell; from 1. */
    for (uint32_t piece = 0; piece < fish.cut.piece_count; piece++) {
        const struct target_list *list = &fish.targets[piece];
        uint32_t *sampler = &samplers[list->curves];
        if (*sampler == 0) {
            struct track track;
            if (!fit(&track, (struct track_function){ list->count, ask_weights, weight_error,
                                                      list })) {
                return false;
            }
            const uint32_t times = add_times(&track);
            *sampler =
                1u + add_sampler(times, GLB_SCALAR, track.values, track.count * track.width);
            track_free(&track);
        }
        add_channel(*sampler - 1u, 1u + piece, "weights");
    }
    return true;
}

/* `column` to `column + width` of the track, a turn never jumping to its other sign. */
static void pick_column(const struct track *track, uint32_t column, uint32_t width, float *out)
{
    for (uint32_t i = 0; i < track->count; i++) {
        const float *from = &track->values[(size_t)i * track->width + column];
        float *to = &out[width * i];
        const float side = width == 4 && i > 0 ? side_of(to - 4, from) : 1.0f;
        for (uint32_t k = 0; k < width; k++) {
            to[k] = side * from[k];
        }
    }
}

static bool add_anchor_channels(const struct track *track, uint32_t times)
{
    const uint32_t first = 1u + fish.cut.piece_count;
    float *column = malloc((size_t)track->count * 4u * sizeof *column);
    for (uint32_t i = 0; column && i < fish.mesh->anchor_count; i++) {
        pick_column(track, ANCHOR_WIDTH * i, 3, column);
        add_channel(add_sampler(times, GLB_VEC3, column, track->count), first + i, "translation");
        if (fish.mesh->anchors[i].turns) {
            pick_column(track, ANCHOR_WIDTH * i + 3, 4, column);
            add_channel(add_sampler(times, GLB_VEC4, column, track->count), first + i,
                        "rotation");
        }
    }
    free(column);
    return column != NULL;
}

static bool animate_anchors(void)
{
    struct track track;
    if (fish.mesh->anchor_count == 0) {
        return true;
    }
    if (!fit(&track, (struct track_function){ ANCHOR_WIDTH * fish.mesh->anchor_count, ask_anchors,
                                              anchor_error, NULL })) {
        return false;
    }
    const bool good = add_anchor_channels(&track, add_times(&track));
    track_free(&track);
    return good;
}

/* ---- Nodes ----------------------------------------------------------------------------------- */

/* What the numbers of the file mean in life. */
static void print_life(struct bytes *out)
{
    const struct species_card *card = &fish.pick->fish->card;
    bytes_print(out, "\"extras\":{\"species\":\"%s\",\"measure\":\"%s\",\"template\":\"%s\","
                     "\"thesis\":%s,\"seconds\":%g,\"keys\":[", card->id, plate_measure(card),
                morph_template_name(fish.pick->template), fish.pick->thesis ? "true" : "false",
                (double)SECONDS);
    for (uint32_t i = 0; i < card->key_count; i++) {
        bytes_print(out, "%s{\"name\":\"%s\",\"progress\":%.6g,", i > 0 ? "," : "",
                    card->key_names[i], (double)i / (card->key_count - 1u));
        bytes_print(out, "\"age_days\":%.6g,\"length_m\":%.6g}", (double)card->key_age_days[i],
                    (double)card->key_length_m[i]);
    }
    bytes_print(out, "]}");
}

static void add_root(void)
{
    struct bytes *out = &fish.file.lists[GLB_NODES];
    const double size = (double)life_length_m(&fish.pick->fish->card, 1.0f);
    glb_next(&fish.file, GLB_NODES);
    bytes_print(out, "{\"name\":\"%s\",\"rotation\":[0,1,0,0],\"scale\":[%.9g,%.9g,%.9g],",
                fish.pick->fish->card.id, size, size, size);
    const char *comma = "\"children\":[";
    for (uint32_t i = 0; i < fish.cut.piece_count; i++) {
        if (!fish.skinned[i]) {
            bytes_print(out, "%s%u", comma, 1u + i);
            comma = ",";
        }
    }
    for (uint32_t i = 0; i < fish.mesh->anchor_count; i++) {
        bytes_print(out, "%s%u", comma, 1u + fish.cut.piece_count + i);
        comma = ",";
    }
    bytes_print(out, "],");
    print_life(out);
    bytes_print(out, "}");
}

static void add_piece(uint32_t piece, uint32_t mesh)
{
    char name[PIECE_NAME_SIZE];
    morph_piece_name(&fish.cut.pieces[piece], name);
    glb_next(&fish.file, GLB_NODES);
    bytes_print(&fish.file.lists[GLB_NODES], "{\"name\":\"%s\",\"mesh\":%u%s}", name, mesh,
                fish.skinned[piece] ? ",\"skin\":0" : "");
}

static void add_joint(uint32_t anchor)
{
    const struct anchor_pose *at = &fish.adult.anchor[anchor];
    glb_next(&fish.file, GLB_NODES);
    bytes_print(&fish.file.lists[GLB_NODES],
                "{\"name\":\"anchor_%u\",\"translation\":[%.9g,%.9g,%.9g],"
                "\"rotation\":[%.9g,%.9g,%.9g,%.9g]}", anchor, (double)at->position.x,
                (double)at->position.y, (double)at->position.z, (double)at->turn.x,
                (double)at->turn.y, (double)at->turn.z, (double)at->turn.w);
}

/* The way back from where an anchor is at progress 1, as glTF writes matrices: column by column. */
static void inverse_bind(const struct anchor_pose *at, float out[16])
{
    const vec3 axes[3] = { v3(1.0f, 0.0f, 0.0f), v3(0.0f, 1.0f, 0.0f), v3(0.0f, 0.0f, 1.0f) };
    memset(out, 0, 16 * sizeof *out);
    for (uint32_t column = 0; column < 4; column++) {
        const vec3 to = column < 3 ? quat_turn_back(at->turn, axes[column])
                                   : quat_turn_back(at->turn, v3_scale(at->position, -1.0f));
        memcpy(&out[4 * column], &to, sizeof to);
    }
    out[15] = 1.0f;
}

static void add_skin(void)
{
    static float matrices[1u + ANCHOR_MAX][16];
    const struct anchor_pose here = { .turn = { 0.0f, 0.0f, 0.0f, 1.0f } };
    struct bytes *out = &fish.file.lists[GLB_SKINS];
    inverse_bind(&here, matrices[0]);
    for (uint32_t i = 0; i < fish.mesh->anchor_count; i++) {
        inverse_bind(&fish.adult.anchor[i], matrices[1u + i]);
    }
    glb_next(&fish.file, GLB_SKINS);
    bytes_print(out, "{\"name\":\"skin\",\"skeleton\":%u,\"inverseBindMatrices\":%u,"
                     "\"joints\":[%u", ROOT_NODE,
                glb_floats(&fish.file, GLB_FOR_DATA, GLB_MAT4, matrices[0],
                           1u + fish.mesh->anchor_count),
                ROOT_NODE);
    for (uint32_t i = 0; i < fish.mesh->anchor_count; i++) {
        bytes_print(out, ",%u", 1u + fish.cut.piece_count + i);
    }
    bytes_print(out, "]}");
}

static void add_nodes(char scene[NAME_SIZE])
{
    uint32_t meshes[PIECE_MAX];
    size_t used = (size_t)snprintf(scene, NAME_SIZE, "%u", ROOT_NODE);
    bool skinned = false;
    for (uint32_t i = 0; i < fish.cut.piece_count; i++) {
        meshes[i] = fish_glb_mesh(&fish, i);
    }
    add_root();
    for (uint32_t i = 0; i < fish.cut.piece_count; i++) {
        add_piece(i, meshes[i]);
        if (fish.skinned[i]) {
            /* Only joints move a skinned mesh: glTF wants it beside the fish, not under it. */
            used += (size_t)snprintf(scene + used, NAME_SIZE - used, ",%u", 1u + i);
            skinned = true;
        }
    }
    for (uint32_t i = 0; i < fish.mesh->anchor_count; i++) {
        add_joint(i);
    }
    if (skinned) {
        add_skin();
    }
}

static void begin(const struct morph_pick *pick)
{
    static vec3 positions[MESH_VERTEX_MAX], normals[MESH_VERTEX_MAX];
    memset(&fish, 0, sizeof fish);
    fish.pick = pick;
    fish.mesh = &pick->fish->lod[0];
    morph_pose(&pick->rig, fish.mesh, 1.0f, &fish.adult);
    morph_shape(fish.mesh, pick->rig.key_count, &fish.adult, positions, normals);
    morph_mesh_cut(fish.mesh, positions, normals, &fish.cut);
    for (uint32_t key = 0; key < pick->rig.key_count; key++) {
        float alone[MORPH_KEY_MAX] = { 0 };
        alone[key] = 1.0f;
        morph_mesh_paint(pick->fish, alone, &fish.cut, fish.paints[key]);
    }
}

enum exit_code morph_glb_write(const struct morph_pick *pick, const char *path)
{
    char scene[NAME_SIZE];
    begin(pick);
    add_nodes(scene);
    const bool good = animate_size() && animate_weights() && animate_anchors();
    const int error = good ? glb_write(&fish.file, path, "growth", scene) : -ENOMEM;
    glb_free(&fish.file);
    return error ? morph_fail(EXIT_IO, command, "%.900s: %s", path, strerror(-error)) : EXIT_OK;
}
