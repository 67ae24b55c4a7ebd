/* png.c -- encodes PNG with stb_image_write. The module itself writes the encoded bytes to the
 * file, so that a full disk is reported with its errno. */
#include "platform/os/png.h"

#include <assert.h>
#include <errno.h>
#include <stdlib.h>

#include "platform/os/file.h"

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
    struct atomic_file out;
    const int error = file_atomic_open(&out, path);
    if (error) {
        return error;
    }
    fwrite(bytes, 1, size, out.file); /* The result of fwrite() is not checked because
                                         file_atomic_close() reports a failed write. */
    return file_atomic_close(&out);
}

int png_write(const char *path, const uint8_t *rgb, uint32_t width, uint32_t height)
{
    assert(rgb && width > 0 && height > 0 && width <= INT32_MAX / 3u);
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
