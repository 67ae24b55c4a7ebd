/* morph_mesh.h -- a species' near mesh in the form that other programs expect. The mesh is cut into
 * pieces by part and side. The sheet of a fin occurs once, with its front in the direction of its
 * normals. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_MORPH_MESH_H
#define KINGYO_PLATFORM_CTL_MORPH_MORPH_MESH_H

#include "platform/ctl/morph/morph_options.h"

/* Maximum number of pieces: each part may have a middle, a right and a left piece. */
#define PIECE_MAX (3u * PART_COUNT)

struct morph_piece {
    uint8_t part, side;
    uint32_t face_first, face_count;
};

struct morph_mesh {
    uint32_t piece_count, face_count;
    struct morph_piece pieces[PIECE_MAX];
    /* Vertex numbers of species_mesh for each triangle, sorted by piece. */
    uint16_t faces[MESH_INDEX_MAX / 3u][3];
};

/* Writes the name of a piece, for example "eye_right" or "dorsal". */
#define PIECE_NAME_SIZE 32u
void morph_piece_name(const struct morph_piece *piece, char out[PIECE_NAME_SIZE]);

/* Cuts `mesh` into pieces. `positions` and `normals` are the shape that decides which side of a
 * sheet is its front. */
void morph_mesh_cut(const struct species_mesh *mesh, const vec3 *positions, const vec3 *normals,
                    struct morph_mesh *out);

/* Computes a colour for each vertex. A body vertex gets the mean colour of paint_at() over the
 * nearest part of each of its triangles. Sampling only at the vertex would show a spot completely
 * or not at all. `paints` has room for mesh->vertex_count elements. */
void morph_mesh_paint(const struct species *species, const float weights[MORPH_KEY_MAX],
                      const struct morph_mesh *cut, struct paint *paints);

/* Writes a Wavefront OBJ file of `pick` at its progress, in true size in metres. Returns EXIT_OK,
 * or prints one line to standard error and returns EXIT_IO. */
enum exit_code morph_obj_write(const struct morph_options *pick, const char *path);

/* Writes the whole life of `pick` as one glTF 2.0 file (see morph_glb.c). Returns EXIT_OK, or
 * prints one line to standard error and returns EXIT_IO. */
enum exit_code morph_glb_write(const struct morph_options *pick, const char *path);

#endif
