/* test_water.c -- checks that waves spread, reflect at walls, fade and stay numerically stable. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/base/hash.h"
#include "core/tank/tank_fields.h"
#include "core/tank/water.h"

static struct water water;
static int8_t slope[RIPPLE_Z][RIPPLE_X][2];
static const vec3 tank_m = { 0.85f, 0.12f, 0.55f };

static float highest(void)
{
    float top = 0.0f;
    for (uint32_t row = 0; row < RIPPLE_Z; row++) {
        for (uint32_t column = 0; column < RIPPLE_X; column++) {
            top = fmaxf(top, fabsf(water.height_m[water.newest][row][column]));
        }
    }
    return top;
}

static void steps(uint32_t count, vec3 size_m)
{
    for (uint32_t i = 0; i < count; i++) {
        water_step(&water, size_m);
    }
}

static void test_still_water_stays_still(void **state)
{
    (void)state;
    memset(&water, 0, sizeof water);
    steps(600, tank_m);
    assert_true(highest() == 0.0f);
}

static void test_a_press_lowers_the_middle_and_keeps_the_volume(void **state)
{
    (void)state;
    memset(&water, 0, sizeof water);
    water_press(&water, tank_m, v3(0.0f, 0.0f, 0.0f), 0.05f, 0.004f);
    double volume = 0.0;
    for (uint32_t row = 0; row < RIPPLE_Z; row++) {
        for (uint32_t column = 0; column < RIPPLE_X; column++) {
            volume += (double)water.height_m[water.newest][row][column];
        }
    }
    const float middle = water.height_m[water.newest][RIPPLE_Z / 2][RIPPLE_X / 2];
    assert_true(middle < -0.003f && middle >= -0.004f);
    /* A press on the water must conserve its volume, so the sum over all cells stays near 0. The
     * initial hollow alone would give about -0.1. */
    assert_true(fabs(volume) < 0.002);
}

static void test_a_wave_reflects_at_the_wall_at_the_expected_time(void **state)
{
    (void)state;
    memset(&water, 0, sizeof water);
    water_press(&water, tank_m, v3(0.30f, 0.0f, 0.0f), 0.02f, 0.004f);
    float first_s = 0.0f;
    for (uint32_t i = 1; i <= 120 && first_s == 0.0f; i++) {
        steps(1, tank_m);
        if (fabsf(water.height_m[water.newest][RIPPLE_Z / 2][RIPPLE_X - 1]) > 5e-5f) {
            first_s = (float)i / 60.0f;
        }
    }
    /* At 23 cm/s, a wave needs about half a second for the 12.5 cm to the wall. The time may be
     * shorter, because the pressed area extends toward the wall. */
    assert_true(first_s > 0.3f && first_s < 0.65f);
}

static void test_waves_fade_within_seconds(void **state)
{
    (void)state;
    memset(&water, 0, sizeof water);
    water_press(&water, tank_m, v3(0.1f, 0.0f, 0.1f), 0.04f, 0.006f);
    steps(600, tank_m);
    assert_true(highest() < 1e-4f);
}

static void test_ten_minutes_of_hard_stirring_stay_stable(void **state)
{
    (void)state;
    static const vec3 sizes[] = { { 0.85f, 0.12f, 0.55f },
                                  { 1.36f, 0.2f, 0.65f },
                                  { 0.2f, 0.1f, 0.1f } };
    for (uint32_t s = 0; s < 3; s++) {
        memset(&water, 0, sizeof water);
        for (uint32_t i = 0; i < 12000; i++) {
            const float angle = 0.07f * (float)i;
            const vec3 at =
                v3(0.3f * sizes[s].x * cosf(angle), 0.0f, 0.3f * sizes[s].z * sinf(angle));
            water_press(&water, sizes[s], at, 0.045f, i % 2u ? 0.003f : -0.003f);
            steps(1, sizes[s]);
        }
        assert_true(highest() < 0.08f);
        steps(1200, sizes[s]);
        assert_true(highest() < 1e-4f);
    }
}

static void test_points_outside_the_tank_are_ignored(void **state)
{
    (void)state;
    memset(&water, 0, sizeof water);
    water_press(&water, tank_m, v3(0.5f, 0.0f, 0.0f), 0.2f, 0.01f);
    water_press(&water, tank_m, v3(0.0f, 0.0f, -0.3f), 0.2f, 0.01f);
    assert_true(highest() == 0.0f);
}

static void test_a_press_at_the_wall_stays_inside_the_field(void **state)
{
    (void)state;
    memset(&water, 0, sizeof water);
    water_press(&water, tank_m, v3(0.425f, 0.0f, 0.275f), 0.05f, 0.005f);
    water_press(&water, tank_m, v3(-0.425f, 0.0f, -0.275f), 0.05f, 0.005f);
    assert_true(highest() > 0.003f);
}

static void test_slopes_are_508_times_rise_over_run(void **state)
{
    (void)state;
    memset(&water, 0, sizeof water);
    for (uint32_t row = 0; row < RIPPLE_Z; row++) {
        for (uint32_t column = 0; column < RIPPLE_X; column++) {
            water.height_m[0][row][column] = 0.1f * (float)column * tank_m.x / (float)RIPPLE_X -
                                             0.9f * (float)row * tank_m.z / (float)RIPPLE_Z;
        }
    }
    water_slopes(&water, tank_m, slope);
    assert_in_range(slope[40][60][0], 50, 51);
    assert_int_equal(slope[40][60][1], -127);
}

static void test_a_change_of_one_cell_changes_the_hash(void **state)
{
    (void)state;
    memset(&water, 0, sizeof water);
    const uint64_t still = field_hash(HASH_START, &water_fields, &water);
    water.height_m[1][3][5] = 1e-6f;
    assert_true(field_hash(HASH_START, &water_fields, &water) != still);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_still_water_stays_still),
        cmocka_unit_test(test_a_press_lowers_the_middle_and_keeps_the_volume),
        cmocka_unit_test(test_a_wave_reflects_at_the_wall_at_the_expected_time),
        cmocka_unit_test(test_waves_fade_within_seconds),
        cmocka_unit_test(test_ten_minutes_of_hard_stirring_stay_stable),
        cmocka_unit_test(test_points_outside_the_tank_are_ignored),
        cmocka_unit_test(test_a_press_at_the_wall_stays_inside_the_field),
        cmocka_unit_test(test_slopes_are_508_times_rise_over_run),
        cmocka_unit_test(test_a_change_of_one_cell_changes_the_hash),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
