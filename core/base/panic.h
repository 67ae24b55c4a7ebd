/* panic.h -- assertions of the core.
 *
 * The core asserts on programming errors, and returns an error for bad data or a failed device. A
 * failed assertion calls core_panic(), which the program defines: the kiosk writes its last inputs
 * and stops, a unit test catches the call, and a bare board resets.
 *
 * The core calls only five external functions: core_panic(), memcpy(), memmove(), memset() and
 * memcmp(). */
#pragma once

/* Handles a failed assertion. The program that links the core must define core_panic(), which must
 * not return. `condition` and `file` are static strings. */
_Noreturn void core_panic(const char *condition, const char *file, int line);

/* Calls core_panic() if the condition is false, also in release builds. Only the command `make
 * bench-assertions` defines CORE_WITHOUT_ASSERTIONS, to measure what the assertions cost. */
#ifdef CORE_WITHOUT_ASSERTIONS
#define CORE_ASSERT(condition) ((void)sizeof(condition))
#else
#define CORE_ASSERT(condition) ((condition) ? (void)0 : core_panic(#condition, __FILE__, __LINE__))
#endif
