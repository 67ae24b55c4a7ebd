/* panic.h -- handling of a broken invariant of the core.
 *
 * The core asserts on programming errors and returns an error for bad data or a failed device. A
 * failed assertion calls core_panic(), the only symbol besides memcpy, memmove, memset and memcmp
 * that the core's objects leave undefined. The kiosk writes its last inputs and stops, a unit test
 * catches the call, a bare board resets. */
#ifndef KINGYO_CORE_BASE_PANIC_H
#define KINGYO_CORE_BASE_PANIC_H

/* Must be defined by the program that links the core, and must not return. `condition` and `file`
 * are static strings. */
_Noreturn void core_panic(const char *condition, const char *file, int line);

/* Asserts one condition; also active in release builds. */
#define CORE_ASSERT(condition) ((condition) ? (void)0 : core_panic(#condition, __FILE__, __LINE__))

#endif
