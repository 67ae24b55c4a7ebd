/* text.c -- parses species texts: the words of one line as numbers, names, colours and choices, the
 * lines of untrusted text files, and the keywords at the start of the lines. */
#include "platform/species/text.h"

#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/panic.h"
#include "platform/os/print.h"
#include "platform/os/file.h"

#define COMPLAINT_SIZE 512

bool species_reader_error(const struct species_reader *r, const char *format, ...)
{
    char text[COMPLAINT_SIZE];
    va_list values;
    va_start(values, format);
    vsnprintf(text, sizeof text, format, values);
    va_end(values);
    print_line(r->complaints, "%s:%u: %s", r->path, r->line, text);
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
        return species_reader_error(r, "'%.40s' is no name: up to %d of a-z, 0-9 and _", word,
                                    (int)SPECIES_NAME_SIZE - 1);
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
        return species_reader_error(r, "'%.40s' is no colour: six of 0-9 and a-f", word);
    }
    *out = (uint32_t)strtoul(word, NULL, 16);
    return true;
}

bool species_reader_choice(const struct species_reader *r, uint32_t index, const char *what,
                           const char *const *choices, uint32_t count, uint32_t *out)
{
    CORE_ASSERT(index < r->word_count);
    char list[TEXT_LINE_SIZE] = "";
    size_t size = 0;
    for (uint32_t i = 0; i < count; i++) {
        if (choices[i] && strcmp(r->words[index], choices[i]) == 0) {
            *out = i;
            return true;
        }
        if (choices[i]) {
            size += (size_t)snprintf(list + size, sizeof list - size, "%s%s", size > 0 ? ", " : "",
                                     choices[i]);
        }
    }
    return species_reader_error(r, "'%.40s' is no %s: %s", r->words[index], what, list);
}

bool species_reader_expect(const struct species_reader *r, uint32_t count, const char *names)
{
    return r->word_count == count + 1 ||
           species_reader_error(r, "write: %s %s", r->words[0], names);
}

/* ---- Text files ------------------------------------------------------------------------------ */

/* This section opens untrusted text files and reads their lines. */

enum text_file_open text_file_open(const char *path, uint32_t size_max, FILE **out,
                                   char why[TEXT_FILE_WHY_SIZE])
{
    const bool fine = size_max % (1u << 20) != 0;
    *out = file_open(path, size_max);
    if (*out) {
        return TEXT_FILE_OPEN;
    }
    if (errno == EFBIG) {
        snprintf(why, TEXT_FILE_WHY_SIZE, "larger than %u %s", size_max >> (fine ? 10 : 20),
                 fine ? "KiB" : "MiB");
        return TEXT_FILE_LARGE;
    }
    snprintf(why, TEXT_FILE_WHY_SIZE, "%s", file_error(errno));
    return TEXT_FILE_NONE;
}

enum text_file_line text_file_line(FILE *file, char *text, size_t size)
{
    CORE_ASSERT(size >= 2);
    size_t length = 0;
    int c = getc(file);
    if (c == EOF) {
        return TEXT_FILE_END;
    }
    for (; c != EOF && c != '\n'; c = getc(file)) {
        if (c == '\0') {
            return TEXT_FILE_ZERO;
        }
        if (length == size - 2) {
            return TEXT_FILE_LONG;
        }
        text[length++] = (char)c;
    }
    text[length] = '\0';
    return TEXT_FILE_LINE;
}

/* ---- Keywords of a species text -------------------------------------------------------------- */

/* This section parses a species text. Each line consists of a keyword and its parameters. */

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

bool species_read(FILE *file, const char *path, FILE *complaints, struct species_text *species)
{
    struct species_reader r = { .path = path, .complaints = complaints, .species = species };
    memset(species, 0, sizeof *species);
    species->curve_count = 1;
    memcpy(species->curves[0].name, "whole", sizeof "whole");
    enum text_file_line got = text_file_line(file, r.text, TEXT_LINE_SIZE);
    for (; got != TEXT_FILE_END; got = text_file_line(file, r.text, TEXT_LINE_SIZE)) {
        r.line++;
        if (got != TEXT_FILE_LINE) {
            return got == TEXT_FILE_LONG
                       ? species_reader_error(&r, "the line is longer than %d", TEXT_LINE_SIZE - 2)
                       : species_reader_error(&r, "a zero byte, and this is to be a text");
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
        if (r.word_count == 0) {
            continue;
        }
        const size_t count = sizeof line_words / sizeof line_words[0];
        size_t i = 0;
        while (i < count && strcmp(r.words[0], line_words[i].word) != 0) {
            i++;
        }
        if (i == count) {
            return species_reader_error(&r, "'%.40s' is no word of a species", r.words[0]);
        }
        if (line_words[i].of_key && !r.key) {
            return species_reader_error(&r, "'%s' stands under a key", r.words[0]);
        }
        if (!line_words[i].read(&r)) {
            return false;
        }
    }
    if (ferror(file)) {
        return species_reader_error(&r, "cannot be read further");
    }
    return text_check_species(&r);
}
