/* panic.h -- handles a broken invariant of the core and fatal signals.
 *
 * core_panic(), SIGSEGV, SIGBUS, SIGFPE, SIGILL and SIGABRT call the handler of panic_prepare()
 * once. Then the signal ends the process. */
#ifndef KINGYO_PLATFORM_PANIC_H
#define KINGYO_PLATFORM_PANIC_H

#include <signal.h>

/* Installs signal handlers on a separate stack for the calling thread, because its own stack may
 * have overflowed. `last_wish` gets "FILE:LINE: not so: CONDITION" or the signal's name and must
 * report the reason. Only async-signal-safe functions are allowed in `last_wish`. If it is null,
 * one line is written. */
void panic_prepare(void (*last_wish)(void *self, const char *reason), void *self);

/* Calls the handler of panic_prepare(), or writes one line if there is none. Only the first panic
 * of a process is reported. Async-signal-safe. */
void panic_report(const char *reason);

/* Removes the signals of a panic from a set that a thread will block. A blocked signal would end
 * the process without evidence. */
void panic_leave_open(sigset_t *set);

#endif
