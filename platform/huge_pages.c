/* huge_pages.c -- allocates an anonymous mapping that is aligned to 2 MiB, because mmap() aligns
 * only to ordinary pages. */
#include "platform/huge_pages.h"

#include <stdint.h>
#include <sys/mman.h>

#include "core/base/panic.h"

#define HUGE_PAGE ((size_t)1 << 21)

static size_t whole_pages(size_t size)
{
    CORE_ASSERT(size > 0);
    return (size + HUGE_PAGE - 1u) / HUGE_PAGE * HUGE_PAGE;
}

void *huge_pages_alloc(size_t size)
{
    const size_t used = whole_pages(size);
    char *mapped =
        mmap(NULL, used + HUGE_PAGE, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (mapped == MAP_FAILED) {
        return NULL;
    }
    const size_t before = (HUGE_PAGE - (uintptr_t)mapped % HUGE_PAGE) % HUGE_PAGE;
    char *memory = mapped + before;
    if (before > 0) {
        munmap(mapped, before);
    }
    munmap(memory + used, HUGE_PAGE - before);
    madvise(memory, used, MADV_HUGEPAGE); /* The result is ignored because a kernel without huge
                                             pages returns an error. */
    return memory;
}

void huge_pages_free(void *memory, size_t size)
{
    if (memory) {
        munmap(memory, whole_pages(size));
    }
}
