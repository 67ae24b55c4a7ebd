/* import.h -- the import of meshes that other programs made, and their conversion to a species.
 *
 * A mesh has up to MORPH_KEY_MAX key shapes, the shapes of the fish at its modelled growth stages.
 * All key shapes have the same triangles. Positions are in the axes and the unit of the file.
 *
 * Wavefront OBJ files are read by a parser of Kingyo, because key shapes correspond by vertex
 * numbers, which general importers do not preserve. assimp reads glTF and all other formats in a
 * child process with resource limits (import_scene.c). */
#pragma once

#include <stdbool.h>
#include <stdio.h>

#include "core/morph/species.h"
#include "platform/config/options.h"
#include "platform/species/pack.h"

/* ---- Mesh ------------------------------------------------------------------------------------ */

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
    /* Display scale of each key shape, from an animation in the file. The value is 1 if the file
     * does not animate the scale. */
    float scales[MORPH_KEY_MAX];
    bool has_life;   /* True if the file contains the age and the length of each key shape. */
    uint8_t measure; /* Kind of length measure that `lengths_m` uses (enum species_measure). */
    float ages_days[MORPH_KEY_MAX], lengths_m[MORPH_KEY_MAX];
    bool has_coats; /* True if the file contains the colours of each key shape in `coats`. */
    struct species_coat coats[MORPH_KEY_MAX];
    /* True if kingyoctl wrote the file. The texture coordinates are then the body coordinates u
     * (along the body) and v (around the body). */
    bool is_ours;
    /* Number of keyframes in the animation of the weights. 0 means that the file does not animate
     * the weights. */
    uint32_t time_count;
    float times[IMPORT_TIME_MAX];
    /* Weight of each key shape, including key shape 0, at each keyframe. */
    float weights[IMPORT_TIME_MAX][MORPH_KEY_MAX];
};

/* Formats a message to `why` as printf() does and returns false. */
__attribute__((format(printf, 2, 3))) bool import_error(char why[IMPORT_WHY_SIZE],
                                                        const char *format, ...);

/* Formats a message as import_error() does, and evaluates to the exit code `code`. */
#define import_fail(code, ...) (import_error(__VA_ARGS__), (code))

/* Opens a regular file of at most `size_max` bytes. Returns EXIT_OK, and the caller closes `*file`.
 * After an error, writes "FILE: MESSAGE" to `why` and returns EXIT_BAD_DATA for a file that is too
 * large, otherwise EXIT_IO. */
enum exit_code import_open(const char *path, uint32_t size_max, FILE **file,
                           char why[IMPORT_WHY_SIZE]);

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

/* ---- Scenes (import_flat.c, in a child process of import_scene.c) ---------------------------- */

/* Returns true if this build can read scenes and the library assimp is installed. Otherwise writes
 * what is missing to `why` and returns false. */
bool import_can_flatten(char why[IMPORT_WHY_SIZE]);

/* Reads the scene at `path` into `mesh`. Returns true. If the scene cannot be used, writes the
 * reason to `why`, without the file name, and returns false.
 *
 * Must be called only in a child process, because a hostile file may crash the importer. The caller
 * must validate `mesh` with import_validate(). */
bool import_flatten(const char *path, struct import_mesh *mesh, char why[IMPORT_WHY_SIZE]);

/* Checks a mesh that the child process wrote against every limit of this header. Returns null if
 * the mesh is valid. Otherwise returns the error text, which is static or stored in `room`. */
const char *import_validate(const struct import_mesh *mesh, char room[IMPORT_WHY_SIZE / 2]);

/* ---- Steps of the conversion to a species ---------------------------------------------------- */

enum import_axis { AXIS_X, AXIS_Y, AXIS_Z, AXIS_MINUS_X, AXIS_MINUS_Y, AXIS_MINUS_Z, AXIS_NONE };

/* Options of the import. Each field *_count is the number of valid values in an array. A count of 0
 * means that the option is absent. */
struct import_options {
    const char *id;
    /* Directions of the snout (`front`) and of the back (`up`) in the file (enum import_axis). If
     * `front` is AXIS_NONE, the direction is detected. */
    uint8_t front, up;
    /* Values as in struct species_card. 255 means that the option is absent. The value of the
     * species `like` then applies, or the default if `like` is null. */
    uint8_t measure, motion, form;
    /* Template of the deformation graph (enum graph_template). TEMPLATE_OWN selects the graph of
     * the file. */
    uint8_t template_id;
    uint32_t name_count, length_count, age_count, growth_count, colour_count;
    char names[MORPH_KEY_MAX][SPECIES_NAME_SIZE];
    double lengths_mm[MORPH_KEY_MAX], ages_days[MORPH_KEY_MAX];
    /* Parameters of the growth curve in the order LENGTH_INF_MM, K, T0, HATCH_MM, FADE_YEAR. */
    double growth[5];
    /* Colours of the back, the flank, the belly, the fins and the iris, as 0xRRGGBB. */
    uint32_t colours[5];
    double unit_m; /* Length of one unit of the file in metres. */
    /* Species from which life data, colours and curves are taken if the file and the options do not
     * contain them. May be null. */
    const struct species *like;
};

/* Results of the import that kingyoctl prints, for example "front -x, 426 vertices, ...". */
struct import_report {
    uint8_t front;
    /* Size of each key shape before it was scaled, in the unit of the file. */
    float size[MORPH_KEY_MAX];
    uint32_t joined_count; /* Number of vertices that were merged with other vertices. */
    /* Greatest difference between the weights of the deformation graph and the animation of the
     * file. */
    float graph_error;
    /* Number of knots of the deformation graph that were chosen to approximate the animation of the
     * file. 0 means that the file has no animation. */
    uint32_t knot_count;
};

/* import_orient(), import_build(), import_life() and import_fitted_life() return true. After an
 * error they write the reason to `why`, without the file name, and return false. */

/* Rotates `mesh` to the axes of Kingyo (snout to -z, back to +y), and scales each key shape to
 * the size 1 in the length measure of the options. Fails if the orientation or the size cannot be
 * detected. */
bool import_orient(struct import_mesh *mesh, const struct import_options *plan,
                   struct import_report *report, char why[IMPORT_WHY_SIZE]);

/* Builds the near and the far body mesh of a species from an oriented mesh. Does not validate the
 * species. Fails if the mesh has too many vertices or triangles. */
bool import_build(const struct import_mesh *mesh, struct species_slot *slot,
                  struct import_report *report, char why[IMPORT_WHY_SIZE]);

/* Fills the species card and the colours of the species in `slot`. Fails if the options do not fit
 * the number of key shapes, or if no lengths are known. */
bool import_life(const struct import_mesh *mesh, const struct import_options *plan,
                 struct species_slot *slot, struct import_report *report,
                 char why[IMPORT_WHY_SIZE]);

/* Applies the options to `card`, the species card of a template that was fitted to meshes. The
 * options set the id, names, lengths, ages and growth. Fails if the options do not fit the number
 * of key shapes. */
bool import_fitted_life(const struct import_options *plan, struct species_card *card,
                        char why[IMPORT_WHY_SIZE]);

/* Computes the normal of each vertex as the mean of the normals of its triangles, weighted by area.
 * The triangles are the first `index_count` indices of `mesh`. Vertices with the same place[] share
 * one normal. If the two sides of a fin have opposite normals, the first triangle determines the
 * direction. */
void import_normals(const struct species_mesh *mesh, uint32_t index_count, const vec3 *positions,
                    const uint32_t *place, vec3 normals[MESH_VERTEX_MAX]);

/* Returns the part of the fish to which a group of triangles belongs. The part is detected from
 * words in the group's name. For example, "Fin_dorsal.L" is the dorsal fin. A group whose name has
 * no known word belongs to the body. */
enum species_part import_part(const char *group);

/* Returns the part of the fish to which a triangle of the mesh belongs. */
static inline enum species_part import_part_of(const struct import_mesh *mesh, uint32_t triangle)
{
    return import_part(mesh->group_names[mesh->groups[triangle]]);
}

extern const char *const import_axis_names[AXIS_NONE];
