/* test_thread.c -- Tests the function with which a thread waits for an event or a timeout, even if
 * poll() fails. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/eventfd.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cmocka.h>

#include "platform/os/clock.h"
#include "platform/os/thread.h"

static uint64_t now_ms(void)
{
    return hal_now_ns(clock_device()) / 1000000u;
}

static void test_an_event_ends_the_wait(void **state)
{
    (void)state;
    const int fd = eventfd(1, EFD_CLOEXEC);
    const uint64_t begin_ms = now_ms();
    assert_true(thread_wait(fd, 60));
    assert_true(now_ms() - begin_ms < 30000);
    close(fd);
}

static void test_the_wait_ends_without_an_event(void **state)
{
    (void)state;
    const int fd = eventfd(0, EFD_CLOEXEC);
    const uint64_t begin_ms = now_ms();
    assert_false(thread_wait(fd, 1));
    assert_true(now_ms() - begin_ms >= 1000);
    close(fd);
}

/* With a limit of 0 open files, poll() fails. The function must nevertheless pause, because its
 * caller calls it in a loop. */
static void test_a_failed_wait_pauses_before_it_returns(void **state)
{
    (void)state;
    const int fd = eventfd(1, EFD_CLOEXEC);
    struct rlimit before;
    assert_int_equal(getrlimit(RLIMIT_NOFILE, &before), 0);
    const struct rlimit none = { .rlim_cur = 0, .rlim_max = before.rlim_max };
    assert_int_equal(setrlimit(RLIMIT_NOFILE, &none), 0);
    const uint64_t begin_ms = now_ms();
    const bool is_event = thread_wait(fd, 60);
    const uint64_t waited_ms = now_ms() - begin_ms;
    assert_int_equal(setrlimit(RLIMIT_NOFILE, &before), 0);
    assert_false(is_event);
    assert_true(waited_ms >= THREAD_RETRY_MS && waited_ms < 30000);
    close(fd);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_an_event_ends_the_wait),
        cmocka_unit_test(test_the_wait_ends_without_an_event),
        cmocka_unit_test(test_a_failed_wait_pauses_before_it_returns),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
