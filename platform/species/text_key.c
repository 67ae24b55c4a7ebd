/* text_key.c -- parses the lines of one key (modelled growth stage): stations (cross sections of
 * the body), eyes, fins and paint. */
#include "platform/species/text.h"

#include <string.h>

#include "core/base/panic.h"

#define COUNT(array) (sizeof(array) / sizeof(array)[0])

static bool read_key(struct species_reader *r)
{
    struct species_card *card = &r->species->card;
    const uint32_t key = card->key_count;
    if (!species_reader_room(r, key, MORPH_KEY_MAX, "keys")) {
        return false;
    }
    if (card->curve_count > 1 || card->curves[0].knot_count > 0) {
        return species_reader_error(r, "all keys must be above the first knot, template or curve");
    }
    char *name = card->key_names[key];
    float *length_m = &card->key_length_m[key], *age_days = &card->key_age_days[key];
    *age_days = -1.0f;
    if (!species_reader_name(r, 1, name) ||
        !species_reader_number(r, 2, 0.5f, 20000.0f, length_m) ||
        (r->word_count == 4 && !species_reader_number(r, 3, 0.0f, 14610.0f, age_days))) {
        return false;
    }
    *length_m /= 1000.0f;
    for (uint32_t i = 0; i < key; i++) {
        if (strcmp(name, card->key_names[i]) == 0) {
            return species_reader_error(r, "the key %s exists already", name);
        }
    }
    if (key > 0 && *age_days < 0.0f && *length_m <= length_m[-1]) {
        return species_reader_error(
            r, "the length must increase from key to key; otherwise write the age: key NAME MM "
               "AGE_DAYS");
    }
    r->key = &r->species->keys[key];
    r->fin = NULL;
    r->key_line[card->key_count++] = r->line;
    return true;
}

/* Parses the line `gill X`, which sets the rear edge of the gill cover. The head ends at this
 * edge. */
static bool read_gill(struct species_reader *r)
{
    return species_reader_number(r, 1, 0.02f, 0.60f, &r->key->gill);
}

static bool read_station(struct species_reader *r)
{
    static const struct range ranges[] = {
        { 0.0f, 1.0f }, { 0.0f, 1.5f }, { 0.0f, 2.0f }, { -0.5f, 0.5f }, { 0.7f, 6.0f }
    };
    struct key_text *key = r->key;
    struct station *s = &key->stations[key->substep_count];
    if (!species_reader_room(r, key->substep_count, STATION_MAX, "stations") ||
        !species_reader_numbers(r, 1, ranges, COUNT(ranges), s)) {
        return false;
    }
    if (key->substep_count == 0 ? s->x != 0.0f : s->x <= s[-1].x) {
        return species_reader_error(r, "the first station must be at x 0, and x must increase");
    }
    if (key->substep_count > 0 && (s->depth < THIN_MIN || s->width < THIN_MIN)) {
        return species_reader_error(r, "only the snout may be thinner than %g", (double)THIN_MIN);
    }
    key->substep_count++;
    return true;
}

static const char eye_parameters[] =
    "X Y DIAMETER BULGE, or eye right|left X Y DIAMETER BULGE [TURN]";

/* Parses the line `eye [right|left] X Y DIAMETER BULGE [TURN]`. If the side is omitted, the line
 * sets both eyes. */
static bool read_eye(struct species_reader *r)
{
    static const char *const sides[] = { "right", "left" };
    static const struct range ranges[] = {
        { 0.005f, 0.5f }, { -0.5f, 0.5f }, { 0.004f, 0.3f }, { 0.0f, 1.2f }, { 0.0f, 180.0f }
    };
    struct eye eye = { 0 };
    uint8_t first = 0, last = 1;
    const bool one = r->words[1][0] >= 'a' && r->words[1][0] <= 'z';
    const uint32_t at = one ? 2 : 1, count = r->word_count - at;
    if (count != 4 && (!one || count != 5)) {
        return species_reader_error(r, "write: eye %s", eye_parameters);
    }
    if (one) {
        if (!species_reader_choice(r, 1, "side", sides, 2, &first)) {
            return false;
        }
        last = first;
    }
    if (!species_reader_numbers(r, at, ranges, count, &eye)) {
        return false;
    }
    for (uint32_t i = first; i <= last; i++) {
        if (r->key->eyes[i].diameter > 0.0f) {
            return species_reader_error(r, "the %s eye exists already", sides[i]);
        }
        r->key->eyes[i] = eye;
    }
    return true;
}

static bool read_fin(struct species_reader *r)
{
    uint8_t part = 0;
    if (!species_reader_choice(r, 1, "fin", &part_names[PART_TAIL], PART_DORSAL_2 - PART_TAIL + 1,
                               &part)) {
        return false;
    }
    part = (uint8_t)(part + PART_TAIL);
    r->fin = &r->key->fins[part];
    if (r->fin->ray_count > 0) {
        return species_reader_error(r, "the fin %s exists already", part_names[part]);
    }
    if (r->species->without >> part & 1u) {
        return species_reader_error(r, "the species has no %s ('without' at the top)",
                                    part_names[part]);
    }
    /* The base of the tail fin extends along the y axis. The base of any other fin extends along
     * the x axis. */
    const float low = part == PART_TAIL ? -0.5f : 0.0f;
    const struct range ranges[] = {
        { low, 1.0f }, { low, 1.0f }, { 0.0f, 0.5f }, { -90.0f, 90.0f }
    };
    return species_reader_numbers(r, 2, ranges, COUNT(ranges), r->fin) &&
           (r->fin->start < r->fin->end ||
            species_reader_error(r, "the fin ends before it starts"));
}

static bool read_ray(struct species_reader *r)
{
    static const struct range ranges[] = {
        { 0.0f, 1.0f }, { THIN_MIN, 2.0f }, { -120.0f, 150.0f }, { -90.0f, 90.0f }
    };
    if (!r->fin) {
        return species_reader_error(r, "a 'ray' line must be below a 'fin' line");
    }
    struct ray *ray = &r->fin->rays[r->fin->ray_count];
    if (!species_reader_room(r, r->fin->ray_count, RAY_MAX, "rays") ||
        !species_reader_numbers(r, 1, ranges, COUNT(ranges), ray)) {
        return false;
    }
    if (r->fin->ray_count == 0 ? ray->at != 0.0f : ray->at <= ray[-1].at) {
        return species_reader_error(r,
                                    "the first ray must be at 0, and the position must increase");
    }
    r->fin->ray_count++;
    return true;
}

/* Parses the line `finlets upper|lower COUNT START END LENGTH SWEEP`, which defines a row of
 * finlets. A tuna has a row behind its second dorsal fin and a row behind its anal fin. */
static bool read_finlets(struct species_reader *r)
{
    static const char *const rows[] = { "upper", "lower" };
    static const struct range ranges[] = {
        { 0.1f, 1.0f }, { 0.1f, 1.0f }, { THIN_MIN, 0.3f }, { 0.0f, 85.0f }
    };
    uint8_t row = 0;
    if (!species_reader_choice(r, 1, "row of finlets", rows, 2, &row)) {
        return false;
    }
    struct finlets *f = &r->key->finlets[row];
    if (f->count > 0) {
        return species_reader_error(r, "the %s row of finlets exists already", rows[row]);
    }
    return species_reader_whole(r, 2, 1, FINLET_MAX, &f->count) &&
           species_reader_numbers(r, 3, ranges, COUNT(ranges), f) &&
           (f->start < f->end || species_reader_error(r, "the row ends before it starts"));
}

/* ---- Lines of the paint ---------------------------------------------------------------------- */

/* This section parses the lines that describe a key's paint: the coat (colours) and its marks. */

/* Parses the line `coat BACK FLANK BELLY FIN IRIS CLEAR SHINE`. The parameters are five colours,
 * then the transparency and the reflectance. */
static bool read_coat(struct species_reader *r)
{
    static const struct range ranges[] = { { 0.0f, 1.0f }, { 0.0f, 1.0f } };
    struct species_coat *coat = &r->key->coat;
    uint32_t *const colours[] = { &coat->back, &coat->flank, &coat->belly, &coat->fin,
                                  &coat->iris };
    float shares[2];
    for (uint32_t i = 0; i < COUNT(colours); i++) {
        if (!species_reader_colour(r, 1 + i, colours[i])) {
            return false;
        }
    }
    if (!species_reader_numbers(r, 6, ranges, COUNT(ranges), shares)) {
        return false;
    }
    coat->clear = (uint8_t)(shares[0] * 255.0f + 0.5f);
    coat->shine = (uint8_t)(shares[1] * 255.0f + 0.5f);
    return true;
}

static const char *const kinds[MARK_COUNT] = {
    [MARK_SPOTS] = "spots", [MARK_BANDS] = "bands", [MARK_STRIPES] = "stripes",
    [MARK_EDGE] = "edge",   [MARK_PATCH] = "patch", [MARK_SIDE] = "side",
    [MARK_ROWS] = "rows",   [MARK_MOUTH] = "mouth", [MARK_GILL] = "gill",
};

/* Default settings of each kind of mark. If the species text has a `gill` line, the default of `to`
 * of a gill mark is replaced by the position on that line. */
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
    uint32_t value = 0;
    uint8_t which = 0;
    if (!species_reader_choice(r, index, "setting of a mark", names, 8, &which)) {
        return false;
    }
    if (index + 1 == r->word_count) {
        return species_reader_error(r, "a number is missing after '%s'", r->words[index]);
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

/* Parses the body part on which a mark lies, and stores the part in m->part. For a mark of kind
 * `side`, which covers one side of the body, parses the side instead and stores the side in
 * m->count. */
static bool read_bearer(const struct species_reader *r, struct species_mark *m)
{
    static const char *const sides[] = { [SIDE_RIGHT] = "right", [SIDE_LEFT] = "left" };
    if (m->kind == MARK_SIDE) {
        return species_reader_choice(r, 2, "side", sides, 3, &m->count);
    }
    if (!species_reader_choice(r, 2, "part", part_names, PART_COUNT, &m->part)) {
        return false;
    }
    if (m->part != PART_BODY && (m->kind == MARK_MOUTH || m->kind == MARK_GILL)) {
        return species_reader_error(r, "a %s must be on the body", kinds[m->kind]);
    }
    return true;
}

/* Parses the line `mark KIND PART COLOUR [SETTING NUMBER] ..`, which adds a mark to a part of the
 * fish. */
static bool read_mark(struct species_reader *r)
{
    CORE_ASSERT(r->key);
    struct species_coat *coat = &r->key->coat;
    uint8_t kind = 0;
    if (!species_reader_room(r, coat->mark_count, MARK_MAX, "marks") ||
        !species_reader_choice(r, 1, "kind of mark", kinds, MARK_COUNT, &kind)) {
        return false;
    }
    struct species_mark mark = defaults[kind];
    mark.kind = kind;
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

const struct line_word text_key_words[] = {
    { "key", 2, 3, "NAME MM [AGE_DAYS]", read_key },
    { "gill", 1, 1, "X", read_gill },
    { "station", 5, 5, "X DEPTH WIDTH OFFSET EXPONENT", read_station },
    { "eye", 4, 6, eye_parameters, read_eye },
    { "fin", 5, 5, "tail|dorsal|dorsal2|anal|pectoral|pelvic START END GIRTH CURL", read_fin },
    { "ray", 4, 4, "AT LENGTH SWEEP SIDE", read_ray },
    { "finlets", 6, 6, "upper|lower COUNT START END LENGTH SWEEP", read_finlets },
    { "coat", 7, 7, "BACK FLANK BELLY FIN IRIS (each as rrggbb) CLEAR SHINE", read_coat },
    { "mark", 3, TEXT_WORD_MAX, "KIND PART COLOUR [SETTING NUMBER] ..", read_mark },
    { NULL, 0, 0, NULL, NULL },
};
