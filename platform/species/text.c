/* text.c -- parses species texts: the words of one line as numbers, names, colours and choices, and
 * the keywords at the start of the lines. Also checks that a parsed text is complete and
 * consistent, so that its meshes can be built. */
#include "platform/species/text.h"

#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/panic.h"
#include "core/morph/morph.h"
#include "platform/os/print.h"
#include "platform/species/shape.h"
#include "platform/os/file.h"

#define COMPLAINT_SIZE 512
/* Maximum coordinate of a point, as a multiple of the fish's length. The limit is slightly below 4,
 * because the largest coordinate of the quantized mesh is 4. */
#define REACH_MAX 3.9
/* Minimum length of the fish, measured as its length measure (enum species_measure) defines. The
 * unit is the drawing's distance from the snout to the tail root. A smaller length indicates an
 * error in the drawing. */
#define UNIT_MIN 0.2
#define EEL_SEAM (1u << PART_TAIL | 1u << PART_DORSAL | 1u << PART_ANAL)
/* Maximum relative difference between the length of a key (modelled growth stage) and the length
 * that the growth curve gives at the key's age. */
#define LENGTH_APART 0.02f

bool species_reader_error(const struct species_reader *r, const char *format, ...)
{
    char text[COMPLAINT_SIZE];
    va_list values;
    va_start(values, format);
    vsnprintf(text, sizeof text, format, values);
    va_end(values);
    print_line(r->errors, "%s:%u: %s", r->path, r->line, text);
    return false;
}

bool species_reader_number(const struct species_reader *r, uint32_t index, float low, float high,
                           float *out)
{
    CORE_ASSERT(index < r->word_count);
    CORE_ASSERT(low <= high);
    char *end = NULL;
    const float value = strtof(r->words[index], &end);
    if (*end != '\0' || !isfinite(value)) {
        return species_reader_error(r, "'%.40s' is not a number", r->words[index]);
    }
    if (value < low || value > high) {
        return species_reader_error(r, "%.40s is outside %g .. %g", r->words[index], (double)low,
                                    (double)high);
    }
    *out = value;
    return true;
}

bool species_reader_numbers(const struct species_reader *r, uint32_t index,
                            const struct range *ranges, uint32_t count, void *out)
{
    float numbers[TEXT_WORD_MAX];
    CORE_ASSERT(count <= TEXT_WORD_MAX);
    for (uint32_t i = 0; i < count; i++) {
        if (!species_reader_number(r, index + i, ranges[i].low, ranges[i].high, &numbers[i])) {
            return false;
        }
    }
    memcpy(out, numbers, count * sizeof numbers[0]);
    return true;
}

bool species_reader_whole(const struct species_reader *r, uint32_t index, uint32_t low,
                          uint32_t high, uint32_t *out)
{
    float value = 0.0f;
    if (!species_reader_number(r, index, (float)low, (float)high, &value)) {
        return false;
    }
    if (value != floorf(value)) {
        return species_reader_error(r, "%.40s is not a whole number", r->words[index]);
    }
    *out = (uint32_t)value;
    return true;
}

bool species_reader_name(const struct species_reader *r, uint32_t index,
                         char out[SPECIES_NAME_SIZE])
{
    CORE_ASSERT(index < r->word_count);
    const char *word = r->words[index];
    const size_t size = strspn(word, "abcdefghijklmnopqrstuvwxyz0123456789_");
    if (size == 0 || word[size] != '\0' || size >= SPECIES_NAME_SIZE) {
        return species_reader_error(r, "'%.40s' is not a name (1 to %d characters a-z, 0-9 and _)",
                                    word, (int)SPECIES_NAME_SIZE - 1);
    }
    memset(out, 0, SPECIES_NAME_SIZE);
    memcpy(out, word, size);
    return true;
}

bool species_reader_colour(const struct species_reader *r, uint32_t index, uint32_t *out)
{
    CORE_ASSERT(index < r->word_count);
    const char *word = r->words[index];
    if (strlen(word) != 6 || strspn(word, "0123456789abcdef") != 6) {
        return species_reader_error(r, "'%.40s' is not a colour (six digits 0-9 and a-f)", word);
    }
    *out = (uint32_t)strtoul(word, NULL, 16);
    return true;
}

bool species_reader_choice(const struct species_reader *r, uint32_t index, const char *what,
                           const char *const *choices, uint32_t count, uint8_t *out)
{
    CORE_ASSERT(index < r->word_count);
    char list[TEXT_LINE_SIZE] = "";
    size_t size = 0;
    for (uint32_t i = 0; i < count; i++) {
        if (choices[i] && strcmp(r->words[index], choices[i]) == 0) {
            *out = (uint8_t)i;
            return true;
        }
        if (choices[i]) {
            size += (size_t)snprintf(list + size, sizeof list - size, "%s%s", size > 0 ? ", " : "",
                                     choices[i]);
        }
    }
    return species_reader_error(r, "'%.40s' is not a %s; valid words are: %s", r->words[index],
                                what, list);
}

bool species_reader_room(const struct species_reader *r, uint32_t count, uint32_t count_max,
                         const char *what)
{
    CORE_ASSERT(count <= count_max);
    return count < count_max || species_reader_error(r, "more than %u %s", count_max, what);
}

/* ---- Checks of a complete species text ------------------------------------------------------- */

/* Checks that key number `index` (a modelled growth stage) has the same fins and finlets as the
 * first key. The morph requires that each vertex has a counterpart in every key. */
static bool check_fins(const struct species_reader *r, uint32_t index)
{
    CORE_ASSERT(r->species->card.key_count > 0);
    const struct key_text *key = &r->species->keys[index], *first = &r->species->keys[0];
    const char *name = r->species->card.key_names[index];
    const char *first_name = r->species->card.key_names[0];
    for (uint32_t part = PART_TAIL; part <= PART_DORSAL_2; part++) {
        const struct fin *fin = &key->fins[part];
        const bool wanted = part == PART_DORSAL_2 ? first->fins[part].ray_count > 0
                                                  : !(r->species->without >> part & 1u);
        if (!wanted && fin->ray_count > 0) {
            return species_reader_error(r, "key %s has a %s, but key %s has none", name,
                                        part_names[part], first_name);
        }
        if (wanted && (fin->ray_count < 2 || fin->rays[fin->ray_count - 1].at != 1.0f)) {
            return species_reader_error(
                r, "key %s: the %s needs two or more rays from 0 to 1%s", name, part_names[part],
                part == PART_DORSAL_2 ? "" : " (or write 'without' at the top)");
        }
    }
    for (int row = 0; row < 2; row++) {
        if (key->finlets[row].count != first->finlets[row].count) {
            return species_reader_error(r, "key %s has %u %s finlets, but key %s has %u", name,
                                        key->finlets[row].count, row == 0 ? "upper" : "lower",
                                        first_name, first->finlets[row].count);
        }
    }
    return true;
}

static bool check_key(const struct species_reader *r, uint32_t index)
{
    const struct key_text *key = &r->species->keys[index];
    const char *name = r->species->card.key_names[index];
    const bool has_gill = key->gill > 0.0f, first_has = r->species->keys[0].gill > 0.0f;
    if (key->substep_count < 4 || key->stations[key->substep_count - 1].x != 1.0f) {
        return species_reader_error(r, "key %s needs four or more stations from x 0 to x 1", name);
    }
    if (has_gill != first_has) {
        return species_reader_error(r, "key %s has %s; write a gill in all keys or in none", name,
                                    has_gill ? "a gill, but the first key has none"
                                             : "no gill, but the first key has one");
    }
    for (int side = 0; side < 2; side++) {
        const struct eye *eye = &key->eyes[side];
        if (eye->diameter <= 0.0f) {
            return species_reader_error(r, "key %s has no %s eye", name,
                                        side == 0 ? "right" : "left");
        }
        if (eye->x < 0.5f * eye->diameter) {
            return species_reader_error(r, "key %s: the eye reaches beyond the snout", name);
        }
    }
    if (!check_fins(r, index)) {
        return false;
    }
    const enum species_measure measure = (enum species_measure)r->species->card.measure;
    const double unit = shape_unit_length(key, measure), farthest = shape_farthest(key);
    if (!(unit >= UNIT_MIN)) {
        return species_reader_error(
            r, "key %s: the measured length is %.2g of the drawing; %g is the minimum", name, unit,
            UNIT_MIN);
    }
    return farthest <= REACH_MAX * unit ||
           species_reader_error(
               r, "key %s: a point is %.3g times the measured length away; %g is the maximum", name,
               farthest / unit, REACH_MAX);
}

/* Computes missing ages from the lengths. Then checks that the ages increase from key to key, and
 * that the growth curve matches the keys' lengths. */
static bool check_ages(struct species_reader *r)
{
    struct species_card *card = &r->species->card;
    for (uint32_t i = 0; i < card->key_count; i++) {
        const char *name = card->key_names[i];
        const float key_m = card->key_length_m[i];
        float *age_days = &card->key_age_days[i];
        r->line = r->key_line[i];
        const bool has_age = *age_days >= 0.0f;
        if (!has_age) {
            *age_days = growth_age_days(&card->growth, key_m);
        }
        const float length_m = growth_length_m(&card->growth, *age_days);
        const bool apart = f_abs(length_m / key_m - 1.0f) > LENGTH_APART;
        if (!has_age && apart) {
            return species_reader_error(
                r,
                "key %s is %g mm long, but the growth curve never has this length "
                "(%.4g mm at %.4g days)",
                name, (double)(key_m * 1000.0f), (double)(length_m * 1000.0f), (double)*age_days);
        }
        if (i > 0 && *age_days <= age_days[-1]) {
            return species_reader_error(
                r, "key %s (%.4g days) is not older than key %s (%.4g days)", name,
                (double)*age_days, card->key_names[i - 1], (double)age_days[-1]);
        }
        /* The age, the progress and the length of a key must be consistent, because some parts of
         * the program compute one of the three values from the others. */
        if (apart) {
            return species_reader_error(
                r,
                "key %s is %.4g mm long at %.4g days, but the growth curve gives %.4g mm; "
                "write a point",
                name, (double)(key_m * 1000.0f), (double)*age_days, (double)(length_m * 1000.0f));
        }
    }
    return true;
}

static bool check_curves(struct species_reader *r)
{
    const struct species_card *card = &r->species->card;
    for (uint32_t i = 0; i < card->curve_count; i++) {
        const struct graph *graph = &card->curves[i];
        const char *name = card->curve_names[i];
        r->line = i > 0 ? r->curve_line[i] : r->line;
        if (graph->knot_count < 2 || graph->knots[graph->knot_count - 1].progress != 1.0f) {
            return species_reader_error(
                r, "the graph%s%s needs knots from progress 0 to 1, or a template",
                i > 0 ? " of curve " : "", i > 0 ? name : "");
        }
        if (i > 0 && r->species->curves[i].parts == 0 && r->species->curves[i].area_count == 0) {
            return species_reader_error(r, "curve %s moves no part and no area", name);
        }
        /* If the species text has the line `line solved` for this graph, graph_solve() must find a
         * solution for its weights. */
        float solution[MORPH_KEY_MAX][MORPH_KEY_MAX];
        uint32_t stuck = 0;
        if (graph->solved && !graph_solve(graph, card->key_count, solution, &stuck)) {
            return species_reader_error(
                r,
                "the graph of %s cannot be solved, because key %s has too little weight at its "
                "own progress",
                name, card->key_names[stuck]);
        }
    }
    return true;
}

/* Checks that the species is complete and that its meshes can be built. */
static bool check_species(struct species_reader *r)
{
    struct species_text *s = r->species;
    struct species_card *card = &s->card;
    CORE_ASSERT(card->key_count <= MORPH_KEY_MAX);
    CORE_ASSERT(card->curve_count >= 1 && card->curve_count <= MORPH_CURVE_MAX);
    if (card->id[0] == '\0') {
        return species_reader_error(r, "the line 'species ID' is missing");
    }
    if (!r->has_growth || card->growth.point_count == 0) {
        return species_reader_error(r, "the line 'growth' or 'hatch' is missing");
    }
    if (card->key_count < 3) {
        return species_reader_error(r, "the species has fewer than three keys");
    }
    if (!check_curves(r)) {
        return false;
    }
    if (card->scale_knot_count > 0 &&
        card->scale_knots[card->scale_knot_count - 1].progress != 1.0f) {
        return species_reader_error(r, "the last scale knot must be at progress 1");
    }
    if (s->confluent && (s->without & EEL_SEAM) != 0) {
        return species_reader_error(
            r,
            "confluent fins need the dorsal, tail and anal fin, but 'without' lists one of these "
            "fins");
    }
    if (s->confluent && s->double_tail) {
        return species_reader_error(r, "confluent fins cannot have a double tail");
    }
    for (uint32_t i = 0; i < card->key_count; i++) {
        s->keys[i].confluent = s->confluent;
        s->keys[i].double_tail = s->double_tail;
        r->line = r->key_line[i];
        if (!check_key(r, i)) {
            return false;
        }
    }
    if (!r->has_thesis) {
        /* If the species text has no `thesis` line, the blend of the 2005 thesis uses the first,
         * the middle and the last key, and the pairwise template. */
        card->thesis_key[1] = (uint8_t)(card->key_count / 2u);
        card->thesis_key[2] = (uint8_t)(card->key_count - 1u);
        card->thesis_template = TEMPLATE_PAIRWISE;
    }
    return check_ages(r);
}

/* ---- Keywords of a species text -------------------------------------------------------------- */

/* This section parses a species text. Each line consists of a keyword and its parameters. */

static const struct line_word *find_word(const struct line_word *words, const char *word)
{
    while (words->word && strcmp(words->word, word) != 0) {
        words++;
    }
    return words->word ? words : NULL;
}

/* Parses one line, which has been split into words. */
static bool read_line(struct species_reader *r)
{
    const struct line_word *word = find_word(text_life_words, r->words[0]);
    if (!word) {
        word = find_word(text_key_words, r->words[0]);
        if (!word) {
            return species_reader_error(r, "'%.40s' is not a keyword of a species text",
                                        r->words[0]);
        }
        if (!r->key && word != text_key_words) {
            return species_reader_error(r, "'%s' must be below a 'key' line", r->words[0]);
        }
    }
    if (r->word_count <= word->least || r->word_count > word->most + 1) {
        return species_reader_error(r, "write: %s %s", word->word, word->names);
    }
    return word->read(r);
}

bool species_read(FILE *file, const char *path, FILE *errors, struct species_text *species)
{
    struct species_reader r = { .path = path, .errors = errors, .species = species };
    memset(species, 0, sizeof *species);
    species->card.curve_count = 1;
    memcpy(species->card.curve_names[0], "whole", sizeof "whole");
    enum file_line got;
    while ((got = file_read_line(file, r.text, sizeof r.text)) != FILE_LINE_END) {
        r.line++;
        if (got == FILE_LINE_BAD) {
            return species_reader_error(
                &r, "the line is longer than %d characters or contains a zero byte",
                TEXT_LINE_SIZE - 1);
        }
        /* Split the line at blanks into words. A '#' starts a comment. */
        r.text[strcspn(r.text, "#")] = '\0';
        r.word_count = 0;
        char *rest = NULL;
        for (char *word = strtok_r(r.text, " \t\r\n", &rest); word;
             word = strtok_r(NULL, " \t\r\n", &rest)) {
            if (r.word_count == TEXT_WORD_MAX) {
                return species_reader_error(&r, "more than %d words", TEXT_WORD_MAX);
            }
            r.words[r.word_count++] = word;
        }
        if (r.word_count > 0 && !read_line(&r)) {
            return false;
        }
    }
    return ferror(file) ? species_reader_error(&r, "a read error occurred") : check_species(&r);
}
