/* standard_streams.h -- opens the standard streams at the start of a program and reports lost
 * output at its end. */
#ifndef KINGYO_PLATFORM_OS_STANDARD_STREAMS_H
#define KINGYO_PLATFORM_OS_STANDARD_STREAMS_H

#include <stdio.h>

/* Opens each of the file descriptors 0, 1 and 2 that the parent process left closed, so that no
 * data file gets its number. Reads and writes on such a descriptor still fail with EBADF. Must be
 * called before any other file is opened. Returns 0 or a negative errno. */
int standard_streams_open(void);

/* Flushes standard output. Returns 0, or the negative errno of a failed write, including an earlier
 * one. */
int standard_output_finish(void);

/* Flushes `out` before the end. Returns 0, or -1 and stores the reason for
 * standard_output_finish(). A command then omits its own line on standard error. */
int standard_output_flush(FILE *out);

#endif
