/* morph_glb.c -- writes the whole life of a fish as a glTF 2.0 file with nodes, a skin and an
 * animation.
 *
 * The scene has one node for the fish, whose animated scale gives the size of the fish. The fish
 * faces +z, as glTF requires. Each piece of the fish has a node with a mesh below the fish's node.
 *
 * A part that is anchored to the body's surface is skinned in the sense of glTF. Each anchor is a
 * joint, and each vertex depends on one joint only. glTF first blends the morph targets and then
 * applies the joints, as morph_shape() does, so the result is exact. Nodes could not replace the
 * joints, because neighbouring rays of a fin have different anchors but share triangles.
 *
 * The animation "growth" has GLB_SECONDS seconds from progress 0 to 1. It contains the weights of
 * the deformation graph, the size and the joints. If the graph is solved, the weights are those of
 * the solved shapes, which stay in [0, 1]. */
#include "platform/ctl/morph/morph_glb.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/ctl/lib/caption.h"

#define NAME_SIZE 2048u /* Size in bytes of a list of PIECE_MAX node numbers, with a margin. */

static const char command[] = "export";

/* File that is being written. The variable is static because it is too large for a stack. */
static struct morph_glb fish;

/* ---- Nodes ----------------------------------------------------------------------------------- */

/* Prints metadata of the species: its keys with their progress, age, length and colours. */
static void print_life(struct byte_buffer *out)
{
    const struct species_card *card = &fish.pick->fish->card;
    byte_buffer_print(out,
                      "\"extras\":{\"species\":\"%s\",\"measure\":\"%s\",\"template\":\"%s\","
                      "\"thesis\":%s,\"seconds\":%g,\"keys\":[",
                      card->id, caption_measure(card), morph_template_name(fish.pick->template_id),
                      fish.pick->thesis ? "true" : "false", (double)GLB_SECONDS);
    for (uint32_t i = 0; i < card->key_count; i++) {
        byte_buffer_print(out, "%s{\"name\":\"%s\",\"progress\":%.6g,", i > 0 ? "," : "",
                          card->key_names[i], (double)i / (card->key_count - 1u));
        byte_buffer_print(out, "\"age_days\":%.6g,\"length_m\":%.6g,",
                          (double)card->key_age_days[i], (double)card->key_length_m[i]);
        /* Colours are 0xRRGGBB numbers. The spots and stripes of the skin are not printed. */
        const struct species_coat *coat = &fish.pick->fish->coats[i];
        byte_buffer_print(out, "\"back\":%u,\"flank\":%u,\"belly\":%u,\"fin\":%u,\"iris\":%u,",
                          coat->back, coat->flank, coat->belly, coat->fin, coat->iris);
        byte_buffer_print(out, "\"clear\":%u,\"shine\":%u}", coat->clear, coat->shine);
    }
    byte_buffer_print(out, "]}");
}

/* Computes the inverse of an anchor's pose at progress 1, as a column-major 4 x 4 matrix for
 * glTF. */
static void inverse_bind(const struct anchor_pose *at, float out[16])
{
    const vec3 axes[3] = { v3(1.0f, 0.0f, 0.0f), v3(0.0f, 1.0f, 0.0f), v3(0.0f, 0.0f, 1.0f) };
    memset(out, 0, 16 * sizeof *out);
    for (uint32_t column = 0; column < 4; column++) {
        const vec3 to = column < 3 ? pose_rotate_inverse(at->turn, axes[column])
                                   : pose_rotate_inverse(at->turn, v3_scale(at->position, -1.0f));
        memcpy(&out[4 * column], &to, sizeof to);
    }
    out[15] = 1.0f;
}

static void add_skin(void)
{
    static float matrices[1u + ANCHOR_MAX][16];
    const struct anchor_pose here = { .turn = { 0.0f, 0.0f, 0.0f, 1.0f } };
    struct byte_buffer *out = &fish.file.lists[GLB_SKINS];
    inverse_bind(&here, matrices[0]);
    for (uint32_t i = 0; i < fish.mesh->anchor_count; i++) {
        inverse_bind(&fish.adult.anchor[i], matrices[1u + i]);
    }
    glb_next(&fish.file, GLB_SKINS);
    byte_buffer_print(
        out,
        "{\"name\":\"skin\",\"skeleton\":%u,\"inverseBindMatrices\":%u,"
        "\"joints\":[%u",
        GLB_ROOT_NODE,
        glb_floats(&fish.file, GLB_FOR_DATA, GLB_MAT4, matrices[0], 1u + fish.mesh->anchor_count),
        GLB_ROOT_NODE);
    for (uint32_t i = 0; i < fish.mesh->anchor_count; i++) {
        byte_buffer_print(out, ",%u", GLB_PIECE_NODE + fish.cut.piece_count + i);
    }
    byte_buffer_print(out, "]}");
}

static void add_nodes(char scene[NAME_SIZE])
{
    CORE_ASSERT(fish.cut.piece_count <= PIECE_MAX);
    uint32_t meshes[PIECE_MAX];
    size_t used = (size_t)snprintf(scene, NAME_SIZE, "%u", GLB_ROOT_NODE);
    bool skinned = false;
    for (uint32_t i = 0; i < fish.cut.piece_count; i++) {
        meshes[i] = morph_glb_add_mesh(&fish, i);
    }
    struct byte_buffer *out = &fish.file.lists[GLB_NODES];
    const double size = (double)life_length_m(&fish.pick->fish->card, 1.0f);
    glb_next(&fish.file, GLB_NODES);
    byte_buffer_print(out, "{\"name\":\"%s\",\"rotation\":[0,1,0,0],\"scale\":[%.9g,%.9g,%.9g],",
                      fish.pick->fish->card.id, size, size, size);
    const char *comma = "\"children\":[";
    for (uint32_t i = 0; i < fish.cut.piece_count; i++) {
        if (!fish.skinned[i]) {
            byte_buffer_print(out, "%s%u", comma, GLB_PIECE_NODE + i);
            comma = ",";
        }
    }
    for (uint32_t i = 0; i < fish.mesh->anchor_count; i++) {
        byte_buffer_print(out, "%s%u", comma, GLB_PIECE_NODE + fish.cut.piece_count + i);
        comma = ",";
    }
    byte_buffer_print(out, "],");
    print_life(out);
    byte_buffer_print(out, "}");
    for (uint32_t i = 0; i < fish.cut.piece_count; i++) {
        char name[PIECE_NAME_SIZE];
        morph_piece_name(&fish.cut.pieces[i], name);
        glb_next(&fish.file, GLB_NODES);
        byte_buffer_print(&fish.file.lists[GLB_NODES], "{\"name\":\"%s\",\"mesh\":%u%s}", name,
                          meshes[i], fish.skinned[i] ? ",\"skin\":0" : "");
        if (fish.skinned[i]) {
            /* glTF ignores the node of a skinned mesh and moves the mesh only by its joints. The
             * node is therefore a root node beside the fish's node. */
            used += (size_t)snprintf(scene + used, NAME_SIZE - used, ",%u", GLB_PIECE_NODE + i);
            skinned = true;
        }
    }
    for (uint32_t i = 0; i < fish.mesh->anchor_count; i++) {
        const struct anchor_pose *at = &fish.adult.anchor[i];
        glb_next(&fish.file, GLB_NODES);
        byte_buffer_print(&fish.file.lists[GLB_NODES],
                          "{\"name\":\"anchor_%u\",\"translation\":[%.9g,%.9g,%.9g],"
                          "\"rotation\":[%.9g,%.9g,%.9g,%.9g]}",
                          i, (double)at->position.x, (double)at->position.y, (double)at->position.z,
                          (double)at->turn.x, (double)at->turn.y, (double)at->turn.z,
                          (double)at->turn.w);
    }
    if (skinned) {
        add_skin();
    }
}

enum exit_code morph_glb_write(const struct morph_options *pick, const char *path)
{
    CORE_ASSERT(pick->fish && path);
    char scene[NAME_SIZE];
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
    add_nodes(scene);
    const int error =
        morph_glb_animate(&fish) ? glb_write(&fish.file, path, "growth", scene) : -ENOMEM;
    glb_free(&fish.file);
    return error ? morph_fail(EXIT_IO, command, "%.900s: %s", path, strerror(-error)) : EXIT_OK;
}
