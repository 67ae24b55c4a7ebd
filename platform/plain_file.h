/* plain_file.h -- opens regular files alone: a FIFO or a device could block the caller for ever. */
#ifndef KINGYO_PLATFORM_PLAIN_FILE_H
#define KINGYO_PLATFORM_PLAIN_FILE_H

#include <stdint.h>
#include <stdio.h>
#include <sys/types.h>

/* Bytes that are read of a file of the kernel, in /proc and /sys; those are of a few pages. */
#define PLAIN_KERNEL_SIZE_MAX (1u << 20)

/* Opens a file that the user named, for reading; the caller closes it. Symbolic links are followed.
 * Returns null and sets errno on an error: EISDIR for a folder, ENOTSUP for a FIFO, a device or a
 * socket, EFBIG for more than `size_max` bytes. A file that gives more bytes than its size said, as
 * some in /proc do, fails with EFBIG while it is read. The stream cannot seek. */
FILE *plain_file_open(const char *path, uint32_t size_max);

/* Opens a file in the data folder. `flags` and `mode` are those of open(2); O_NOFOLLOW, O_NONBLOCK,
 * O_CLOEXEC and O_NOCTTY are added, and O_TRUNC takes effect only on a regular file. Returns the
 * descriptor, or -1 and sets errno: ELOOP for a symbolic link, EISDIR for a folder, ENOTSUP for a
 * FIFO, a device or a socket, else as open(2). */
int plain_file_handle(const char *path, int flags, mode_t mode);

/* Returns whether `path` names something that plain_file_handle() refuses to open because of its
 * type. Returns false for a path that does not exist or cannot be examined. */
int plain_file_is_other(const char *path);

/* Returns strerror(`error`), with clearer words for ELOOP, ENOTSUP and EFBIG. */
const char *plain_file_error(int error);

#endif
