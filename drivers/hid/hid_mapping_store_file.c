/* hid_mapping_store_file.c -- reads small files and replaces them atomically. */
#include "drivers/hid/hid_mapping_store_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

int hid_mapping_store_file_open(const char *path)
{
    struct stat about;
    const int fd = open(path, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
    if (fd >= 0 && (fstat(fd, &about) != 0 || !S_ISREG(about.st_mode))) {
        close(fd);
        errno = ENOTSUP;
        return -1;
    }
    return fd;
}

int hid_mapping_store_file_read(const char *path, char text[HID_MAPPING_STORE_TEXT_SIZE])
{
    const int fd = hid_mapping_store_file_open(path);
    size_t used = 0;
    ssize_t got = 0;
    if (fd < 0) {
        return errno;
    }
    while (used < HID_MAPPING_STORE_TEXT_SIZE &&
           ((got = read(fd, text + used, HID_MAPPING_STORE_TEXT_SIZE - used)) > 0 ||
            (got < 0 && errno == EINTR))) {
        used += got > 0 ? (size_t)got : 0u;
    }
    const int error = got < 0 ? errno : used == HID_MAPPING_STORE_TEXT_SIZE ? EFBIG : 0;
    close(fd);
    text[used < HID_MAPPING_STORE_TEXT_SIZE ? used : 0u] = '\0';
    return error;
}

static int write_all(int fd, const char *text)
{
    size_t left = strlen(text);
    while (left > 0) {
        const ssize_t done = write(fd, text, left);
        if (done < 0 && errno != EINTR) {
            return errno;
        }
        text += done > 0 ? done : 0;
        left -= done > 0 ? (size_t)done : 0u;
    }
    return fsync(fd) == 0 ? 0 : errno;
}

int hid_mapping_store_file_sync(const char *folder)
{
    const int fd = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    const int error = fd < 0 || fsync(fd) != 0 ? errno : 0;
    if (fd >= 0) {
        close(fd);
    }
    return error;
}

int hid_mapping_store_file_replace(const char *path, const char *text)
{
    char beside[HID_MAPPING_STORE_PATH_SIZE + 8u];
    snprintf(beside, sizeof beside, "%s.new", path);
    unlink(beside); /* The temporary file can remain from a power loss or from another process. */
    const int fd = open(beside, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0644);
    if (fd < 0) {
        return errno;
    }
    int error = write_all(fd, text);
    error = close(fd) != 0 && !error ? errno : error;
    error = !error && rename(beside, path) != 0 ? errno : error;
    if (error) {
        unlink(beside);
    }
    return error;
}
