/* morph_mesh.h -- a species' near mesh as other programs like it: pieces by part and side, a fin's
 * sheet once, with its front where its normals point. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_MESH_H
#define KINGYO_PLATFORM_CTL_MORPH_MESH_H

#include "platform/ctl/morph_pick.h"

#define PIECE_MAX (3u * PART_COUNT) /* A part may be of the middle, the right and the left. */

struct morph_piece {
    uint8_t part, side;
    uint32_t face_first, face_count;
};

struct morph_mesh {
    uint32_t piece_count, face_count;
    struct morph_piece pieces[PIECE_MAX];
    uint16_t faces[MESH_INDEX_MAX / 3u][3]; /* Of species_mesh's vertices, piece by piece. */
};

/* "eye_right", "dorsal" */
#define PIECE_NAME_SIZE 32u
void morph_piece_name(const struct morph_piece *piece, char out[PIECE_NAME_SIZE]);

/* `positions` and `normals` are the shape by which a sheet's front is told. */
void morph_mesh_cut(const struct species_mesh *mesh, const vec3 *positions, const vec3 *normals,
                    struct morph_mesh *out);

/* What a vertex can tell of the skin around it: on the body, paint_at() over the part of each of
 * its triangles that is nearest to it; at the vertex alone, a spot would be all or nothing.
 * `paints` takes mesh->vertex_count. */
void morph_mesh_paint(const struct species *species, const float weights[MORPH_KEY_MAX],
                      const struct morph_mesh *cut, struct paint *paints);

/* Wavefront OBJ of `pick` at its progress, true size in metres. EXIT_OK, or EXIT_IO, told. */
enum exit_code morph_obj_write(const struct morph_pick *pick, const char *path);

/* glTF 2.0 of its whole life, in one file: morph_glb.c says how. EXIT_OK, or EXIT_IO, told. */
enum exit_code morph_glb_write(const struct morph_pick *pick, const char *path);

#endif
