/* text_key.c -- parses the lines of one key (modelled growth stage): stations, eyes, fins and
 * paint. */
#include "platform/species/text.h"

#include <string.h>

#include "core/base/panic.h"

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

/* ---- Paint ----------------------------------------------------------------------------------- */

/* This section parses the lines that describe a key's paint: the coat (colours) and its marks. */

/* Parses the line `coat BACK FLANK BELLY FIN IRIS CLEAR SHINE`. The parameters are five colours,
 * then the transparency and the reflectance. */
bool text_read_coat(struct species_reader *r)
{
    CORE_ASSERT(r->key);
    struct species_coat *coat = &r->key->coat;
    float clear = 0.0f, shine = 0.0f;
    if (!species_reader_expect(r, 7, "BACK FLANK BELLY FIN IRIS (each as rrggbb) CLEAR SHINE") ||
        !species_reader_colour(r, 1, &coat->back) || !species_reader_colour(r, 2, &coat->flank) ||
        !species_reader_colour(r, 3, &coat->belly) || !species_reader_colour(r, 4, &coat->fin) ||
        !species_reader_colour(r, 5, &coat->iris) ||
        !species_reader_number(r, 6, 0.0f, 1.0f, &clear) ||
        !species_reader_number(r, 7, 0.0f, 1.0f, &shine)) {
        return false;
    }
    coat->clear = (uint8_t)(clear * 255.0f + 0.5f);
    coat->shine = (uint8_t)(shine * 255.0f + 0.5f);
    return true;
}

static const char *const kinds[MARK_COUNT] = {
    [MARK_SPOTS] = "spots", [MARK_BANDS] = "bands", [MARK_STRIPES] = "stripes",
    [MARK_EDGE] = "edge",   [MARK_PATCH] = "patch", [MARK_SIDE] = "side",
    [MARK_ROWS] = "rows",   [MARK_MOUTH] = "mouth", [MARK_GILL] = "gill",
};

/* Default values of the settings of each kind of mark. For a gill mark, `to` is the rear edge of
 * the key's gill cover if the text has a `gill` line. */
static const struct species_mark defaults[MARK_COUNT] = {
    [MARK_SPOTS] = { .count = 24, .seed = 1, .to = 1, .high = 1, .width = 0.02f },
    [MARK_BANDS] = { .count = 5, .seed = 1, .to = 1, .high = 1, .width = 0.04f },
    [MARK_STRIPES] = { .count = 1, .seed = 1, .to = 1, .high = 1, .width = 0.06f },
    [MARK_EDGE] = { .count = 1, .seed = 1, .to = 1, .high = 1, .width = 0.15f },
    [MARK_PATCH] = { .count = 1, .seed = 1, .to = 1, .high = 1, .width = 0.04f },
    [MARK_SIDE] = { .count = 1, .seed = 1, .to = 1, .high = 1, .width = 0.15f },
    [MARK_ROWS] = { .count = 12, .seed = 3, .to = 1, .high = 1, .width = 0.008f },
    [MARK_MOUTH] = { .count = 1,
                     .seed = 1,
                     .to = 0.06f,
                     .low = 0.4f,
                     .high = 0.4f,
                     .width = 0.006f },
    [MARK_GILL] = { .count = 1,
                    .seed = 1,
                    .to = GILL_U,
                    .low = 0.1f,
                    .high = 0.8f,
                    .width = 0.008f,
                    .slant = 0.25f },
};

/* Parses the words `index` and `index` + 1, which are the name of a mark's setting and its
 * value. */
static bool read_setting(const struct species_reader *r, uint32_t index, struct species_mark *m)
{
    static const char *const names[] = { "from",  "to",    "low",   "high",
                                         "width", "slant", "count", "seed" };
    float *const numbers[] = { &m->from, &m->to, &m->low, &m->high, &m->width, &m->slant };
    uint32_t which = 0, value = 0;
    if (!species_reader_choice(r, index, "setting of a mark", names, 8, &which)) {
        return false;
    }
    if (index + 1 == r->word_count) {
        return species_reader_error(r, "'%s' wants a number", r->words[index]);
    }
    if (which < 6) {
        return species_reader_number(r, index + 1, which == 5 ? -1.0f : 0.0f, 1.0f, numbers[which]);
    }
    if (!species_reader_whole(r, index + 1, which == 6 ? 1 : 0, which == 6 ? 120 : 255, &value)) {
        return false;
    }
    *(which == 6 ? &m->count : &m->seed) = (uint8_t)value;
    return true;
}

/* Parses the body part on which a mark lies. For a mark of kind `side`, parses the side of the body
 * and stores it in `count`. */
static bool read_bearer(const struct species_reader *r, struct species_mark *m)
{
    static const char *const sides[] = { [SIDE_RIGHT] = "right", [SIDE_LEFT] = "left" };
    uint32_t value = 0;
    if (m->kind == MARK_SIDE) {
        if (!species_reader_choice(r, 2, "side", sides, 3, &value)) {
            return false;
        }
        m->count = (uint8_t)value;
        return true;
    }
    if (!species_reader_choice(r, 2, "part", part_names, PART_COUNT, &value)) {
        return false;
    }
    m->part = (uint8_t)value;
    if (m->part != PART_BODY && (m->kind == MARK_MOUTH || m->kind == MARK_GILL)) {
        return species_reader_error(r, "a %s is on the body", kinds[m->kind]);
    }
    return true;
}

/* Parses the line `mark KIND PART COLOUR [SETTING NUMBER] ..`, which adds a mark to a part of the
 * fish. */
bool text_read_mark(struct species_reader *r)
{
    CORE_ASSERT(r->key);
    struct species_coat *coat = &r->key->coat;
    uint32_t kind = 0;
    if (r->word_count < 4) {
        return species_reader_error(r, "write: mark KIND PART COLOUR [SETTING NUMBER] ..");
    }
    if (coat->mark_count == MARK_MAX) {
        return species_reader_error(r, "more than %u marks", MARK_MAX);
    }
    if (!species_reader_choice(r, 1, "kind of mark", kinds, MARK_COUNT, &kind)) {
        return false;
    }
    struct species_mark mark = defaults[kind];
    mark.kind = (uint8_t)kind;
    if (kind == MARK_GILL && r->key->gill > 0.0f) {
        mark.to = r->key->gill;
    }
    if (!read_bearer(r, &mark) || !species_reader_colour(r, 3, &mark.colour)) {
        return false;
    }
    for (uint32_t i = 4; i < r->word_count; i += 2) {
        if (!read_setting(r, i, &mark)) {
            return false;
        }
    }
    if (mark.from > mark.to || (mark.kind != MARK_MOUTH && mark.low > mark.high)) {
        return species_reader_error(r, "the mark ends before it starts");
    }
    coat->marks[coat->mark_count++] = mark;
    return true;
}
