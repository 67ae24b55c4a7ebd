/* bytes.h -- bytes that grow at their end, for whoever writes a file whose head needs its size. */
#ifndef KINGYO_PLATFORM_CTL_BYTES_H
#define KINGYO_PLATFORM_CTL_BYTES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* All zero is empty. */
struct bytes {
    uint8_t *data;
    size_t size, room;
    bool failed; /* There was no memory; from then on nothing is added. */
};

void bytes_add(struct bytes *bytes, const void *data, size_t size);

/* As printf, without the zero at the end; at most 1,000 characters. */
__attribute__((format(printf, 2, 3)))
void bytes_print(struct bytes *bytes, const char *format, ...);

void bytes_free(struct bytes *bytes);

#endif
