/* text.c -- parses a species' text: one fact a line, a keyword and its numbers. */
#include "platform/species/reader.h"

#include <string.h>

#include "platform/species/plain.h"

static const struct {
    const char *word;
    bool of_key;
    bool (*read)(struct reader *r);
} line_words[] = {
    { "species", false, read_species },
    { "measure", false, read_measure },
    { "form", false, read_form },
    { "motion", false, read_motion },
    { "without", false, read_without },
    { "confluent", false, read_confluent },
    { "growth", false, read_growth },
    { "hatch", false, read_hatch },
    { "point", false, read_point },
    { "scale", false, read_scale },
    { "thesis", false, read_thesis },
    { "key", false, read_key },
    { "gill", true, read_gill },
    { "station", true, read_station },
    { "eye", true, read_eye },
    { "fin", true, read_fin },
    { "ray", true, read_ray },
    { "finlets", true, read_finlets },
    { "coat", true, read_coat },
    { "mark", true, read_mark },
    { "curve", false, read_curve },
    { "area", false, read_area },
    { "knot", false, read_knot },
    { "line", false, read_line_kind },
    { "template", false, read_template },
};

static bool read_words(struct reader *r)
{
    for (size_t i = 0; i < sizeof line_words / sizeof line_words[0]; i++) {
        if (strcmp(r->words[0], line_words[i].word) == 0) {
            if (line_words[i].of_key && !r->key) {
                return refuse(r, "'%s' stands under a key", r->words[0]);
            }
            return line_words[i].read(r);
        }
    }
    return refuse(r, "'%.40s' is no word of a species", r->words[0]);
}

/* Splits the line into words at blanks; '#' starts a comment. */
static bool split(struct reader *r)
{
    r->text[strcspn(r->text, "#")] = '\0';
    r->word_count = 0;
    char *rest = NULL;
    for (char *word = strtok_r(r->text, " \t\r\n", &rest); word;
         word = strtok_r(NULL, " \t\r\n", &rest)) {
        if (r->word_count == WORD_MAX) {
            return refuse(r, "more than %d words", WORD_MAX);
        }
        r->words[r->word_count++] = word;
    }
    return true;
}

bool species_read(FILE *file, const char *path, FILE *complaints, struct species_text *species)
{
    struct reader r = { .path = path, .complaints = complaints, .species = species };
    memset(species, 0, sizeof *species);
    species->curve_count = 1;
    memcpy(species->curves[0].name, "whole", sizeof "whole");
    enum plain_line got = plain_line(file, r.text, LINE_SIZE);
    for (; got != PLAIN_END; got = plain_line(file, r.text, LINE_SIZE)) {
        r.line++;
        if (got != PLAIN_LINE) {
            return got == PLAIN_LONG ? refuse(&r, "the line is longer than %d", LINE_SIZE - 2)
                                     : refuse(&r, "a zero byte, and this is to be a text");
        }
        if (!split(&r) || (r.word_count > 0 && !read_words(&r))) {
            return false;
        }
    }
    if (ferror(file)) {
        return refuse(&r, "cannot be read further");
    }
    return check_species(&r);
}
