/* plain_file.h -- opens what is read to its end: no pipe, which keeps its reader waiting. */
#ifndef KINGYO_PLATFORM_PLAIN_FILE_H
#define KINGYO_PLATFORM_PLAIN_FILE_H

#include <stdio.h>

/* For reading; the caller closes it. Null, and errno says why: EISDIR for a folder, ENOTSUP for a
 * pipe, into which nobody may ever write. */
FILE *plain_file_open(const char *path);

#endif
