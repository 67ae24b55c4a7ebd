/* morph_glb_mesh.c -- writes a piece of the fish as a glTF mesh. The base of the mesh is the shape
 * of the last key, and the morph targets are the displacements to the other keys. */
#include <string.h>

#include "core/base/panic.h"
#include "platform/ctl/lib/fish_preview.h"
#include "platform/ctl/morph/glb.h"
#include "platform/species/part.h"

/* ---- Colours of the vertices ----------------------------------------------------------------- */

/* This section computes the position, the normal and the colour of a vertex in each shape of a glTF
 * mesh. The shapes are the base and the morph targets.
 *
 * Symbols: c is a curve of the deformation graph, k is a key (growth stage), and "last" is the last
 * key. m_c is the share of curve c in the motion of the vertex. V_ck is the weight of key k in
 * curve c. C_ck is the shape of the vertex in the solved key, or in the drawn key if no shape is
 * solved.
 *
 * Kingyo computes the vertex p = sum over c of (m_c * sum over k of (V_ck * C_ck)). The shares m_c
 * have the sum 1. For each curve, the weights V_ck have the sum 1 and are >= 0.
 *
 * A glTF viewer computes the vertex p = B + sum over the morph targets t of (w_t * D_t), with the
 * base B, the weight w_t and the displacement D_t. The file therefore contains the base B = sum
 * over c of (m_c * C_c,last). For each curve c and each key k except the last, the file contains
 * one morph target with D = m_c * (C_ck - C_c,last) and w = V_ck. With these values, the viewer's p
 * equals Kingyo's p, and every weight is in [0, 1].
 *
 * Colours are morph targets too (COLOR_0, linear). A viewer that does not blend colours shows
 * the colours of the last key. The alpha of a transparent body is written, but the material of
 * the body is opaque, because many viewers draw transparent bodies with errors. Fins use alpha
 * blending. */

/* Attributes of one vertex in one shape of the fish. */
struct aspect {
    vec3 position, normal, colour;
    float hides;
};

/* Returns the share, in [0, 1], with which curve `curve` moves the vertex. The shares of curves
 * that the rig does not have are added to curve 0. */
static float share_of(const struct morph_glb *fish, uint32_t vertex, uint32_t curve)
{
    CORE_ASSERT(vertex < fish->mesh->vertex_count);
    CORE_ASSERT(curve < MORPH_CURVE_MAX);
    uint32_t share = 0;
    for (uint32_t i = 0; i < MORPH_CURVE_MAX; i++) {
        if (i == curve || (curve == 0 && i >= fish->pick->rig.curve_count)) {
            share += fish->mesh->vertices[vertex].mask[i];
        }
    }
    return (float)share / 255.0f;
}

static void add_aspect(struct aspect *sum, const struct aspect *look, float weight)
{
    sum->position = v3_muladd(sum->position, look->position, weight);
    sum->normal = v3_muladd(sum->normal, look->normal, weight);
    sum->colour = v3_muladd(sum->colour, look->colour, weight);
    sum->hides += look->hides * weight;
}

/* Returns C_ck (defined in the section comment above) for one vertex. */
static struct aspect solved_aspect(const struct morph_glb *fish, uint32_t vertex, uint32_t curve,
                                   uint32_t key)
{
    CORE_ASSERT(key < fish->pick->rig.key_count);
    struct aspect sum = { .hides = 0.0f };
    for (uint32_t j = 0; j < fish->pick->rig.key_count; j++) {
        /* The core blends the normals of keys on the octahedron |x| + |y| + |z| = 1 (see struct
         * morph_pose). */
        const vec3 n = morph_normal(fish->mesh->points[j][vertex].normal);
        struct aspect drawn = {
            .position = morph_position(fish->mesh, j, vertex),
            .normal = v3_scale(n, 1.0f / (f_abs(n.x) + f_abs(n.y) + f_abs(n.z))),
        };
        /* The colour is linear, as glTF requires for vertex colours. */
        const struct paint *paint = &fish->paints[j][vertex];
        drawn.colour = canvas_linear(paint->colour);
        drawn.hides = fish_preview_hides(paint, &fish->mesh->vertices[vertex]);
        add_aspect(&sum, &drawn, fish->pick->rig.solution[curve][key][j]);
    }
    return sum;
}

/* Moves a vertex with an anchor to its position at progress 1, so that a viewer without skinning
 * shows a complete fish. In a viewer with skinning, the inverse bind matrix of the joint reverses
 * this move. */
static void carry(const struct morph_glb *fish, uint32_t vertex, bool is_place, struct aspect *look)
{
    const uint8_t anchor = fish->mesh->vertices[vertex].anchor;
    if (anchor != ANCHOR_NONE) {
        const struct anchor_pose *at = &fish->adult.anchor[anchor];
        look->position = pose_rotate(at->turn, look->position);
        look->normal = pose_rotate(at->turn, look->normal);
        if (is_place) {
            look->position = v3_add(look->position, at->position);
        }
    }
}

/* Returns the base B of a vertex. A vertex with an anchor has its position at progress 1. */
static struct aspect base_appearance(const struct morph_glb *fish, uint32_t vertex)
{
    const uint32_t last = fish->pick->rig.key_count - 1u;
    /* The colours depend only on the curve of the whole fish, which has the index 0. */
    const struct aspect painted = solved_aspect(fish, vertex, 0, last);
    struct aspect sum = { .hides = 0.0f };
    for (uint32_t curve = 0; curve < fish->pick->rig.curve_count; curve++) {
        const struct aspect one = solved_aspect(fish, vertex, curve, last);
        add_aspect(&sum, &one, share_of(fish, vertex, curve));
    }
    sum.colour = v3(f_clamp(painted.colour.x, 0.0f, 1.0f), f_clamp(painted.colour.y, 0.0f, 1.0f),
                    f_clamp(painted.colour.z, 0.0f, 1.0f));
    sum.hides = f_clamp(painted.hides, 0.0f, 1.0f);
    carry(fish, vertex, true, &sum);
    return sum;
}

/* Returns the displacement D of a vertex in the morph target of curve `curve` and key `key`. */
static struct aspect target_appearance(const struct morph_glb *fish, uint32_t vertex,
                                       uint32_t curve, uint32_t key)
{
    const float share = share_of(fish, vertex, curve);
    const struct aspect to = solved_aspect(fish, vertex, curve, key);
    struct aspect way = to;
    const struct aspect from = solved_aspect(fish, vertex, curve, fish->pick->rig.key_count - 1u);
    add_aspect(&way, &from, -1.0f);
    way.position = v3_scale(way.position, share);
    way.normal = v3_scale(way.normal, share);
    if (curve != 0) {
        way.colour = v3(0.0f, 0.0f, 0.0f);
        way.hides = 0.0f;
    }
    carry(fish, vertex, false, &way);
    return way;
}

/* ---- Columns of a piece ---------------------------------------------------------------------- */

/* Vertex attributes of one mesh before they are written to the file. The variable is static because
 * it is too large for a stack. */
static struct {
    uint32_t count;
    uint16_t vertices[MESH_VERTEX_MAX]; /* Vertex indices of species_mesh, in rising order. */
    /* Index in `vertices` of each vertex of species_mesh. Valid only for vertices that the piece
     * uses. */
    uint16_t place[MESH_VERTEX_MAX];
    float position[MESH_VERTEX_MAX][3], normal[MESH_VERTEX_MAX][3], colour[MESH_VERTEX_MAX][4];
    float coordinates[MESH_VERTEX_MAX][2], source[MESH_VERTEX_MAX];
    /* Length of the base normal of each vertex before normalization. */
    float facing[MESH_VERTEX_MAX];
    uint8_t joints[MESH_VERTEX_MAX][4];
    float shares[MESH_VERTEX_MAX][4]; /* Joint weights. The weights are floats, because some
                                         importers misread weights that are stored as fractions of
                                         255. */
    uint16_t indices[MESH_INDEX_MAX];
} columns;

static void write_aspect(uint32_t place, const struct aspect *look)
{
    memcpy(columns.position[place], &look->position, sizeof look->position);
    memcpy(columns.normal[place], &look->normal, sizeof look->normal);
    memcpy(columns.colour[place], &look->colour, sizeof look->colour);
    columns.colour[place][3] = look->hides;
}

static void gather_vertices(const struct morph_glb *fish, const struct morph_piece *piece)
{
    const uint16_t *corners = fish->cut.faces[piece->face_first];
    const uint32_t corner_count = 3u * piece->face_count;
    static bool taken[MESH_VERTEX_MAX];
    memset(taken, 0, sizeof taken);
    for (uint32_t i = 0; i < corner_count; i++) {
        taken[corners[i]] = true;
    }
    columns.count = 0;
    for (uint32_t i = 0; i < fish->mesh->vertex_count; i++) {
        if (taken[i]) {
            columns.place[i] = (uint16_t)columns.count;
            columns.vertices[columns.count++] = (uint16_t)i;
        }
    }
    for (uint32_t i = 0; i < corner_count; i++) {
        columns.indices[i] = columns.place[corners[i]];
    }
}

static struct target_list list_targets(const struct morph_glb *fish)
{
    struct target_list list = { .curves = 1 };
    for (uint32_t curve = 0; curve < fish->pick->rig.curve_count; curve++) {
        for (uint32_t i = 0; i < columns.count; i++) {
            if (share_of(fish, columns.vertices[i], curve) > 0.0f) {
                list.curves |= (uint8_t)(1u << curve);
            }
        }
        for (uint32_t key = 0; (list.curves >> curve & 1u) && key + 1u < fish->pick->rig.key_count;
             key++) {
            list.curve[list.count] = (uint8_t)curve;
            list.key[list.count++] = (uint8_t)key;
        }
    }
    return list;
}

/* ---- Writing to the file --------------------------------------------------------------------- */

static uint32_t material_of(struct morph_glb *fish, uint8_t part)
{
    CORE_ASSERT(part < PART_COUNT);
    const struct species_coat *coat = &fish->pick->fish->coats[fish->pick->rig.key_count - 1u];
    const bool is_fin = part >= PART_TAIL;
    const double rough = part == PART_EYE ? 0.15 : is_fin ? 0.6 : 0.7 - 0.4 * coat->shine / 255.0;
    struct json *out = &fish->file.lists[GLB_MATERIALS];
    if (fish->materials[part] == 0) {
        fish->materials[part] = 1u + glb_next(&fish->file, GLB_MATERIALS);
        json_print(out,
                   "{name: %s, pbrMetallicRoughness: {metallicFactor: %u, roughnessFactor: %.3f}",
                   part_names[part], 0u, rough);
        if (is_fin) {
            json_print(out, "alphaMode: %s, doubleSided: %hhd", "BLEND", is_fin);
        }
        json_close(out, '}');
    }
    return fish->materials[part] - 1u;
}

/* Writes a column to the file, and prints its accessor as the attribute `name` of `out`. */
static void print_column(struct morph_glb *fish, struct json *out, const char *name,
                         enum glb_use use, enum glb_type type, const void *column)
{
    json_value(out, name, "%u", glb_array(&fish->file, use, type, column, columns.count));
}

/* Writes the positions, normals and colours in `columns` to the file, and begins the JSON object
 * `key` with their accessors. The caller has filled the columns. */
static void print_shape(struct morph_glb *fish, const char *key, struct json *out)
{
    json_open(out, key, '{');
    print_column(fish, out, "POSITION", GLB_FOR_PLACES, GLB_VEC3, columns.position);
    print_column(fish, out, "NORMAL", GLB_FOR_VERTICES, GLB_VEC3, columns.normal);
    print_column(fish, out, "COLOR_0", GLB_FOR_VERTICES, GLB_VEC4, columns.colour);
}

static void print_attributes(struct morph_glb *fish, bool skinned, struct json *out)
{
    for (uint32_t i = 0; i < columns.count; i++) {
        struct aspect look = base_appearance(fish, columns.vertices[i]);
        columns.facing[i] = f_max(v3_length(look.normal), 1e-6f);
        look.normal = v3_normalize_or(look.normal, v3(0.0f, 1.0f, 0.0f));
        write_aspect(i, &look);
    }
    print_shape(fish, "attributes", out);
    print_column(fish, out, "_VERTEX", GLB_FOR_VERTICES, GLB_SCALAR, columns.source);
    print_column(fish, out, "TEXCOORD_0", GLB_FOR_VERTICES, GLB_VEC2, columns.coordinates);
    if (skinned) {
        print_column(fish, out, "WEIGHTS_0", GLB_FOR_VERTICES, GLB_VEC4, columns.shares);
        print_column(fish, out, "JOINTS_0", GLB_FOR_JOINTS, GLB_VEC4, columns.joints);
    }
    json_close(out, '}');
}

static void print_targets(struct morph_glb *fish, const struct target_list *list, struct json *out)
{
    for (uint32_t t = 0; t < list->count; t++) {
        for (uint32_t i = 0; i < columns.count; i++) {
            struct aspect look =
                target_appearance(fish, columns.vertices[i], list->curve[t], list->key[t]);
            /* Only the direction of a blended normal matters. All normals of a vertex are therefore
             * divided by the length of the base normal. */
            look.normal = v3_scale(look.normal, 1.0f / columns.facing[i]);
            write_aspect(i, &look);
        }
        print_shape(fish, NULL, out);
        json_close(out, '}');
    }
}

uint32_t morph_glb_add_mesh(struct morph_glb *fish, uint32_t index)
{
    CORE_ASSERT(index < fish->cut.piece_count);
    const struct morph_piece *piece = &fish->cut.pieces[index];
    char name[PIECE_NAME_SIZE];
    morph_piece_name(piece, name);
    gather_vertices(fish, piece);
    fish->targets[index] = list_targets(fish);
    /* Joint 0 is the fish itself, and joint i + 1 is anchor i. */
    bool rides = false;
    for (uint32_t i = 0; i < columns.count; i++) {
        const struct species_vertex *at = &fish->mesh->vertices[columns.vertices[i]];
        const bool anchored = at->anchor != ANCHOR_NONE;
        rides = rides || anchored;
        columns.coordinates[i][0] = at->u;
        columns.coordinates[i][1] = at->v;
        columns.source[i] = (float)columns.vertices[i];
        memset(columns.joints[i], 0, 4);
        memset(columns.shares[i], 0, sizeof columns.shares[i]);
        columns.joints[i][0] = anchored ? (uint8_t)(at->anchor + 1u) : 0;
        columns.shares[i][0] = 1.0f;
    }
    fish->skinned[index] = rides;
    const uint32_t material = material_of(fish, piece->part);
    const uint32_t indices = glb_array(&fish->file, GLB_FOR_TRIANGLES, GLB_SCALAR, columns.indices,
                                       3u * piece->face_count);
    const uint32_t mesh = glb_next(&fish->file, GLB_MESHES);
    struct json *out = &fish->file.lists[GLB_MESHES];
    json_print(out, "{name: %s, extras: {targetNames: [", name);
    /* The name of a morph target is KEY, or CURVE.KEY for a target of a part's own curve. */
    const struct target_list *list = &fish->targets[index];
    const struct species_card *card = &fish->pick->fish->card;
    for (uint32_t t = 0; t < list->count; t++) {
        const bool own = list->curve[t] > 0;
        char target[2u * SPECIES_NAME_SIZE];
        snprintf(target, sizeof target, "%s%s%s", own ? card->curve_names[list->curve[t]] : "",
                 own ? "." : "", card->key_names[list->key[t]]);
        json_text(out, NULL, target);
    }
    json_print(out, "]}, primitives: [{material: %u, indices: %u", material, indices);
    print_attributes(fish, rides, out);
    json_print(out, "targets: [");
    print_targets(fish, list, out);
    json_print(out, "]}]}");
    return mesh;
}
