/* csv.h -- tables of numbers that people write: columns by the names in the first line.
 *
 * Nothing is assumed of the order of the columns; but each must be a known one, and every row as
 * long as the head: a misspelt name that was passed over would be a default in disguise. Lines end
 * in LF or CRLF, empty ones are skipped, and so is the byte-order mark that some editors begin
 * with. What cannot be used is told in one line that names the file, the line and the column. */
#ifndef KINGYO_PLATFORM_CTL_CSV_H
#define KINGYO_PLATFORM_CTL_CSV_H

#include <stdint.h>
#include <stdio.h>

#include "platform/kiosk/options.h"

#define CSV_COLUMN_MAX 16u
#define CSV_LINE_MAX 1024u
#define CSV_SIZE_MAX (64u << 20) /* Bytes; 131,072 fish of --place are about 16 MiB. */

/* A column that is known. */
struct csv_column {
    const char *name;
    double min, max;          /* Of its numbers. */
    const char *const *words; /* Not null: the value is the place of one of these, ends in null. */
    uint8_t may_miss;         /* Else a file without it is refused. */
    uint8_t unread;           /* Its values are nobody's business: always `otherwise`. */
    double otherwise;         /* Its value where the file has no such column. */
};

struct csv {
    const char *speaker; /* "kingyoctl tank: --place" */
    const char *path;
    FILE *file;
    uint32_t line;        /* Number of the newest line, from 1. */
    uint32_t field_count; /* Of the head, and so of every row. */
    const struct csv_column *columns;
    uint32_t column_count;             /* <= CSV_COLUMN_MAX */
    uint32_t field_of[CSV_COLUMN_MAX]; /* In the file, from 1; 0: the file has none. */
    char text[CSV_LINE_MAX];
};

/* Opens `path` and reads its head. EXIT_OK, or EXIT_IO or EXIT_BAD_DATA, told. The strings must
 * outlive `csv`. */
enum exit_code csv_open(struct csv *csv, const char *speaker, const char *path,
                        const struct csv_column *columns, uint32_t column_count);

/* The next row into values[column_count], EXIT_OK; at the end of the file `*is_end` is set. */
enum exit_code csv_row(struct csv *csv, double *values, int *is_end);

/* Whether the file has the column `index`. */
int csv_has(const struct csv *csv, uint32_t index);

/* Tells what is wrong with the newest line's column `index`, and EXIT_BAD_DATA. */
__attribute__((format(printf, 3, 4)))
enum exit_code csv_refuse(const struct csv *csv, uint32_t index, const char *format, ...);

void csv_close(struct csv *csv);

#endif
