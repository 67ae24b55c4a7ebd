/* test_pulse_train.c -- Tests that an output gives the requested number of pulses and that no pulse
 * or pause is too short. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

#include "drivers/gpio/gpio_thread.h"

#define MS 1000000ull

static const struct pulse_train slow = { .on_ns = 100 * MS, .off_ns = 60 * MS };

static void test_pulses_follow_each_other_with_a_pause_after_each(void **state)
{
    (void)state;
    struct pulse_train train = slow;
    assert_int_equal(gpio_pulses_due_ns(&train), UINT64_MAX);
    assert_false(gpio_pulses_at(&train, 5 * MS));
    gpio_pulses_add(&train, 2);
    assert_true(gpio_pulses_at(&train, 10 * MS));
    assert_int_equal(gpio_pulses_due_ns(&train), 110 * MS);
    assert_true(gpio_pulses_at(&train, 110 * MS - 1));
    assert_false(gpio_pulses_at(&train, 110 * MS));
    assert_false(gpio_pulses_at(&train, 170 * MS - 1));
    assert_true(gpio_pulses_at(&train, 170 * MS));
    assert_false(gpio_pulses_at(&train, 270 * MS));
    assert_int_equal(gpio_pulses_due_ns(&train), UINT64_MAX);
    assert_false(gpio_pulses_at(&train, 900 * MS));
}

static void test_a_pulse_that_is_requested_in_a_pause_starts_after_the_pause(void **state)
{
    (void)state;
    struct pulse_train train = slow;
    gpio_pulses_add(&train, 1);
    gpio_pulses_at(&train, 10 * MS);
    gpio_pulses_at(&train, 110 * MS);
    gpio_pulses_add(&train, 1);
    assert_false(gpio_pulses_at(&train, 169 * MS));
    assert_true(gpio_pulses_at(&train, 170 * MS));
}

static void test_late_updates_make_pulses_longer_and_no_fewer(void **state)
{
    (void)state;
    struct pulse_train train = slow;
    uint32_t begun = 0;
    uint64_t changed_ns = 0, shortest_on_ns = UINT64_MAX, shortest_off_ns = UINT64_MAX;
    bool on = false;
    gpio_pulses_add(&train, 50);
    for (uint64_t now_ns = MS; now_ns < 60000 * MS; now_ns += (1 + now_ns / MS % 97) * MS) {
        const bool is_on = gpio_pulses_at(&train, now_ns);
        if (is_on == on) {
            continue;
        }
        const uint64_t lasted_ns = now_ns - changed_ns;
        uint64_t *shortest_ns = on ? &shortest_on_ns : &shortest_off_ns;
        if (begun > 0 && lasted_ns < *shortest_ns) {
            *shortest_ns = lasted_ns;
        }
        begun += is_on;
        on = is_on;
        changed_ns = now_ns;
    }
    assert_int_equal(begun, 50);
    assert_false(on);
    assert_true(shortest_on_ns >= slow.on_ns);
    assert_true(shortest_off_ns >= slow.off_ns);
}

static void test_the_number_of_pending_pulses_saturates(void **state)
{
    (void)state;
    struct pulse_train train = slow;
    gpio_pulses_add(&train, UINT32_MAX);
    gpio_pulses_add(&train, 5);
    assert_int_equal(train.left, UINT32_MAX);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pulses_follow_each_other_with_a_pause_after_each),
        cmocka_unit_test(test_a_pulse_that_is_requested_in_a_pause_starts_after_the_pause),
        cmocka_unit_test(test_late_updates_make_pulses_longer_and_no_fewer),
        cmocka_unit_test(test_the_number_of_pending_pulses_saturates),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
