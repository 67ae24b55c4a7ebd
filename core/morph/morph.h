/* morph.h -- a fish of any age from three or more drawings (2005 thesis).
 *
 * age -> length (growth curve) -> progress between the keys -> a weight per key (deformation graph)
 * -> blended shape (eq. 3.2). Weights are >= 0 and sum to 1. */
#ifndef KINGYO_CORE_MORPH_MORPH_H
#define KINGYO_CORE_MORPH_MORPH_H

#include "core/morph/species.h"

/* Total length in metres at `age_days` >= 0 after hatching; never less than the hatch length. */
float growth_length_m(const struct growth *growth, float age_days);

/* The age at which the curve reaches `length_m`, within 0.1 day; clamps to [0, 40 years]. */
float growth_age_days(const struct growth *growth, float length_m);

/* [0, 1] from the first key's length to the last key's; the keys in between are equally spaced in
 * progress and lengths interpolate geometrically, since fish grow by factors. */
float morph_progress(const struct species *species, float length_m);

/* The deformation graph at `progress` in [0, 1]: linear between knots. Unused keys get 0. */
void morph_weights(const struct species *species, float progress, float weights[MORPH_KEY_MAX]);

/* The ordinary two-shape morph (eq. 3.1) of the first and last key, for comparison. */
void morph_weights_ordinary(const struct species *species, float progress,
                            float weights[MORPH_KEY_MAX]);

/* Eq. 3.2 on the CPU: `positions` and `normals` (either may be null) hold mesh->vertex_count. */
void morph_blend(const struct species_mesh *mesh, uint32_t key_count,
                 const float weights[MORPH_KEY_MAX], vec3 *positions, vec3 *normals);

#endif
