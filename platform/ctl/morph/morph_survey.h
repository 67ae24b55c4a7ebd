/* morph_survey.h -- measures the whole growth of a species for `kingyoctl morph check`. The
 * functions are pure.
 *
 * Lengths are relative to the body (the measured length of the species is 1), at every size of the
 * fish. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_MORPH_SURVEY_H
#define KINGYO_PLATFORM_CTL_MORPH_MORPH_SURVEY_H

#include "core/morph/morph.h"

#define MORPH_SURVEY_NOWHERE UINT32_MAX

/* The worst value of a kind, and the vertex and the progress at which it was found. */
struct finding {
    float value; /* Worst value. A value of 0 means that nothing was found. */
    float progress;
    uint32_t vertex; /* Vertex of the worst value, or MORPH_SURVEY_NOWHERE. */
};

/* Greatest distance of a vertex from the straight line between its first and its last position. */
struct curvature {
    /* Number of the vertex, or MORPH_SURVEY_NOWHERE if the fish does not have the part. */
    uint32_t vertex;
    float from_chord;
};

struct morph_survey {
    /* `sum_error` is the greatest |sum - 1| of the graph's weights over all curves. `weight_min` is
     * the least weight. */
    float sum_error, weight_min;
    /* `drawn_sum_error` and `drawn_weight_min` are the same values for the factors of the drawn
     * shapes. A factor is negative where shapes are solved. */
    float drawn_sum_error, drawn_weight_min;
    /* `key_error` is the distance from a key at moments when every curve shows this key alone.
     * `keys_alone` is the number of such keys. */
    struct finding key_error;
    uint32_t keys_alone;
    /* Number of triangles that are flipped at any step. A triangle of the body or an eye is flipped
     * if it faces inward. A fin triangle is flipped if it reverses from one step to the next. */
    uint32_t flipped_skin, flipped_fins;
    float flipped_at; /* Progress at which the first flipped triangle was found. */
    /* Number of moments at which the body has a hole. The inside of the body is undefined at these
     * moments. */
    uint32_t moments_open;
    /* The following findings are penetration depths. */
    struct finding body_in_body;  /* Depth of a body point in a fold of the body's own skin. */
    struct finding fin_in_body;   /* Depth of a fin point below the root of its ray. */
    struct finding eye_in_body;   /* Depth of an eye's visible part in the head. */
    struct finding pupil_in_body; /* Depth of an eye's pupil in the head. */
    struct finding eye_in_eye;    /* Depth of one eye in another eye on the same side. */
    struct finding fin_in_eye;
    struct finding root_off_skin; /* Distance of a fin's root above the skin. */
    /* Dip of the body's volume, as a share of the lesser volume of the two neighbouring keys. */
    struct finding volume_dip;
    /* Body volume at progress 0 and at progress 1, for a fish of length 1. */
    float volume_first, volume_last;
    /* Greater of two errors of a key: the distance of the snout from z = -0.5, and the difference
     * between the measured length and 1. */
    struct finding size_error;
    struct curvature dorsal_root, eye_right, eye_left;
    /* `moments_not_older` counts the moments at which the fish is not older than at the previous
     * moment. `age_stands_at` is the progress of the first such moment. */
    uint32_t moments_not_older;
    float age_stands_at;
    /* Difference between a progress and the progress that the fish's age converts back to. */
    struct finding progress_lost;
    /* Difference between a length and the length that it converts back to, as a share of the
     * length. */
    struct finding length_lost;
    /* Difference between the length and the growth curve, as a share. */
    struct finding off_growth;
};

/* Measures `steps` + 1 moments from progress 0 to 1 and the moment of each key, at one level of
 * detail. */
void morph_survey(const struct species *species, const struct morph_rig *rig, uint32_t lod,
                  uint32_t steps, struct morph_survey *out);

#endif
