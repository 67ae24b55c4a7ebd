/* png.h -- writes a PNG file. */
#ifndef KINGYO_PLATFORM_OS_PNG_H
#define KINGYO_PLATFORM_OS_PNG_H

#include <stdint.h>

/* Writes `width` x `height` pixels of 3 bytes, top row first. Returns 0 or a negative errno; after
 * an error no new file exists. Allocates memory, therefore demonstrations and tools call it and the
 * running kiosk does not. */
int png_write(const char *path, const uint8_t *rgb, uint32_t width, uint32_t height);

#endif
