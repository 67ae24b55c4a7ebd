/* pack_file.c -- packed species from and to files. */
#include "platform/species/pack.h"

#include <errno.h>
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "platform/species/plain.h"

static enum pack_result cannot(int error, char why[VET_WHY_SIZE])
{
    snprintf(why, VET_WHY_SIZE, "%s", strerror(error));
    return PACK_IO;
}

enum pack_result pack_read(const char *path, struct species_slot *slot, char why[VET_WHY_SIZE])
{
    static uint8_t bytes[PACK_SIZE_MAX];
    char cannot_open[PLAIN_WHY_SIZE];
    FILE *file;
    const enum plain_open opened = plain_open(path, PACK_SIZE_MAX, &file, cannot_open);
    if (opened != PLAIN_OPEN) {
        snprintf(why, VET_WHY_SIZE, "%s", cannot_open);
        return opened == PLAIN_LARGE ? PACK_BAD : PACK_IO;
    }
    const size_t size = fread(bytes, 1, sizeof bytes, file);
    const int error = ferror(file) ? errno : 0;
    fclose(file);
    return error != 0 ? cannot(error, why) : pack_decode(bytes, size, slot, why);
}

static bool write_whole(FILE *file, const uint8_t *bytes, size_t size)
{
    const bool whole = fwrite(bytes, 1, size, file) == size && fflush(file) == 0 &&
                       fsync(fileno(file)) == 0;
    return fclose(file) == 0 && whole;
}

/* The file that `path` leads to, or is to be; 0 or an errno. No device or folder gives way. */
static int find_place(const char *path, char place[PATH_MAX])
{
    struct stat status;
    if (!realpath(path, place)) { /* Not there yet. */
        const int error = errno, length = snprintf(place, PATH_MAX, "%s", path);
        return length < PATH_MAX ? error == ENOENT ? 0 : error : ENAMETOOLONG;
    }
    if (stat(place, &status) != 0) {
        return errno;
    }
    return S_ISREG(status.st_mode) ? 0 : S_ISDIR(status.st_mode) ? EISDIR : ENOTSUP;
}

/* Beside its place, then into it: whoever reads finds the old file or the new one. */
enum pack_result pack_write(const char *path, struct species_slot *slot, char why[VET_WHY_SIZE])
{
    static uint8_t bytes[PACK_SIZE_MAX];
    char place[PATH_MAX], beside[PATH_MAX];
    const size_t size = pack_encode(slot, bytes);
    const int error = find_place(path, place);
    if (error != 0) {
        return cannot(error, why);
    }
    const int length = snprintf(beside, sizeof beside, "%s.new", place);
    if (length < 0 || (size_t)length >= sizeof beside) {
        return cannot(ENAMETOOLONG, why);
    }
    FILE *file = fopen(beside, "wb");
    if (!file) {
        return cannot(errno, why);
    }
    if (!write_whole(file, bytes, size) || rename(beside, place) != 0) {
        const int left = errno;
        unlink(beside);
        return cannot(left, why);
    }
    return PACK_OK;
}
