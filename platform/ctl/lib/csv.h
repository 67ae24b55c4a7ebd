/* csv.h -- a reader for CSV tables of numbers whose header line names the columns.
 *
 * The columns may have any order. Each column name must be known, because a misspelt name would
 * otherwise silently select a default. Every row must have as many fields as the header. Lines end
 * in LF or CRLF. Empty lines and a byte-order mark are skipped. Each error is printed as one line
 * that names the file, the line and the column. */
#pragma once

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "platform/config/options.h"

/* Maximum number of columns that a caller may define. */
#define CSV_COLUMN_MAX 16u

/* Size of the line buffer in bytes, including the newline and the terminating zero. */
#define CSV_LINE_MAX 1024u

/* Largest file size in bytes. A file with 131,072 fish for --place needs about 16 MiB. */
#define CSV_SIZE_MAX (64u << 20)

/* Definition of one column that a CSV file may contain. */
struct csv_column {
    const char *name;
    double min, max; /* Allowed range of the numbers. Not used if `words` is set. */
    /* Allowed words, terminated by a null pointer. The value of a field is the index of its word. A
     * null `words` means a column of numbers. */
    const char *const *words;
    bool may_miss; /* True if the file may lack the column. */
    /* True if the fields of the column are not parsed, so that the value is always `otherwise`. */
    bool unread;
    double otherwise; /* Value that every row gets if the file does not have the column. */
};

/* A CSV file. The caller of csv_read() sets the first four fields, and all other fields to 0. */
struct csv {
    const char *prefix; /* Prefix of error messages, for example "kingyoctl tank: --place". */
    const char *path;
    const struct csv_column *columns;
    uint32_t column_count; /* Number of columns that the caller defined, at most CSV_COLUMN_MAX. */
    FILE *file;
    uint32_t line; /* Number of the current line, counted from 1. */
    /* Number of fields of the header line. Every row must have the same number of fields. */
    uint32_t field_count;
    /* Position in the file of each defined column, counted from 1. 0 means that the file does not
     * have the column. */
    uint32_t field_of[CSV_COLUMN_MAX];
    char text[CSV_LINE_MAX];
};

/* Opens the file, parses its header line, and calls `take` with `self` for each row. `values` has
 * one value for each defined column. `take` returns EXIT_OK, or prints one line and returns another
 * exit code, which ends the reading. csv_read() returns EXIT_OK. After an error, prints one line
 * and returns EXIT_IO, EXIT_BAD_DATA or the exit code of `take`. A file without a row is an error.
 * */
enum exit_code csv_read(struct csv *csv,
                        enum exit_code (*take)(void *self, const struct csv *csv,
                                               const double *values),
                        void *self);

/* Prints an error for column `index` of the current line. The reason is formatted as by printf().
 * Returns EXIT_BAD_DATA. */
__attribute__((format(printf, 3, 4))) enum exit_code
csv_error(const struct csv *csv, uint32_t index, const char *format, ...);
