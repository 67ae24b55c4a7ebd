/* reader.h -- what the readers of a species' lines share: one line cut into words.
 *
 * Private to text*.c. Every function that answers bool has, when it answers false, already written
 * its one line of complaint. */
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
    struct key_text *key; /* What a line of a key adds to; null before the first. */
    struct fin *fin;      /* What a ray adds to; null outside a fin. */
    uint32_t key_line[MORPH_KEY_MAX], curve_line[MORPH_CURVE_MAX]; /* Where each started. */
    bool has_growth, has_hatch, has_thesis;
};

/* Writes 'PATH:LINE: what' and answers false. */
__attribute__((format(printf, 2, 3))) bool refuse(const struct reader *r, const char *format, ...);

/* Word `index` as a number in [low, high]. */
bool number(const struct reader *r, uint32_t index, float low, float high, float *out);

/* Word `index` as a whole number in [low, high]. */
bool whole(const struct reader *r, uint32_t index, uint32_t low, uint32_t high, uint32_t *out);

/* Word `index` as a name: a-z, 0-9 and _. */
bool name(const struct reader *r, uint32_t index, char out[SPECIES_NAME_SIZE]);

/* Word `index` as a colour, rrggbb. */
bool colour(const struct reader *r, uint32_t index, uint32_t *out);

/* Word `index` as one of `choices`, of which the null ones are none; else all are listed. */
bool choice(const struct reader *r, uint32_t index, const char *what, const char *const *choices,
            uint32_t count, uint32_t *out);

/* True where `count` numbers follow the line's first word; else says how to write it. */
bool wants(const struct reader *r, uint32_t count, const char *names);

/* Parts by the names that makers use; head and trunk behind them. */
extern const char *const part_names[OWNED_COUNT];

/* text_life.c */
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

/* text_key.c */
bool read_key(struct reader *r);
bool read_gill(struct reader *r);
bool read_station(struct reader *r);
bool read_eye(struct reader *r);
bool read_fin(struct reader *r);
bool read_ray(struct reader *r);
bool read_finlets(struct reader *r);

/* text_coat.c */
bool read_coat(struct reader *r);
bool read_mark(struct reader *r);

/* text_graph.c */
bool read_curve(struct reader *r);
bool read_area(struct reader *r);
bool read_knot(struct reader *r);
bool read_line_kind(struct reader *r);
bool read_template(struct reader *r);

/* text_check.c: what a whole species must have before it can be lofted. */
bool check_species(struct reader *r);

#endif
