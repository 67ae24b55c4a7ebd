/* thread.h -- starts threads that leave the handling of signals to the main thread, and lets a
 * thread wait for an event. */
#pragma once

#include <pthread.h>
#include <stdbool.h>
#include <stdint.h>

/* Starts a thread that calls `run` with `self`. The thread blocks all signals except the fatal
 * signals of panic.h, because the main thread handles the signals that end the kiosk. A blocked
 * fatal signal would end the process without a report. The thread has a signal stack of
 * PANIC_STACK_SIZE bytes, so that its stack overflow is reported too. The thread must end by
 * returning from `run`. Returns 0 or the error of pthread_create(). */
int thread_start(pthread_t *thread, void *(*run)(void *self), void *self);

/* Waits until the eventfd `fd` has an event, at most `seconds` seconds. Returns true if there is an
 * event. Does not depend on the civil clock, which may be set back by years. If poll() fails, waits
 * THREAD_RETRY_MS and returns false, so that a loop around this function never runs without a
 * pause. */
bool thread_wait(int fd, uint32_t seconds);

/* Time in ms that thread_wait() waits if poll() fails. */
#define THREAD_RETRY_MS 1000u
