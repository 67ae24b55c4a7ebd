/* reader.h -- functions that the parsers of a species' lines share; a line is split into words.
 *
 * Private to text*.c. Every function that returns bool has written its one line of error message
 * when it returns false. */
#ifndef KINGYO_PLATFORM_SPECIES_READER_H
#define KINGYO_PLATFORM_SPECIES_READER_H

#include "platform/species/drawing.h"

#define LINE_SIZE 256
#define WORD_MAX 24
#define THIN_MIN 0.002f /* A leptocephalus of 64 mm is 0.6 mm thin; less has no side. */

struct species_reader {
    const char *path;
    FILE *complaints;
    uint32_t line;
    char text[LINE_SIZE];
    const char *words[WORD_MAX];
    uint32_t word_count;
    struct species_text *species;
    struct key_text *key; /* Key to which a key's line adds; null before the first. */
    struct fin *fin;      /* Fin to which a ray adds; null outside a fin. */
    uint32_t key_line[MORPH_KEY_MAX], curve_line[MORPH_CURVE_MAX]; /* Line number at which each
                                                                      started. */
    bool has_growth, has_hatch, has_thesis;
};

/* Writes 'PATH:LINE: what' and returns false. */
__attribute__((format(printf, 2, 3))) bool species_reader_error(const struct species_reader *r,
                                                                const char *format, ...);

/* Parses word `index` as a number in [low, high]. */
bool species_reader_number(const struct species_reader *r, uint32_t index, float low, float high,
                           float *out);

/* Parses word `index` as an integer in [low, high]. */
bool species_reader_whole(const struct species_reader *r, uint32_t index, uint32_t low,
                          uint32_t high, uint32_t *out);

/* Parses word `index` as a name of a-z, 0-9 and _. */
bool species_reader_name(const struct species_reader *r, uint32_t index,
                         char out[SPECIES_NAME_SIZE]);

/* Parses word `index` as a colour, rrggbb. */
bool species_reader_colour(const struct species_reader *r, uint32_t index, uint32_t *out);

/* Parses word `index` as one of `choices`; null entries are skipped. The error message lists all
 * choices. */
bool species_reader_choice(const struct species_reader *r, uint32_t index, const char *what,
                           const char *const *choices, uint32_t count, uint32_t *out);

/* Returns true if `count` numbers follow the line's first word. Otherwise the error message shows
 * the syntax. */
bool species_reader_expect(const struct species_reader *r, uint32_t count, const char *names);

/* Makers' names of the parts, then of head and trunk. */
extern const char *const part_names[OWNED_COUNT];

/* Implemented in text_life.c. */
bool text_read_species(struct species_reader *r);
bool text_read_measure(struct species_reader *r);
bool text_read_form(struct species_reader *r);
bool text_read_motion(struct species_reader *r);
bool text_read_without(struct species_reader *r);
bool text_read_confluent(struct species_reader *r);
bool text_read_growth(struct species_reader *r);
bool text_read_hatch(struct species_reader *r);
bool text_read_point(struct species_reader *r);
bool text_read_scale(struct species_reader *r);
bool text_read_thesis(struct species_reader *r);

/* Implemented in text_key.c. */
bool text_read_key(struct species_reader *r);
bool text_read_gill(struct species_reader *r);
bool text_read_station(struct species_reader *r);
bool text_read_eye(struct species_reader *r);
bool text_read_fin(struct species_reader *r);
bool text_read_ray(struct species_reader *r);
bool text_read_finlets(struct species_reader *r);

/* Implemented in text_coat.c. */
bool text_read_coat(struct species_reader *r);
bool text_read_mark(struct species_reader *r);

/* Implemented in text_graph.c. */
bool text_read_curve(struct species_reader *r);
bool text_read_area(struct species_reader *r);
bool text_read_knot(struct species_reader *r);
bool text_read_line_kind(struct species_reader *r);
bool text_read_template(struct species_reader *r);

/* Checks in text_check.c that a species is complete and can be lofted. */
bool text_check_species(struct species_reader *r);

#endif
