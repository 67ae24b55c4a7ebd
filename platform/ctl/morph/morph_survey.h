/* morph_survey.h -- measures errors in the growth of a species for `kingyoctl morph check`. The
 * functions are pure.
 *
 * The growth is examined at many moments from progress 0 to progress 1. Lengths are in units of the
 * fish's measured length, at every age of the fish. A key is a growth stage that the author of the
 * species drew. */
#pragma once

#include <stdbool.h>

#include "core/morph/morph.h"

#define MORPH_SURVEY_NOWHERE UINT32_MAX

/* Worst value of one kind of error, with the vertex and the progress at which the value was
 * found. */
struct finding {
    float value; /* Worst value. 0 means that no error was found. */
    float progress;
    /* Vertex with the worst value, or MORPH_SURVEY_NOWHERE if the value belongs to no vertex. */
    uint32_t vertex;
};

struct morph_survey {
    /* `sum_error` is the greatest |sum - 1| of the key weights in the deformation graph, over all
     * curves. `weight_min` is the least weight. */
    float sum_error, weight_min;
    /* `drawn_sum_error` and `drawn_weight_min` are the corresponding values for the factors with
     * which the drawn shapes are blended. If shapes are solved, some factors are negative. */
    float drawn_sum_error, drawn_weight_min;
    /* `key_error` is the greatest distance between the fish and a drawn key, at moments when all
     * curves give the key the weight 1. `keys_alone` is the number of keys for which there is such
     * a moment. */
    struct finding key_error;
    uint32_t keys_alone;
    /* Number of triangles that are flipped at any moment. A triangle of the body or of an eye is
     * flipped if it faces inward. A triangle of a fin is flipped if its direction reverses between
     * two moments. */
    uint32_t flipped_skin, flipped_fins;
    float flipped_at; /* Progress at which the first flipped triangle was found. */
    /* Number of moments at which the body's surface has a hole. Penetration depths are not measured
     * at these moments. */
    uint32_t moments_open;
    /* The findings from `body_in_body` to `eye_in_eye` are penetration depths. */
    struct finding body_in_body; /* Depth to which a point of the skin lies inside the body because
                                    the skin has folded. */
    /* Depth of a fin point below the skin, minus the depth of the root of its fin ray. */
    struct finding fin_in_body;
    /* Depth to which a point of the eye's visible part lies inside the body. */
    struct finding eye_in_body;
    struct finding pupil_in_body; /* Depth to which a point of the pupil lies inside the body. */
    struct finding eye_in_eye;    /* Depth to which a point of one eye lies inside the other eye. */
    struct finding fin_in_eye;
    /* Greatest distance from the body of a fin ray's root that lies outside the body. */
    struct finding root_off_skin;
    /* Loss of body volume between two keys, as a share of the lesser volume of the two keys. */
    struct finding volume_dip;
    /* The greater of two errors of a key: the distance of the snout from z = -0.5, and the
     * difference between the measured length and 1. */
    struct finding size_error;
    /* Greatest distance of the part's first vertex from the straight line between its first and
     * last positions during the growth. 0 if the fish does not have the part. */
    float dorsal_root, eye_right, eye_left;
    /* `moments_not_older` is the number of moments at which the fish is not older than at the
     * previous moment. `age_stands_at` is the progress of the first such moment. */
    uint32_t moments_not_older;
    float age_stands_at;
    /* Difference between a progress and the result of converting the progress to an age and
     * back. */
    struct finding progress_lost;
    /* Difference between a length and the result of converting the length to a progress and back,
     * as a share of the length. */
    struct finding length_lost;
    /* Difference between the fish's length and its growth curve, as a share of the length. */
    struct finding off_growth;
};

/* Measures `steps` + 1 moments at equal distances from progress 0 to 1, and also the moment of each
 * key. `lod` is the level of detail of the mesh: 0 is near, 1 is far. */
void morph_survey(const struct species *species, const struct morph_rig *rig, uint32_t lod,
                  uint32_t steps, struct morph_survey *out);

/* ---- Closed surfaces (morph_skin.c) ---------------------------------------------------------- */

/* A surface is the body of a fish or one eyeball. A point is inside the surface if a ray from
 * the point to the right crosses the surface an odd number of times. The triangles are sorted into
 * bins, a grid seen from the right, to make the test fast. */

#define MORPH_SKIN_TRIANGLE_MAX (MESH_INDEX_MAX / 3u)
#define MORPH_SKIN_ROWS 16u /* Number of rows of the bin grid, from bottom to top. */
/* Number of columns of the bin grid, from front to rear. A ray to the right passes through exactly
 * one bin. */
#define MORPH_SKIN_COLUMNS 32u
#define MORPH_SKIN_BINS (MORPH_SKIN_ROWS * MORPH_SKIN_COLUMNS)

struct morph_skin { /* A closed surface with its bins. The structure has about 3 MiB. */
    uint32_t triangle_count;
    vec3 corner[MORPH_SKIN_TRIANGLE_MAX][3];
    float low_y, low_z, high_y, high_z;
    uint32_t bin_first[MORPH_SKIN_BINS + 1u];
    uint16_t binned[MORPH_SKIN_TRIANGLE_MAX * MORPH_SKIN_BINS];
};

/* Builds the surface from the triangles of the part `part` on `side`. SIDE_MIDDLE selects the
 * triangles of all sides. */
void morph_skin_build(struct morph_skin *skin, const struct species_mesh *mesh,
                      const vec3 *positions, enum species_part part, enum species_side side);

/* Returns true if the surface has triangles and no hole. In a closed surface, the sum of the
 * triangles' area vectors is zero. */
bool morph_skin_is_closed(const struct morph_skin *skin);

/* Returns the volume inside a closed surface. */
float morph_skin_volume(const struct morph_skin *skin);

/* Returns whether `point` is inside the surface. */
bool morph_skin_has(const struct morph_skin *skin, vec3 point);

/* Returns the distance from `point` to the nearest point of the surface. The point may be inside or
 * outside. */
float morph_skin_distance(const struct morph_skin *skin, vec3 point);

/* Returns the distance from `point`, which must be inside, to the surface in the direction `way`, a
 * unit vector. Returns 0 if the ray does not meet the surface. */
float morph_skin_way_out(const struct morph_skin *skin, vec3 point, vec3 way);

/* ---- State of a survey (morph_survey.c, morph_flaws.c) --------------------------------------- */

struct morph_walk { /* State of a survey. The structure has about 10 MiB. */
    const struct species *species;
    const struct species_mesh *mesh;
    const struct morph_rig *rig;
    struct morph_survey *out;
    float progress;
    struct morph_pose pose, key_pose;
    vec3 positions[MESH_VERTEX_MAX], normals[MESH_VERTEX_MAX];
    vec3 key_positions[MESH_VERTEX_MAX];
    /* Normal of each fin triangle, measured at the last moment at which the triangle was large
     * enough. */
    vec3 facing[MESH_INDEX_MAX / 3];
    bool flipped[MESH_INDEX_MAX / 3], doubtful[MESH_INDEX_MAX / 3];
    /* Progress at the previous moment. `before` is less than `progress`, except while the first
     * moment is measured. */
    float before;
    /* For each fin vertex, the vertex at the root of the same fin ray. */
    uint32_t root[MESH_VERTEX_MAX];
    bool key_alone[MORPH_KEY_MAX];
    float key_volume[MORPH_KEY_MAX];
    struct morph_skin body, eye[2];
    bool body_closed, eye_closed[2];
};

/* Stores `value` in `finding`, with the present progress and `vertex`, if `value` exceeds the
 * stored value. */
static inline void morph_walk_keep(const struct morph_walk *w, struct finding *finding, float value,
                                   uint32_t vertex)
{
    if (value > finding->value) {
        *finding = (struct finding){ value, w->progress, vertex };
    }
}

/* Finds the root of each fin ray. Called once before the first moment. */
void morph_inside_find_roots(struct morph_walk *w);
/* Builds the surfaces of the body and of the eyes, and measures penetrations. Called at every
 * moment for which a shape is computed. */
void morph_inside_measure(struct morph_walk *w);

/* Counts triangles that are flipped. Called at every moment for which a shape is computed. Progress
 * must increase from call to call. */
void morph_flips_measure(struct morph_walk *w);
