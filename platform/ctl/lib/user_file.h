/* user_file.h -- opens files that the user names on the command line. */
#ifndef KINGYO_PLATFORM_CTL_LIB_USER_FILE_H
#define KINGYO_PLATFORM_CTL_LIB_USER_FILE_H

#include <stdint.h>
#include <stdio.h>

#include "platform/config/options.h"

/* Opens the regular file `path` for reading. The caller closes the file. Returns EXIT_OK.
 *
 * After an error, sets `*out` to null and prints one line, "SPEAKER: PATH: reason", to standard
 * error. Returns EXIT_BAD_DATA if the file has more than `size_max` bytes. Returns EXIT_IO if the
 * file is missing or is not a regular file. */
enum exit_code user_file_open(const char *speaker, const char *path, uint32_t size_max, FILE **out);

/* Prints the error line for a read that failed with the errno `error`. Returns the exit code that
 * user_file_open() returns for this error. */
enum exit_code user_file_error(const char *speaker, const char *path, uint32_t size_max, int error);

#endif
