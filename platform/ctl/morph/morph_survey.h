/* morph_survey.h -- measures errors in the growth of a species for `kingyoctl morph check`. The
 * functions are pure.
 *
 * The growth is examined at many moments from progress 0 to progress 1. Lengths are in units of the
 * fish's measured length, at every age of the fish. A key is a growth stage that the author of the
 * species drew. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_MORPH_SURVEY_H
#define KINGYO_PLATFORM_CTL_MORPH_MORPH_SURVEY_H

#include "core/morph/morph.h"

#define MORPH_SURVEY_NOWHERE UINT32_MAX

/* Worst value of one kind of error, with the vertex and the progress at which the value was
 * found. */
struct finding {
    float value; /* Worst value. 0 means that no error was found. */
    float progress;
    uint32_t vertex; /* Vertex with the worst value, or MORPH_SURVEY_NOWHERE if the value belongs to
                        no vertex. */
};

/* Greatest distance of a vertex from the straight line between its first and last positions. */
struct curvature {
    /* Index of the vertex, or MORPH_SURVEY_NOWHERE if the fish does not have the part. */
    uint32_t vertex;
    float from_chord;
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
    struct finding body_in_body;  /* Depth to which a point of the skin lies inside the body
                                     because the skin has folded. */
    struct finding fin_in_body;   /* Depth of a fin point below the skin, minus the depth of the
                                     root of its fin ray. */
    struct finding eye_in_body;   /* Depth to which a point of the eye's visible part lies inside
                                     the body. */
    struct finding pupil_in_body; /* Depth to which a point of the pupil lies inside the body. */
    struct finding eye_in_eye;    /* Depth to which a point of one eye lies inside the other eye. */
    struct finding fin_in_eye;
    struct finding root_off_skin; /* Distance between the root of a fin ray and the body, for a root
                                     outside the body. */
    /* Loss of body volume between two keys, as a share of the lesser volume of the two keys. */
    struct finding volume_dip;
    /* Body volume at progress 0 (`volume_first`) and at progress 1 (`volume_last`), for a fish of
     * length 1. */
    float volume_first, volume_last;
    /* The greater of two errors of a key: the distance of the snout from z = -0.5, and the
     * difference between the measured length and 1. */
    struct finding size_error;
    struct curvature dorsal_root, eye_right, eye_left;
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

#endif
