/* png.h -- writes a picture. */
#ifndef KINGYO_PLATFORM_PNG_H
#define KINGYO_PLATFORM_PNG_H

#include <stdint.h>

/* Writes `width` x `height` pixels of 3 bytes, top row first. 0, or a negative errno; then
 * nothing of the file is left. Allocates while it packs, so it is for demonstrations and tools, not
 * for the running kiosk. */
int png_write(const char *path, const uint8_t *rgb, uint32_t width, uint32_t height);

#endif
