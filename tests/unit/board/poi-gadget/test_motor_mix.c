/* test_motor_mix.c -- tests the level of the vibration motor, which is mixed from drag, decaying
 * impacts and the rattle of a tear. Also tests that the motor stops when the host sends no more
 * reports. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "board/poi-gadget/motor.h"

#define DT_S 0.004f

static void test_drag_leaves_room_for_an_impact(void **state)
{
    (void)state;
    struct motor_mix mix = { 0 };
    const struct poi_force drag = { .drag = 1.0f }, blow = { .drag = 1.0f, .slap = 1.0f };
    assert_float_equal(motor_mix_step(&mix, &drag, DT_S).motor, FEEL_DRAG_SHARE, 1e-6f);
    assert_float_equal(motor_mix_step(&mix, &drag, DT_S).light, 0.0f, 0.0f);
    assert_float_equal(motor_mix_step(&mix, &blow, DT_S).motor, 1.0f, 0.0f);
    assert_float_equal(motor_mix_step(&mix, &drag, DT_S).light, 1.0f, 0.1f);
}

static void test_an_impact_decays_with_its_time_constant(void **state)
{
    (void)state;
    struct motor_mix mix = { 0 };
    const struct poi_force slap = { .slap = 0.8f };
    float level = motor_mix_step(&mix, &slap, DT_S).motor;
    assert_float_equal(level, 0.8f, 1e-6f);
    for (uint32_t n = 0; n < 15; n++) {
        const float next = motor_mix_step(&mix, NULL, DT_S).motor;
        assert_true(next < level);
        level = next;
    }
    /* The test has waited for 60 ms, which is the time in which an impact decays to 1/e. */
    assert_float_equal(level, 0.8f * 0.36788f, 1e-3f);
}

static void test_a_tear_gives_a_rattle(void **state)
{
    (void)state;
    struct motor_mix mix = { 0 };
    const struct poi_force tear = { .tear = 1.0f };
    uint32_t turns = 0, on = motor_mix_step(&mix, &tear, DT_S).motor > 0.0f;
    /* 100 steps of 4 ms take 0.4 s. */
    for (uint32_t n = 1; n < 100; n++) {
        const uint32_t now = motor_mix_step(&mix, &tear, DT_S).motor > 0.0f;
        turns += now != on;
        on = now;
    }
    /* The rattle has 25 Hz, so the motor is switched on and off about 20 times in 0.4 s. */
    assert_in_range(turns, 18, 20);
}

static void test_the_motor_stops_after_the_host_timeout(void **state)
{
    (void)state;
    struct motor_mix mix = { 0 };
    const struct poi_force drag = { .drag = 1.0f };
    struct feel_levels levels = motor_mix_step(&mix, &drag, DT_S);
    for (float s = 0.0f; s < 0.2f; s += DT_S) {
        levels = motor_mix_step(&mix, NULL, DT_S);
    }
    assert_float_equal(levels.motor, FEEL_DRAG_SHARE, 1e-3f);
    for (float s = 0.0f; s < 0.1f; s += DT_S) {
        levels = motor_mix_step(&mix, NULL, DT_S);
    }
    assert_float_equal(levels.motor, 0.0f, 1e-3f);
}

static void test_extreme_values_are_clamped_to_the_motor_range(void **state)
{
    (void)state;
    struct motor_mix mix = { 0 };
    const struct poi_force wild = { .drag = 1e30f, .slap = -5.0f, .tear = 1e30f };
    for (uint32_t n = 0; n < 50; n++) {
        const struct feel_levels levels = motor_mix_step(&mix, &wild, DT_S);
        assert_true(levels.motor >= 0.0f && levels.motor <= 1.0f);
        assert_true(levels.light >= 0.0f && levels.light <= 1.0f);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_drag_leaves_room_for_an_impact),
        cmocka_unit_test(test_an_impact_decays_with_its_time_constant),
        cmocka_unit_test(test_a_tear_gives_a_rattle),
        cmocka_unit_test(test_the_motor_stops_after_the_host_timeout),
        cmocka_unit_test(test_extreme_values_are_clamped_to_the_motor_range),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
