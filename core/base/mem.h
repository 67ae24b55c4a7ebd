/* mem.h -- the four memory functions that a freestanding compiler may call.
 *
 * <string.h> is not a freestanding header, so the core declares the functions that it uses. */
#ifndef KINGYO_CORE_BASE_MEM_H
#define KINGYO_CORE_BASE_MEM_H

#include <stddef.h>

void *memcpy(void *restrict to, const void *restrict from, size_t size);
void *memmove(void *to, const void *from, size_t size);
void *memset(void *to, int byte, size_t size);
int memcmp(const void *left, const void *right, size_t size);

/* Calls memcpy() with a size known at compile time, so that loads and stores replace the call,
 * which a freestanding source's memcpy() would keep. */
#define MEM_COPY(to, from, size) ((void)__builtin_memcpy(to, from, size))

#endif
