/* pack_file.c -- packed species from and to files. */
#include "platform/species/pack.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "platform/out_file.h"
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

enum pack_result pack_write(const char *path, struct species_slot *slot, char why[VET_WHY_SIZE])
{
    static uint8_t bytes[PACK_SIZE_MAX];
    struct out_file out;
    const size_t size = pack_encode(slot, bytes);
    int error = out_open_lasting(&out, path);
    if (error == 0) {
        fwrite(bytes, 1, size, out.file); /* What becomes of it, closing tells. */
        error = out_close(&out);
    }
    return error != 0 ? cannot(-error, why) : PACK_OK;
}
