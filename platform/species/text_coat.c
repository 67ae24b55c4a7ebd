/* text_coat.c -- parses the lines that describe a key's paint: the coat (colours) and its marks. */
#include "platform/species/reader.h"

#include <string.h>

/* Parses the line `coat BACK FLANK BELLY FIN IRIS CLEAR SHINE`. The parameters are five colours,
 * then the transparency and the reflectance. */
bool text_read_coat(struct species_reader *r)
{
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

/* Returns a mark of kind `kind` with the default values of all settings. */
static struct species_mark usual(uint32_t kind, const struct key_text *key)
{
    struct species_mark m = { .kind = (uint8_t)kind, .count = 1, .seed = 1, .to = 1, .high = 1 };
    switch (kind) {
    case MARK_SPOTS:
        m.count = 24;
        m.width = 0.02f;
        break;
    case MARK_BANDS:
        m.count = 5;
        m.width = 0.04f;
        break;
    case MARK_STRIPES:
        m.width = 0.06f;
        break;
    case MARK_EDGE:
        m.width = 0.15f;
        break;
    case MARK_PATCH:
        m.width = 0.04f;
        break;
    case MARK_SIDE:
        m.width = 0.15f;
        break;
    case MARK_ROWS:
        m.count = 12;
        m.seed = 3;
        m.width = 0.008f;
        break;
    case MARK_MOUTH:
        m.to = 0.06f;
        m.width = 0.006f;
        m.low = m.high = 0.4f;
        break;
    case MARK_GILL:
        m.to = key->gill > 0.0f ? key->gill : GILL_U;
        m.width = 0.008f;
        m.slant = 0.25f;
        m.low = 0.1f;
        m.high = 0.8f;
        break;
    default:
        break;
    }
    return m;
}

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
    struct species_mark mark = usual(kind, r->key);
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
