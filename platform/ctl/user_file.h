/* user_file.h -- opens the files that a command line names. */
#ifndef KINGYO_PLATFORM_CTL_USER_FILE_H
#define KINGYO_PLATFORM_CTL_USER_FILE_H

#include <stdint.h>
#include <stdio.h>

#include "platform/kiosk/options.h"

/* Opens the regular file `path` of at most `size_max` bytes for reading; the caller closes it.
 * Returns EXIT_OK; otherwise `*out` is null and one line, "SPEAKER: PATH: why", is on standard
 * error: EXIT_BAD_DATA for a file that is too large, EXIT_IO for one that is missing or of another
 * type. */
enum exit_code user_file_open(const char *speaker, const char *path, uint32_t size_max, FILE **out);

/* Prints the line for a read that failed with `error`. Returns the exit code as above. */
enum exit_code user_file_refuse(const char *speaker, const char *path, uint32_t size_max,
                                int error);

#endif
