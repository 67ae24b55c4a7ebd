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

struct reader {
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
__attribute__((format(printf, 2, 3))) bool refuse(const struct reader *r, const char *format, ...);

/* Parses word `index` as a number in [low, high]. */
bool number(const struct reader *r, uint32_t index, float low, float high, float *out);

/* Parses word `index` as an integer in [low, high]. */
bool whole(const struct reader *r, uint32_t index, uint32_t low, uint32_t high, uint32_t *out);

/* Parses word `index` as a name of a-z, 0-9 and _. */
bool name(const struct reader *r, uint32_t index, char out[SPECIES_NAME_SIZE]);

/* Parses word `index` as a colour, rrggbb. */
bool colour(const struct reader *r, uint32_t index, uint32_t *out);

/* Parses word `index` as one of `choices`; null entries are skipped. The error message lists all
 * choices. */
bool choice(const struct reader *r, uint32_t index, const char *what, const char *const *choices,
            uint32_t count, uint32_t *out);

/* Returns true if `count` numbers follow the line's first word. Otherwise the error message shows
 * the syntax. */
bool wants(const struct reader *r, uint32_t count, const char *names);

/* Makers' names of the parts, then of head and trunk. */
extern const char *const part_names[OWNED_COUNT];

/* Implemented in text_life.c. */
bool read_species(struct reader *r);
bool read_measure(struct reader *r);
bool read_form(struct reader *r);
bool read_motion(struct reader *r);
bool read_without(struct reader *r);
bool read_confluent(struct reader *r);
bool read_growth(struct reader *r);
bool read_hatch(struct reader *r);
bool read_point(struct reader *r);
bool read_scale(struct reader *r);
bool read_thesis(struct reader *r);

/* Implemented in text_key.c. */
bool read_key(struct reader *r);
bool read_gill(struct reader *r);
bool read_station(struct reader *r);
bool read_eye(struct reader *r);
bool read_fin(struct reader *r);
bool read_ray(struct reader *r);
bool read_finlets(struct reader *r);

/* Implemented in text_coat.c. */
bool read_coat(struct reader *r);
bool read_mark(struct reader *r);

/* Implemented in text_graph.c. */
bool read_curve(struct reader *r);
bool read_area(struct reader *r);
bool read_knot(struct reader *r);
bool read_line_kind(struct reader *r);
bool read_template(struct reader *r);

/* Checks in text_check.c that a species is complete and can be lofted. */
bool check_species(struct reader *r);

#endif
