/* text.c -- parses a species text. Each line consists of a keyword and its parameters. */
#include "platform/species/reader.h"

#include <string.h>

#include "platform/species/text_file.h"

static const struct {
    const char *word;
    bool of_key;
    bool (*read)(struct species_reader *r);
} line_words[] = {
    { "species", false, text_read_species },
    { "measure", false, text_read_measure },
    { "form", false, text_read_form },
    { "motion", false, text_read_motion },
    { "without", false, text_read_without },
    { "confluent", false, text_read_confluent },
    { "growth", false, text_read_growth },
    { "hatch", false, text_read_hatch },
    { "point", false, text_read_point },
    { "scale", false, text_read_scale },
    { "thesis", false, text_read_thesis },
    { "key", false, text_read_key },
    { "gill", true, text_read_gill },
    { "station", true, text_read_station },
    { "eye", true, text_read_eye },
    { "fin", true, text_read_fin },
    { "ray", true, text_read_ray },
    { "finlets", true, text_read_finlets },
    { "coat", true, text_read_coat },
    { "mark", true, text_read_mark },
    { "curve", false, text_read_curve },
    { "area", false, text_read_area },
    { "knot", false, text_read_knot },
    { "line", false, text_read_line_kind },
    { "template", false, text_read_template },
};

static bool text_read_words(struct species_reader *r)
{
    for (size_t i = 0; i < sizeof line_words / sizeof line_words[0]; i++) {
        if (strcmp(r->words[0], line_words[i].word) == 0) {
            if (line_words[i].of_key && !r->key) {
                return species_reader_error(r, "'%s' stands under a key", r->words[0]);
            }
            return line_words[i].read(r);
        }
    }
    return species_reader_error(r, "'%.40s' is no word of a species", r->words[0]);
}

/* Splits the line into words, which blanks separate. A '#' starts a comment. */
static bool split(struct species_reader *r)
{
    r->text[strcspn(r->text, "#")] = '\0';
    r->word_count = 0;
    char *rest = NULL;
    for (char *word = strtok_r(r->text, " \t\r\n", &rest); word;
         word = strtok_r(NULL, " \t\r\n", &rest)) {
        if (r->word_count == WORD_MAX) {
            return species_reader_error(r, "more than %d words", WORD_MAX);
        }
        r->words[r->word_count++] = word;
    }
    return true;
}

bool species_read(FILE *file, const char *path, FILE *complaints, struct species_text *species)
{
    struct species_reader r = { .path = path, .complaints = complaints, .species = species };
    memset(species, 0, sizeof *species);
    species->curve_count = 1;
    memcpy(species->curves[0].name, "whole", sizeof "whole");
    enum text_file_line got = text_file_line(file, r.text, LINE_SIZE);
    for (; got != TEXT_FILE_END; got = text_file_line(file, r.text, LINE_SIZE)) {
        r.line++;
        if (got != TEXT_FILE_LINE) {
            return got == TEXT_FILE_LONG
                       ? species_reader_error(&r, "the line is longer than %d", LINE_SIZE - 2)
                       : species_reader_error(&r, "a zero byte, and this is to be a text");
        }
        if (!split(&r) || (r.word_count > 0 && !text_read_words(&r))) {
            return false;
        }
    }
    if (ferror(file)) {
        return species_reader_error(&r, "cannot be read further");
    }
    return text_check_species(&r);
}
