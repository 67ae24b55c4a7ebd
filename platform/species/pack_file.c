/* pack_file.c -- reads and writes species files (NAME.kfish). */
#include "platform/species/pack.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "platform/os/file.h"
#include "platform/species/text.h"

static enum pack_result cannot(int error, char why[VALIDATE_WHY_SIZE])
{
    snprintf(why, VALIDATE_WHY_SIZE, "%s", strerror(error));
    return PACK_IO;
}

enum pack_result pack_read(const char *path, struct species_slot *slot, char why[VALIDATE_WHY_SIZE])
{
    static uint8_t bytes[PACK_SIZE_MAX];
    char cannot_open[TEXT_FILE_WHY_SIZE];
    FILE *file;
    const enum text_file_open opened = text_file_open(path, PACK_SIZE_MAX, &file, cannot_open);
    if (opened != TEXT_FILE_OPEN) {
        snprintf(why, VALIDATE_WHY_SIZE, "%s", cannot_open);
        return opened == TEXT_FILE_LARGE ? PACK_BAD : PACK_IO;
    }
    const size_t size = fread(bytes, 1, sizeof bytes, file);
    const int error = ferror(file) ? errno : 0;
    fclose(file);
    return error != 0 ? cannot(error, why) : pack_decode(bytes, size, slot, why);
}

enum pack_result pack_read_data(const char *path, struct species_slot *slot,
                                char why[VALIDATE_WHY_SIZE])
{
    static uint8_t bytes[PACK_SIZE_MAX + 1u]; /* The buffer is one byte larger than the maximum
                                                 file size, so that a file that is too large is
                                                 detected. */
    const int handle = file_handle(path, O_RDONLY, 0);
    size_t size = 0;
    ssize_t got = handle < 0 ? -1 : 1;
    while (got > 0 && size < sizeof bytes) {
        got = read(handle, bytes + size, sizeof bytes - size);
        size += got > 0 ? (size_t)got : 0u;
    }
    const int error = got < 0 ? errno : size > PACK_SIZE_MAX ? EFBIG : 0;
    if (handle >= 0) {
        close(handle);
    }
    if (error != 0) {
        snprintf(why, VALIDATE_WHY_SIZE, "%s", file_error(error));
        return error == EFBIG ? PACK_BAD : PACK_IO;
    }
    return pack_decode(bytes, size, slot, why);
}

enum pack_result pack_write(const char *path, struct species_slot *slot,
                            char why[VALIDATE_WHY_SIZE])
{
    static uint8_t bytes[PACK_SIZE_MAX];
    struct atomic_file out;
    const size_t size = pack_encode(slot, bytes);
    int error = file_atomic_open_durable(&out, path);
    if (error == 0) {
        fwrite(bytes, 1, size, out.file); /* file_atomic_close() also reports an earlier error of
                                             fwrite(). */
        error = file_atomic_close(&out);
    }
    return error != 0 ? cannot(-error, why) : PACK_OK;
}
