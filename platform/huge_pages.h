/* huge_pages.h -- allocates large arrays on memory pages of 2 MiB, for arrays that are accessed in
 * random order. */
#pragma once

#include <stddef.h>

/* Returns `size` bytes of zeros, aligned to 2 MiB, or NULL if there is no memory. Pages of 2 MiB
 * reduce the processor's time for address translation. The kernel may use ordinary pages instead.
 * The caller releases the memory with free(). */
void *huge_pages_alloc(size_t size);
