/* panic.h -- handling of a broken invariant of the core.
 *
 * The core asserts on programming errors and returns an error for bad data or a failed device. A
 * failed assertion calls core_panic(). Besides core_panic(), the core's object files leave only
 * memcpy, memmove, memset and memcmp undefined. The kiosk writes its last inputs and stops, a unit
 * test catches the call, and a bare board resets. */
#ifndef KINGYO_CORE_BASE_PANIC_H
#define KINGYO_CORE_BASE_PANIC_H

/* Handles a failed assertion. The program that links the core must define core_panic(), which must
 * not return. `condition` and `file` are static strings. */
_Noreturn void core_panic(const char *condition, const char *file, int line);

/* Calls core_panic() if the condition is 0, also in release builds. */
#define CORE_ASSERT(condition) ((condition) ? (void)0 : core_panic(#condition, __FILE__, __LINE__))

#endif
