/* user_file.h -- opens the files that a command line names. */
#ifndef KINGYO_PLATFORM_CTL_LIB_USER_FILE_H
#define KINGYO_PLATFORM_CTL_LIB_USER_FILE_H

#include <stdint.h>
#include <stdio.h>

#include "platform/config/options.h"

/* Opens the regular file `path` of at most `size_max` bytes for reading. The caller closes the
 * file. Returns EXIT_OK. After an error, sets `*out` to null and prints one line, "SPEAKER: PATH:
 * reason", to standard error. Returns EXIT_BAD_DATA for a file that is too large, and EXIT_IO for a
 * file that is missing or of another type. */
enum exit_code user_file_open(const char *speaker, const char *path, uint32_t size_max, FILE **out);

/* Prints the error line for a read that failed with `error`. Returns the exit code of
 * user_file_open() for the error. */
enum exit_code user_file_error(const char *speaker, const char *path, uint32_t size_max, int error);

#endif
