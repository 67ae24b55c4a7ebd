/* morph_export.h -- the writers of `kingyoctl morph export`: pictures of a growing fish, and meshes
 * for other programs.
 *
 * For a mesh file, the near mesh of a species is divided into pieces, one for each body part and
 * side. In the near mesh, a fin consists of two sheets of triangles, one for each side. The file
 * gets only one of these sheets: the sheet whose triangles face in the direction of the vertex
 * normals. Each writer returns EXIT_OK, or prints one line to standard error and returns
 * EXIT_IO. */
#pragma once

#include "platform/ctl/lib/fish_preview.h"
#include "platform/ctl/morph/morph_options.h"

/* ---- Pictures (morph_sheet.c) ---------------------------------------------------------------- */

/* Number of stages that the contact sheet shows between two keys (modelled growth stages). */
#define MORPH_SHEET_BETWEEN 9u
#define FRAME_WIDTH 1280u
#define FRAME_HEIGHT 720u

/* Writes the contact sheet to one PNG file. The sheet shows every key, and nine stages between each
 * two keys, in three views. Below each stage are its age, its length and a scale bar. Returns
 * EXIT_OK, or prints one line to standard error and returns EXIT_IO. */
enum exit_code morph_sheet_write(const struct morph_options *pick, const char *path);

/* Writes `count` frames as DIR/ID_0000.png, DIR/ID_0001.png and so on, at equal steps of progress.
 * `count` must be at least 2. The fish has the same drawn length in each frame. If the folder does
 * not exist, it is created. Returns EXIT_OK, or prints one line to standard error and returns
 * EXIT_IO. */
enum exit_code morph_frames_write(const struct morph_options *pick, enum fish_preview_view view,
                                  uint32_t count, const char *folder);

/* ---- Meshes (morph_export.c, glb.c) ------------------------------------------------------ */

/* Maximum number of pieces. Each part may have a middle, a right and a left piece. */
#define PIECE_MAX (3u * PART_COUNT)

struct morph_piece {
    uint8_t part, side;
    uint32_t face_first, face_count;
};

struct morph_mesh {
    uint32_t piece_count, face_count;
    struct morph_piece pieces[PIECE_MAX];
    /* Vertex indices of species_mesh for each triangle, sorted by piece. */
    uint16_t faces[MESH_INDEX_MAX / 3u][3];
};

/* Size in bytes of a piece's name. morph_piece_name() writes for example "eye_right" or
 * "dorsal". */
#define PIECE_NAME_SIZE 32u
void morph_piece_name(const struct morph_piece *piece, char out[PIECE_NAME_SIZE]);

/* Cuts `mesh` into pieces. `positions` and `normals` describe one shape of the fish. This shape
 * determines which side of each sheet is the front. */
void morph_mesh_cut(const struct species_mesh *mesh, const vec3 *positions, const vec3 *normals,
                    struct morph_mesh *out);

/* Computes a colour for each vertex. A vertex of the body gets the mean colour of small areas in
 * the triangles around it. A colour sampled only at the vertex would show a small spot completely
 * or not at all. `paints` must have room for mesh->vertex_count elements. */
void morph_mesh_paint(const struct species *species, const float weights[MORPH_KEY_MAX],
                      const struct morph_mesh *cut, struct paint *paints);

/* Writes the fish that `pick` selects as a Wavefront OBJ file, at its progress and in true size in
 * metres. Returns EXIT_OK, or prints one line to standard error and returns EXIT_IO. */
enum exit_code morph_obj_write(const struct morph_options *pick, const char *path);

/* Writes the whole life of the fish that `pick` selects as a glTF 2.0 file (see glb.c).
 * Returns EXIT_OK, or prints one line to standard error and returns EXIT_IO. */
enum exit_code morph_glb_write(const struct morph_options *pick, const char *path);
