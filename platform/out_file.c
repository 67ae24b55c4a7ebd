/* out_file.c -- a disk may be full at any byte: all of them are asked for, and told once. */
#include "platform/out_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* ---- Opening -------------------------------------------------------------------------------- */

/* What `path` leads to, or where it is to be; 0 or a negative errno. `*mode` 0: not there yet. */
static int find_place(const char *path, char place[PATH_MAX], mode_t *mode)
{
    struct stat status;
    *mode = 0;
    if (realpath(path, place)) {
        const int error = stat(place, &status) != 0 ? -errno : 0;
        *mode = status.st_mode;
        return error;
    }
    const int error = -errno;
    if (error != -ENOENT || lstat(path, &status) == 0) { /* A link that leads nowhere. */
        return error;
    }
    return snprintf(place, PATH_MAX, "%s", path) < PATH_MAX ? 0 : -ENAMETOOLONG;
}

static int take(struct out_file *out, int fd)
{
    out->file = fd < 0 ? NULL : fdopen(fd, "wb");
    const int error = out->file ? 0 : -errno;
    if (fd >= 0 && !out->file) {
        close(fd);
    }
    return error;
}

/* A pipe without a reader would make us wait for one who never comes: ENXIO. */
static int open_stream(struct out_file *out)
{
    const int fd = open(out->place, O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    out->is_stream = true;
    if (fd >= 0) {
        fcntl(fd, F_SETFL, fcntl(fd, F_GETFL) & ~O_NONBLOCK);
    }
    return take(out, fd);
}

/* What an earlier loss of power left there goes; what somebody else put there, too, but never
 * through a link. */
static int open_part(struct out_file *out, mode_t mode)
{
    const int length = snprintf(out->part, sizeof out->part, "%s" OUT_FILE_PART, out->place);
    if (length < 0 || (size_t)length >= sizeof out->part) {
        return -ENAMETOOLONG;
    }
    if (mode != 0 && access(out->place, W_OK) != 0) {
        return -errno; /* Who may not write a file may not replace it. */
    }
    unlink(out->part);
    const int fd = open(out->part, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (fd >= 0 && mode != 0) {
        fchmod(fd, mode & 0777);
    }
    return take(out, fd);
}

static int open_any(struct out_file *out, const char *path, bool lasts)
{
    mode_t mode;
    out->file = NULL;
    out->is_stream = false;
    out->lasts = lasts;
    const int error = find_place(path, out->place, &mode);
    if (error != 0) {
        return error;
    }
    if (mode == 0 || S_ISREG(mode)) {
        return open_part(out, mode);
    }
    if (S_ISDIR(mode)) {
        return -EISDIR;
    }
    return lasts || !(S_ISCHR(mode) || S_ISFIFO(mode)) ? -ENOTSUP : open_stream(out);
}

int out_open(struct out_file *out, const char *path)
{
    return open_any(out, path, false);
}

int out_open_lasting(struct out_file *out, const char *path)
{
    return open_any(out, path, true);
}

/* ---- Closing -------------------------------------------------------------------------------- */

/* A name in a folder lasts once the folder is on the disk. */
static int sync_folder(char place[PATH_MAX])
{
    char *slash = strrchr(place, '/');
    if (slash) {
        slash[slash == place] = '\0'; /* The root keeps its own. */
    }
    const int fd = open(slash ? place : ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (fd < 0) {
        return -errno;
    }
    const int error = fsync(fd) != 0 ? -errno : 0;
    close(fd);
    return error;
}

/* The first error of the stream since it was opened, which is closed. */
static int finish(struct out_file *out)
{
    /* A write that failed left its errno, and what succeeded since has not touched it. */
    const bool failed = ferror(out->file) != 0;
    int why = failed ? (errno ? errno : EIO) : 0;
    if (fflush(out->file) != 0 && why == 0) {
        why = errno;
    }
    if (why == 0 && out->lasts && fsync(fileno(out->file)) != 0) {
        why = errno;
    }
    if (fclose(out->file) != 0 && why == 0) {
        why = errno;
    }
    out->file = NULL;
    return -why;
}

int out_close(struct out_file *out)
{
    int error = finish(out);
    if (out->is_stream) {
        return error;
    }
    if (error == 0 && rename(out->part, out->place) != 0) {
        error = -errno;
    }
    if (error != 0) {
        unlink(out->part);
        return error;
    }
    return out->lasts ? sync_folder(out->place) : 0;
}
