/* morph_survey.h -- a species' whole growth, measured: what `kingyoctl morph check` judges. Pure.
 *
 * Lengths are of the body's own (the species' measure is 1), whatever size the fish has. */
#ifndef KINGYO_PLATFORM_CTL_MORPH_SURVEY_H
#define KINGYO_PLATFORM_CTL_MORPH_SURVEY_H

#include "core/morph/morph.h"

#define SURVEY_NOWHERE UINT32_MAX

/* The worst of a kind, and where and when it was found. */
struct finding {
    float value;     /* 0 where there is nothing to find. */
    float progress;
    uint32_t vertex; /* Or SURVEY_NOWHERE. */
};

/* How far from the straight line between its first place and its last a vertex goes. */
struct curvature {
    uint32_t vertex; /* SURVEY_NOWHERE where the fish has no such part. */
    float from_chord;
};

struct survey {
    /* Of the graphs: over all curves, |sum - 1|, and the least weight. */
    float sum_error, weight_min;
    /* The same of what multiplies the drawn shapes: below 0 where shapes are solved. */
    float drawn_sum_error, drawn_weight_min;
    /* Where every curve shows one key alone: the distance from that key, and how many keys are. */
    struct finding key_error;
    uint32_t keys_alone;
    /* Triangles that are turned over at any step: of body and eyes those that face inward, of fins
     * those whose sheet turns over from one step to the next. */
    uint32_t flipped_skin, flipped_fins;
    float flipped_at; /* When the first was seen. */
    uint32_t moments_open; /* At which the body has a hole: what is inside it nobody can tell. */
    /* How deep is inside what it must not be inside of. */
    struct finding body_in_body; /* A fold of the skin. */
    struct finding fin_in_body;  /* Deeper than the root of its ray. */
    struct finding eye_in_body;  /* The visible part of an eye in the head ... */
    struct finding pupil_in_body; /* ... and its pupil alone. */
    struct finding eye_in_eye;   /* Two eyes on one side. */
    struct finding fin_in_eye;
    struct finding root_off_skin; /* How far a fin's root floats above it. */
    struct finding volume_dip;    /* The body's, a share below the lesser of the keys around. */
    float volume_first, volume_last; /* Of a fish one long. */
    /* How far a key's snout is from z = -0.5, or its size, as the species measures it, from 1. */
    struct finding size_error;
    struct curvature dorsal_root, eye_right, eye_left;
    /* Its life: moments at which it is no older than at the one before, and the first such ... */
    uint32_t moments_not_older;
    float age_stands_at;
    struct finding progress_lost; /* ... how far its age leads back to another progress ... */
    struct finding length_lost;   /* ... its length to another length, a share of it ... */
    struct finding off_growth;    /* ... and the share by which it is off the growth curve. */
};

/* Measures `steps` + 1 moments from progress 0 to 1, and each key's own, of one level of detail. */
void morph_survey(const struct species *species, const struct morph_rig *rig, uint32_t lod,
                  uint32_t steps, struct survey *out);

#endif
