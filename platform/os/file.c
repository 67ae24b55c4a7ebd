/* file.c -- opens, reads, replaces and locks files and folders; see file.h. */
#include "platform/os/file.h"

#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
#include <libgen.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/panic.h"

/* ---- Regular files --------------------------------------------------------------------------- */

/* Opens a regular file and rejects any other type of file. The file type is read from the open
 * descriptor, so that no other file can replace the file between the check and the use. If `flags`
 * has O_TRUNC, the file is truncated after the check. Returns a descriptor, or -1 with errno
 * set. */
static int open_regular(int folder, const char *path, int flags, mode_t mode)
{
    struct stat about = { 0 };
    const int added = O_NONBLOCK | O_CLOEXEC | O_NOCTTY;
    const int handle = openat(folder, path, (flags & ~O_TRUNC) | added, mode);
    if (handle < 0) {
        errno = errno == ENXIO ? ENOTSUP : errno; /* ENXIO means that the path is a FIFO without a
                                                     reader, a socket, or a device without its
                                                     driver. */
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

int file_handle_at(int folder, const char *path, int flags, mode_t mode)
{
    return open_regular(folder, path, flags | O_NOFOLLOW, mode);
}

int file_handle(const char *path, int flags, mode_t mode)
{
    return open_regular(AT_FDCWD, path, flags | O_NOFOLLOW, mode);
}

int file_user_handle(const char *path, int flags, mode_t mode)
{
    return open_regular(AT_FDCWD, path, flags, mode);
}

int file_give_at(int folder, const char *path, uid_t owner, gid_t group, mode_t mode)
{
    struct stat about;
    const int handle = file_handle_at(folder, path, O_RDONLY, 0);
    if (handle < 0) {
        return -1;
    }
    int result = fstat(handle, &about);
    if (result == 0 && (about.st_uid != geteuid() || about.st_nlink != 1)) {
        errno = EPERM;
        result = -1;
    }
    if (result == 0) {
        result = fchown(handle, owner, group) == 0 ? fchmod(handle, mode) : -1;
    }
    const int error = errno;
    close(handle);
    errno = error;
    return result;
}

/* Open file of which only a limited number of bytes may be read. `left` is the number of bytes that
 * may still be read. */
struct bounded {
    int handle;
    uint32_t left;
};

/* Reads from the file. The read may exceed `left` by one byte, to detect a file that is longer than
 * the limit. If the file is longer, returns -1 and sets errno to EFBIG. */
static ssize_t bounded_read(void *cookie, char *out, size_t size)
{
    struct bounded *bounded = cookie;
    const size_t request_size = size > bounded->left ? (size_t)bounded->left + 1u : size;
    const ssize_t got = read(bounded->handle, out, request_size);
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

FILE *file_open(const char *path, uint32_t size_max)
{
    const cookie_io_functions_t functions = { .read = bounded_read, .close = bounded_close };
    struct stat about = { 0 };
    const int handle = file_user_handle(path, O_RDONLY, 0);
    if (handle < 0) {
        return NULL;
    }
    const int error = fstat(handle, &about) != 0 ? errno : about.st_size > size_max ? EFBIG : 0;
    struct bounded *bounded = error == 0 ? malloc(sizeof *bounded) : NULL;
    FILE *file = NULL;
    if (bounded) {
        *bounded = (struct bounded){ .handle = handle, .left = size_max };
        file = fopencookie(bounded, "r", functions);
    }
    if (!file) {
        free(bounded);
        close(handle);
        errno = error ? error : ENOMEM;
    }
    return file;
}

int file_type_error(const char *path)
{
    struct stat about;
    return lstat(path, &about) != 0 || S_ISREG(about.st_mode) ? 0
           : S_ISLNK(about.st_mode)                           ? ELOOP
           : S_ISDIR(about.st_mode)                           ? EISDIR
                                                              : ENOTSUP;
}

bool file_is_other(const char *path)
{
    return file_type_error(path) != 0;
}

bool file_has_suffix(const char *name, const char *suffix)
{
    const size_t length = strlen(name), tail = strlen(suffix);
    return length >= tail && strcmp(name + length - tail, suffix) == 0;
}

const char *file_error(int error)
{
    return error == ELOOP     ? "is a symbolic link"
           : error == ENOTSUP ? "is not a regular file"
           : error == EFBIG   ? "is too large"
                              : strerror(error);
}

/* ---- Lines ----------------------------------------------------------------------------------- */

/* Maximum number of bytes that are skipped after the start of a bad line. The number is limited
 * because a file of the kernel may be endless. If the bad line is longer, its rest is read as the
 * next line. */
#define SKIP_MAX (1u << 20)

enum file_line file_read_line(FILE *file, char *line, size_t size)
{
    CORE_ASSERT(file && size >= 2);
    enum file_line result = FILE_LINE_READ;
    size_t length = 0, skipped = 0;
    int c = getc(file);
    if (c == EOF) {
        return FILE_LINE_END;
    }
    for (; c != '\n' && c != EOF && skipped < SKIP_MAX; c = getc(file)) {
        if (c == 0 || length + 1u == size) {
            result = FILE_LINE_BAD;
        }
        if (result == FILE_LINE_READ) {
            line[length++] = (char)c;
        } else {
            skipped++;
        }
    }
    line[length] = '\0';
    return ferror(file) ? FILE_LINE_END : result;
}

char *file_skip_mark(char *text)
{
    return text + (strncmp(text, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0);
}

char *file_trim(char *text)
{
    while (isspace((unsigned char)*text)) {
        text++;
    }
    size_t length = strlen(text);
    while (length > 0 && isspace((unsigned char)text[length - 1])) {
        text[--length] = '\0';
    }
    return text;
}

char *file_trim_comment(char *line)
{
    for (char *hash = strchr(line, '#'); hash; hash = strchr(hash + 1, '#')) {
        if (hash == line || isspace((unsigned char)hash[-1])) {
            *hash = '\0';
            break;
        }
    }
    return file_trim(line);
}

char *file_cut_value(char *key)
{
    char *equals = strchr(key, '=');
    if (!equals) {
        return NULL;
    }
    *equals = '\0';
    file_trim(key);
    return file_trim(equals + 1);
}

void file_first_line(const char *path, char *line, size_t size)
{
    FILE *file = file_open(path, FILE_KERNEL_SIZE_MAX);
    if (!file || file_read_line(file, line, size) == FILE_LINE_END) {
        line[0] = '\0';
    }
    if (file) {
        fclose(file);
    }
}

/* ---- Writing and renaming -------------------------------------------------------------------- */

int file_write(int fd, const void *bytes, size_t size)
{
    const char *from = bytes;
    while (size > 0) {
        const ssize_t written = write(fd, from, size);
        if (written < 0 && errno == EINTR) {
            continue;
        }
        if (written <= 0) {
            return written < 0 ? -errno : -EIO;
        }
        from += written;
        size -= (size_t)written;
    }
    return 0;
}

int file_sync_parent(const char *path)
{
    CORE_ASSERT(path);
    char folder[PATH_MAX];
    const size_t size = strlen(path) + 1u;
    if (size > sizeof folder) {
        return -ENAMETOOLONG;
    }
    memcpy(folder, path, size);
    const int fd = open(dirname(folder), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (fd < 0) {
        return -errno;
    }
    const int error = fsync(fd) != 0 ? -errno : 0;
    close(fd);
    return error;
}

int file_rename_durable(const char *from, const char *to)
{
    return rename(from, to) != 0 ? -errno : file_sync_parent(to);
}

int file_rename_new(const char *from, const char *to)
{
    struct stat about;
    if (renameat2(AT_FDCWD, from, AT_FDCWD, to, RENAME_NOREPLACE) == 0) {
        return 0;
    }
    if (errno != EINVAL && errno != ENOSYS) {
        return -errno;
    }
    /* The file system or the kernel does not support the flag. The data folder is locked, so no
     * other kiosk creates `to` between the check and the rename. */
    const int error = lstat(to, &about) == 0 ? EEXIST : errno;
    if (error != ENOENT) {
        return -error;
    }
    return rename(from, to) != 0 ? -errno : 0;
}

/* Creates the temporary file of `path`, whose name is written to `part`. An existing file with this
 * name is deleted first. The existing file may be left from a power cut, or belong to another
 * program. A link is never followed. Returns a descriptor or a negative errno. */
static int open_part(const char *path, char part[PATH_MAX], mode_t mode)
{
    const int length = snprintf(part, PATH_MAX, "%s" FILE_ATOMIC_PART, path);
    if (length < 0 || length >= PATH_MAX) {
        return -ENAMETOOLONG;
    }
    unlink(part);
    const int fd = open(part, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
    return fd < 0 ? -errno : fd;
}

/* Replaces `path` by the temporary file if `error` is 0, otherwise deletes the temporary file.
 * Returns 0 or a negative errno. */
static int finish_part(const char *part, const char *path, int error, bool is_durable)
{
    CORE_ASSERT(error <= 0);
    if (error == 0 && rename(part, path) != 0) {
        error = -errno;
    }
    if (error != 0) {
        unlink(part);
        return error;
    }
    return is_durable ? file_sync_parent(path) : 0;
}

int file_replace(const char *path, const void *bytes, size_t size, int flags)
{
    CORE_ASSERT((flags & ~(FILE_REPLACE_DURABLE | FILE_REPLACE_PUBLIC)) == 0);
    char part[PATH_MAX];
    const int fd = open_part(path, part, 0644);
    if (fd < 0) {
        return fd;
    }
    int error = (flags & FILE_REPLACE_PUBLIC) && fchmod(fd, 0644) != 0 ? -errno : 0;
    error = error == 0 ? file_write(fd, bytes, size) : error;
    if (error == 0 && (flags & FILE_REPLACE_DURABLE) && fsync(fd) != 0) {
        error = -errno;
    }
    if (close(fd) != 0 && error == 0) {
        error = -errno;
    }
    return finish_part(part, path, error, (flags & FILE_REPLACE_DURABLE) != 0);
}

/* ---- Atomic streams -------------------------------------------------------------------------- */

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

static int open_any(struct atomic_file *out, const char *path, bool lasts)
{
    mode_t mode;
    int fd;
    *out = (struct atomic_file){ .lasts = lasts };
    const int error = find_place(path, out->place, &mode);
    if (error != 0) {
        return error;
    }
    if (mode == 0 || S_ISREG(mode)) {
        /* A file that the user may not write must not be replaced either. */
        if (mode != 0 && access(out->place, W_OK) != 0) {
            return -errno;
        }
        fd = open_part(out->place, out->part, 0666);
        if (fd < 0) {
            return fd;
        }
        if (mode != 0) {
            fchmod(fd, mode & 0777);
        }
    } else if (lasts || !(S_ISCHR(mode) || S_ISFIFO(mode))) {
        return S_ISDIR(mode) ? -EISDIR : -ENOTSUP;
    } else {
        /* The path is a character device or a pipe. With O_NONBLOCK, open() fails with ENXIO
         * instead of blocking if the pipe has no reader. */
        out->is_stream = true;
        fd = open(out->place, O_WRONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
        if (fd < 0) {
            return -errno;
        }
        fcntl(fd, F_SETFL, fcntl(fd, F_GETFL) & ~O_NONBLOCK);
    }
    out->file = fdopen(fd, "wb");
    if (!out->file) {
        close(fd);
        return -ENOMEM;
    }
    return 0;
}

int file_atomic_open(struct atomic_file *out, const char *path)
{
    return open_any(out, path, false);
}

int file_atomic_open_durable(struct atomic_file *out, const char *path)
{
    return open_any(out, path, true);
}

/* Closes the stream. Returns 0, or the negative errno of the first error since the stream was
 * opened. An error of any write is returned here, so that the caller need not check each write. */
int file_atomic_close(struct atomic_file *out)
{
    CORE_ASSERT(out->file);
    /* If a write failed, errno still has the reason, because successful calls do not change
     * errno. */
    int why = ferror(out->file) ? (errno ? errno : EIO) : 0;
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
    return out->is_stream ? -why : finish_part(out->part, out->place, -why, out->lasts);
}

/* ---- Folders --------------------------------------------------------------------------------- */

int file_make_folder(const char *path)
{
    char copy[FILE_FOLDER_MAX];
    struct stat status;
    const size_t length = strlen(path);
    if (length == 0 || length >= sizeof copy) {
        return length == 0 ? -ENOENT : -ENAMETOOLONG;
    }
    memcpy(copy, path, length + 1);
    /* Creates the folder for each prefix of the path that ends before a slash or at the end of the
     * path. */
    for (size_t i = 1; i <= length; i++) {
        if (copy[i] == '/' || copy[i] == '\0') {
            copy[i] = '\0';
            if (mkdir(copy, 0755) != 0 && errno != EEXIST) {
                return -errno;
            }
            copy[i] = path[i];
        }
    }
    if (stat(path, &status) == 0 && !S_ISDIR(status.st_mode)) {
        return -ENOTDIR;
    }
    return access(path, W_OK | X_OK) != 0 ? -errno : 0;
}

int file_lock_folder(const char *path)
{
    const int handle = open(path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (handle < 0) {
        return -errno;
    }
    if (flock(handle, LOCK_EX | LOCK_NB) != 0) {
        const int error = errno;
        close(handle);
        return -error;
    }
    return handle;
}

void file_default_data(char out[FILE_FOLDER_MAX])
{
    const char *data = getenv("XDG_DATA_HOME");
    const char *home = getenv("HOME");
    out[0] = '\0';
    if (data && data[0] == '/') {
        snprintf(out, FILE_FOLDER_MAX, "%s/kingyo", data);
    } else if (home && home[0] == '/') {
        snprintf(out, FILE_FOLDER_MAX, "%s/.local/share/kingyo", home);
    }
}
