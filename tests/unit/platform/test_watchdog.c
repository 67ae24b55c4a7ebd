/* test_watchdog.c -- Tests the messages that the kiosk sends to the watchdog of the service manager
 * (systemd), and their rate. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cmocka.h>

#include "drivers/sim/hal_sim.h"
#include "platform/watchdog.h"

#define MS 1000000ull

/* Opens a socket in place of the service manager's. `name` is an abstract socket name, which begins
 * with "@". */
static int listen_as(const char *name)
{
    struct sockaddr_un address = { .sun_family = AF_UNIX };
    const int fd = socket(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK, 0);
    assert_true(fd >= 0);
    memcpy(address.sun_path + 1, name + 1, strlen(name) - 1);
    const socklen_t size = (socklen_t)(offsetof(struct sockaddr_un, sun_path) + strlen(name));
    assert_int_equal(bind(fd, (const struct sockaddr *)&address, size), 0);
    return fd;
}

static const char *heard(int fd)
{
    static char line[64];
    const ssize_t size = recv(fd, line, sizeof line - 1, 0);
    line[size > 0 ? size : 0] = '\0';
    return line;
}

static void test_ready_is_sent_once_and_kicks_several_times_per_deadline(void **state)
{
    struct clock_sim clock = { .now_ns = 5000 * MS };
    struct watchdog watchdog;
    char name[64];
    (void)state;
    snprintf(name, sizeof name, "@kingyo-test-%d", (int)getpid());
    const int fd = listen_as(name);
    assert_int_equal(watchdog_init(&watchdog, sim_clock_device(&clock), name, 2000000), HAL_OK);
    const struct hal_watchdog device = watchdog_device(&watchdog);
    device.ops->kick(device.self);
    assert_string_equal(heard(fd), "READY=1");
    assert_int_equal(device.ops->watches(device.self), WATCH_OK);
    uint32_t kicks = 0;
    /* Runs frames for ten seconds. The service manager expects a message at least every two
     * seconds, and the kiosk sends one every half second. */
    for (uint32_t i = 0; i < 600; i++) {
        clock.now_ns += 16666667;
        device.ops->kick(device.self);
        kicks += strcmp(heard(fd), "WATCHDOG=1") == 0;
    }
    assert_in_range(kicks, 18, 20);
    close(fd);
    device.ops->kick(device.self); /* Without a service manager, a kick must not cause an error. */
    clock.now_ns += 10000 * MS;
    device.ops->kick(device.self);
    assert_int_equal(device.ops->watches(device.self), WATCH_FAIL);
    assert_true(device.ops->describe(device.self)[0] != '\0');
    close(watchdog.socket_fd);
}

static void test_ready_is_sent_again_if_the_service_manager_was_busy(void **state)
{
    struct clock_sim clock = { .now_ns = 5000 * MS };
    struct watchdog watchdog;
    char name[64];
    (void)state;
    snprintf(name, sizeof name, "@kingyo-busy-%d", (int)getpid());
    const int fd = listen_as(name);
    assert_int_equal(watchdog_init(&watchdog, sim_clock_device(&clock), name, 2000000), HAL_OK);
    const struct hal_watchdog device = watchdog_device(&watchdog);
    /* Fills the queue of the service manager's socket, so that a message cannot be sent. */
    while (send(watchdog.socket_fd, "x", 1, MSG_NOSIGNAL) == 1) {
    }
    device.ops->kick(device.self);
    while (strcmp(heard(fd), "x") == 0) {
    }
    device.ops->kick(device.self);
    assert_string_equal(heard(fd), "READY=1");
    close(fd);
    close(watchdog.socket_fd);
}

static void test_without_a_manager_there_is_no_watchdog(void **state)
{
    static const char *const nobody[] = {
        NULL, "", "x", "relative/path", "@kingyo-nobody-listens", "/nowhere/at/all"
    };
    struct clock_sim clock = { 0 };
    struct watchdog watchdog;
    (void)state;
    for (size_t i = 0; i < sizeof nobody / sizeof nobody[0]; i++) {
        assert_int_equal(watchdog_init(&watchdog, sim_clock_device(&clock), nobody[i], 0),
                         HAL_ERR_ABSENT);
        assert_int_equal(watchdog.socket_fd, -1);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_ready_is_sent_once_and_kicks_several_times_per_deadline),
        cmocka_unit_test(test_ready_is_sent_again_if_the_service_manager_was_busy),
        cmocka_unit_test(test_without_a_manager_there_is_no_watchdog),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
