/* print.h -- prints one line that may contain text from outside the program, opens the standard
 * streams at program start, and reports lost output at program end.
 *
 * print_part(), print_line() and print_error() format as printf() does, and pass the result through
 * printable() (core/base/printable.h). A line break or an escape sequence in an argument therefore
 * cannot break the line or reach the terminal. `format` must not contain control characters,
 * including tabs. */
#pragma once

#include <stdio.h>

/* Maximum size of a line in bytes, including its line end. The size is enough for two paths of
 * PATH_MAX bytes and some text. Longer lines are cut. */
#define PRINT_LINE_MAX 9216u

/* Writes a part of a line to `file`, without a line end. */
__attribute__((format(printf, 2, 3))) void print_part(FILE *file, const char *format, ...);

/* Writes one line and a line end to `file`. */
__attribute__((format(printf, 2, 3))) void print_line(FILE *file, const char *format, ...);

/* Writes one line and a line end to standard error. */
#define print_error(...) print_line(stderr, __VA_ARGS__)

/* Writes one line and a line end to standard error. The value of the expression is `code`, the exit
 * code that the caller returns. */
#define print_fail(code, ...) (print_error(__VA_ARGS__), (code))

/* ---- Standard streams ------------------------------------------------------------------------ */

/* Opens each of the descriptors 0, 1 and 2 that the parent process left closed, so that no data
 * file that is opened later gets one of these numbers. Reads and writes on a descriptor that this
 * function has opened fail with EBADF. Also replaces `stdout` by a stream that stores the reason of
 * its first failed write. fileno() of this stream fails. Must be called before any other file is
 * opened. Returns 0 or a negative errno. */
int print_open_streams(void);

/* Flushes standard output. Returns 0, or the negative errno of the first failed write since program
 * start. */
int print_finish(void);

/* Flushes `out` before program end. Returns 0, or -1 after an error. If `out` is standard output,
 * the caller must not report the error, because print_finish() reports it. */
int print_flush(FILE *out);
