/* png.h -- writes a PNG file. */
#pragma once

#include <stdint.h>

/* Writes a PNG file of `width` x `height` pixels. `rgb` has 3 bytes per pixel, top row first.
 * Returns 0 or a negative errno. After an error no new file exists. The function allocates memory,
 * therefore only demonstrations and command-line tools call it; the running kiosk does not. */
int png_write(const char *path, const uint8_t *rgb, uint32_t width, uint32_t height);
