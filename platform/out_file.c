/* out_file.c -- a disk may be full at any byte: all of them are asked for, and told once. */
#include "platform/out_file.h"

#include <errno.h>
#include <sys/stat.h>
#include <unistd.h>

int out_open(struct out_file *out, const char *path)
{
    *out = (struct out_file){ .file = fopen(path, "wb"), .path = path };
    return out->file ? 0 : -errno;
}

/* A device such as /dev/full stays. */
static void remove_regular(const char *path)
{
    struct stat status;
    if (lstat(path, &status) == 0 && S_ISREG(status.st_mode)) {
        unlink(path);
    }
}

int out_close(struct out_file *out)
{
    errno = 0;
    int failed = fflush(out->file) != 0 || ferror(out->file);
    const int why = errno;
    failed = fclose(out->file) != 0 || failed;
    out->file = NULL;
    if (!failed) {
        return 0;
    }
    remove_regular(out->path);
    return why ? -why : errno ? -errno : -EIO;
}
