/* plain_file.c -- see plain_file.h. */
#include "platform/plain_file.h"

#include <errno.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

/* Opened without waiting, so that what was looked at is what is read. */
FILE *plain_file_open(const char *path)
{
    struct stat about = { 0 };
    const int handle = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (handle < 0) {
        return NULL;
    }
    const int error = fstat(handle, &about) != 0   ? errno
                      : S_ISDIR(about.st_mode)     ? EISDIR
                      : S_ISFIFO(about.st_mode)    ? ENOTSUP
                                                   : 0;
    FILE *file = error == 0 ? fdopen(handle, "r") : NULL;
    if (!file) {
        close(handle);
        errno = error != 0 ? error : ENOMEM;
    }
    return file;
}
