/* atomic_file.c -- writes an atomic file; see atomic_file.h. The first error is stored and returned
 * at the close, because a disk may be full at any byte. */
#include "platform/os/atomic_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* ---- Opening ------------------------------------------------------------------------------- */

/* Resolves `path` to the absolute path `place`. Returns 0 or a negative errno. Sets `*mode` to the
 * mode of the file, or to 0 if the file does not exist. */
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
    if (error != -ENOENT || lstat(path, &status) == 0) { /* A dangling symbolic link is an error. */
        return error;
    }
    return snprintf(place, PATH_MAX, "%s", path) < PATH_MAX ? 0 : -ENAMETOOLONG;
}

static int atomic_file_use_descriptor(struct atomic_file *out, int fd)
{
    out->file = fd < 0 ? NULL : fdopen(fd, "wb");
    const int error = out->file ? 0 : -errno;
    if (fd >= 0 && !out->file) {
        close(fd);
    }
    return error;
}

/* Opens a character device or a pipe. If the pipe has no reader, the open fails with ENXIO instead
 * of blocking. */
static int open_stream(struct atomic_file *out)
{
    const int fd = open(out->place, O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
    out->is_stream = true;
    if (fd >= 0) {
        fcntl(fd, F_SETFL, fcntl(fd, F_GETFL) & ~O_NONBLOCK);
    }
    return atomic_file_use_descriptor(out, fd);
}

/* Opens the temporary file. An existing file with this name is deleted first. The existing file may
 * be left from a power cut, or belong to another program. A link is never followed. */
static int open_part(struct atomic_file *out, mode_t mode)
{
    const int length = snprintf(out->part, sizeof out->part, "%s" FILE_ATOMIC_PART, out->place);
    if (length < 0 || (size_t)length >= sizeof out->part) {
        return -ENAMETOOLONG;
    }
    if (mode != 0 && access(out->place, W_OK) != 0) {
        return -errno; /* A file without write permission must not be replaced. */
    }
    unlink(out->part);
    const int fd = open(out->part, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (fd >= 0 && mode != 0) {
        fchmod(fd, mode & 0777);
    }
    return atomic_file_use_descriptor(out, fd);
}

static int open_any(struct atomic_file *out, const char *path, bool lasts)
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

int file_atomic_open(struct atomic_file *out, const char *path)
{
    return open_any(out, path, false);
}

int file_atomic_open_durable(struct atomic_file *out, const char *path)
{
    return open_any(out, path, true);
}

/* ---- Closing ------------------------------------------------------------------------------- */

/* Syncs the folder that contains `place`. A new file name survives a power cut only after this
 * sync. */
static int sync_folder(char place[PATH_MAX])
{
    char *slash = strrchr(place, '/');
    if (slash) {
        slash[slash == place] = '\0'; /* The root folder keeps its slash. */
    }
    const int fd = open(slash ? place : ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (fd < 0) {
        return -errno;
    }
    const int error = fsync(fd) != 0 ? -errno : 0;
    close(fd);
    return error;
}

/* Closes the stream. Returns 0, or the negative errno of the stream's first error. */
static int finish(struct atomic_file *out)
{
    /* errno is still set by the failed write, because successful calls do not change errno. */
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

int file_atomic_close(struct atomic_file *out)
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
