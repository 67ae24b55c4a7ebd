/* huge_pages.c -- allocates memory that is aligned to 2 MiB, so that the kernel can use pages of 2
 * MiB. The function has a file of its own, because the benchmark of the tank links only this file
 * of the platform folder. */
#include "platform/huge_pages.h"

#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>

#include "core/base/panic.h"

#define HUGE_PAGE ((size_t)1 << 21)

void *huge_pages_alloc(size_t size)
{
    CORE_ASSERT(size > 0);
    const size_t used = (size + HUGE_PAGE - 1u) / HUGE_PAGE * HUGE_PAGE;
    void *memory = aligned_alloc(HUGE_PAGE, used);
    if (memory) {
        madvise(memory, used, MADV_HUGEPAGE); /* The result is ignored, because a kernel without
                                               * huge pages returns an error and ordinary pages also
                                               * work. */
        memset(memory, 0, used);
    }
    return memory;
}
