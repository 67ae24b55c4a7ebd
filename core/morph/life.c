/* life.c -- where in its life a fish is: age, length, and progress between the drawn keys. */
#include "core/morph/morph.h"

#include "core/base/panic.h"

float morph_progress(const struct species_card *card, float length_m)
{
    const float *key = card->key_length_m;
    const uint32_t last = card->key_count - 1u;
    CORE_ASSERT(card->key_count >= 2 && card->key_count <= MORPH_KEY_MAX);
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

float life_progress(const struct species_card *card, float age_days)
{
    return morph_progress(card, growth_length_m(&card->growth, age_days));
}

float life_length_m(const struct species_card *card, float progress)
{
    const uint32_t last = card->key_count - 1u;
    CORE_ASSERT(progress >= 0.0f && progress <= 1.0f);
    const uint32_t i = progress < 1.0f ? (uint32_t)(progress * (float)last) : last - 1u;
    const float part = progress * (float)last - (float)i;
    const float ratio = card->key_length_m[i + 1] / card->key_length_m[i];
    return card->key_length_m[i] * f_exp(f_ln(ratio) * part);
}

float life_age_days(const struct species_card *card, float progress)
{
    return growth_age_days(&card->growth, life_length_m(card, progress));
}
