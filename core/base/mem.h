/* mem.h -- the four memory functions that a freestanding compiler may call anyway.
 *
 * <string.h> is not a freestanding header, so the core declares what it uses of it here. */
#ifndef KINGYO_CORE_BASE_MEM_H
#define KINGYO_CORE_BASE_MEM_H

#include <stddef.h>

void *memcpy(void *restrict to, const void *restrict from, size_t size);
void *memmove(void *to, const void *from, size_t size);
void *memset(void *to, int byte, size_t size);
int memcmp(const void *left, const void *right, size_t size);

/* memcpy() of a size that the compiler knows: loads and stores, where a freestanding source's
 * memcpy() is a call. */
#define MEM_COPY(to, from, size) ((void)__builtin_memcpy(to, from, size))

#endif
