/* test_startled_tank.c -- startles all fish of a tank at the same time. No fish may overlap another
 * fish, and all fish must escape. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/input.h"
#include "core/tank/behavior/startle.h"
#include "tests/unit/support/open_tank.h"

static struct tank tank;
static vec3 start_m[TANK_FISH_MAX];

static float deepest_m(uint32_t *over_half_mm)
{
    float deepest = 0.0f;
    for (uint32_t i = 0; i < tank.fish_count; i++) {
        const struct box a = fish_box(&tank.fish[i]);
        for (uint32_t j = 0; j < i; j++) {
            const vec3 off = v3_sub(tank.fish[i].position_m, tank.fish[j].position_m);
            const float reach_m = 0.6f * (tank.fish[i].length_m + tank.fish[j].length_m);
            if (v3_dot(off, off) < reach_m * reach_m) {
                const struct box b = fish_box(&tank.fish[j]);
                const float depth_m = box_depth_m(&a, &b);
                deepest = f_max(deepest, depth_m);
                *over_half_mm += depth_m > 0.0005f;
            }
        }
    }
    return deepest;
}

/* Startles all fish in one tick, as if a pressure wave came from the middle of the tank. */
static void startle_all(void)
{
    for (uint32_t i = 0; i < tank.fish_count; i++) {
        tank.fish[i].startle = STARTLE_PRESSURE;
        tank.fish[i].startle_s = 0.010f;
        tank.fish[i].startle_from_m = v3(0.0f, -0.05f, 0.0f);
        start_m[i] = tank.fish[i].position_m;
    }
}

/* Returns the mean distance of all fish from their start positions, in body lengths. */
static float mean_way_lengths(void)
{
    float sum = 0.0f;
    for (uint32_t i = 0; i < tank.fish_count; i++) {
        const vec3 way_m = v3_sub(tank.fish[i].position_m, start_m[i]);
        sum += v3_length(way_m) / tank.fish[i].length_m;
    }
    return sum / (float)tank.fish_count;
}

static uint32_t escaping(void)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < tank.fish_count; i++) {
        count += tank.fish[i].gait == GAIT_ESCAPE;
    }
    return count;
}

static void check_panic(uint8_t preset, uint32_t fish_count, uint32_t seed, float way_min)
{
    uint32_t over = 0, start = 0;
    float deepest = 0.0f, way = 0.0f;
    open_tank(&tank, preset, fish_count, seed);
    for (uint32_t tick = 0; tick < 3u * CORE_TICK_HZ; tick++) {
        tank_tick(&tank, tick, NULL, 0);
    }
    startle_all();
    for (uint32_t tick = 0; tick < CORE_TICK_HZ; tick++) {
        tank_tick(&tank, 3u * CORE_TICK_HZ + tick, NULL, 0);
        deepest = f_max(deepest, deepest_m(&over));
        start = tick == 10u ? escaping() : start;
        /* Tick 13 is 12 ticks (100 ms) after the escape began in tick 1. */
        way = tick == 13u ? mean_way_lengths() : way;
    }
    print_message("%u fish, %u start: deepest %.2f mm, %u pair-ticks over 0.5 mm, %.2f lengths "
                  "away after 100 ms\n",
                  fish_count, start, (double)(1e3f * deepest), over, (double)way);
    assert_true(start > fish_count * 9u / 10u);
    assert_int_equal(over, 0);
    assert_true(way > way_min);
}

static void test_startled_fish_of_the_festival_do_not_overlap(void **state)
{
    (void)state;
    check_panic(TANK_PRESET_FESTIVAL, 300, 1, 0.3f);
    check_panic(TANK_PRESET_FESTIVAL, 500, 2, 0.2f);
}

static void test_startled_fish_of_the_championship_do_not_overlap(void **state)
{
    (void)state;
    check_panic(TANK_PRESET_OFFICIAL, 1000, 3, 0.2f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_startled_fish_of_the_festival_do_not_overlap),
        cmocka_unit_test(test_startled_fish_of_the_championship_do_not_overlap),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
