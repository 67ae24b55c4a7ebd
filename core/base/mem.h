/* mem.h -- the four memory functions that a compiler may call in a freestanding program.
 *
 * <string.h> is not a freestanding header, so this header declares the four functions. */
#pragma once

#include <stddef.h>

void *memcpy(void *restrict to, const void *restrict from, size_t size);
void *memmove(void *to, const void *from, size_t size);
void *memset(void *to, int byte, size_t size);
int memcmp(const void *left, const void *right, size_t size);

/* Copies `size` bytes. `size` is a constant, so the compiler replaces the copy by loads and stores.
 * A direct memcpy() would remain a call, because the core is compiled as freestanding code. */
#define MEM_COPY(to, from, size) ((void)__builtin_memcpy(to, from, size))
