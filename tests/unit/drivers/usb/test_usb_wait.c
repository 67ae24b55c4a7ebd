/* test_usb_wait.c -- tests after which times the USB thread retries and gives up a reserved slot,
 * with a simulated clock. Also tests a failing poll(), and a file of the operator's choices that
 * cannot be read. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdatomic.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include "core/game/phases.h"
#include "drivers/usb/usb_transport.h"
#include "tests/unit/support/usb/usb_fixture.h"

#define NS_PER_S 1000000000ull

static struct usb_fixture fixture;
static struct hid_device_info face;
static atomic_ullong advanced_ns;

static uint64_t advanced_now_ns(void *self)
{
    (void)self;
    return clock_device().ops->now_ns(NULL) + atomic_load(&advanced_ns);
}

static void begin(void)
{
    static const struct hal_clock_ops ops = { .now_ns = advanced_now_ns };
    fixture_start_with(&fixture, (struct hal_clock){ .ops = &ops }, NULL, 0);
}

/* Advances the clock by `seconds`. Then plugs a keyboard in and out, because the USB thread sleeps
 * until an event wakes it up. */
static void advance(uint64_t seconds)
{
    atomic_fetch_add(&advanced_ns, seconds * NS_PER_S);
    usb_sim_unplug(usb_sim_plug(&keyboard, 9), USB_SIM_GONE);
    usleep(150000);
}

static int set_up(void **state)
{
    (void)state;
    atomic_store(&advanced_ns, 0);
    fixture_prepare(&fixture);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    assert_int_equal(fixture_end(&fixture), 0);
    assert_int_equal(usb_sim_breaches(), 0);
    return 0;
}

/* ---- Times between retries ------------------------------------------------------------------ */

static void test_retries_of_a_device_without_a_descriptor_become_less_frequent(void **state)
{
    (void)state;
    static const uint32_t waits_s[] = { 2, 4, 8, 16, 32, 60, 60 };
    usb_sim_set_faults(&(struct usb_sim_faults){ .hides_descriptor = 1 });
    begin();
    const uint32_t poi = usb_sim_plug(&unbound_poi, 1);
    advance(0);
    for (uint32_t i = 0; i < sizeof waits_s / sizeof waits_s[0]; i++) {
        assert_int_equal(usb_sim_seen(poi).opens, i + 1u);
        /* The retry is not due before this time, so the device must not be opened again. */
        advance(waits_s[i] - 1u);
        assert_int_equal(usb_sim_seen(poi).opens, i + 1u);
        advance(2); /* The retry is now due. */
    }
    usb_sim_set_faults(&(struct usb_sim_faults){ 0 });
    advance(60);
    /* The wait is at most 60 s, so the next retry opens the device. */
    assert_true(fixture_open(&fixture, 0, &face));
}

/* The other three slots are in use. Another device could therefore get a slot only if the
 * reservation of the unplugged device has ended. */
static void test_a_slot_is_reserved_for_the_longest_pause_of_a_round(void **state)
{
    (void)state;
    static const struct usb_sim_kind others[] = {
        { .vendor = 0xcafe,
          .product = 1,
          .name = "A",
          .is_bound = 1,
          .interface_count = 1,
          .interface = { OWN_INTERFACE } },
        { .vendor = 0xcafe,
          .product = 2,
          .name = "B",
          .is_bound = 1,
          .interface_count = 1,
          .interface = { OWN_INTERFACE } },
        { .vendor = 0xcafe,
          .product = 3,
          .name = "C",
          .is_bound = 1,
          .interface_count = 1,
          .interface = { OWN_INTERFACE } },
    };
    begin();
    const uint32_t lost = usb_sim_plug(&own_poi, 1);
    assert_true(fixture_open(&fixture, 0, &face));
    for (uint8_t i = 0; i < 3; i++) {
        usb_sim_plug(&others[i], (uint8_t)(i + 2u));
        assert_true(fixture_open(&fixture, i + 1u, &face));
    }
    usb_sim_unplug(lost, USB_SIM_GONE);
    assert_true(fixture_wait_state(&fixture, 0, CONTROLLER_LOST));
    static const struct usb_sim_kind unknown = {
        .vendor = 0xcafe,
        .product = 4,
        .name = "D",
        .is_bound = 1,
        .interface_count = 1,
        .interface = { OWN_INTERFACE },
    };
    const uint32_t waiting = usb_sim_plug(&unknown, 5);
    advance(GAME_WAIT_TICKS_MAX / CORE_TICK_HZ - 5u);
    assert_int_equal(usb_sim_seen(waiting).opens, 0);
    advance(10);
    assert_true(fixture_open(&fixture, 0, &face));
    assert_int_equal(face.identity.product, 4);
}

/* With a limit of 0 open files (RLIMIT_NOFILE), poll() fails. The USB thread must then sleep before
 * each retry, and must still deliver reports. */
static void test_a_failed_wait_pauses_and_reports_still_arrive(void **state)
{
    (void)state;
    struct rlimit before;
    struct hid_raw raw;
    begin();
    const uint32_t poi = usb_sim_plug(&own_poi, 1);
    assert_true(fixture_open(&fixture, 0, &face));
    assert_int_equal(getrlimit(RLIMIT_NOFILE, &before), 0);
    const struct rlimit none = { .rlim_cur = 0, .rlim_max = before.rlim_max };
    assert_int_equal(setrlimit(RLIMIT_NOFILE, &none), 0);
    /* poll() began before the limit was set, so it still succeeds. Report 1 ends this call, and the
     * next call fails. */
    fixture_send(poi, 1);
    const int first = fixture_take(&fixture, 0, &raw);
    const uint32_t calls = usb_sim_calls();
    usleep(500000);
    const uint32_t made = usb_sim_calls() - calls;
    fixture_send(poi, 2);
    const int second = fixture_take(&fixture, 0, &raw);
    assert_int_equal(setrlimit(RLIMIT_NOFILE, &before), 0);
    assert_int_equal(first, 1);
    assert_in_range(made, 1, 100);
    assert_int_equal(second, 1);
    assert_int_equal(fixture_number(&raw), 2);
}

/* ---- File of the operator's choices --------------------------------------------------------- */

static void choose_the_joystick(void)
{
    const struct hid_device_list device_list = usb_transport_list(fixture.thread);
    usb_sim_plug(&joystick, 1);
    assert_true(fixture_wait_state(&fixture, 0, CONTROLLER_FREE));
    assert_int_equal(device_list.ops->choose(device_list.self, 0, true), HAL_OK);
    assert_true(fixture_wait_state(&fixture, 0, CONTROLLER_ACTIVE));
}

/* A symbolic link to itself exists but cannot be opened, even by root. */
static void test_a_file_that_cannot_be_opened_is_reported_and_not_overwritten(void **state)
{
    (void)state;
    char line[HAL_TEXT_SIZE] = "";
    struct stat now;
    assert_int_equal(symlink(fixture.choices, fixture.choices), 0);
    begin();
    assert_non_null(strstr(fixture.why, "usb.txt: is not a regular file"));
    choose_the_joystick();
    assert_int_equal(fixture_message(&fixture, line), 1);
    assert_non_null(strstr(line, "not overwritten; the choice is lost when the kiosk ends"));
    assert_int_equal(lstat(fixture.choices, &now), 0);
    assert_true(S_ISLNK(now.st_mode));
}

static void test_a_partly_unreadable_file_is_reported_and_not_overwritten(void **state)
{
    (void)state;
    char line[HAL_TEXT_SIZE] = "";
    struct stat now;
    /* A folder can be opened but not read. */
    assert_int_equal(mkdir(fixture.choices, 0755), 0);
    begin();
    assert_non_null(strstr(fixture.why, "usb.txt: is not a regular file"));
    choose_the_joystick();
    assert_int_equal(fixture_message(&fixture, line), 1);
    assert_non_null(strstr(line, "not overwritten"));
    assert_int_equal(stat(fixture.choices, &now), 0);
    assert_true(S_ISDIR(now.st_mode));
}

int main(void)
{
#define BENCH(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        BENCH(test_retries_of_a_device_without_a_descriptor_become_less_frequent),
        BENCH(test_a_slot_is_reserved_for_the_longest_pause_of_a_round),
        BENCH(test_a_failed_wait_pauses_and_reports_still_arrive),
        BENCH(test_a_file_that_cannot_be_opened_is_reported_and_not_overwritten),
        BENCH(test_a_partly_unreadable_file_is_reported_and_not_overwritten),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
