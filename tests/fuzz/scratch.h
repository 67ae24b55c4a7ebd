/* scratch.h -- files for fuzz targets whose readers take a path. */
#ifndef KINGYO_TESTS_FUZZ_SCRATCH_H
#define KINGYO_TESTS_FUZZ_SCRATCH_H

#include <stddef.h>

#define SCRATCH_PATH_SIZE 256u

/* Writes the path of file `name` in $TMPDIR (/tmp) into `path`; the process id keeps two apart. */
void scratch_path(char path[SCRATCH_PATH_SIZE], const char *name);

/* Makes the file at `path` hold exactly `size` bytes; traps when the disk refuses. */
void scratch_put(const char *path, const void *bytes, size_t size);

#endif
