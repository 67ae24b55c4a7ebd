/* text_check.c -- checks that a parsed species text is complete and consistent, so that its meshes
 * can be built. */
#include "platform/species/text.h"

#include "core/base/panic.h"
#include "core/morph/morph.h"
#include "platform/species/shape.h"

/* Maximum coordinate of a point, as a multiple of the fish's length. The quantized mesh can
 * represent coordinates up to 4. */
#define REACH_MAX 3.9
/* Minimum length of the fish as its length measure (enum species_measure) defines it, as a fraction
 * of the drawing's length. A smaller value indicates an error in the drawing. */
#define UNIT_MIN 0.2
#define EEL_SEAM (1u << PART_TAIL | 1u << PART_DORSAL | 1u << PART_ANAL)
/* Maximum relative difference between a key's length and the length on the growth curve at the
 * key's age. */
#define LENGTH_APART 0.02f

/* Checks that all keys have the same parts, so that every vertex has a counterpart in the next
 * key. */
static bool check_fins(const struct species_reader *r, const struct key_text *key)
{
    CORE_ASSERT(r->species->key_count > 0);
    const struct key_text *first = &r->species->keys[0];
    for (uint32_t part = PART_TAIL; part <= PART_DORSAL_2; part++) {
        const struct fin *fin = &key->fins[part];
        const bool wanted = part == PART_DORSAL_2 ? first->fins[part].ray_count > 0
                                                  : !(r->species->without >> part & 1u);
        if (!wanted && fin->ray_count > 0) {
            return species_reader_error(r, "key %s has a %s and key %s has none", key->name,
                                        part_names[part], first->name);
        }
        if (wanted && (fin->ray_count < 2 || fin->rays[fin->ray_count - 1].at != 1.0f)) {
            return species_reader_error(
                r, "key %s: the %s needs rays from 0 to 1, two or more%s", key->name,
                part_names[part], part == PART_DORSAL_2 ? "" : " (or say 'without' at the top)");
        }
    }
    for (int row = 0; row < 2; row++) {
        if (key->finlets[row].count != first->finlets[row].count) {
            return species_reader_error(r, "key %s has %u %s finlets and key %s has %u", key->name,
                                        key->finlets[row].count, row == 0 ? "upper" : "lower",
                                        first->name, first->finlets[row].count);
        }
    }
    return true;
}

static bool check_key(const struct species_reader *r, const struct key_text *key)
{
    const bool has_gill = key->gill > 0.0f, first_has = r->species->keys[0].gill > 0.0f;
    if (key->substep_count < 4 || key->stations[key->substep_count - 1].x != 1.0f) {
        return species_reader_error(r, "key %s needs stations from x 0 to x 1, four or more",
                                    key->name);
    }
    if (has_gill != first_has) {
        return species_reader_error(r, "key %s has %s: write it in all keys or in none", key->name,
                                    has_gill ? "a gill and the first key has none"
                                             : "no gill and the first has");
    }
    for (int side = 0; side < 2; side++) {
        const struct eye *eye = &key->eyes[side];
        if (eye->diameter <= 0.0f) {
            return species_reader_error(r, "key %s has no %s eye", key->name,
                                        side == 0 ? "right" : "left");
        }
        if (eye->x < 0.5f * eye->diameter) {
            return species_reader_error(r, "key %s: the eye reaches beyond the snout", key->name);
        }
    }
    if (!check_fins(r, key)) {
        return false;
    }
    const enum species_measure measure = (enum species_measure)r->species->measure;
    const double unit = shape_unit_length(key, measure);
    if (!(unit >= UNIT_MIN)) {
        return species_reader_error(r,
                                    "key %s: what is measured is %.2g of the drawing, less than %g",
                                    key->name, unit, UNIT_MIN);
    }
    if (!(shape_farthest(key) <= REACH_MAX * unit)) {
        return species_reader_error(
            r, "key %s reaches out to %.3g times what is measured; up to %g fits", key->name,
            shape_farthest(key) / unit, REACH_MAX);
    }
    return true;
}

/* Computes missing ages from the lengths. Then checks that the ages increase from key to key, and
 * that the growth curve matches the keys' lengths. */
static bool check_ages(struct species_reader *r)
{
    struct species_text *s = r->species;
    for (uint32_t i = 0; i < s->key_count; i++) {
        struct key_text *key = &s->keys[i];
        r->line = r->key_line[i];
        const bool has_age = key->age_days >= 0.0f;
        if (!has_age) {
            key->age_days = growth_age_days(&s->growth, key->length_m);
        }
        const float length_m = growth_length_m(&s->growth, key->age_days);
        const bool apart = f_abs(length_m / key->length_m - 1.0f) > LENGTH_APART;
        if (!has_age && apart) {
            return species_reader_error(
                r, "key %s is %g mm and growth gives no age for that: %.4g mm at %.4g days",
                key->name, (double)(key->length_m * 1000.0f), (double)(length_m * 1000.0f),
                (double)key->age_days);
        }
        if (i > 0 && key->age_days <= key[-1].age_days) {
            return species_reader_error(
                r, "key %s (%.4g days) is not older than key %s (%.4g days)", key->name,
                (double)key->age_days, key[-1].name, (double)key[-1].age_days);
        }
        /* The age, the progress and the length of a key must be consistent, because some parts of
         * the program compute one of the three values from the others. */
        if (apart) {
            return species_reader_error(
                r, "key %s is %.4g mm at %.4g days, and growth says %.4g mm: write a point",
                key->name, (double)(key->length_m * 1000.0f), (double)key->age_days,
                (double)(length_m * 1000.0f));
        }
    }
    return true;
}

static bool check_curves(struct species_reader *r)
{
    const struct species_text *s = r->species;
    for (uint32_t i = 0; i < s->curve_count; i++) {
        const struct curve_text *curve = &s->curves[i];
        const uint32_t count = curve->graph.knot_count;
        r->line = i > 0 ? r->curve_line[i] : r->line;
        if (count < 2 || curve->graph.knots[count - 1].progress != 1.0f) {
            return species_reader_error(
                r, "the graph%s%s needs knots from progress 0 to 1, or a template",
                i > 0 ? " of curve " : "", i > 0 ? curve->name : "");
        }
        if (i > 0 && curve->parts == 0 && curve->area_count == 0) {
            return species_reader_error(r, "curve %s moves no part and no area", curve->name);
        }
        /* The deformation graph must have a solution if its line kind is "solved". */
        float solution[MORPH_KEY_MAX][MORPH_KEY_MAX];
        uint32_t stuck = 0;
        if (curve->graph.solved &&
            !graph_solve(&curve->graph, r->species->key_count, solution, &stuck)) {
            return species_reader_error(
                r, "the graph of %s shows too little of key %s to be solved for it", curve->name,
                r->species->keys[stuck].name);
        }
    }
    return true;
}

bool text_check_species(struct species_reader *r)
{
    CORE_ASSERT(r->species->key_count <= MORPH_KEY_MAX);
    CORE_ASSERT(r->species->curve_count >= 1 && r->species->curve_count <= MORPH_CURVE_MAX);
    struct species_text *s = r->species;
    if (s->id[0] == '\0') {
        return species_reader_error(r, "no species ID");
    }
    if (!r->has_growth || !r->has_hatch) {
        return species_reader_error(r, "no growth or no hatch");
    }
    if (s->key_count < 3) {
        return species_reader_error(r, "fewer than three keys");
    }
    if (!check_curves(r)) {
        return false;
    }
    if (s->scale_knot_count > 0 && s->scale_knots[s->scale_knot_count - 1].progress != 1.0f) {
        return species_reader_error(r, "scale knots go from progress 0 to 1");
    }
    if (s->confluent && (s->without & EEL_SEAM) != 0) {
        return species_reader_error(
            r, "confluent fins are dorsal, tail and anal: it is without one of them");
    }
    for (uint32_t i = 0; i < s->key_count; i++) {
        s->keys[i].confluent = s->confluent;
        r->line = r->key_line[i];
        if (!check_key(r, &s->keys[i])) {
            return false;
        }
    }
    if (!r->has_thesis) {
        /* Without a `thesis` line in the species text, the three keys of the 2005 thesis have the
         * following defaults. */
        s->thesis_key[1] = (uint8_t)(s->key_count / 2u);
        s->thesis_key[2] = (uint8_t)(s->key_count - 1u);
        s->thesis_template = TEMPLATE_PAIRWISE;
    }
    return check_ages(r);
}
