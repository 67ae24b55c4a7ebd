/* byte_buffer.h -- a byte buffer that grows when data is appended.
 *
 * Used for files whose header contains the file size, which is known only when all data is
 * complete. */
#ifndef KINGYO_PLATFORM_CTL_LIB_BYTE_BUFFER_H
#define KINGYO_PLATFORM_CTL_LIB_BYTE_BUFFER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A byte buffer. A zero-initialized structure is a valid empty buffer. */
struct byte_buffer {
    uint8_t *data;
    size_t size, room;
    bool failed; /* True after an allocation has failed. All later additions are ignored. */
};

/* Appends a copy of the `size` bytes at `data`. Sets `failed` if memory allocation fails. */
void byte_buffer_add(struct byte_buffer *bytes, const void *data, size_t size);

/* Appends formatted text as printf() does, without a terminating zero. Asserts that the text has at
 * most 1,000 characters. */
__attribute__((format(printf, 2, 3))) void byte_buffer_print(struct byte_buffer *bytes,
                                                             const char *format, ...);

/* Frees the memory of the buffer. */
void byte_buffer_free(struct byte_buffer *bytes);

#endif
