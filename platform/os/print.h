/* print.h -- prints one line that may contain text from outside the program.
 *
 * Each function formats as printf() does, and passes the result through printable()
 * (core/base/printable.h). A line break or an escape sequence in an argument therefore cannot break
 * the line or reach the terminal. `format` must not contain control characters, including tabs. */
#ifndef KINGYO_PLATFORM_OS_PRINT_H
#define KINGYO_PLATFORM_OS_PRINT_H

#include <stdio.h>

/* Size of a line in bytes with its line end, enough for two paths of PATH_MAX bytes and some text.
 * Longer lines are cut. */
#define PRINT_LINE_MAX 9216u

/* Writes a part of a line to `file`, without a line end. */
__attribute__((format(printf, 2, 3))) void print_part(FILE *file, const char *format, ...);

/* Writes one line and a line end to `file`. */
__attribute__((format(printf, 2, 3))) void print_line(FILE *file, const char *format, ...);

/* Writes one line and a line end to standard error. */
__attribute__((format(printf, 1, 2))) void print_error(const char *format, ...);

#endif
