/* regular_file.h -- opens regular files only, because a FIFO or a device could block the caller
 * forever. */
#ifndef KINGYO_PLATFORM_OS_REGULAR_FILE_H
#define KINGYO_PLATFORM_OS_REGULAR_FILE_H

#include <stdint.h>
#include <stdio.h>
#include <sys/types.h>

/* Read limit in bytes for kernel files in /proc and /sys, which have a size of a few pages. */
#define FILE_KERNEL_SIZE_MAX (1u << 20)

/* Opens a file for reading. The path comes from the user, therefore symbolic links are followed.
 * The caller closes the returned stream, which does not support seeking. On an error returns null
 * and sets errno: EISDIR for a folder, ENOTSUP for a FIFO, a device or a socket, EFBIG for more
 * than `size_max` bytes. Some files in /proc return more bytes than their reported size. If one of
 * these files exceeds `size_max`, a read fails with EFBIG. */
FILE *file_open(const char *path, uint32_t size_max);

/* Opens a file in the data folder with the `flags` and `mode` of open(2). The function adds
 * O_NOFOLLOW, O_NONBLOCK, O_CLOEXEC and O_NOCTTY. O_TRUNC truncates regular files only. Returns the
 * descriptor. On an error returns -1 and sets errno: ELOOP for a symbolic link, EISDIR for a
 * folder, ENOTSUP for a FIFO, a device or a socket, otherwise as open(2) does. */
int file_handle(const char *path, int flags, mode_t mode);

/* Returns 1 if `path` is not a regular file, so that file_handle() rejects it. Returns 0
 * for a regular file, and for a path that does not exist or cannot be examined. */
int file_is_other(const char *path);

/* Returns strerror(`error`), or a more specific text for ELOOP, ENOTSUP and EFBIG. */
const char *file_error(int error);

#endif
