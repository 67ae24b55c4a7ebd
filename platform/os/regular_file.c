/* regular_file.c -- opens and checks regular files; see regular_file.h. */
#include "platform/os/regular_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Open file with a read limit. `left` is the number of bytes that may still be read. */
struct bounded {
    int handle;
    uint32_t left;
};

/* Reads from the file. The read may exceed `left` by one byte, to detect a file that is longer than
 * the limit. If the file is longer, returns -1 and sets errno to EFBIG. */
static ssize_t bounded_read(void *cookie, char *out, size_t size)
{
    struct bounded *bounded = cookie;
    const size_t ask = size > bounded->left ? (size_t)bounded->left + 1u : size;
    const ssize_t got = read(bounded->handle, out, ask);
    if (got > 0 && (size_t)got > bounded->left) {
        errno = EFBIG;
        return -1;
    }
    bounded->left -= got > 0 ? (uint32_t)got : 0u;
    return got;
}

static int bounded_close(void *cookie)
{
    struct bounded *bounded = cookie;
    const int result = close(bounded->handle);
    free(bounded);
    return result;
}

/* Returns a stream that reads at most `size_max` bytes from `handle` and closes `handle` at its
 * end. If there is no memory, closes `handle`, sets errno and returns null. */
static FILE *bounded_open(int handle, uint32_t size_max)
{
    const cookie_io_functions_t functions = { .read = bounded_read, .close = bounded_close };
    struct bounded *bounded = malloc(sizeof *bounded);
    FILE *file = NULL;
    if (bounded) {
        *bounded = (struct bounded){ .handle = handle, .left = size_max };
        file = fopencookie(bounded, "r", functions);
    }
    if (!file) {
        free(bounded);
        close(handle);
        errno = ENOMEM;
    }
    return file;
}

/* Opens the file without blocking, then checks the type of the open file. */
FILE *file_open(const char *path, uint32_t size_max)
{
    struct stat about = { 0 };
    const int handle = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (handle < 0) {
        errno = errno == ENXIO ? ENOTSUP : errno; /* `path` is a socket, or a device without its
                                                     driver. */
        return NULL;
    }
    const int error = fstat(handle, &about) != 0 ? errno
                      : S_ISDIR(about.st_mode)   ? EISDIR
                      : !S_ISREG(about.st_mode)  ? ENOTSUP
                      : about.st_size > size_max ? EFBIG
                                                 : 0;
    if (error != 0) {
        close(handle);
        errno = error;
        return NULL;
    }
    return bounded_open(handle, size_max);
}

/* Reads the file type from the open descriptor, so that no other file can take its place between
 * the check and the use. */
int file_handle(const char *path, int flags, mode_t mode)
{
    const int added = O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | O_NOCTTY;
    struct stat about = { 0 };
    const int handle = open(path, (flags & ~O_TRUNC) | added, mode);
    if (handle < 0) {
        errno = errno == ENXIO ? ENOTSUP : errno; /* `path` is a FIFO without a reader, or a
                                                     socket. */
        return -1;
    }
    int error = fstat(handle, &about) != 0 ? errno
                : S_ISREG(about.st_mode)   ? 0
                : S_ISDIR(about.st_mode)   ? EISDIR
                                           : ENOTSUP;
    if (error == 0 && (flags & O_TRUNC) && ftruncate(handle, 0) != 0) {
        error = errno;
    }
    if (error != 0) {
        close(handle);
        errno = error;
    }
    return error == 0 ? handle : -1;
}

int file_is_other(const char *path)
{
    struct stat about;
    return lstat(path, &about) == 0 && !S_ISREG(about.st_mode);
}

const char *file_error(int error)
{
    return error == ELOOP     ? "is a symbolic link"
           : error == ENOTSUP ? "is not a regular file"
           : error == EFBIG   ? "is too large"
                              : strerror(error);
}
