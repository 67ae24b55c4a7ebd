/* plain.h -- opens and reads text files from outside the program: regular files alone, line by
 * line. */
#ifndef KINGYO_PLATFORM_SPECIES_PLAIN_H
#define KINGYO_PLATFORM_SPECIES_PLAIN_H

#include <stdint.h>
#include <stdio.h>

#define PLAIN_WHY_SIZE 96u

enum plain_open {
    PLAIN_OPEN,
    PLAIN_NONE,  /* It is not there, not readable, or no regular file. */
    PLAIN_LARGE, /* It has more than `size_max` bytes. */
};

/* Opens a regular file of at most `size_max` bytes; pipes and devices are neither waited for nor
 * read. Where not, `*out` is null and `why` says so without the path. The caller closes it. */
enum plain_open plain_open(const char *path, uint32_t size_max, FILE **out,
                           char why[PLAIN_WHY_SIZE]);

enum plain_line {
    PLAIN_LINE,
    PLAIN_END,  /* No further line; ferror() tells whether the file ended. */
    PLAIN_LONG, /* More than size - 2 characters. */
    PLAIN_ZERO, /* There is a zero byte in it. */
};

/* The next line, without its line end. */
enum plain_line plain_line(FILE *file, char *text, size_t size);
#endif
