/* text.h -- the parser of species texts, and functions that read untrusted text files.
 *
 * The functions text_file_*() open any regular text file and read the file line by line. The code
 * that reads meshes and landmarks also uses these functions. The rest of this header is shared by
 * the files text*.c. Each line of a species text is split into words. A function that returns bool
 * returns true on success. On an error the function writes one line with the error message and
 * returns false. */
#ifndef KINGYO_PLATFORM_SPECIES_TEXT_H
#define KINGYO_PLATFORM_SPECIES_TEXT_H

#include "platform/species/drawing.h"
#include "platform/species/part.h"

/* ---- Text files ------------------------------------------------------------------------------ */

#define TEXT_FILE_WHY_SIZE 96u

enum text_file_open {
    TEXT_FILE_OPEN,
    TEXT_FILE_NONE,  /* The file does not exist, is not readable, or is not a regular file. */
    TEXT_FILE_LARGE, /* The file has more than `size_max` bytes. */
};

/* Opens a regular file of at most `size_max` bytes. Never blocks on a pipe or a device, and never
 * reads from one. On failure, sets `*out` to null and writes the reason without the path to `why`.
 * The caller closes the file. */
enum text_file_open text_file_open(const char *path, uint32_t size_max, FILE **out,
                                   char why[TEXT_FILE_WHY_SIZE]);

enum text_file_line {
    TEXT_FILE_LINE,
    TEXT_FILE_END,  /* No line is left, or a read failed. ferror() distinguishes a read error from
                       the end of the file. */
    TEXT_FILE_LONG, /* The line has more than `size` - 2 characters. */
    TEXT_FILE_ZERO, /* The line contains a zero byte. */
};

/* Reads the next line into `text`, a buffer of `size` bytes, without the line end. */
enum text_file_line text_file_line(FILE *file, char *text, size_t size);

/* ---- Words of a line ------------------------------------------------------------------------- */

#define TEXT_LINE_SIZE 256
#define TEXT_WORD_MAX 24
/* Minimum width of a cross section, as a fraction of the distance from the snout to the tail root.
 * A leptocephalus larva of 64 mm is 0.6 mm wide. A thinner body has no usable flank. */
#define THIN_MIN 0.002f

struct species_reader {
    const char *path;
    FILE *complaints;
    uint32_t line;
    char text[TEXT_LINE_SIZE];
    const char *words[TEXT_WORD_MAX];
    uint32_t word_count;
    struct species_text *species;
    struct key_text *key; /* Key (modelled growth stage) to which the current line belongs. Null
                             before the first key. */
    struct fin *fin;      /* Fin to which a `ray` line belongs. Null if the current line belongs to
                             no fin. */
    uint32_t key_line[MORPH_KEY_MAX], curve_line[MORPH_CURVE_MAX]; /* Line numbers in the file at
                                                                      which each key and each curve
                                                                      starts. */
    bool has_growth, has_hatch, has_thesis;
};

/* Writes the error message 'PATH:LINE: what' and returns false. `format` and the arguments produce
 * `what`. */
__attribute__((format(printf, 2, 3))) bool species_reader_error(const struct species_reader *r,
                                                                const char *format, ...);

/* Parses word `index` as a number in [low, high]. */
bool species_reader_number(const struct species_reader *r, uint32_t index, float low, float high,
                           float *out);

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
                           const char *const *choices, uint32_t count, uint32_t *out);

/* Returns true if exactly `count` words follow the line's first word. Otherwise writes an error
 * message that shows the syntax with the parameter names `names`, and returns false. */
bool species_reader_expect(const struct species_reader *r, uint32_t count, const char *names);

/* Declarations of the functions in text_life.c that parse the lines about the whole species. */
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

/* Declarations of the functions in text_key.c that parse the lines of a key (modelled growth
 * stage). */
bool text_read_key(struct species_reader *r);
bool text_read_gill(struct species_reader *r);
bool text_read_station(struct species_reader *r);
bool text_read_eye(struct species_reader *r);
bool text_read_fin(struct species_reader *r);
bool text_read_ray(struct species_reader *r);
bool text_read_finlets(struct species_reader *r);

/* Declarations of the functions in text_key.c that parse the lines of a key's coat (its paint). */
bool text_read_coat(struct species_reader *r);
bool text_read_mark(struct species_reader *r);

/* Declarations of the functions in text_life.c that parse the lines of a deformation graph. */
bool text_read_curve(struct species_reader *r);
bool text_read_area(struct species_reader *r);
bool text_read_knot(struct species_reader *r);
bool text_read_line_kind(struct species_reader *r);
bool text_read_template(struct species_reader *r);

/* Checks that the species is complete and that its meshes can be built. Returns true on success. On
 * an error writes the error message and returns false. Implemented in text_check.c. */
bool text_check_species(struct species_reader *r);

#endif
