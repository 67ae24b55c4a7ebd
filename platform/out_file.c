/* out_file.c -- a disk may be full at any byte: all of them are asked for, and told once. */
#include "platform/out_file.h"

#include <errno.h>
#include <stdbool.h>
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
    /* A write that failed left its errno, and what succeeded since has not touched it. */
    int why = ferror(out->file) ? errno : 0;
    if (fflush(out->file) != 0 && why == 0) {
        why = errno;
    }
    const bool whole = !ferror(out->file);
    if (fclose(out->file) != 0 && why == 0) {
        why = errno;
    }
    out->file = NULL;
    if (whole && why == 0) {
        return 0;
    }
    remove_regular(out->path);
    return why ? -why : -EIO;
}
