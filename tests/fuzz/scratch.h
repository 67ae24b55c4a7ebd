/* scratch.h -- temporary files for fuzz targets whose readers take a path. */
#ifndef KINGYO_TESTS_FUZZ_SCRATCH_H
#define KINGYO_TESTS_FUZZ_SCRATCH_H

#include <stddef.h>

#define SCRATCH_PATH_SIZE 256u

/* Writes the path of file `name` in $TMPDIR (default /tmp) into `path`. The path contains the
 * process id, so that two processes use different files. */
void scratch_path(char path[SCRATCH_PATH_SIZE], const char *name);

/* Replaces the file at `path` by exactly `size` bytes. Traps if the file cannot be written. */
void scratch_put(const char *path, const void *bytes, size_t size);

#endif
