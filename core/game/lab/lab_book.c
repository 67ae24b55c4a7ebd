/* lab_book.c -- gives access to the species by index, validates their data, and computes its hash.
 *
 * Packed species files are validated before they are loaded (platform/species/validate.c). The lab
 * book in a recording does not come from a species file, so this file checks the same ranges. */
#include "core/game/lab/lab_edit.h"

#include "core/base/panic.h"

uint32_t lab_book_count(const struct lab_book *book)
{
    CORE_ASSERT(book->card_count <= SPECIES_EXTRA_MAX);
    return species_table_count + book->card_count;
}

const struct species_card *lab_book_card(const struct lab_book *book, uint32_t species)
{
    CORE_ASSERT(species < lab_book_count(book));
    return species < species_table_count ? &species_table[species]->card
                                         : &book->cards[species - species_table_count];
}

/* ---- Validation of custom species ----------------------------------------------------------- */

/* Largest valid age in days: 40 years, which is also the limit of growth.c. */
#define AGE_MAX_DAYS 14610.0f
/* Smallest valid length of a custom species. An edit in the lab may go down to LAB_LENGTH_MIN_M. */
#define LENGTH_MIN_M 0.0005f
/* Largest valid relative difference between the length of a key shape and the length on the growth
 * curve at the same age. */
#define LENGTH_APART 0.02f

/* Returns true if `x` is within `low` .. `high`. Returns false for NaN and infinity. */
static bool is_within(float x, float low, float high)
{
    CORE_ASSERT(low <= high);
    return x >= low && x <= high;
}

static bool is_length(float length_m)
{
    return is_within(length_m, LENGTH_MIN_M, LAB_LENGTH_MAX_M);
}

/* Returns true if the name consists of at least one character of a-z, 0-9 and _, followed only by
 * zeros. */
static bool is_name(const char name[SPECIES_NAME_SIZE])
{
    uint32_t length = 0;
    while (length < SPECIES_NAME_SIZE &&
           ((name[length] >= 'a' && name[length] <= 'z') ||
            (name[length] >= '0' && name[length] <= '9') || name[length] == '_')) {
        length++;
    }
    bool good = length > 0 && length < SPECIES_NAME_SIZE;
    for (uint32_t i = length; i < SPECIES_NAME_SIZE; i++) {
        good = good && name[i] == 0;
    }
    return good;
}

static bool growth_is_good(const struct growth *growth)
{
    bool good = growth->point_count >= 1 && growth->point_count <= GROWTH_POINT_MAX &&
                is_length(growth->length_inf_m) && is_within(growth->k_per_year, 0.001f, 10.0f) &&
                is_within(growth->t0_year, -20.0f, 20.0f) &&
                is_within(growth->fade_year, 0.001f, 5.0f) && growth->points[0].age_days == 0.0f;
    for (uint32_t i = 0; good && i < growth->point_count; i++) {
        const struct growth_point *point = &growth->points[i];
        good = is_length(point->length_m) && is_within(point->age_days, 0.0f, AGE_MAX_DAYS) &&
               (i == 0 || point->age_days > point[-1].age_days);
    }
    return good;
}

/* Returns true if the card's growth, keys and curves are valid. The keys are tested after the
 * growth, because a key's length must be on the growth curve. */
static bool card_is_good(const struct species_card *card)
{
    const uint8_t *thesis = card->thesis_key;
    struct lab_edit own;
    if (!is_name(card->id) || card->measure > MEASURE_DISC || card->motion > MOTION_WING ||
        card->form > FORM_PUFFER || !growth_is_good(&card->growth) || card->key_count < 3 ||
        card->key_count > MORPH_KEY_MAX) {
        return false;
    }
    for (uint32_t i = 0; i < card->key_count; i++) {
        const float age = card->key_age_days[i], length = card->key_length_m[i];
        if (!is_name(card->key_names[i]) || !is_length(length) ||
            !is_within(age, 0.0f, AGE_MAX_DAYS) || (i > 0 && !(age > card->key_age_days[i - 1u])) ||
            !(f_abs(growth_length_m(&card->growth, age) / length - 1.0f) <= LENGTH_APART)) {
            return false;
        }
    }
    if (thesis[0] >= thesis[1] || thesis[1] >= thesis[2] || thesis[2] >= card->key_count ||
        card->thesis_template <= TEMPLATE_OWN || card->thesis_template >= TEMPLATE_COUNT ||
        card->curve_count < 1 || card->curve_count > MORPH_CURVE_MAX) {
        return false;
    }
    for (uint32_t i = 0; i < card->curve_count; i++) {
        const struct graph *graph = &card->curves[i];
        if (!is_name(card->curve_names[i]) || graph->line > GRAPH_SMOOTH || graph->solved > 1u ||
            graph_check(graph, card->key_count).fault != GRAPH_GOOD) {
            return false;
        }
    }
    lab_edit_own(&own, card);
    return lab_edit_is_valid(&own, card);
}

bool lab_book_is_valid(const struct lab_book *book)
{
    if (book->card_count > SPECIES_EXTRA_MAX) {
        return false;
    }
    for (uint32_t i = 0; i < book->card_count; i++) {
        if (!card_is_good(&book->cards[i])) {
            return false;
        }
    }
    for (uint32_t i = 0; i < SPECIES_MAX; i++) {
        const bool is_there = book->has_edit[i] != 0;
        if (is_there && (i >= lab_book_count(book) ||
                         !lab_edit_is_valid(&book->edits[i], lab_book_card(book, i)))) {
            return false;
        }
    }
    return true;
}
