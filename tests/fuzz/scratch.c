/* scratch.c -- implementation of scratch.h: temporary files for fuzz targets. */
#include "tests/fuzz/scratch.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "tests/fuzz/trap.h"

void scratch_path(char path[SCRATCH_PATH_SIZE], const char *name)
{
    const char *folder = getenv("TMPDIR");
    const int length = snprintf(path, SCRATCH_PATH_SIZE, "%s/kingyo-fuzz-%d-%s",
                                folder ? folder : "/tmp", (int)getpid(), name);
    HOLD(length > 0 && (size_t)length < SCRATCH_PATH_SIZE);
}

void scratch_put(const char *path, const void *bytes, size_t size)
{
    const int file = open(path, O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    HOLD(file >= 0 && write(file, bytes, size) == (ssize_t)size);
    close(file);
}
