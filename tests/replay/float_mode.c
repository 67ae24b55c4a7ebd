/* float_mode.c -- a library for LD_PRELOAD that makes the processor flush denormal numbers to zero,
 * as some display libraries do.
 *
 * The library sets the modes flush-to-zero and denormals-are-zero in the first thread and in each
 * new thread. If FLOAT_MODE_IN is "pread", the library also sets them in every pread(). Because a
 * correct core restores its own mode, its digests must not change. Works only on x86-64. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>
#include <unistd.h>

static void spoil(void)
{
    __builtin_ia32_ldmxcsr(0x1f80u | 1u << 15 | 1u << 6);
}

static void spoil_if_named(const char *function)
{
    const char *named = getenv("FLOAT_MODE_IN");
    if (named && strcmp(named, function) == 0) {
        spoil();
    }
}

__attribute__((constructor)) static void load(void)
{
    spoil();
}

ssize_t pread(int fd, void *bytes, size_t size, off_t offset)
{
    ssize_t (*next)(int, void *, size_t, off_t) =
        (ssize_t(*)(int, void *, size_t, off_t))dlsym(RTLD_NEXT, "pread");
    spoil_if_named("pread");
    return next(fd, bytes, size, offset);
}

struct start {
    void *(*run)(void *);
    void *self;
};

static void *begin(void *self)
{
    const struct start start = *(struct start *)self;
    free(self);
    spoil();
    return start.run(start.self);
}

int pthread_create(pthread_t *thread, const pthread_attr_t *attributes, void *(*run)(void *),
                   void *self)
{
    int (*next)(pthread_t *, const pthread_attr_t *, void *(*)(void *), void *) =
        (int (*)(pthread_t *, const pthread_attr_t *, void *(*)(void *), void *))dlsym(
            RTLD_NEXT, "pthread_create");
    struct start *start = malloc(sizeof *start);
    *start = (struct start){ run, self };
    return next(thread, attributes, begin, start);
}
