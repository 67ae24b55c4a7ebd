/* import_mesh.h -- a mesh that another program made, before its conversion to a species.
 *
 * A mesh has up to MORPH_KEY_MAX key shapes, the shapes of the fish at its modelled growth stages.
 * All key shapes have the same triangles. Positions are in the axes and the unit of the file.
 *
 * Wavefront OBJ files are read by a parser of Kingyo, because key shapes correspond by vertex
 * numbers, which general importers do not preserve. assimp reads glTF and all other formats in a
 * child process with resource limits (import_scene.c). */
#ifndef KINGYO_PLATFORM_CTL_IMPORT_IMPORT_MESH_H
#define KINGYO_PLATFORM_CTL_IMPORT_IMPORT_MESH_H

#include <stdbool.h>

#include "core/morph/species.h"
#include "platform/config/options.h"

/* Maximum number of vertices of a file, for example of a 3D scan. The mesh of a species has at most
 * MESH_VERTEX_MAX vertices. */
#define IMPORT_VERTEX_MAX 65536u
#define IMPORT_TRIANGLE_MAX 131072u
#define IMPORT_GROUP_MAX 64u
#define IMPORT_NAME_SIZE 64u
#define IMPORT_TIME_MAX 4096u /* Maximum number of keyframes in an animation of weights. */
#define IMPORT_FILE_MAX (64u * 1024u * 1024u)

/* Largest absolute coordinate. A file with larger coordinates is rejected as damaged. */
#define IMPORT_REACH_MAX 1e6f
#define IMPORT_WHY_SIZE 200u

/* A mesh with several key shapes. The structure is too large for a stack. */
struct import_mesh {
    uint32_t key_count, vertex_count, triangle_count, group_count;
    char key_names[MORPH_KEY_MAX][IMPORT_NAME_SIZE];
    char group_names[IMPORT_GROUP_MAX][IMPORT_NAME_SIZE];
    vec3 positions[MORPH_KEY_MAX][IMPORT_VERTEX_MAX];
    float uv[IMPORT_VERTEX_MAX][2];
    uint32_t colours[IMPORT_VERTEX_MAX]; /* Colour of each vertex as 0xRRGGBB. */
    uint32_t triangles[IMPORT_TRIANGLE_MAX][3];
    uint8_t groups[IMPORT_TRIANGLE_MAX];
    bool has_uv, has_colours;
    float scales[MORPH_KEY_MAX]; /* Animated display scale of each key shape. The value is 1 if the
                                    file has no animated scale. */
    bool has_life;   /* True if the file contains the age and the length of each key shape. */
    uint8_t measure; /* Kind of length measure that `lengths_m` uses (enum species_measure). */
    float ages_days[MORPH_KEY_MAX], lengths_m[MORPH_KEY_MAX];
    bool has_coats; /* True if the file contains the colours of each key shape in `coats`. */
    struct species_coat coats[MORPH_KEY_MAX];
    bool is_ours;        /* True if kingyoctl wrote the file. The texture coordinates are then the
                            body coordinates u and v. */
    uint32_t time_count; /* Number of keyframes in the animation of the weights. 0 means that the
                            file does not animate the weights. */
    float times[IMPORT_TIME_MAX];
    float weights[IMPORT_TIME_MAX][MORPH_KEY_MAX]; /* Weight of each key shape, including key shape
                                                      0, at each keyframe. */
};

/* Reads an OBJ file as key shape `key` of `mesh`. The file of key shape 0 defines the vertices and
 * the faces. The file of each further key shape must have the same vertices and faces. A polygon
 * becomes a fan of triangles.
 *
 * Returns EXIT_OK. After an error, writes "FILE:LINE: MESSAGE" to `why` and returns another exit
 * code. */
enum exit_code import_obj(struct import_mesh *mesh, uint32_t key, const char *path,
                          char why[IMPORT_WHY_SIZE]);

/* Reads a scene (.glb or another format of assimp) into `mesh`. The morph targets of the scene
 * become key shapes. Returns EXIT_OK. After an error, writes a message to `why` and returns another
 * exit code. */
enum exit_code import_scene(struct import_mesh *mesh, const char *path, char why[IMPORT_WHY_SIZE]);

/* Returns true if this program was built with the headers of assimp. */
bool import_flat_is_available(void);

#endif
