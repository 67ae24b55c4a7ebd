/* atomic_file.h -- an atomic file: a reader finds the old content or the complete new content.
 *
 * The output goes to PATH.part in the same folder, which replaces PATH at the end. This holds even
 * if the disk is full or the power fails. A symbolic link is kept and its target is replaced; a
 * dangling link is rejected. Folders and disks are rejected. A terminal, /dev/null or a pipe with a
 * reader is written directly. */
#ifndef KINGYO_PLATFORM_OS_ATOMIC_FILE_H
#define KINGYO_PLATFORM_OS_ATOMIC_FILE_H

#include <limits.h>
#include <stdbool.h>
#include <stdio.h>

#define ATOMIC_FILE_PART ".part"

struct atomic_file {
    FILE *file;
    bool is_stream; /* 1: a terminal, pipe or /dev/null that is written without a temporary file. */
    bool lasts;
    char place[PATH_MAX]; /* Resolved path of the target. */
    char part[PATH_MAX];
};

/* Opens `path` for writing, empty. Returns 0 or a negative errno. */
int atomic_file_open(struct atomic_file *out, const char *path);

/* Opens as atomic_file_open(), and atomic_file_close() then blocks until the content is on disk.
 * Only a regular file is accepted: returns -ENOTSUP otherwise. */
int atomic_file_open_durable(struct atomic_file *out, const char *path);

/* Closes the file. Returns 0, or the negative errno of the first failed write since the opening. In
 * that case the temporary file is removed and the old file is unchanged. */
int atomic_file_close(struct atomic_file *out);

#endif
