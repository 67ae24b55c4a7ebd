/* import_mesh.h -- meshes from other programs, before they are a species.
 *
 * Up to MORPH_KEY_MAX shapes of one topology, in the file's own axes and unit. The reader of
 * Wavefront OBJ is ours: shapes correspond by the numbers of their vertices, which general
 * importers do not keep. glTF and all else is read by assimp, in a child process with limits
 * (import_scene.c). */
#ifndef KINGYO_PLATFORM_CTL_IMPORT_MESH_H
#define KINGYO_PLATFORM_CTL_IMPORT_MESH_H

#include <stdbool.h>

#include "core/morph/species.h"
#include "platform/kiosk/options.h"

#define IMPORT_VERTEX_MAX 65536u    /* A scan; a species' own mesh has at most MESH_VERTEX_MAX. */
#define IMPORT_TRIANGLE_MAX 131072u
#define IMPORT_GROUP_MAX 64u
#define IMPORT_NAME_SIZE 64u
#define IMPORT_TIME_MAX 4096u       /* Moments of an animation of weights. */
#define IMPORT_FILE_MAX (64u * 1024u * 1024u)
#define IMPORT_REACH_MAX 1e6f       /* Coordinates beyond are a damaged file. */
#define IMPORT_WHY_SIZE 200u

struct import_mesh {
    uint32_t key_count, vertex_count, triangle_count, group_count;
    char key_names[MORPH_KEY_MAX][IMPORT_NAME_SIZE];
    char group_names[IMPORT_GROUP_MAX][IMPORT_NAME_SIZE];
    vec3 positions[MORPH_KEY_MAX][IMPORT_VERTEX_MAX];
    float uv[IMPORT_VERTEX_MAX][2];
    uint32_t colours[IMPORT_VERTEX_MAX]; /* 0xRRGGBB */
    uint32_t triangles[IMPORT_TRIANGLE_MAX][3];
    uint8_t groups[IMPORT_TRIANGLE_MAX];
    bool has_uv, has_colours;
    float scales[MORPH_KEY_MAX]; /* How large each key is shown, by an animated scale; else 1. */
    bool has_life;   /* The file says how old and long each key is ... */
    uint8_t measure; /* ... and by which measure (enum species_measure). */
    float ages_days[MORPH_KEY_MAX], lengths_m[MORPH_KEY_MAX];
    bool has_coats;  /* And how each is painted. */
    struct species_coat coats[MORPH_KEY_MAX];
    bool is_ours;        /* kingyoctl wrote it: texture coordinates are body coordinates. */
    uint32_t time_count; /* Of the weights' animation; 0: there is none. */
    float times[IMPORT_TIME_MAX];
    float weights[IMPORT_TIME_MAX][MORPH_KEY_MAX]; /* Of each key, the first included. */
};

/* Reads shape `key` of `mesh` from an OBJ file: key 0 defines vertices and faces, each further one
 * must have the same. Polygons become fans. Answers an exit code; `why` is "FILE:LINE: what". */
enum exit_code import_obj(struct import_mesh *mesh, uint32_t key, const char *path,
                          char why[IMPORT_WHY_SIZE]);

/* Reads a scene (.glb, and what else assimp knows) with its morph targets as keys 1 .. n. */
enum exit_code import_scene(struct import_mesh *mesh, const char *path, char why[IMPORT_WHY_SIZE]);

/* Was this program built beside assimp's headers? */
bool import_knows_scenes(void);

#endif
