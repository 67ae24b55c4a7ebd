/* test_shade_tank.c -- checks the effect of shadows on whole tanks: which fish gather (2013 thesis,
 * figures 4.17 to 4.20), which fish are startled, and which objects of the game cast shadows. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/core.h"
#include "tests/unit/support/open_tank.h"

static struct tank tank;

static struct shade_cast fan_at(float x_m, float z_m)
{
    return (struct shade_cast){ 1, x_m, z_m, 0.10f, SHADE_FAN_DARK };
}

/* ---- Whole tanks ---------------------------------------------------------------------------- */

static void hold_fan(uint32_t *tick, const struct shade_cast *cast, uint32_t seconds)
{
    struct shade_cast casts[TANK_SHADE_MAX] = { [0] = *cast };
    for (uint32_t i = 0; i < seconds * CORE_TICK_HZ; i++) {
        tank_cast(&tank, casts);
        tank_tick(&tank, (*tick)++, NULL, 0);
    }
}

struct gathering {
    uint32_t at_0, at_1, at_6, at_10, at_30;
};

static struct gathering gather(uint32_t seed)
{
    const struct shade_cast fan = fan_at(0.0f, 0.0f);
    struct gathering count = { 0 };
    uint32_t tick = 0;
    open_tank(&tank, TANK_PRESET_THESIS, 200, seed);
    count.at_0 = tank_shade_count(&tank, &fan);
    hold_fan(&tick, &fan, 1);
    count.at_1 = tank_shade_count(&tank, &fan);
    hold_fan(&tick, &fan, 5);
    count.at_6 = tank_shade_count(&tank, &fan);
    hold_fan(&tick, &fan, 4);
    count.at_10 = tank_shade_count(&tank, &fan);
    hold_fan(&tick, &fan, 20);
    count.at_30 = tank_shade_count(&tank, &fan);
    return count;
}

/* Figures 4.17 to 4.20 show that more and more of 200 fish gather under a fan after 1, 6 and 10 s,
 * and stay there. The test adds the counts of several tanks, because single fish change the count
 * of one tank by a few. */
static void test_fish_gather_as_in_figures_4_17_to_4_20(void **state)
{
    (void)state;
    struct gathering all = { 0 };
    for (uint32_t seed = 1; seed <= 5; seed++) {
        const struct gathering one = gather(seed);
        print_message("seed %u: %u, %u, %u, %u, %u in the shade after 0, 1, 6, 10, 30 s\n", seed,
                      one.at_0, one.at_1, one.at_6, one.at_10, one.at_30);
        assert_true(one.at_1 > one.at_0);
        assert_true(2u * one.at_6 >= 3u * one.at_1);
        assert_true(one.at_10 + 3u >= one.at_6);
        assert_true(one.at_30 + 3u >= one.at_10);
        all.at_6 += one.at_6;
        all.at_10 += one.at_10;
    }
    assert_true(all.at_10 * 100u > all.at_6 * 105u);
}

/* In the thesis (section 3.5) a shadow pulls every fish, so it also turns a bursting fish. A
 * bursting fish keeps its speed, because only the speed of swimming fish is limited (section
 * 3.3). */
static void test_a_shade_turns_a_bursting_fish_only_in_the_thesis(void **state)
{
    const uint8_t presets[] = { TANK_PRESET_THESIS, TANK_PRESET_FESTIVAL };
    (void)state;
    for (uint32_t p = 0; p < 2; p++) {
        const struct tank_stage stage = { .position_m = { 0.08f, -0.06f, 0.0f },
                                          .stamina = 1.0f,
                                          .speed_m_s = 0.15f,
                                          .gait = GAIT_BURST };
        const struct shade_cast fan = fan_at(0.0f, 0.0f);
        uint32_t tick = 0;
        open_tank(&tank, presets[p], 1, 3);
        /* Holds the fan still for 3 s, so that its shadow pulls at full strength in every
         * preset. */
        hold_fan(&tick, &fan, 3);
        tank_stage_all(&tank, &stage, 1);
        /* Clears the turn and the push that the fish got from the shadow in these 3 s, before
         * tank_stage_all() placed the fish. */
        tank.fish[0].drawn_rad = tank.fish[0].yaw_rate_rad_s = 0.0f;
        tank.fish[0].push_m_s = v3(0.0f, 0.0f, 0.0f);
        const struct shade_cast casts[TANK_SHADE_MAX] = { [0] = fan };
        for (uint32_t i = 0; i < 3u * CORE_TICK_HZ / 4u; i++, tick++) {
            tank_cast(&tank, casts);
            tank_tick(&tank, tick, NULL, 0);
        }
        /* The fan is on the left of the fish, so a fish that is pulled turns left. */
        const float turned_rad = tank.fish[0].angles.yaw_rad;
        assert_true(presets[p] == TANK_PRESET_THESIS ? turned_rad > 10.0f * F_DEG
                                                     : f_abs(turned_rad) < 1.0f * F_DEG);
        /* The bursting fish must not be limited to 7.5 cm/s, the limit for swimming fish. */
        assert_true(tank.fish[0].speed_goal_m_s > 0.10f);
    }
}

static void test_swimmers_in_a_shade_keep_to_7_5_cm_s(void **state)
{
    const struct shade_cast casts[TANK_SHADE_MAX] = { [0] = fan_at(0.0f, 0.0f) };
    uint32_t drawn = 0;
    (void)state;
    open_tank(&tank, TANK_PRESET_THESIS, 200, 2);
    for (uint32_t tick = 0; tick < 3u * CORE_TICK_HZ; tick++) {
        tank_cast(&tank, casts);
        tank_tick(&tank, tick, NULL, 0);
        for (uint32_t i = 0; i < tank.fish_count; i++) {
            const struct fish *fish = &tank.fish[i];
            if (fish->gait == GAIT_REST || fish->gait == GAIT_SWIM) {
                assert_true(fish->speed_goal_m_s <= 0.0750001f);
                drawn += fish->gait == GAIT_REST && fish->speed_goal_m_s > 0.04f;
            }
        }
    }
    /* Checks that the test is not empty: the shadow must have moved many resting fish, with speed
     * goals above 4 cm/s. */
    assert_true(drawn > 100u);
}

/* Returns how often a fish within `circle` reverses its turn, per second and per fish, from second
 * 6 to second 14. A reversal is a change from a turn to one side to a turn to the other side, both
 * faster than 20 degrees per second. */
static float reversals_per_s(uint32_t fish_count, uint32_t seed, const struct shade_cast *fan,
                             const struct shade_cast *circle, float *within)
{
    static float turning[TANK_FISH_MAX];
    const struct shade_cast casts[TANK_SHADE_MAX] = { [0] = *fan };
    uint32_t reversals = 0, fish_ticks = 0;
    memset(turning, 0, sizeof turning);
    open_tank(&tank, TANK_PRESET_THESIS, fish_count, seed);
    for (uint32_t tick = 0; tick < 14u * CORE_TICK_HZ; tick++) {
        tank_cast(&tank, casts);
        tank_tick(&tank, tick, NULL, 0);
        for (uint32_t i = 0; tick >= 6u * CORE_TICK_HZ && i < tank.fish_count; i++) {
            const float rate = tank.fish[i].yaw_rate_rad_s;
            if (!shade_covers(circle, tank.fish[i].position_m)) {
                continue;
            }
            fish_ticks++;
            if (f_abs(rate) >= 20.0f * F_DEG) {
                reversals += rate * turning[i] < 0.0f;
                turning[i] = rate;
            }
        }
    }
    *within = (float)fish_ticks / (8.0f * (float)CORE_TICK_HZ);
    return (float)(reversals * CORE_TICK_HZ) / (float)fish_ticks;
}

/* Fish under a fan are close together and therefore meet often. They are compared with the fish of
 * a tank that has the same density and no fan. Fish under a fan also turn back at the edge of the
 * shadow every few seconds, so a few more reversals are allowed. */
static void test_gathered_fish_do_not_jitter(void **state)
{
    const struct shade_cast none = { 0 }, fan = fan_at(0.0f, 0.0f);
    float gathered = 0.0f, dense = 0.0f;
    (void)state;
    for (uint32_t seed = 1; seed <= 2; seed++) {
        float within, around;
        gathered += reversals_per_s(600, seed, &fan, &fan, &within) / 2.0f;
        dense += reversals_per_s(1700, seed, &none, &fan, &around) / 2.0f;
        print_message("%.0f fish gathered, %.0f in a tank as dense\n", (double)within,
                      (double)around);
        assert_true(within > 40.0f);
        assert_true(around > 0.8f * within && around < 1.25f * within);
    }
    print_message("%.2f and %.2f reversals a second\n", (double)gathered, (double)dense);
    assert_true(gathered < 2.0f * dense);
}

/* In presets in which fish can be startled, a new shadow must drive fish away, and a resting shadow
 * must attract them. */
static void test_a_new_fan_scatters_fish_and_a_still_one_gathers_them(void **state)
{
    const struct shade_cast fan = fan_at(0.0f, 0.0f);
    const struct shade_cast none = { 0 };
    (void)state;
    for (uint32_t seed = 1; seed <= 3; seed++) {
        uint32_t tick = 0;
        open_tank(&tank, TANK_PRESET_FESTIVAL, 300, seed);
        hold_fan(&tick, &none, 3);
        const uint32_t before = tank_shade_count(&tank, &fan);
        hold_fan(&tick, &fan, 1);
        const uint32_t scattered = tank_shade_count(&tank, &fan);
        hold_fan(&tick, &fan, 1);
        /* Two seconds after the fan appeared, more than half of the fish under it must have
         * fled. */
        assert_true(2u * tank_shade_count(&tank, &fan) < before);
        hold_fan(&tick, &fan, 8);
        const uint32_t gathered = tank_shade_count(&tank, &fan);
        print_message("seed %u: %u before, %u after 1 s, %u after 10 s\n", seed, before, scattered,
                      gathered);
        assert_true(2u * scattered < before);
        assert_true(gathered > before + before / 2u);
    }
}

static uint32_t escaping(void)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < tank.fish_count; i++) {
        count += tank.fish[i].gait == GAIT_ESCAPE;
    }
    return count;
}

/* Measures the time from the appearance of a fan to the C-start, which is the beginning of the
 * escape. A gulping fish takes 1.5 times as long, because it submerges first. */
static void test_fish_react_to_a_new_fan_after_60_to_150_ms(void **state)
{
    const struct shade_cast none = { 0 };
    const struct shade_cast casts[TANK_SHADE_MAX] = { [0] = fan_at(0.0f, 0.0f) };
    uint32_t started[TANK_FISH_MAX], after[32] = { 0 }, starts = 0, soon = 0, late = 0;
    (void)state;
    for (uint32_t seed = 1; seed <= 40; seed++) {
        /* Each fish updates its behavior in every fourth tick. The different start ticks of the
         * loop cover all four phases. */
        uint32_t tick = seed;
        open_tank(&tank, TANK_PRESET_FESTIVAL, 300, seed);
        hold_fan(&tick, &none, 1);
        memset(started, 0, sizeof started);
        for (uint32_t n = 0; n < 32; n++, tick++) {
            tank_cast(&tank, casts);
            tank_tick(&tank, tick, NULL, 0);
            for (uint32_t i = 0; i < tank.fish_count; i++) {
                const struct fish *fish = &tank.fish[i];
                if (fish->gait == GAIT_ESCAPE && !started[i]) {
                    started[i] = 1;
                    after[n]++;
                    starts++;
                }
            }
        }
    }
    for (uint32_t n = 0; n < 32; n++) {
        const float after_s = (float)n * CORE_TICK_S;
        soon += after_s < 0.060f ? after[n] : 0u;
        late += after_s > 0.1501f ? after[n] : 0u;
        if (after[n] > 0) {
            print_message("%3.0f ms: %u\n", (double)(1e3f * after_s), after[n]);
        }
    }
    print_message("%u starts, %u before 60 ms, %u after 150\n", starts, soon, late);
    assert_true(starts > 1000u);
    assert_int_equal(soon, 0);
    /* Only a fish that swims under the fan later may start its escape more than 150 ms after the
     * fan appeared. Fewer than 1 % of the escapes may be so late. */
    assert_true(100u * late < starts);
}

static uint32_t escapes_under(uint8_t preset, float fan_m_s, float dark)
{
    struct shade_cast casts[TANK_SHADE_MAX] = { [0] = fan_at(-0.30f, 0.0f) };
    uint32_t most = 0;
    casts[0].dark = dark;
    open_tank(&tank, preset, 200, 4);
    for (uint32_t tick = 0; tick < 2u * CORE_TICK_HZ; tick++) {
        casts[0].x_m += tick > CORE_TICK_HZ ? fan_m_s * CORE_TICK_S : 0.0f;
        tank_cast(&tank, casts);
        tank_tick(&tank, tick, NULL, 0);
        /* Skips the first second, because the appearance of the fan startles fish. */
        if (tick > CORE_TICK_HZ) {
            const uint32_t now = escaping();
            most = now > most ? now : most;
        }
    }
    return most;
}

static void test_a_moving_fan_startles_more_fish_than_a_poi_in_the_air(void **state)
{
    (void)state;
    const uint32_t swept = escapes_under(TANK_PRESET_FESTIVAL, 0.30f, SHADE_FAN_DARK);
    const uint32_t still = escapes_under(TANK_PRESET_FESTIVAL, 0.0f, SHADE_FAN_DARK);
    const uint32_t paper = escapes_under(TANK_PRESET_FESTIVAL, 0.30f, 0.34f);
    print_message("%u start under a sweeping fan, %u under a still one, %u under paper\n", swept,
                  still, paper);
    assert_true(swept >= 8u);
    assert_true(still <= 2u);
    assert_true(paper <= swept / 4u);
    assert_int_equal(escapes_under(TANK_PRESET_THESIS, 0.30f, SHADE_FAN_DARK), 0);
}

/* ---- Shadows in the whole core -------------------------------------------------------------- */

static struct core core;
static struct output output;

static void open_fixture(void)
{
    const struct core_config config = { .seed = 3, .fish_count = 60 };
    assert_int_equal(core_init(&core, &config), CORE_OK);
}

static void test_the_position_of_a_fan_is_limited_to_the_tank(void **state)
{
    struct input input = { .shade[2] = { 1, 0.1f, -0.2f, 0.12f } };
    (void)state;
    open_fixture();
    core_tick(&core, &input, &output);
    const struct shade_cast *cast = &core.world.tank.shade[2].cast;
    assert_true(cast->present && cast->x_m == 0.1f && cast->z_m == -0.2f);
    assert_true(cast->radius_m == 0.12f && cast->dark == SHADE_FAN_DARK);
    assert_int_equal(core.world.tank.shade[0].cast.present, 0);
    input.shade[2] = (struct shade_input){ 1, 3e38f, -3e38f, 3e38f };
    core_tick(&core, &input, &output);
    assert_true(cast->x_m < 2.0f && cast->z_m > -2.0f && cast->radius_m == SHADE_RADIUS_MAX_M);
    input.shade[2].radius_m = -1.0f;
    core_tick(&core, &input, &output);
    assert_true(cast->radius_m == SHADE_RADIUS_MIN_M);
    /* This fan is absent, so its infinite coordinate must have no effect. */
    input.shade[2] = (struct shade_input){ 0, 1.0f / 0.0f, 0.0f, 0.0f };
    core_tick(&core, &input, &output);
    assert_int_equal(cast->present, 0);
}

static void test_a_nan_fan_fails_an_assertion(void **state)
{
    static const float broken[] = { 1.0f / 0.0f, -1.0f / 0.0f };
    (void)state;
    open_fixture();
    for (size_t i = 0; i < 2; i++) {
        struct input input = { .shade[0] = { 1, broken[i], 0.0f, 0.1f } };
        expect_assert_failure(core_tick(&core, &input, &output));
        input.shade[0] = (struct shade_input){ 1, 0.0f, broken[i], 0.1f };
        expect_assert_failure(core_tick(&core, &input, &output));
        input.shade[0] = (struct shade_input){ 1, 0.0f, 0.0f, broken[i] };
        expect_assert_failure(core_tick(&core, &input, &output));
    }
}

static void test_a_dry_poi_casts_a_shadow_and_a_submerged_poi_casts_none(void **state)
{
    struct poi poi;
    (void)state;
    poi_init(&poi, 6, v3(0.1f, 0.05f, -0.1f), 1);
    const struct shade_cast level = poi_shade(&poi);
    assert_true(level.present && level.x_m == 0.1f && level.z_m == -0.1f);
    assert_float_equal(level.radius_m, POI_OUTER_RADIUS_M, 1e-4f);
    assert_float_equal(level.dark, POI_PAPER_DARK, 1e-4f);
    /* The poi is tilted by 60 degrees, so its shadow is an ellipse of half the area. The core uses
     * a disc of the same area, whose radius is smaller by the factor 0.7071. */
    poi.angles.pitch_rad = 60.0f * F_DEG;
    assert_float_equal(poi_shade(&poi).radius_m, 0.7071f * POI_OUTER_RADIUS_M, 1e-4f);
    poi.immersed = 0.01f;
    assert_int_equal(poi_shade(&poi).present, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_fish_gather_as_in_figures_4_17_to_4_20),
        cmocka_unit_test(test_a_shade_turns_a_bursting_fish_only_in_the_thesis),
        cmocka_unit_test(test_swimmers_in_a_shade_keep_to_7_5_cm_s),
        cmocka_unit_test(test_gathered_fish_do_not_jitter),
        cmocka_unit_test(test_a_new_fan_scatters_fish_and_a_still_one_gathers_them),
        cmocka_unit_test(test_fish_react_to_a_new_fan_after_60_to_150_ms),
        cmocka_unit_test(test_a_moving_fan_startles_more_fish_than_a_poi_in_the_air),
        cmocka_unit_test(test_the_position_of_a_fan_is_limited_to_the_tank),
        cmocka_unit_test(test_a_nan_fan_fails_an_assertion),
        cmocka_unit_test(test_a_dry_poi_casts_a_shadow_and_a_submerged_poi_casts_none),
    };
    cmocka_set_message_output(CM_OUTPUT_TAP);
    return cmocka_run_group_tests(tests, NULL, NULL);
}
