/* csv.h -- a reader for CSV tables of numbers whose header line names the columns.
 *
 * The columns may have any order. Each column name must be known, and every row must have as many
 * fields as the header. Otherwise a misspelt name would silently select a default. Lines end in LF
 * or CRLF. Empty lines and a byte-order mark are skipped. Each error is printed as one line that
 * names the file, the line and the column. */
#ifndef KINGYO_PLATFORM_CTL_LIB_CSV_H
#define KINGYO_PLATFORM_CTL_LIB_CSV_H

#include <stdint.h>
#include <stdio.h>

#include "platform/config/options.h"

/* Most columns that a reader may define. */
#define CSV_COLUMN_MAX 16u

/* Size in bytes of the line buffer, with the newline and the terminating zero. */
#define CSV_LINE_MAX 1024u

/* Largest file size in bytes. 131,072 fish of --place need about 16 MiB. */
#define CSV_SIZE_MAX (64u << 20)

/* Definition of a column that a file may have. */
struct csv_column {
    const char *name;
    double min, max;          /* Allowed range of the numbers, unless `words` is set. */
    const char *const *words; /* Allowed words, terminated by null. The value is the index of the
                                 word. Null for a column of numbers. */
    uint8_t may_miss;         /* 1 if a file without this column is accepted. Otherwise such a file
                                 is refused. */
    uint8_t unread;           /* 1 if the values are not parsed. The value is then always
                                 `otherwise`. */
    double otherwise;         /* Value of the column for a file that does not have the column. */
};

/* State of an open CSV file. csv_open() fills it. */
struct csv {
    const char *speaker; /* Prefix of error messages, for example "kingyoctl tank: --place". */
    const char *path;
    FILE *file;
    uint32_t line;        /* Number of the current line, from 1. */
    uint32_t field_count; /* Fields of the header line, and therefore of each row. */
    const struct csv_column *columns;
    uint32_t column_count;             /* Number of known columns, at most CSV_COLUMN_MAX. */
    uint32_t field_of[CSV_COLUMN_MAX]; /* Position of each known column in the file, from 1. 0 means
                                          that the file does not have the column. */
    char text[CSV_LINE_MAX];
};

/* Opens the file at `path` and parses its header line. Returns EXIT_OK, or EXIT_IO or EXIT_BAD_DATA
 * after printing the error. `speaker`, `path` and `columns` must outlive `csv`. */
enum exit_code csv_open(struct csv *csv, const char *speaker, const char *path,
                        const struct csv_column *columns, uint32_t column_count);

/* Reads the next row into values[column_count]. Returns EXIT_OK, or EXIT_IO or EXIT_BAD_DATA after
 * printing the error. Sets `*is_end` at the end of the file. */
enum exit_code csv_row(struct csv *csv, double *values, int *is_end);

/* Returns whether the file has the known column `index`. */
int csv_has(const struct csv *csv, uint32_t index);

/* Prints what is wrong with column `index` of the current line. Returns EXIT_BAD_DATA. */
__attribute__((format(printf, 3, 4))) enum exit_code
csv_error(const struct csv *csv, uint32_t index, const char *format, ...);

/* Closes the file. */
void csv_close(struct csv *csv);

#endif
