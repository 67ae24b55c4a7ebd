/* morph_glb_mesh.c -- writes a piece of the fish as a glTF mesh. The base of the mesh is the shape
 * of the last key, and the morph targets are the displacements to the other keys (see
 * morph_glb_look.c). */
#include <string.h>

#include "platform/ctl/morph/morph_glb.h"
#include "platform/species/reader.h"

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

static void put_look(uint32_t place, const struct aspect *look)
{
    memcpy(columns.position[place], &look->position, sizeof look->position);
    memcpy(columns.normal[place], &look->normal, sizeof look->normal);
    memcpy(columns.colour[place], &look->colour, sizeof look->colour);
    columns.colour[place][3] = look->hides;
}

/* ---- Contents of a piece --------------------------------------------------------------------- */

static void gather_vertices(const struct morph_glb *fish, const struct morph_piece *piece)
{
    static bool taken[MESH_VERTEX_MAX];
    memset(taken, 0, sizeof taken);
    for (uint32_t i = 0; i < 3u * piece->face_count; i++) {
        taken[fish->cut.faces[piece->face_first + i / 3u][i % 3u]] = true;
    }
    columns.count = 0;
    for (uint32_t i = 0; i < fish->mesh->vertex_count; i++) {
        if (taken[i]) {
            columns.place[i] = (uint16_t)columns.count;
            columns.vertices[columns.count++] = (uint16_t)i;
        }
    }
    for (uint32_t i = 0; i < 3u * piece->face_count; i++) {
        columns.indices[i] = columns.place[fish->cut.faces[piece->face_first + i / 3u][i % 3u]];
    }
}

static struct target_list list_targets(const struct morph_glb *fish)
{
    struct target_list list = { .curves = 1 };
    for (uint32_t curve = 0; curve < fish->pick->rig.curve_count; curve++) {
        for (uint32_t i = 0; i < columns.count; i++) {
            if (morph_glb_share_of(fish, columns.vertices[i], curve) > 0.0f) {
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

/* Fills the joint columns and the weight columns. Joint 0 is the fish itself, and joint i + 1 is
 * anchor i. Returns true if any vertex has an anchor. */
static bool fill_rest(const struct morph_glb *fish)
{
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
    return rides;
}

/* ---- Writing to the file --------------------------------------------------------------------- */

static uint32_t material_of(struct morph_glb *fish, uint8_t part)
{
    const struct species_coat *coat = &fish->pick->fish->coats[fish->pick->rig.key_count - 1u];
    const bool is_fin = part >= PART_TAIL;
    const double rough = part == PART_EYE ? 0.15 : is_fin ? 0.6 : 0.7 - 0.4 * coat->shine / 255.0;
    if (fish->materials[part] == 0) {
        fish->materials[part] = 1u + glb_next(&fish->file, GLB_MATERIALS);
        byte_buffer_print(&fish->file.lists[GLB_MATERIALS],
                          "{\"name\":\"%s\",\"pbrMetallicRoughness\":{\"metallicFactor\":0,"
                          "\"roughnessFactor\":%.3f}%s}",
                          part_names[part], rough,
                          is_fin ? ",\"alphaMode\":\"BLEND\",\"doubleSided\":true" : "");
    }
    return fish->materials[part] - 1u;
}

/* Writes the positions, normals and colours in `columns` to the file, and prints their accessors.
 * The caller has filled the columns. */
static void print_shape(struct morph_glb *fish, struct byte_buffer *out)
{
    const uint32_t position =
        glb_floats(&fish->file, GLB_FOR_PLACES, GLB_VEC3, columns.position[0], columns.count);
    const uint32_t normal =
        glb_floats(&fish->file, GLB_FOR_VERTICES, GLB_VEC3, columns.normal[0], columns.count);
    const uint32_t colour =
        glb_floats(&fish->file, GLB_FOR_VERTICES, GLB_VEC4, columns.colour[0], columns.count);
    byte_buffer_print(out, "{\"POSITION\":%u,\"NORMAL\":%u,\"COLOR_0\":%u", position, normal,
                      colour);
}

static void print_attributes(struct morph_glb *fish, bool skinned, struct byte_buffer *out)
{
    struct glb *file = &fish->file;
    for (uint32_t i = 0; i < columns.count; i++) {
        struct aspect look = morph_glb_base_appearance(fish, columns.vertices[i]);
        columns.facing[i] = f_max(v3_length(look.normal), 1e-6f);
        look.normal = v3_normalize_or(look.normal, v3(0.0f, 1.0f, 0.0f));
        put_look(i, &look);
    }
    print_shape(fish, out);
    byte_buffer_print(
        out, ",\"TEXCOORD_0\":%u,\"_VERTEX\":%u",
        glb_floats(file, GLB_FOR_VERTICES, GLB_VEC2, columns.coordinates[0], columns.count),
        glb_floats(file, GLB_FOR_VERTICES, GLB_SCALAR, columns.source, columns.count));
    if (skinned) {
        byte_buffer_print(
            out, ",\"JOINTS_0\":%u,\"WEIGHTS_0\":%u",
            glb_joints(file, (const uint8_t(*)[4])columns.joints, columns.count),
            glb_floats(file, GLB_FOR_VERTICES, GLB_VEC4, columns.shares[0], columns.count));
    }
    byte_buffer_print(out, "}");
}

static void print_targets(struct morph_glb *fish, const struct target_list *list,
                          struct byte_buffer *out)
{
    for (uint32_t t = 0; t < list->count; t++) {
        for (uint32_t i = 0; i < columns.count; i++) {
            struct aspect look = morph_glb_target_appearance(fish, columns.vertices[i],
                                                             list->curve[t], list->key[t]);
            /* Only the direction of a blended normal is used. All normals of a vertex are therefore
             * divided by the length of the base normal. */
            look.normal = v3_scale(look.normal, 1.0f / columns.facing[i]);
            put_look(i, &look);
        }
        byte_buffer_print(out, "%s", t > 0 ? "," : "");
        print_shape(fish, out);
        byte_buffer_print(out, "}");
    }
}

/* Prints the name of each morph target. The name is KEY, or CURVE.KEY for a target of a part's own
 * curve. */
static void print_names(const struct morph_glb *fish, const struct target_list *list,
                        struct byte_buffer *out)
{
    const struct species_card *card = &fish->pick->fish->card;
    for (uint32_t t = 0; t < list->count; t++) {
        const bool own = list->curve[t] > 0;
        byte_buffer_print(out, "%s\"%s%s%s\"", t > 0 ? "," : "",
                          own ? card->curve_names[list->curve[t]] : "", own ? "." : "",
                          card->key_names[list->key[t]]);
    }
}

uint32_t morph_glb_add_mesh(struct morph_glb *fish, uint32_t index)
{
    const struct morph_piece *piece = &fish->cut.pieces[index];
    char name[PIECE_NAME_SIZE];
    morph_piece_name(piece, name);
    gather_vertices(fish, piece);
    fish->targets[index] = list_targets(fish);
    fish->skinned[index] = fill_rest(fish);
    const uint32_t material = material_of(fish, piece->part);
    const uint32_t indices = glb_indices(&fish->file, columns.indices, 3u * piece->face_count);
    const uint32_t mesh = glb_next(&fish->file, GLB_MESHES);
    struct byte_buffer *out = &fish->file.lists[GLB_MESHES];
    byte_buffer_print(out, "{\"name\":\"%s\",\"extras\":{\"targetNames\":[", name);
    print_names(fish, &fish->targets[index], out);
    byte_buffer_print(out, "]},\"primitives\":[{\"material\":%u,\"indices\":%u,\"attributes\":",
                      material, indices);
    print_attributes(fish, fish->skinned[index], out);
    byte_buffer_print(out, ",\"targets\":[");
    print_targets(fish, &fish->targets[index], out);
    byte_buffer_print(out, "]}]}");
    return mesh;
}
