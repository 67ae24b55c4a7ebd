/* panic.h -- where a broken invariant of the core ends.
 *
 * The core asserts bugs and returns weather. A bug reaches core_panic(), the only symbol besides
 * memcpy, memmove, memset and memcmp that the core's objects leave undefined: the kiosk writes its
 * last inputs and stops, a unit test catches it, a bare board resets. */
#ifndef KINGYO_CORE_BASE_PANIC_H
#define KINGYO_CORE_BASE_PANIC_H

/* Provided by whoever links the core; must not return. `condition` and `file` are static
 * strings. */
_Noreturn void core_panic(const char *condition, const char *file, int line);

/* One condition each, kept in release builds. */
#define CORE_ASSERT(condition)                                                                     \
    ((condition) ? (void)0 : core_panic(#condition, __FILE__, __LINE__))

#endif
