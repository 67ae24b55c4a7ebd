/* regular_file.h -- opens regular files only, because a FIFO or a device could block the caller
 * forever. */
#ifndef KINGYO_PLATFORM_OS_REGULAR_FILE_H
#define KINGYO_PLATFORM_OS_REGULAR_FILE_H

#include <stdint.h>
#include <stdio.h>
#include <sys/types.h>

/* Read limit in bytes for kernel files in /proc and /sys, whose size is a few pages. */
#define REGULAR_FILE_KERNEL_SIZE_MAX (1u << 20)

/* Opens a file that the user named, for reading. The caller closes the stream, which cannot
 * seek. Symbolic links are followed. Returns null and sets errno on an error: EISDIR for a
 * folder, ENOTSUP for a FIFO, a device or a socket, EFBIG for more than `size_max` bytes. A file
 * that returns more bytes than its stated size, as some in /proc do, fails with EFBIG while it
 * is read. */
FILE *regular_file_open(const char *path, uint32_t size_max);

/* Opens a file in the data folder. `flags` and `mode` are those of open(2); O_NOFOLLOW, O_NONBLOCK,
 * O_CLOEXEC and O_NOCTTY are added, and O_TRUNC takes effect only on a regular file. Returns the
 * descriptor, or -1 and sets errno: ELOOP for a symbolic link, EISDIR for a folder, ENOTSUP for a
 * FIFO, a device or a socket, else as open(2). */
int regular_file_handle(const char *path, int flags, mode_t mode);

/* Returns true if `path` names an object that regular_file_handle() rejects because of its type.
 * Returns false for a path that does not exist or cannot be examined. */
int regular_file_is_other(const char *path);

/* Returns strerror(`error`), or a clearer text for ELOOP, ENOTSUP and EFBIG. */
const char *regular_file_error(int error);

#endif
