/* panic.h -- what the programs do at a broken invariant of the core and at a fatal signal.
 *
 * core_panic(), SIGSEGV, SIGBUS, SIGFPE, SIGILL and SIGABRT call the function that panic_prepare()
 * was given, once, and then end the process by the signal. */
#ifndef KINGYO_PLATFORM_PANIC_H
#define KINGYO_PLATFORM_PANIC_H

#include <signal.h>

/* Handles the signals on a stack of their own for the calling thread, since its own may have
 * overflowed. `last_wish` gets "FILE:LINE: not so: CONDITION" or the signal's name, may use
 * async-signal-safe functions alone, and reports the reason. Without it one line is written. */
void panic_prepare(void (*last_wish)(void *self, const char *reason), void *self);

/* Calls the last wish, or writes a line where there is none. Only the first panic of a process is
 * told. Async-signal-safe. */
void panic_tell(const char *reason);

/* Takes the signals of a panic out of a set that a thread will block: a blocked one would end the
 * process without evidence. */
void panic_leave_open(sigset_t *set);

#endif
