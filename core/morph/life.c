/* life.c -- converts between age, length and progress of a fish through its key shapes.
 *
 * A key shape (key) is one modelled growth stage. Key i of n keys is at progress i / (n - 1) and
 * has its own age and length. (The 2005 thesis uses one letter t for age, length and progress.)
 * Between two keys, progress is a linear function of the logarithm of length, because growth
 * multiplies the length. If the length is not monotone between two keys, progress is a linear
 * function of age. For example, a conger is longest before it becomes an eel.
 *
 * The length of a key may differ slightly from the growth curve at the age of the key. For the
 * conversion between age and progress, the lengths are therefore taken from the growth curve at the
 * ages of both keys. Age then always increases with progress. */
#include "core/morph/morph.h"

#include "core/base/panic.h"

static uint32_t last_key(const struct species_card *card)
{
    CORE_ASSERT(card->key_count >= 2 && card->key_count <= MORPH_KEY_MAX);
    return card->key_count - 1u;
}

/* Returns true if progress between `key` and the next key is computed from length. This requires
 * that the growth curve is monotone between both keys, and that the curve and the lengths of the
 * keys change in the same direction. */
static bool is_length_monotone(const struct species_card *card, uint32_t key)
{
    const float *length = &card->key_length_m[key], *age = &card->key_age_days[key];
    const bool rises =
        growth_length_m(&card->growth, age[1]) > growth_length_m(&card->growth, age[0]);
    return length[0] != length[1] && (length[1] > length[0]) == rises &&
           growth_is_one_way(&card->growth, age[0], age[1]);
}

/* Returns the position [0, 1] of `length_m` between two lengths on a logarithmic scale: 0 at
 * `from_m`, 1 at `to_m`. */
static float part_between(float from_m, float to_m, float length_m)
{
    CORE_ASSERT(from_m > 0.0f && to_m > 0.0f);
    return f_clamp(f_log(length_m / from_m) / f_log(to_m / from_m), 0.0f, 1.0f);
}

static float length_between(float from_m, float to_m, float part)
{
    CORE_ASSERT(from_m > 0.0f && to_m > 0.0f && part >= 0.0f && part <= 1.0f);
    const float length_m = from_m * f_exp(f_log(to_m / from_m) * part);
    return f_clamp(length_m, f_min(from_m, to_m), f_max(from_m, to_m));
}

static float part_of_age(const struct species_card *card, uint32_t key, float age_days)
{
    const float *age = &card->key_age_days[key];
    CORE_ASSERT(age[1] > age[0]);
    return f_clamp((age_days - age[0]) / (age[1] - age[0]), 0.0f, 1.0f);
}

static float progress_of(const struct species_card *card, uint32_t key, float part)
{
    CORE_ASSERT(key < last_key(card) && part >= 0.0f && part <= 1.0f);
    return ((float)key + part) / (float)last_key(card);
}

float life_progress(const struct species_card *card, float age_days)
{
    const uint32_t last = last_key(card);
    CORE_ASSERT(age_days >= 0.0f);
    if (age_days <= card->key_age_days[0]) {
        return 0.0f;
    }
    for (uint32_t key = 0; key < last; key++) {
        if (age_days == card->key_age_days[key]) {
            return progress_of(card, key, 0.0f); /* If the age is exactly the age of a key, the
                                                    result is the progress of the key without
                                                    rounding errors. */
        }
        if (age_days < card->key_age_days[key + 1]) {
            if (!is_length_monotone(card, key)) {
                return progress_of(card, key, part_of_age(card, key, age_days));
            }
            const float *age = &card->key_age_days[key];
            return progress_of(card, key,
                               part_between(growth_length_m(&card->growth, age[0]),
                                            growth_length_m(&card->growth, age[1]),
                                            growth_length_m(&card->growth, age_days)));
        }
    }
    return 1.0f;
}

/* Returns the index of the last key whose progress is at most `progress`; at progress 1, returns
 * the last key but one. Writes the position between this key and the next key, in [0, 1], to
 * `part`. */
static uint32_t key_before(const struct species_card *card, float progress, float *part)
{
    const float last = (float)last_key(card);
    uint32_t key = 0;
    CORE_ASSERT(progress >= 0.0f && progress <= 1.0f);
    while (key + 1u < last_key(card) && progress >= (float)(key + 1u) / last) {
        key++;
    }
    *part = f_clamp(progress * last - (float)key, 0.0f, 1.0f); /* At the progress of a key,
                                                                  `progress * last` is exactly the
                                                                  index of the key. */
    return key;
}

float life_age_days(const struct species_card *card, float progress)
{
    float part;
    const uint32_t key = key_before(card, progress, &part);
    const float *age = &card->key_age_days[key];
    if (part <= 0.0f || part >= 1.0f) {
        return age[part >= 1.0f];
    }
    if (!is_length_monotone(card, key)) {
        return f_lerp(age[0], age[1], part);
    }
    const float length_m = length_between(growth_length_m(&card->growth, age[0]),
                                          growth_length_m(&card->growth, age[1]), part);
    const float days = growth_age_between(&card->growth, age[0], age[1], length_m);
    CORE_ASSERT(days >= age[0]);
    return days;
}

/* Returns the length by the hand-drawn size curve (the purple curve of the 2005 thesis). The curve
 * is interpolated logarithmically between two knots, in the same way as the length between two
 * keys. Therefore an additional knot with the progress and the length of a key does not change the
 * curve. */
static float scale_by_hand_m(const struct species_card *card, float progress)
{
    const struct scale_knot *to = &card->scale_knots[1];
    CORE_ASSERT(card->scale_knot_count >= 2 && card->scale_knot_count <= GRAPH_KNOT_MAX);
    while (to < &card->scale_knots[card->scale_knot_count - 1u] && progress >= to->progress) {
        to++;
    }
    const struct scale_knot *from = to - 1;
    const float part = (progress - from->progress) / (to->progress - from->progress);
    if (part <= 0.0f || part >= 1.0f) {
        return part <= 0.0f ? from->length_m : to->length_m;
    }
    return length_between(from->length_m, to->length_m, part);
}

float life_length_m(const struct species_card *card, float progress)
{
    float part;
    const uint32_t key = key_before(card, progress, &part);
    if (card->scale_knot_count > 0) {
        return scale_by_hand_m(card, progress);
    }
    const float *length = &card->key_length_m[key];
    if (part <= 0.0f || part >= 1.0f) {
        return length[part >= 1.0f];
    }
    return is_length_monotone(card, key)
               ? length_between(length[0], length[1], part)
               : growth_length_m(&card->growth, life_age_days(card, progress));
}

/* Returns the earliest progress at which the hand-drawn size curve has the length `length_m`.
 * Returns -1 if the curve never has this length. */
static float progress_by_hand(const struct species_card *card, float length_m)
{
    for (uint32_t i = 0; i < card->scale_knot_count; i++) {
        const struct scale_knot *from = &card->scale_knots[i > 0 ? i - 1u : 0];
        const struct scale_knot *to = &card->scale_knots[i];
        if (length_m == to->length_m) {
            return to->progress;
        }
        if ((length_m > from->length_m) != (length_m > to->length_m)) {
            return f_lerp(from->progress, to->progress,
                          part_between(from->length_m, to->length_m, length_m));
        }
    }
    return -1.0f;
}

/* Returns the earliest progress between `key` and the next key at which the fish has the length
 * `length_m`. Returns -1 if the fish does not have this length between the two keys. */
static float progress_from_key(const struct species_card *card, uint32_t key, float length_m)
{
    const float *length = &card->key_length_m[key], *age = &card->key_age_days[key];
    if (length_m == length[0] || length_m == length[1]) {
        return progress_of(card, key, length_m == length[0] ? 0.0f : 1.0f);
    }
    if (is_length_monotone(card, key)) {
        const bool within = (length_m > length[0]) != (length_m > length[1]);
        const float part = part_between(length[0], length[1], length_m);
        return within ? progress_of(card, key, part) : -1.0f;
    }
    const float days = growth_age_between(&card->growth, age[0], age[1], length_m);
    return days >= 0.0f ? progress_of(card, key, part_of_age(card, key, days)) : -1.0f;
}

float morph_progress(const struct species_card *card, float length_m)
{
    const uint32_t last = last_key(card);
    const bool by_hand = card->scale_knot_count > 0;
    float progress = by_hand ? progress_by_hand(card, length_m) : -1.0f;
    for (uint32_t key = 0; key < last && progress < 0.0f && !by_hand; key++) {
        progress = progress_from_key(card, key, length_m);
    }
    if (progress >= 0.0f) {
        return progress;
    }
    return length_m > life_length_m(card, 0.0f) ? 1.0f : 0.0f;
}
