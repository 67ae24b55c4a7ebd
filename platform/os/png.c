/* png.c -- encodes PNG with stb_image_write. The encoded bytes are written to the file by this
 * module and not by stb_image_write, so that an error such as a full disk is reported with its
 * errno. */
#include "platform/os/png.h"

#include <errno.h>
#include <stdlib.h>

#include "core/base/panic.h"
#include "platform/os/file.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

int png_write(const char *path, const uint8_t *rgb, uint32_t width, uint32_t height)
{
    CORE_ASSERT(rgb && width > 0 && height > 0 && width <= INT32_MAX / 3u);
    int size = 0;
    uint8_t *packed =
        stbi_write_png_to_mem(rgb, (int)(width * 3u), (int)width, (int)height, 3, &size);
    if (!packed) {
        return -ENOMEM;
    }
    struct atomic_file out;
    int error = file_atomic_open(&out, path);
    if (error == 0) {
        fwrite(packed, 1, (size_t)size, out.file); /* The result of fwrite() is not checked because
                                                      file_atomic_close() reports a failed write. */
        error = file_atomic_close(&out);
    }
    free(packed);
    return error;
}
