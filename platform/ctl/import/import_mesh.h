/* import_mesh.h -- a mesh of another program before its conversion to a species.
 *
 * A mesh has up to MORPH_KEY_MAX key shapes of one topology, in the axes and the unit of the file.
 * We read Wavefront OBJ with a parser of our own because key shapes correspond by vertex numbers,
 * which general importers do not keep. assimp reads glTF and all other formats in a child process
 * with resource limits (import_scene.c). */
#ifndef KINGYO_PLATFORM_CTL_IMPORT_IMPORT_MESH_H
#define KINGYO_PLATFORM_CTL_IMPORT_IMPORT_MESH_H

#include <stdbool.h>

#include "core/morph/species.h"
#include "platform/config/options.h"

/* Most vertices of a file, for example of a 3D scan. The mesh of a species has at most
 * MESH_VERTEX_MAX. */
#define IMPORT_VERTEX_MAX 65536u
#define IMPORT_TRIANGLE_MAX 131072u
#define IMPORT_GROUP_MAX 64u
#define IMPORT_NAME_SIZE 64u
#define IMPORT_TIME_MAX 4096u /* Most keyframes of an animation of weights. */
#define IMPORT_FILE_MAX (64u * 1024u * 1024u)

/* Largest coordinate. A file with greater coordinates is reported as damaged. */
#define IMPORT_REACH_MAX 1e6f
#define IMPORT_WHY_SIZE 200u

/* A mesh with several key shapes. The struct is large and must not be on the stack. */
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
    float scales[MORPH_KEY_MAX]; /* Animated display scale of each key shape. 1 without an animated
                                    scale. */
    bool has_life;   /* Whether the file contains the age and the length of each key shape. */
    uint8_t measure; /* Measure of the lengths in the file (enum species_measure). */
    float ages_days[MORPH_KEY_MAX], lengths_m[MORPH_KEY_MAX];
    bool has_coats; /* Whether the file contains the colours of each key shape (`coats`). */
    struct species_coat coats[MORPH_KEY_MAX];
    bool is_ours;        /* Whether kingyoctl wrote the file. Texture coordinates are then body
                            coordinates. */
    uint32_t time_count; /* Number of keyframes of the weights' animation. 0 means that there is no
                            animation. */
    float times[IMPORT_TIME_MAX];
    float weights[IMPORT_TIME_MAX][MORPH_KEY_MAX]; /* Weight of each key shape at each keyframe,
                                                      including key shape 0. */
};

/* Reads key shape `key` of `mesh` from an OBJ file. Key 0 defines vertices and faces, and each
 * further key must have the same topology. Polygons become triangle fans.
 *
 * Returns an exit code. After an error, `why` is "FILE:LINE: MESSAGE". */
enum exit_code import_obj(struct import_mesh *mesh, uint32_t key, const char *path,
                          char why[IMPORT_WHY_SIZE]);

/* Reads a scene (.glb or another format of assimp) into `mesh`. Its morph targets become key
 * shapes. Returns an exit code. After an error, `why` is the message. */
enum exit_code import_scene(struct import_mesh *mesh, const char *path, char why[IMPORT_WHY_SIZE]);

/* Returns whether this program was built with assimp's headers. */
bool import_flat_is_available(void);

#endif
