/* panic.h -- handles a failed assertion of the core (a panic) and fatal signals.
 *
 * core_panic(), SIGSEGV, SIGBUS, SIGFPE, SIGILL and SIGABRT call the panic handler once. Afterwards
 * the signal ends the process. */
#ifndef KINGYO_PLATFORM_PANIC_H
#define KINGYO_PLATFORM_PANIC_H

#include <signal.h>

/* Installs the signal handlers. The calling thread gets a separate signal stack, because its own
 * stack may have overflowed. `last_wish` is the panic handler, which is called with `self` and the
 * reason: "FILE:LINE: not so: CONDITION" or the signal's name. The handler must report the reason
 * and may call async-signal-safe functions only. If `last_wish` is null, panic_report() writes one
 * line to standard error. */
void panic_prepare(void (*last_wish)(void *self, const char *reason), void *self);

/* Calls the panic handler of panic_prepare(), or writes one line if there is no handler. Only the
 * first panic of a process is reported. Async-signal-safe. */
void panic_report(const char *reason);

/* Removes the fatal signals of panic_prepare() from a set of signals that a thread will block. A
 * blocked fatal signal would end the process without a report. */
void panic_leave_open(sigset_t *set);

#endif
