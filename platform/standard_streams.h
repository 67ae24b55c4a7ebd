/* standard_streams.h -- the first and the last act of a program that prints: standard input, output
 * and error are open before any other file is, and output that was lost is an error at the end. */
#ifndef KINGYO_PLATFORM_STANDARD_STREAMS_H
#define KINGYO_PLATFORM_STANDARD_STREAMS_H

#include <stdio.h>

/* Opens each of the file descriptors 0, 1 and 2 that the caller of the program left closed, so that
 * no data file takes its number. Reads and writes on them go on to fail with EBADF. Must be called
 * before any other file is opened. Returns 0 or a negative errno. */
int standard_streams_open(void);

/* Writes what standard output still holds. Returns 0, or the negative errno of a failed write; a
 * write that failed earlier counts, too. */
int standard_output_finish(void);

/* Flushes `out` before the end. Returns 0, or -1 and keeps the reason for
 * standard_output_finish(): a command then omits its own line on standard error. */
int standard_output_flush(FILE *out);

#endif
