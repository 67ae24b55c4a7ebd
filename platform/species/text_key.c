/* text_key.c -- parses the lines of one key shape: stations, eyes, fins. */
#include "platform/species/reader.h"

#include <string.h>

bool read_key(struct reader *r)
{
    struct species_text *s = r->species;
    if (s->key_count == MORPH_KEY_MAX) {
        return refuse(r, "more than %u keys", MORPH_KEY_MAX);
    }
    if (s->curve_count > 1 || s->curves[0].graph.knot_count > 0) {
        return refuse(r, "all keys stand above the first knot, template or curve");
    }
    struct key_text *key = &s->keys[s->key_count];
    key->age_days = -1.0f;
    if (r->word_count != 3 && r->word_count != 4) {
        return refuse(r, "write: key NAME MM [AGE_DAYS]");
    }
    if (!name(r, 1, key->name) || !number(r, 2, 0.5f, 20000.0f, &key->length_m) ||
        (r->word_count == 4 && !number(r, 3, 0.0f, 14610.0f, &key->age_days))) {
        return false;
    }
    key->length_m /= 1000.0f;
    for (uint32_t i = 0; i < s->key_count; i++) {
        if (strcmp(key->name, s->keys[i].name) == 0) {
            return refuse(r, "a second key called %s", key->name);
        }
    }
    if (s->key_count > 0 && key->age_days < 0.0f && key->length_m <= key[-1].length_m) {
        return refuse(r, "keys go from short to long, or say their age: key NAME MM AGE_DAYS");
    }
    r->key = key;
    r->fin = NULL;
    r->key_line[s->key_count++] = r->line;
    return true;
}

/* Parses `gill X`: the end of the gill cover and of the head. */
bool read_gill(struct reader *r)
{
    return wants(r, 1, "X") && number(r, 1, 0.02f, 0.60f, &r->key->gill);
}

bool read_station(struct reader *r)
{
    struct key_text *key = r->key;
    if (key->station_count == STATION_MAX) {
        return refuse(r, "more than %d stations", STATION_MAX);
    }
    struct station *s = &key->stations[key->station_count];
    if (!wants(r, 5, "X DEPTH WIDTH OFFSET EXPONENT") || !number(r, 1, 0.0f, 1.0f, &s->x) ||
        !number(r, 2, 0.0f, 1.5f, &s->depth) || !number(r, 3, 0.0f, 2.0f, &s->width) ||
        !number(r, 4, -0.5f, 0.5f, &s->offset) || !number(r, 5, 0.7f, 6.0f, &s->exponent)) {
        return false;
    }
    if (key->station_count == 0 ? s->x != 0.0f : s->x <= s[-1].x) {
        return refuse(r, "stations go from x 0 backward");
    }
    if (key->station_count > 0 && (s->depth < THIN_MIN || s->width < THIN_MIN)) {
        return refuse(r, "only the snout may be thinner than %g", (double)THIN_MIN);
    }
    key->station_count++;
    return true;
}

/* Parses `eye [right|left] X Y DIAMETER BULGE [TURN]`. Without a side, the line sets both eyes. */
bool read_eye(struct reader *r)
{
    static const char *const sides[] = { "right", "left" };
    struct eye eye = { 0 };
    uint32_t side = 0;
    const bool one = r->word_count > 1 && r->words[1][0] >= 'a' && r->words[1][0] <= 'z';
    const uint32_t at = one ? 2 : 1;
    if (r->word_count != at + 4 && (!one || r->word_count != at + 5)) {
        return refuse(r, "write: eye X Y DIAMETER BULGE, or eye right|left X Y DIAMETER BULGE "
                         "[TURN]");
    }
    if ((one && !choice(r, 1, "side", sides, 2, &side)) ||
        !number(r, at, 0.005f, 0.5f, &eye.x) || !number(r, at + 1, -0.5f, 0.5f, &eye.y) ||
        !number(r, at + 2, 0.004f, 0.3f, &eye.diameter) ||
        !number(r, at + 3, 0.0f, 0.8f, &eye.bulge) ||
        (r->word_count == at + 5 && !number(r, at + 4, 0.0f, 180.0f, &eye.turn_deg))) {
        return false;
    }
    for (uint32_t i = one ? side : 0; i <= (one ? side : 1); i++) {
        if (r->key->eyes[i].diameter > 0.0f) {
            return refuse(r, "a second %s eye", sides[i]);
        }
        r->key->eyes[i] = eye;
    }
    return true;
}

bool read_fin(struct reader *r)
{
    uint32_t part = 0;
    if (!wants(r, 5, "tail|dorsal|dorsal2|anal|pectoral|pelvic START END GIRTH CURL") ||
        !choice(r, 1, "fin", &part_names[PART_TAIL], PART_DORSAL_2 - PART_TAIL + 1, &part)) {
        return false;
    }
    part += PART_TAIL;
    r->fin = &r->key->fins[part];
    if (r->fin->ray_count > 0) {
        return refuse(r, "a second %s", part_names[part]);
    }
    if (r->species->without >> part & 1u) {
        return refuse(r, "a %s in a species without", part_names[part]);
    }
    /* A tail's base is a range of heights, other bases are positions along x. */
    const float low = part == PART_TAIL ? -0.5f : 0.0f;
    return number(r, 2, low, 1.0f, &r->fin->start) && number(r, 3, low, 1.0f, &r->fin->end) &&
           number(r, 4, 0.0f, 0.5f, &r->fin->girth) &&
           number(r, 5, -90.0f, 90.0f, &r->fin->curl_deg) &&
           (r->fin->start < r->fin->end || refuse(r, "the fin ends before it starts"));
}

bool read_ray(struct reader *r)
{
    if (!r->fin) {
        return refuse(r, "a ray stands under its fin");
    }
    if (r->fin->ray_count == RAY_MAX) {
        return refuse(r, "more than %d rays", RAY_MAX);
    }
    struct ray *ray = &r->fin->rays[r->fin->ray_count];
    if (!wants(r, 4, "AT LENGTH SWEEP SIDE") || !number(r, 1, 0.0f, 1.0f, &ray->at) ||
        !number(r, 2, THIN_MIN, 2.0f, &ray->length) ||
        !number(r, 3, -120.0f, 150.0f, &ray->sweep_deg) ||
        !number(r, 4, -90.0f, 90.0f, &ray->side_deg)) {
        return false;
    }
    if (r->fin->ray_count == 0 ? ray->at != 0.0f : ray->at <= ray[-1].at) {
        return refuse(r, "rays go from 0 to 1");
    }
    r->fin->ray_count++;
    return true;
}

/* Parses `finlets upper|lower COUNT START END LENGTH SWEEP`: a tuna's finlets behind dorsal2 and
 * anal. */
bool read_finlets(struct reader *r)
{
    static const char *const rows[] = { "upper", "lower" };
    uint32_t row = 0;
    if (!wants(r, 6, "upper|lower COUNT START END LENGTH SWEEP") ||
        !choice(r, 1, "row of finlets", rows, 2, &row)) {
        return false;
    }
    struct finlets *f = &r->key->finlets[row];
    if (f->count > 0) {
        return refuse(r, "a second %s row of finlets", rows[row]);
    }
    return whole(r, 2, 1, FINLET_MAX, &f->count) && number(r, 3, 0.1f, 1.0f, &f->start) &&
           number(r, 4, 0.1f, 1.0f, &f->end) && number(r, 5, THIN_MIN, 0.3f, &f->length) &&
           number(r, 6, 0.0f, 85.0f, &f->sweep_deg) &&
           (f->start < f->end || refuse(r, "the row ends before it starts"));
}
