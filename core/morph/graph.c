/* graph.c -- the deformation graph: how much of each key shape a fish shows as it grows. */
#include "core/morph/morph.h"

#include "core/base/panic.h"

float morph_progress(const struct species *species, float length_m)
{
    const float *key = species->key_length_m;
    const uint32_t last = species->key_count - 1;
    CORE_ASSERT(species->key_count >= 2 && species->key_count <= MORPH_KEY_MAX);
    if (!(length_m > key[0])) {
        return 0.0f;
    }
    for (uint32_t i = 0; i < last; i++) {
        if (length_m < key[i + 1]) {
            const float part = f_ln(length_m / key[i]) / f_ln(key[i + 1] / key[i]);
            return ((float)i + f_clamp(part, 0.0f, 1.0f)) / (float)last;
        }
    }
    return 1.0f;
}

void morph_weights(const struct species *species, float progress, float weights[MORPH_KEY_MAX])
{
    CORE_ASSERT(progress >= 0.0f && progress <= 1.0f);
    CORE_ASSERT(species->knot_count >= 2 && species->knot_count <= CURVE_KNOT_MAX);
    uint32_t next = 1;
    while (next < species->knot_count - 1 && progress > species->knots[next].progress) {
        next++;
    }
    const struct graph_knot *from = &species->knots[next - 1];
    const struct graph_knot *to = &species->knots[next];
    const float t =
        f_clamp((progress - from->progress) / (to->progress - from->progress), 0.0f, 1.0f);
    for (uint32_t i = 0; i < MORPH_KEY_MAX; i++) {
        /* Both ends exact, and never below 0 where both ends are not. */
        weights[i] = i < species->key_count ? from->weight[i] * (1.0f - t) + to->weight[i] * t : 0;
    }
}

void morph_weights_ordinary(const struct species *species, float progress,
                            float weights[MORPH_KEY_MAX])
{
    CORE_ASSERT(progress >= 0.0f && progress <= 1.0f);
    CORE_ASSERT(species->key_count >= 2 && species->key_count <= MORPH_KEY_MAX);
    for (uint32_t i = 0; i < MORPH_KEY_MAX; i++) {
        weights[i] = 0.0f;
    }
    weights[0] = 1.0f - progress;
    weights[species->key_count - 1] = progress;
}
