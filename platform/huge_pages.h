/* huge_pages.h -- memory for large states that are accessed at random. */
#ifndef KINGYO_PLATFORM_HUGE_PAGES_H
#define KINGYO_PLATFORM_HUGE_PAGES_H

#include <stddef.h>

/* Returns `size` bytes of zeros, aligned to 2 MiB, or NULL if there is no memory. With 2 MiB pages
 * the processor spends less time on address translation; the kernel may use ordinary pages instead.
 * The caller releases the memory with huge_pages_free() and the same size. */
void *huge_pages_alloc(size_t size);

/* Releases memory of huge_pages_alloc(), with the same size. */
void huge_pages_free(void *memory, size_t size);

#endif
