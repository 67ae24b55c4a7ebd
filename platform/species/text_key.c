/* text_key.c -- parses the lines of one key (modelled growth stage): stations, eyes and fins. */
#include "platform/species/reader.h"

#include <string.h>

bool text_read_key(struct species_reader *r)
{
    struct species_text *s = r->species;
    if (s->key_count == MORPH_KEY_MAX) {
        return species_reader_error(r, "more than %u keys", MORPH_KEY_MAX);
    }
    if (s->curve_count > 1 || s->curves[0].graph.knot_count > 0) {
        return species_reader_error(r, "all keys stand above the first knot, template or curve");
    }
    struct key_text *key = &s->keys[s->key_count];
    key->age_days = -1.0f;
    if (r->word_count != 3 && r->word_count != 4) {
        return species_reader_error(r, "write: key NAME MM [AGE_DAYS]");
    }
    if (!species_reader_name(r, 1, key->name) ||
        !species_reader_number(r, 2, 0.5f, 20000.0f, &key->length_m) ||
        (r->word_count == 4 && !species_reader_number(r, 3, 0.0f, 14610.0f, &key->age_days))) {
        return false;
    }
    key->length_m /= 1000.0f;
    for (uint32_t i = 0; i < s->key_count; i++) {
        if (strcmp(key->name, s->keys[i].name) == 0) {
            return species_reader_error(r, "a second key called %s", key->name);
        }
    }
    if (s->key_count > 0 && key->age_days < 0.0f && key->length_m <= key[-1].length_m) {
        return species_reader_error(
            r, "keys go from short to long, or say their age: key NAME MM AGE_DAYS");
    }
    r->key = key;
    r->fin = NULL;
    r->key_line[s->key_count++] = r->line;
    return true;
}

/* Parses the line `gill X`, which sets the rear edge of the gill cover. The head ends at this
 * edge. */
bool text_read_gill(struct species_reader *r)
{
    return species_reader_expect(r, 1, "X") &&
           species_reader_number(r, 1, 0.02f, 0.60f, &r->key->gill);
}

bool text_read_station(struct species_reader *r)
{
    struct key_text *key = r->key;
    if (key->substep_count == STATION_MAX) {
        return species_reader_error(r, "more than %d stations", STATION_MAX);
    }
    struct station *s = &key->stations[key->substep_count];
    if (!species_reader_expect(r, 5, "X DEPTH WIDTH OFFSET EXPONENT") ||
        !species_reader_number(r, 1, 0.0f, 1.0f, &s->x) ||
        !species_reader_number(r, 2, 0.0f, 1.5f, &s->depth) ||
        !species_reader_number(r, 3, 0.0f, 2.0f, &s->width) ||
        !species_reader_number(r, 4, -0.5f, 0.5f, &s->offset) ||
        !species_reader_number(r, 5, 0.7f, 6.0f, &s->exponent)) {
        return false;
    }
    if (key->substep_count == 0 ? s->x != 0.0f : s->x <= s[-1].x) {
        return species_reader_error(r, "stations go from x 0 backward");
    }
    if (key->substep_count > 0 && (s->depth < THIN_MIN || s->width < THIN_MIN)) {
        return species_reader_error(r, "only the snout may be thinner than %g", (double)THIN_MIN);
    }
    key->substep_count++;
    return true;
}

/* Parses the line `eye [right|left] X Y DIAMETER BULGE [TURN]`. If the side is omitted, the line
 * sets both eyes. */
bool text_read_eye(struct species_reader *r)
{
    static const char *const sides[] = { "right", "left" };
    struct eye eye = { 0 };
    uint32_t side = 0;
    const bool one = r->word_count > 1 && r->words[1][0] >= 'a' && r->words[1][0] <= 'z';
    const uint32_t at = one ? 2 : 1;
    if (r->word_count != at + 4 && (!one || r->word_count != at + 5)) {
        return species_reader_error(
            r, "write: eye X Y DIAMETER BULGE, or eye right|left X Y DIAMETER BULGE "
               "[TURN]");
    }
    if ((one && !species_reader_choice(r, 1, "side", sides, 2, &side)) ||
        !species_reader_number(r, at, 0.005f, 0.5f, &eye.x) ||
        !species_reader_number(r, at + 1, -0.5f, 0.5f, &eye.y) ||
        !species_reader_number(r, at + 2, 0.004f, 0.3f, &eye.diameter) ||
        !species_reader_number(r, at + 3, 0.0f, 0.8f, &eye.bulge) ||
        (r->word_count == at + 5 &&
         !species_reader_number(r, at + 4, 0.0f, 180.0f, &eye.turn_deg))) {
        return false;
    }
    for (uint32_t i = one ? side : 0; i <= (one ? side : 1); i++) {
        if (r->key->eyes[i].diameter > 0.0f) {
            return species_reader_error(r, "a second %s eye", sides[i]);
        }
        r->key->eyes[i] = eye;
    }
    return true;
}

bool text_read_fin(struct species_reader *r)
{
    uint32_t part = 0;
    if (!species_reader_expect(r, 5,
                               "tail|dorsal|dorsal2|anal|pectoral|pelvic START END GIRTH CURL") ||
        !species_reader_choice(r, 1, "fin", &part_names[PART_TAIL], PART_DORSAL_2 - PART_TAIL + 1,
                               &part)) {
        return false;
    }
    part += PART_TAIL;
    r->fin = &r->key->fins[part];
    if (r->fin->ray_count > 0) {
        return species_reader_error(r, "a second %s", part_names[part]);
    }
    if (r->species->without >> part & 1u) {
        return species_reader_error(r, "a %s in a species without", part_names[part]);
    }
    /* The base of the tail fin is a range of heights. The base of any other fin is a range of
     * positions along x. */
    const float low = part == PART_TAIL ? -0.5f : 0.0f;
    return species_reader_number(r, 2, low, 1.0f, &r->fin->start) &&
           species_reader_number(r, 3, low, 1.0f, &r->fin->end) &&
           species_reader_number(r, 4, 0.0f, 0.5f, &r->fin->girth) &&
           species_reader_number(r, 5, -90.0f, 90.0f, &r->fin->curl_deg) &&
           (r->fin->start < r->fin->end ||
            species_reader_error(r, "the fin ends before it starts"));
}

bool text_read_ray(struct species_reader *r)
{
    if (!r->fin) {
        return species_reader_error(r, "a ray stands under its fin");
    }
    if (r->fin->ray_count == RAY_MAX) {
        return species_reader_error(r, "more than %d rays", RAY_MAX);
    }
    struct ray *ray = &r->fin->rays[r->fin->ray_count];
    if (!species_reader_expect(r, 4, "AT LENGTH SWEEP SIDE") ||
        !species_reader_number(r, 1, 0.0f, 1.0f, &ray->at) ||
        !species_reader_number(r, 2, THIN_MIN, 2.0f, &ray->length) ||
        !species_reader_number(r, 3, -120.0f, 150.0f, &ray->sweep_deg) ||
        !species_reader_number(r, 4, -90.0f, 90.0f, &ray->side_deg)) {
        return false;
    }
    if (r->fin->ray_count == 0 ? ray->at != 0.0f : ray->at <= ray[-1].at) {
        return species_reader_error(r, "rays go from 0 to 1");
    }
    r->fin->ray_count++;
    return true;
}

/* Parses the line `finlets upper|lower COUNT START END LENGTH SWEEP`, which defines a row of
 * finlets. A tuna has a row behind its second dorsal fin and a row behind its anal fin. */
bool text_read_finlets(struct species_reader *r)
{
    static const char *const rows[] = { "upper", "lower" };
    uint32_t row = 0;
    if (!species_reader_expect(r, 6, "upper|lower COUNT START END LENGTH SWEEP") ||
        !species_reader_choice(r, 1, "row of finlets", rows, 2, &row)) {
        return false;
    }
    struct finlets *f = &r->key->finlets[row];
    if (f->count > 0) {
        return species_reader_error(r, "a second %s row of finlets", rows[row]);
    }
    return species_reader_whole(r, 2, 1, FINLET_MAX, &f->count) &&
           species_reader_number(r, 3, 0.1f, 1.0f, &f->start) &&
           species_reader_number(r, 4, 0.1f, 1.0f, &f->end) &&
           species_reader_number(r, 5, THIN_MIN, 0.3f, &f->length) &&
           species_reader_number(r, 6, 0.0f, 85.0f, &f->sweep_deg) &&
           (f->start < f->end || species_reader_error(r, "the row ends before it starts"));
}
