/* byte_buffer.h -- a byte buffer that grows at its end.
 *
 * Writers use it for files whose header contains the file size. */
#ifndef KINGYO_PLATFORM_CTL_LIB_BYTE_BUFFER_H
#define KINGYO_PLATFORM_CTL_LIB_BYTE_BUFFER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A byte buffer. All zero is a valid empty buffer. */
struct byte_buffer {
    uint8_t *data;
    size_t size, room;
    bool failed; /* Whether an allocation has failed. All later additions are then ignored. */
};

/* Appends `size` bytes of `data`. Sets `failed` if memory is exhausted. */
void byte_buffer_add(struct byte_buffer *bytes, const void *data, size_t size);

/* Appends formatted text as printf() does, without a terminating zero. Asserts that the text has at
 * most 1,000 characters. */
__attribute__((format(printf, 2, 3))) void byte_buffer_print(struct byte_buffer *bytes,
                                                             const char *format, ...);

/* Frees the data of the buffer. */
void byte_buffer_free(struct byte_buffer *bytes);

#endif
