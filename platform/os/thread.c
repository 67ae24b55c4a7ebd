/* thread.c -- starts a thread with all signals blocked except the fatal signals, and waits for an
 * event. */
#include "platform/os/thread.h"

#include <assert.h>
#include <poll.h>
#include <signal.h>
#include <stddef.h>

int thread_start(pthread_t *thread, void *(*run)(void *self), void *self)
{
    static const int fatal[] = { SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT };
    sigset_t all, before;
    assert(thread && run);
    sigfillset(&all);
    for (size_t i = 0; i < sizeof fatal / sizeof fatal[0]; i++) {
        sigdelset(&all, fatal[i]);
    }
    pthread_sigmask(SIG_SETMASK, &all, &before);
    const int error = pthread_create(thread, NULL, run, self);
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
