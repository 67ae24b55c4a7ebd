/* test_many_fish.c -- checks the avoidance rules for a pair of fish whose indices are too large for
 * 16 bits. Only the benchmark has so many fish. */
#define TANK_FISH_MAX 131072u

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

/* Compiles avoid.c again with a larger maximum of fish, because the library is compiled with the
 * kiosk's maximum. */
#include "core/tank/behavior/avoid.c"
#include "core/tank/preset.h"

static struct avoid_party swimmer(float z_m, float ahead, uint32_t index)
{
    return (struct avoid_party){ .position_m = { 0.0f, -0.06f, z_m },
                                 .forward = { 0.0f, 0.0f, ahead },
                                 .speed_m_s = 0.05f,
                                 .length_m = 0.05f,
                                 .height_m = 0.018f,
                                 .index = (fish_index)index };
}

/* Returns the side to which both fish of a pair turn: +1 is left, -1 is right. A random number of
 * the pair selects the side. */
static float side_of(uint32_t a, uint32_t b, uint32_t tick)
{
    const struct avoid_party one = swimmer(0.03f, -1.0f, a), other = swimmer(-0.03f, 1.0f, b);
    const struct behavior_params *params = &tank_preset(TANK_PRESET_FESTIVAL)->params;
    const struct avoid_pair pair = avoid_meet(&one, &other, 0.01f, params, 1, tick);
    assert_int_equal(pair.a.kind, MEET_HEAD_ON);
    return pair.a.turn;
}

static void test_pairs_whose_indices_differ_by_65536_draw_independently(void **state)
{
    (void)state;
    uint32_t same = 0;
    for (uint32_t i = 0; i < 1000; i++) {
        same += side_of(i, i + 1u, i) == side_of(i, i + 1u + 65536u, i);
    }
    assert_in_range(same, 440, 560);
}

static void test_the_counter_types_hold_the_number_of_all_fish(void **state)
{
    (void)state;
    assert_true((fish_index)TANK_FISH_MAX == TANK_FISH_MAX);
    assert_true((fish_index)(TANK_FISH_MAX - 1u) == TANK_FISH_MAX - 1u);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_pairs_whose_indices_differ_by_65536_draw_independently),
        cmocka_unit_test(test_the_counter_types_hold_the_number_of_all_fish),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
