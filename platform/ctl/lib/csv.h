/* csv.h -- a reader for CSV tables of numbers whose header line names the columns.
 *
 * The columns may have any order. Each column name must be known, because a misspelt name would
 * otherwise silently select a default. Every row must have as many fields as the header. Lines end
 * in LF or CRLF. Empty lines and a byte-order mark are skipped. Each error is printed as one line
 * that names the file, the line and the column. */
#ifndef KINGYO_PLATFORM_CTL_LIB_CSV_H
#define KINGYO_PLATFORM_CTL_LIB_CSV_H

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
    double min, max;          /* Allowed range of the numbers. Not used if `words` is set. */
    const char *const *words; /* Allowed words, terminated by a null pointer. The value of a
                                 field is the index of its word. A null `words` means a column of
                                 numbers. */
    uint8_t may_miss;         /* 1 if the file may lack the column. 0 if a file without the column
                                 is rejected. */
    uint8_t unread;           /* 1 if the fields of the column are not parsed, so that the value is
                                 always `otherwise`. 0 if the fields are parsed. */
    double otherwise;         /* Value that every row gets if the file does not have the column. */
};

/* An open CSV file. csv_open() initializes the structure. */
struct csv {
    const char *speaker; /* Prefix of error messages, for example "kingyoctl tank: --place". */
    const char *path;
    FILE *file;
    uint32_t line;        /* Number of the current line, counted from 1. */
    uint32_t field_count; /* Number of fields of the header line. Every row must have the same
                             number of fields. */
    const struct csv_column *columns;
    uint32_t column_count;             /* Number of columns that the caller defined, at most
                                          CSV_COLUMN_MAX. */
    uint32_t field_of[CSV_COLUMN_MAX]; /* Position in the file of each defined column, counted from
                                          1. 0 means that the file does not have the column. */
    char text[CSV_LINE_MAX];
};

/* Opens the file at `path` and parses its header line. Returns EXIT_OK. After an error, prints one
 * line and returns EXIT_IO or EXIT_BAD_DATA. `speaker`, `path` and `columns` must outlive `csv`. */
enum exit_code csv_open(struct csv *csv, const char *speaker, const char *path,
                        const struct csv_column *columns, uint32_t column_count);

/* Reads the next row into values[column_count]. Returns EXIT_OK. After an error, prints one line
 * and returns EXIT_IO or EXIT_BAD_DATA. Sets `*is_end` to 1 at the end of the file, otherwise to
 * 0. */
enum exit_code csv_row(struct csv *csv, double *values, int *is_end);

/* Returns 1 if the file has the defined column `index`, otherwise 0. */
int csv_has(const struct csv *csv, uint32_t index);

/* Prints an error for column `index` of the current line. The reason is formatted as by printf().
 * Returns EXIT_BAD_DATA. */
__attribute__((format(printf, 3, 4))) enum exit_code
csv_error(const struct csv *csv, uint32_t index, const char *format, ...);

/* Closes the CSV file. */
void csv_close(struct csv *csv);

#endif
