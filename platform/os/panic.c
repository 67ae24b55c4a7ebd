/* panic.c -- calls the panic handler once, then ends the process without exit(). Text is formatted
 * without stdio, because a signal may arrive while a thread holds the stdio lock. */
#include "platform/os/panic.h"

#include <poll.h>
#include <signal.h>
#include <stdatomic.h>
#include <string.h>
#include <unistd.h>

#include "core/base/panic.h"
#include "core/base/printable.h"
#include "platform/os/log.h"

/* Maximum time in milliseconds for which a second panicking thread waits until the first thread has
 * written its report. Writing to a slow card may take seconds. */
#define OTHER_WAIT_MS 5000

typedef void (*panic_function)(void *self, const char *reason);

static const struct {
    int number;
    const char *name;
} fatal[] = { { SIGSEGV, "SIGSEGV" },
              { SIGBUS, "SIGBUS" },
              { SIGFPE, "SIGFPE" },
              { SIGILL, "SIGILL" },
              { SIGABRT, "SIGABRT" } };
#define FATAL_COUNT (sizeof fatal / sizeof fatal[0])

static uint8_t stack[PANIC_STACK_SIZE];
static panic_function panic_handler;
static void *handler_self;
static atomic_int panicking; /* Id of the thread that panicked first. 0 means no panic. */

/* ---- Text ----------------------------------------------------------------------------------- */

void panic_put(struct panic_text *text, const char *words)
{
    CORE_ASSERT(text->used < PANIC_TEXT_MAX);
    while (*words && text->used + 1u < PANIC_TEXT_MAX) {
        text->out[text->used++] = *words++;
    }
    text->out[text->used] = '\0';
}

void panic_put_number(struct panic_text *text, uint32_t number)
{
    char digits[11];
    size_t at = sizeof digits - 1u;
    digits[at] = '\0';
    do {
        digits[--at] = (char)('0' + number % 10u);
        number /= 10u;
    } while (number > 0);
    panic_put(text, digits + at);
}

void panic_put_end(struct panic_text *text)
{
    printable(text->out);
    text->used = strlen(text->out);
    if (text->used + 1u == PANIC_TEXT_MAX) {
        text->used--;
    }
    panic_put(text, "\n");
}

/* ---- Panic handler -------------------------------------------------------------------------- */

/* Reports a panic. Only the first panic is reported. If a second thread panics, it waits while the
 * first thread writes its report. If the panic handler itself panics, the function returns
 * immediately, so that the process ends. */
void panic_report(const char *reason)
{
    int first = 0;
    if (atomic_compare_exchange_strong(&panicking, &first, (int)gettid())) {
        if (panic_handler) {
            panic_handler(handler_self, reason);
        } else {
            struct panic_text text = { 0 };
            panic_put(&text, "panic: ");
            panic_put(&text, reason);
            log_print_raw(LOG_LEVEL_CRITICAL, text.out);
        }
    } else if (first != (int)gettid()) {
        poll(NULL, 0, OTHER_WAIT_MS);
    }
}

static void on_fatal(int number)
{
    const char *name = "signal";
    for (size_t i = 0; i < FATAL_COUNT; i++) {
        name = fatal[i].number == number ? fatal[i].name : name;
    }
    panic_report(name);
    signal(number, SIG_DFL);
    /* The raised signal is delivered when this signal handler returns. The signal then ends the
     * process. */
    raise(number);
}

void panic_prepare(void (*handler)(void *self, const char *reason), void *self)
{
    const stack_t own = { .ss_sp = stack, .ss_size = sizeof stack };
    struct sigaction action = { .sa_handler = on_fatal, .sa_flags = SA_ONSTACK };
    panic_handler = handler;
    handler_self = self;
    sigaltstack(&own, NULL);
    sigemptyset(&action.sa_mask);
    for (size_t i = 0; i < FATAL_COUNT; i++) {
        sigaction(fatal[i].number, &action, NULL);
    }
}
