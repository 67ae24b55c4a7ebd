/* png.c -- stb_image_write packs, we write, so that a full disk is told by its name. */
#include "platform/png.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wmissing-prototypes"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

static int write_all(const char *path, const uint8_t *bytes, size_t size)
{
    FILE *file = fopen(path, "wb");
    if (!file) {
        return -errno;
    }
    int result = fwrite(bytes, 1, size, file) == size ? 0 : -errno;
    if (fclose(file) != 0 && result == 0) {
        result = -errno;
    }
    return result;
}

int png_write(const char *path, const uint8_t *rgb, uint32_t width, uint32_t height)
{
    int size = 0;
    uint8_t *packed =
        stbi_write_png_to_mem(rgb, (int)(width * 3u), (int)width, (int)height, 3, &size);
    if (!packed) {
        return -ENOMEM;
    }
    const int result = write_all(path, packed, (size_t)size);
    free(packed);
    return result;
}
