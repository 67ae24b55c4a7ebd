/* text.h -- the parser of species texts. The files text*.c share this header.
 *
 * Each line of a species text is split into words. A function that returns bool returns true on
 * success. On an error the function writes one line with the error message and returns false. */
#pragma once

#include "platform/species/drawing.h"
#include "platform/species/part.h"

#define TEXT_LINE_SIZE 256
#define TEXT_WORD_MAX 24
/* Minimum width and height of a cross section behind the snout, as a fraction of the distance from
 * the snout to the tail root. A thinner body has no usable flank. For comparison, a leptocephalus
 * larva (64 mm long, 0.6 mm wide) has a width of about 0.01. */
#define THIN_MIN 0.002f

struct species_reader {
    const char *path;
    FILE *errors;
    uint32_t line;
    char text[TEXT_LINE_SIZE];
    const char *words[TEXT_WORD_MAX];
    uint32_t word_count;
    struct species_text *species;
    /* Key (modelled growth stage) to which the current line belongs. Null before the first key. */
    struct key_text *key;
    /* Fin to which a `ray` line belongs. Null if the current line belongs to no fin. */
    struct fin *fin;
    /* Line numbers in the file at which each key and each curve starts. */
    uint32_t key_line[MORPH_KEY_MAX], curve_line[MORPH_CURVE_MAX];
    bool has_growth, has_thesis;
};

/* A keyword at the start of a line, its parameters, and the function that parses the line. */
struct line_word {
    const char *word;
    uint32_t least, most; /* Allowed number of parameters after the keyword. */
    /* Names of the parameters, which the error message for a wrong number of parameters shows. */
    const char *names;
    /* Parses the parameters and stores their values. The caller has checked the number of
     * parameters. */
    bool (*read)(struct species_reader *r);
};

/* Keywords of a whole species and of its deformation graphs (text_life.c), and keywords of a key
 * (text_key.c). The last entry of each table has a null word. The lines that begin with a keyword
 * of text_key_words, except `key`, are valid only below a `key` line. */
extern const struct line_word text_life_words[], text_key_words[];

/* Writes the error message 'PATH:LINE: what' and returns false. `format` and the arguments produce
 * `what`. */
__attribute__((format(printf, 2, 3))) bool species_reader_error(const struct species_reader *r,
                                                                const char *format, ...);

/* Parses word `index` as a number in [low, high]. */
bool species_reader_number(const struct species_reader *r, uint32_t index, float low, float high,
                           float *out);

struct range {
    float low, high;
};

/* Parses `count` words, beginning with word `index`, as numbers, each within its own range. Copies
 * the numbers to `out`, an array or a structure of floats. Leaves `out` unchanged on an error. */
bool species_reader_numbers(const struct species_reader *r, uint32_t index,
                            const struct range *ranges, uint32_t count, void *out);

/* Parses word `index` as an integer in [low, high]. */
bool species_reader_whole(const struct species_reader *r, uint32_t index, uint32_t low,
                          uint32_t high, uint32_t *out);

/* Parses word `index` as a name, which consists of the characters a-z, 0-9 and _. */
bool species_reader_name(const struct species_reader *r, uint32_t index,
                         char out[SPECIES_NAME_SIZE]);

/* Parses word `index` as a colour of six hexadecimal digits, rrggbb. */
bool species_reader_colour(const struct species_reader *r, uint32_t index, uint32_t *out);

/* Parses word `index` as one of the words in `choices`. Writes the array index of the matching
 * choice to `out`. Null entries of `choices` are skipped. The error message lists all choices. */
bool species_reader_choice(const struct species_reader *r, uint32_t index, const char *what,
                           const char *const *choices, uint32_t count, uint8_t *out);

/* Returns true if a table with `count` entries has room for another entry. Otherwise writes an
 * error message with the name `what` of the entries, and returns false. */
bool species_reader_room(const struct species_reader *r, uint32_t count, uint32_t count_max,
                         const char *what);
