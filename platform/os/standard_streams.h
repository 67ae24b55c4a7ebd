/* standard_streams.h -- opens the standard streams at program start and reports lost output at
 * program end. */
#ifndef KINGYO_PLATFORM_OS_STANDARD_STREAMS_H
#define KINGYO_PLATFORM_OS_STANDARD_STREAMS_H

#include <stdio.h>

/* Opens those of the descriptors 0, 1 and 2 that the parent process left closed. No data file can
 * then get one of these numbers. Reads and writes on a descriptor opened here fail with EBADF. Must
 * be called before any other file is opened. Returns 0 or a negative errno. */
int print_open_streams(void);

/* Flushes standard output. Returns 0, or the negative errno of the first failed write since program
 * start. */
int print_finish(void);

/* Flushes `out` before program end. Returns 0. On an error returns -1 and stores errno.
 * print_finish() reports the stored error, so that the caller must not report it. */
int print_flush(FILE *out);

#endif
