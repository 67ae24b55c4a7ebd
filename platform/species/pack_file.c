/* pack_file.c -- packed species from and to files. */
#include "platform/species/pack.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define PATH_SIZE 1024u

static enum pack_result cannot(int error, char why[VET_WHY_SIZE])
{
    snprintf(why, VET_WHY_SIZE, "%s", strerror(error));
    return PACK_IO;
}

/* All that is there, up to `size`; negative: -errno. */
static ssize_t read_all(int fd, uint8_t *bytes, size_t size)
{
    size_t at = 0;
    ssize_t got = 1;
    while (at < size && got > 0) {
        got = read(fd, bytes + at, size - at);
        at += got > 0 ? (size_t)got : 0;
    }
    return got < 0 ? -errno : (ssize_t)at;
}

enum pack_result pack_read(const char *path, struct species_slot *slot, char why[VET_WHY_SIZE])
{
    static uint8_t bytes[PACK_SIZE_MAX + 1]; /* One more, to see that a file is too long. */
    struct stat status;
    /* A pipe would make a kiosk wait for a writer who never comes. */
    const int fd = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    if (fd < 0 || fstat(fd, &status) != 0) {
        return cannot(errno, why);
    }
    const bool plain = S_ISREG(status.st_mode);
    const ssize_t size = plain ? read_all(fd, bytes, sizeof bytes) : 0;
    close(fd);
    if (!plain || size < 0) {
        return cannot(S_ISDIR(status.st_mode) ? EISDIR : plain ? (int)-size : ESPIPE, why);
    }
    return pack_decode(bytes, (size_t)size, slot, why);
}

static bool write_whole(FILE *file, const uint8_t *bytes, size_t size)
{
    const bool whole = fwrite(bytes, 1, size, file) == size && fflush(file) == 0 &&
                       fsync(fileno(file)) == 0;
    return fclose(file) == 0 && whole;
}

enum pack_result pack_write(const char *path, struct species_slot *slot, char why[VET_WHY_SIZE])
{
    static uint8_t bytes[PACK_SIZE_MAX];
    char beside[PATH_SIZE];
    const size_t size = pack_encode(slot, bytes);
    const int length = snprintf(beside, sizeof beside, "%s.new", path);
    if (length < 0 || (size_t)length >= sizeof beside) {
        return cannot(ENAMETOOLONG, why);
    }
    FILE *file = fopen(beside, "wb");
    if (!file) {
        return cannot(errno, why);
    }
    if (!write_whole(file, bytes, size) || rename(beside, path) != 0) {
        const int error = errno;
        unlink(beside);
        return cannot(error, why);
    }
    return PACK_OK;
}
