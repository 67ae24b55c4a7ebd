/* atomic_file.h -- writes atomic files: a reader finds either the old content or the complete new
 * content.
 *
 * The output goes to the temporary file PATH.part in the same folder. At the end PATH.part replaces
 * PATH. The content of PATH is therefore complete even if the disk is full or the power fails. If
 * PATH is a symbolic link, the link stays and its target is replaced. A dangling link, a folder or
 * a disk is rejected. A terminal, /dev/null or a pipe with a reader is written directly. */
#ifndef KINGYO_PLATFORM_OS_ATOMIC_FILE_H
#define KINGYO_PLATFORM_OS_ATOMIC_FILE_H

#include <limits.h>
#include <stdbool.h>
#include <stdio.h>

#define FILE_ATOMIC_PART ".part"

struct atomic_file {
    FILE *file;
    bool is_stream; /* True for a terminal, a pipe or /dev/null, which are written without a
                       temporary file. */
    bool lasts;
    char place[PATH_MAX]; /* Resolved path of the target. */
    char part[PATH_MAX];
};

/* Opens `path` for writing, with empty content. Returns 0 or a negative errno. */
int file_atomic_open(struct atomic_file *out, const char *path);

/* Opens `path` as file_atomic_open() does. file_atomic_close() then blocks until the content is on
 * disk. Returns -ENOTSUP if `path` exists and is not a regular file. */
int file_atomic_open_durable(struct atomic_file *out, const char *path);

/* Closes the file. Returns 0, or the negative errno of the first failed write. After an error the
 * temporary file is removed and the old file is unchanged. */
int file_atomic_close(struct atomic_file *out);

#endif
