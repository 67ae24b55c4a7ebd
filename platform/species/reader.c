/* reader.c -- parses the words of one line as numbers, names, colours and choices. */
#include "platform/species/reader.h"

#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include "platform/os/print.h"

#define COMPLAINT_SIZE 512

const char *const part_names[OWNED_COUNT] = {
    [PART_BODY] = "body",
    [PART_EYE] = "eye",
    [PART_TAIL] = "tail",
    [PART_DORSAL] = "dorsal",
    [PART_ANAL] = "anal",
    [PART_PECTORAL] = "pectoral",
    [PART_PELVIC] = "pelvic",
    [PART_DORSAL_2] = "dorsal2",
    [PART_FINLET_UPPER] = "finlets_upper",
    [PART_FINLET_LOWER] = "finlets_lower",
    [PART_HEAD] = "head",
    [PART_TRUNK] = "trunk",
};

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
    char list[LINE_SIZE] = "";
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
