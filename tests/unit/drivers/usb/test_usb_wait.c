/* test_usb_wait.c -- how long the USB thread waits for whom, by a clock that leaps; and a file of
 * choices that cannot be read. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <stdatomic.h>
#include <sys/stat.h>

#include "core/game/phases.h"
#include "drivers/usb/usb_transport.h"
#include "tests/unit/support/usb_kinds.h"

#define NS_PER_S 1000000000ull

static struct usb_bench bench;
static struct hid_device_info face;
static atomic_ullong leapt_ns;

static uint64_t leaping_ns(void *self)
{
    (void)self;
    return clock_device().ops->now_ns(NULL) + atomic_load(&leapt_ns);
}

static void begin(void)
{
    static const struct hal_clock_ops ops = { .now_ns = leaping_ns };
    bench_start_with(&bench, (struct hal_clock){ .ops = &ops }, NULL, 0);
}

/* Somebody plugs in a keyboard and pulls it out, so that the thread looks up. */
static void leap(uint64_t seconds)
{
    atomic_fetch_add(&leapt_ns, seconds * NS_PER_S);
    stand_unplug(stand_plug(&keyboard, 9), STAND_GONE);
    usleep(150000);
}

static int set_up(void **state)
{
    (void)state;
    atomic_store(&leapt_ns, 0);
    bench_prepare(&bench);
    return 0;
}

static int tear_down(void **state)
{
    (void)state;
    assert_int_equal(bench_end(&bench), 0);
    assert_int_equal(stand_breaches(), 0);
    return 0;
}

/* ---- Waiting -------------------------------------------------------------------------------- */

static void test_one_that_does_not_answer_is_asked_less_and_less_often(void **state)
{
    (void)state;
    static const uint32_t waits_s[] = { 2, 4, 8, 16, 32, 60, 60 };
    stand_set_faults(&(struct stand_faults){ .hides_descriptor = 1 });
    begin();
    const uint32_t poi = stand_plug(&bench_poi, 1);
    leap(0);
    for (uint32_t i = 0; i < sizeof waits_s / sizeof waits_s[0]; i++) {
        assert_int_equal(stand_seen(poi).opens, i + 1u);
        leap(waits_s[i] - 2u + (waits_s[i] > 2u)); /* A second before its time ... */
        assert_int_equal(stand_seen(poi).opens, i + 1u);
        leap(2); /* ... and one after it. */
    }
    stand_set_faults(&(struct stand_faults){ 0 });
    leap(60);
    assert_true(bench_open(&bench, 0, &face)); /* It was never given up. */
}

/* Four sat here, so that a stranger has no seat but that of who was pulled out. */
static void test_a_seat_is_kept_for_as_long_as_a_round_may_wait(void **state)
{
    (void)state;
    static const struct stand_kind others[] = {
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
    const uint32_t lost = stand_plug(&own_poi, 1);
    assert_true(bench_open(&bench, 0, &face));
    for (uint8_t i = 0; i < 3; i++) {
        stand_plug(&others[i], (uint8_t)(i + 2u));
        assert_true(bench_open(&bench, i + 1u, &face));
    }
    stand_unplug(lost, STAND_GONE);
    assert_true(bench_until(&bench, 0, CONTROLLER_LOST));
    static const struct stand_kind stranger = {
        .vendor = 0xcafe,
        .product = 4,
        .name = "D",
        .is_bound = 1,
        .interface_count = 1,
        .interface = { OWN_INTERFACE },
    };
    const uint32_t waiting = stand_plug(&stranger, 5);
    leap(GAME_WAIT_TICKS_MAX / CORE_TICK_HZ - 5u);
    assert_int_equal(stand_seen(waiting).opens, 0);
    leap(10);
    assert_true(bench_open(&bench, 0, &face));
    assert_int_equal(face.identity.product, 4);
}

/* ---- The file ------------------------------------------------------------------------------- */

static void choose_the_joystick(void)
{
    const struct hid_device_list device_list = usb_transport_roster(bench.seats);
    stand_plug(&joystick, 1);
    assert_true(bench_until(&bench, 0, CONTROLLER_FREE));
    assert_int_equal(device_list.ops->choose(device_list.self, 0), HAL_OK);
    assert_true(bench_until(&bench, 0, CONTROLLER_ACTIVE));
}

/* A name that leads to itself: neither absent nor to be opened, whoever asks. */
static void test_a_file_that_cannot_be_opened_is_told_and_not_written_over(void **state)
{
    (void)state;
    char line[HAL_TEXT_SIZE] = "";
    struct stat now;
    assert_int_equal(symlink(bench.choices, bench.choices), 0);
    begin();
    assert_non_null(strstr(bench.why, "usb.txt: is not a regular file"));
    choose_the_joystick();
    assert_int_equal(bench_told(&bench, line), 1);
    assert_non_null(strstr(line, "not written over; the choice holds for today"));
    assert_int_equal(lstat(bench.choices, &now), 0);
    assert_true(S_ISLNK(now.st_mode));
}

static void test_a_file_that_cannot_be_read_to_its_end_is_told_and_not_written_over(void **state)
{
    (void)state;
    char line[HAL_TEXT_SIZE] = "";
    struct stat now;
    assert_int_equal(mkdir(bench.choices, 0755), 0); /* It opens, and then does not read. */
    begin();
    assert_non_null(strstr(bench.why, "usb.txt: is not a regular file"));
    choose_the_joystick();
    assert_int_equal(bench_told(&bench, line), 1);
    assert_non_null(strstr(line, "not written over"));
    assert_int_equal(stat(bench.choices, &now), 0);
    assert_true(S_ISDIR(now.st_mode));
}

int main(void)
{
#define BENCH(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        BENCH(test_one_that_does_not_answer_is_asked_less_and_less_often),
        BENCH(test_a_seat_is_kept_for_as_long_as_a_round_may_wait),
        BENCH(test_a_file_that_cannot_be_opened_is_told_and_not_written_over),
        BENCH(test_a_file_that_cannot_be_read_to_its_end_is_told_and_not_written_over),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
