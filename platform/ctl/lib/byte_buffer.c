/* byte_buffer.c -- the implementation of a growing byte buffer.
 *
 * The capacity doubles when the buffer is full, so that each byte is copied about once on
 * average. */
#include "platform/ctl/lib/byte_buffer.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/panic.h"

#define ROOM_AT_FIRST 4096u
#define PRINT_MAX 1001u

void byte_buffer_add(struct byte_buffer *bytes, const void *data, size_t size)
{
    if (!bytes->failed && bytes->room - bytes->size < size) {
        size_t room = bytes->room ? bytes->room : ROOM_AT_FIRST;
        while (room - bytes->size < size) {
            room *= 2u;
        }
        uint8_t *more = realloc(bytes->data, room);
        bytes->failed = more == NULL;
        if (more) {
            bytes->data = more;
            bytes->room = room;
        }
    }
    if (!bytes->failed && size > 0) {
        memcpy(bytes->data + bytes->size, data, size);
        bytes->size += size;
    }
}

void byte_buffer_print(struct byte_buffer *bytes, const char *format, ...)
{
    char text[PRINT_MAX];
    va_list arguments;
    va_start(arguments, format);
    const int length = vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    CORE_ASSERT(length >= 0 && length < (int)sizeof text);
    byte_buffer_add(bytes, text, (size_t)length);
}

void byte_buffer_free(struct byte_buffer *bytes)
{
    free(bytes->data);
    *bytes = (struct byte_buffer){ 0 };
}
