/* thread.c -- starts a thread that has its own signal stack and blocks all signals except the fatal
 * signals, and waits for an event. */
#include "platform/os/thread.h"

#include <poll.h>
#include <semaphore.h>
#include <signal.h>
#include <stddef.h>

#include "core/base/panic.h"
#include "platform/os/panic.h"

/* Parameters of a new thread, on the stack of thread_start(). */
struct thread_begin {
    void *(*run)(void *self);
    void *self;
    sem_t is_copied; /* Semaphore that the new thread posts when it has copied the parameters. */
};

/* Start function of each new thread: installs a signal stack and calls the thread's function `run`.
 * The signal stack `memory` is part of the thread's own stack, at the end that an overflow does not
 * reach, so that no table of signal stacks limits the number of threads. The former signal stack is
 * restored at the end, because the address sanitizer unmaps the signal stack of a thread that
 * ends. */
static void *run_with_signal_stack(void *parameters)
{
    struct thread_begin *begin = parameters;
    void *(*const run)(void *self) = begin->run;
    void *const self = begin->self;
    uint8_t memory[PANIC_STACK_SIZE];
    const stack_t own = { .ss_sp = memory, .ss_size = sizeof memory };
    stack_t before;
    sem_post(&begin->is_copied);
    sigaltstack(&own, &before);
    void *const result = run(self);
    sigaltstack(&before, NULL);
    return result;
}

int thread_start(pthread_t *thread, void *(*run)(void *self), void *self)
{
    static const int fatal[] = { SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT };
    struct thread_begin begin = { .run = run, .self = self };
    sigset_t all, before;
    CORE_ASSERT(thread && run);
    sigfillset(&all);
    for (size_t i = 0; i < sizeof fatal / sizeof fatal[0]; i++) {
        sigdelset(&all, fatal[i]);
    }
    sem_init(&begin.is_copied, 0, 0);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    const int error = pthread_create(thread, NULL, run_with_signal_stack, &begin);
    while (!error && sem_wait(&begin.is_copied) != 0) {
        /* The wait is repeated after an interruption by a signal (EINTR), which is the only
         * possible error. */
    }
    sem_destroy(&begin.is_copied);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return error;
}

bool thread_wait(int fd, uint32_t seconds)
{
    struct pollfd event = { .fd = fd, .events = POLLIN };
    const int count = poll(&event, 1, (int)seconds * 1000);
    if (count < 0) {
        poll(NULL, 0, THREAD_RETRY_MS);
    }
    return count > 0;
}
