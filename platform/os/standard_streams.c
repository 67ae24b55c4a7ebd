/* standard_streams.c -- opens and flushes the standard streams; see standard_streams.h. */
#include "platform/os/standard_streams.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <unistd.h>

int print_open_streams(void)
{
    for (int fd = STDIN_FILENO; fd <= STDERR_FILENO; fd++) {
        if (fcntl(fd, F_GETFD) >= 0) {
            continue;
        }
        /* /dev/null is opened for writing as standard input, and for reading as standard output or
         * standard error. Each use therefore fails. open() returns the lowest free descriptor,
         * which is `fd`. */
        if (open("/dev/null", fd == STDIN_FILENO ? O_WRONLY : O_RDONLY) != fd) {
            return errno != 0 ? -errno : -EIO;
        }
    }
    return 0;
}

static int flush_error; /* errno of the first failed print_flush(), or 0 if no call
                           failed. */

int print_flush(FILE *out)
{
    errno = 0;
    if (fflush(out) == 0 && !ferror(out)) {
        return 0;
    }
    flush_error = flush_error ? flush_error : errno;
    return -1;
}

int print_finish(void)
{
    const int has_failed = ferror(stdout) != 0;
    errno = 0;
    /* After a failed write the C library keeps the bytes in its buffer, so that fflush() fails
     * again for the same reason. */
    if (fflush(stdout) == 0 && !has_failed) {
        return 0;
    }
    return flush_error != 0 ? -flush_error : errno != 0 ? -errno : -EIO;
}
