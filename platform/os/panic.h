/* panic.h -- handles a failed assertion of the core (a panic) and fatal signals, and formats text
 * with async-signal-safe functions.
 *
 * core_panic(), SIGSEGV, SIGBUS, SIGFPE, SIGILL and SIGABRT call the panic handler once. Afterwards
 * the signal ends the process. */
#pragma once

#include <stddef.h>
#include <stdint.h>

/* Size in bytes of the separate stack on which a thread handles a fatal signal. core_hash() and the
 * replay writer need less than 4 KiB, but a signal handler of a library may also run on this
 * stack. */
#define PANIC_STACK_SIZE (64u * 1024u)

/* Installs the signal handlers. The calling thread gets a separate signal stack, because its normal
 * stack may have overflowed when a signal arrives. The other threads get their signal stacks from
 * thread_start(), and SDL's audio thread from audio.c. `handler` is the panic handler. It is called
 * with `self` and with the reason, which is "FILE:LINE: assertion failed: CONDITION" or the name of
 * the signal. The panic handler must report the reason and may call async-signal-safe functions
 * only. If `handler` is null, panic_report() writes one line to standard error. */
void panic_prepare(void (*handler)(void *self, const char *reason), void *self);

/* Calls the panic handler that panic_prepare() has installed, or writes one line if there is no
 * panic handler. Only the first panic of a process is reported. Async-signal-safe. */
void panic_report(const char *reason);

/* ---- Text: async-signal-safe ----------------------------------------------------------------- */

#define PANIC_TEXT_MAX 1536u /* Maximum size of a line in bytes. Longer text is cut. */

/* Buffer for one line of text. A structure of zeros is an empty line. */
struct panic_text {
    size_t used;
    char out[PANIC_TEXT_MAX]; /* Text of the line, with a terminating zero. */
};

/* panic_put() appends `words`; panic_put_number() appends `number` in decimal. Text beyond
 * PANIC_TEXT_MAX is dropped. */
void panic_put(struct panic_text *text, const char *words);
void panic_put_number(struct panic_text *text, uint32_t number);

/* Replaces unprintable characters (core/base/printable.h) and appends a line end. The line end is
 * written even if the line is full. */
void panic_put_end(struct panic_text *text);
