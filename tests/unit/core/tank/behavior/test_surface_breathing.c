/* test_surface_breathing.c -- checks which fish rise to breathe at the surface, how they gulp
 * there, and how they dive again. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/input.h"
#include "core/tank/behavior/gait.h"
#include "core/tank/behavior/surface_breathing.h"
#include "core/tank/tank.h"
#include "tests/unit/support/pond.h"

static struct tank tank;
static uint32_t now;

static struct tank_config thesis_43(void)
{
    struct tank_config config = tank_config_of(TANK_PRESET_THESIS);
    config.fish_count = 200;
    config.stamina_min = config.stamina_max = 0.20f;
    return config;
}

static struct tank_config config_with(float oxygen_mg_l)
{
    struct tank_config config = tank_config_of(TANK_PRESET_FESTIVAL);
    config.fish_count = 120;
    config.oxygen_mg_l = oxygen_mg_l;
    config.time_compression = 0.0f;
    config.pump = 0;
    return config;
}

static void open(const struct tank_config *config)
{
    assert_true(tank_open(&tank, config));
    now = 0;
}

static void run(float seconds)
{
    const uint32_t end = now + (uint32_t)(seconds * (float)CORE_TICK_HZ);
    for (; now < end; now++) {
        tank_tick(&tank, now, NULL, 0);
    }
}

static float nose_m(const struct fish *fish)
{
    return fish->position_m.y + 0.5f * fish->length_m * f_sin(fish->angles.pitch_rad);
}

static float top_m(const struct fish *fish)
{
    const struct box box = fish_box(fish);
    return fish->position_m.y + box_extent_m(&box).y;
}

/* ---- Rising --------------------------------------------------------------------------------- */

static void test_the_gulping_probability_is_half_at_1_8_mg_l_and_0_in_good_water(void **state)
{
    (void)state;
    assert_float_equal(surface_chance(1.8f, 0.5f), 0.5f, 1e-4f);
    assert_float_equal(surface_chance(1.8f - 0.25f, 0.5f), 0.7311f, 1e-3f);
    assert_float_equal(surface_chance(1.8f + 0.25f, 0.5f), 0.2689f, 1e-3f);
    assert_true(surface_chance(1.0f, 0.5f) > 0.95f);
    assert_true(surface_chance(4.0f, 0.0f) < 1e-3f);
    assert_true(surface_chance(20.0f, 0.0f) >= 0.0f);
}

static void test_a_tired_fish_rises_at_0_2_mg_l_more_oxygen(void **state)
{
    (void)state;
    assert_float_equal(surface_chance(2.0f, 0.0f), 0.5f, 1e-4f);
    assert_float_equal(surface_chance(1.6f, 1.0f), 0.5f, 1e-4f);
}

static uint32_t calls_of_1000(float oxygen_mg_l, const struct behavior_params *params)
{
    uint32_t calls = 0;
    for (uint32_t i = 0; i < 1000; i++) {
        struct perception around = *pond_at(5, i);
        around.params = params;
        around.oxygen_mg_l = oxygen_mg_l;
        const struct fish fish = { WAKIN(0.05f), .stamina = 0.5f };
        calls += (uint32_t)surface_calls(&fish, 3, &around);
    }
    return calls;
}

static void test_oxygen_starts_gulping_except_in_the_thesis_tank(void **state)
{
    (void)state;
    assert_in_range(calls_of_1000(1.8f, pond_params()), 450, 550);
    assert_true(calls_of_1000(0.8f, pond_params()) > 950);
    assert_int_equal(calls_of_1000(8.0f, pond_params()), 0);
    assert_int_equal(calls_of_1000(0.0f, &tank_preset(TANK_PRESET_THESIS)->params), 0);
}

/* Returns the number of fish that gulp at the surface. */
static uint32_t surfacing_count(const struct tank *water)
{
    uint32_t count = 0;
    for (uint32_t i = 0; i < water->fish_count; i++) {
        count += water->fish[i].gait == GAIT_SURFACE;
    }
    return count;
}

/* In the thesis (section 3.6), a fish rises if its stamina is below 25 of 100, which is 0.25 in the
 * code. Other presets have no such rule. */
static void test_low_stamina_starts_gulping_only_in_the_thesis_tank(void **state)
{
    (void)state;
    struct tank_config config = thesis_43();
    config.stamina_min = config.stamina_max = 0.26f;
    open(&config);
    run(2.0f);
    assert_int_equal(surfacing_count(&tank), 0);
    struct tank_config saturated = config_with(TANK_OXYGEN_SATURATED);
    saturated.stamina_min = saturated.stamina_max = 0.05f;
    open(&saturated);
    run(10.0f);
    assert_int_equal(surfacing_count(&tank), 0);
}

/* ---- The thesis' experiment, section 4.3 ---------------------------------------------------- */

static void test_200_fish_of_stamina_20_rise_within_seconds_and_dive_again(void **state)
{
    (void)state;
    const struct tank_config config = thesis_43();
    open(&config);
    const uint32_t at_0 = surfacing_count(&tank);
    run(1.0f);
    const uint32_t at_1 = surfacing_count(&tank);
    run(2.0f);
    const uint32_t at_3 = surfacing_count(&tank);
    run(7.0f);
    const uint32_t at_10 = surfacing_count(&tank);
    print_message("at the surface after 0, 1, 3, 10 s: %u, %u, %u, %u of 200\n", at_0, at_1, at_3,
                  at_10);
    assert_int_equal(at_0, 0);
    assert_true(at_1 >= 10);
    assert_true(at_3 >= 60 && at_3 > 2u * at_1);
    assert_true(at_10 < at_3 / 4u);
}

/* The thesis states that "three seconds of gulping bring stamina to 100, and it dives".  */
static void test_three_seconds_of_gulping_restore_stamina_and_the_fish_dives(void **state)
{
    (void)state;
    struct tank_config config = thesis_43();
    config.stamina_min = config.stamina_max = 0.01f;
    open(&config);
    uint32_t breaths[200] = { 0 }, dived = 0;
    for (; now < 14u * CORE_TICK_HZ; now++) {
        tank_tick(&tank, now, NULL, 0);
        for (uint32_t i = 0; i < tank.fish_count; i++) {
            const struct fish *fish = &tank.fish[i];
            breaths[i] += (uint32_t)surface_breathes(fish);
            if (fish->air == AIR_DIVES && breaths[i] > 0) {
                assert_float_equal((float)breaths[i] / (float)CORE_TICK_HZ, 3.0f, 0.1f);
                assert_true(fish->stamina > 0.98f);
                breaths[i] = 0;
                dived++;
            }
        }
    }
    assert_true(dived >= 190);
    for (uint32_t i = 0; i < tank.fish_count; i++) {
        if (tank.fish[i].air == AIR_ENOUGH) {
            /* A fish with a stamina of at least 0.75 stays at a depth of 18 cm, and other fish stay
             * at most 13 cm deep. A goal below 15 cm therefore proves that gulping has restored the
             * stamina. */
            assert_true(tank.fish[i].depth_goal_m < -0.15f);
        }
    }
}

/* ---- Gulping -------------------------------------------------------------------------------- */

struct watch {
    uint32_t ticks, in_film, steep, emerged;
    float climb_max_m_s, over_max_m;
};

/* Runs the tank for `seconds` seconds, and measures all fish that are at the surface in this
 * time. */
static struct watch watch(float seconds)
{
    struct watch seen = { 0 };
    const uint32_t end = now + (uint32_t)(seconds * (float)CORE_TICK_HZ);
    for (; now < end; now++) {
        tank_tick(&tank, now, NULL, 0);
        for (uint32_t i = 0; i < tank.fish_count; i++) {
            const struct fish *fish = &tank.fish[i];
            seen.climb_max_m_s = f_max(seen.climb_max_m_s, f_abs(fish->climb_m_s));
            if (fish->gait != GAIT_SURFACE) {
                seen.over_max_m = f_max(seen.over_max_m, top_m(fish));
                continue;
            }
            seen.over_max_m = f_max(seen.over_max_m, top_m(fish) - fish->height_m - 0.003f);
            if (fish->air == AIR_GULPS) {
                const float pitch_deg = fish->angles.pitch_rad / F_DEG;
                seen.ticks++;
                seen.in_film += (uint32_t)surface_breathes(fish);
                seen.steep += pitch_deg > 31.0f && pitch_deg < 54.0f;
                seen.emerged += nose_m(fish) > 0.0f && nose_m(fish) < 0.008f;
            }
        }
    }
    return seen;
}

static void test_gulpers_have_their_mouths_at_the_surface_and_their_bodies_below(void **state)
{
    (void)state;
    const struct tank_config config = config_with(1.0f);
    open(&config);
    run(25.0f);
    assert_true(surfacing_count(&tank) > 30);
    const struct watch seen = watch(10.0f);
    const float ticks = (float)seen.ticks;
    print_message("of a gulper's time: mouth in the film %.0f %%, 31 to 54 degrees %.0f %%, nose 0 "
                  "to 8 mm out %.0f %%\n",
                  (double)(100.0f * (float)seen.in_film / ticks),
                  (double)(100.0f * (float)seen.steep / ticks),
                  (double)(100.0f * (float)seen.emerged / ticks));
    assert_true((float)seen.in_film > 0.85f * ticks);
    assert_true((float)seen.steep > 0.85f * ticks);
    assert_true((float)seen.emerged > 0.80f * ticks);
    assert_true(seen.climb_max_m_s < 0.0301f);
    assert_true(seen.over_max_m < 0.0001f);
}

static void test_bad_water_keeps_more_fish_at_the_surface_than_fair_water(void **state)
{
    (void)state;
    static const float oxygens[4] = { 0.8f, 1.6f, 2.2f, 4.0f };
    float share[4];
    for (int i = 0; i < 4; i++) {
        const struct tank_config config = config_with(oxygens[i]);
        open(&config);
        run(20.0f);
        uint32_t count = 0;
        for (int second = 0; second < 30; second++) {
            run(1.0f);
            count += surfacing_count(&tank);
        }
        share[i] = (float)count / (30.0f * 120.0f);
        print_message("%.1f mg/L: %.1f %% at the surface\n", (double)oxygens[i],
                      (double)(100.0f * share[i]));
    }
    assert_true(share[0] > 0.55f);
    assert_true(share[1] > 0.15f && share[1] < share[0]);
    assert_true(share[2] > 0.002f && share[2] < 0.15f);
    assert_float_equal(share[3], 0.0f, 0.0f);
}

static void test_gulpers_come_back_after_a_dive_while_the_water_is_bad(void **state)
{
    (void)state;
    static uint32_t bouts[TANK_FISH_MAX];
    static uint8_t was[TANK_FISH_MAX];
    const struct tank_config config = config_with(1.6f);
    open(&config);
    for (; now < 90u * CORE_TICK_HZ; now++) {
        tank_tick(&tank, now, NULL, 0);
        for (uint32_t i = 0; i < tank.fish_count; i++) {
            bouts[i] += tank.fish[i].gait == GAIT_SURFACE && was[i] != GAIT_SURFACE;
            was[i] = tank.fish[i].gait;
        }
    }
    uint32_t again = 0;
    for (uint32_t i = 0; i < tank.fish_count; i++) {
        again += bouts[i] >= 2;
    }
    print_message("%u of %u came up twice or more in 90 s at 1.6 mg/L\n", again, tank.fish_count);
    assert_true(again > tank.fish_count / 2u);
}

static struct fish gulper(void)
{
    struct fish fish = { WAKIN(0.05f), .stamina = 0.5f, .look = 0x5a5a5a5au };
    fish.gait = GAIT_SURFACE;
    fish.air = AIR_GULPS;
    fish.angles.pitch_rad = 0.75f;
    fish.position_m.y = 0.002f - 0.025f * f_sin(0.75f);
    fish.gait_left_s = 3.0f;
    return fish;
}

static void test_a_gulping_mouth_opens_67_to_95_times_a_minute(void **state)
{
    (void)state;
    for (uint32_t look = 0; look < 32; look++) {
        struct fish fish = gulper();
        fish.look = look << 17;
        uint32_t gulps = 0, opens = 0;
        float before = 0.0f, widest = 0.0f;
        for (uint32_t tick = 0; tick < 60u * CORE_TICK_HZ; tick++) {
            const float gape = surface_gape(&fish, tick);
            gulps += tick % 4u == 0 && surface_gulps(&fish, tick, 4.0f * CORE_TICK_S);
            opens += gape > 0.0f && before == 0.0f;
            widest = f_max(widest, gape);
            before = gape;
        }
        assert_in_range(gulps, 66, 96);
        assert_in_range(opens, gulps - 1u, gulps + 1u);
        assert_true(widest > 0.98f && widest <= 1.0f);
    }
}

static void test_a_mouth_below_the_film_stays_shut(void **state)
{
    (void)state;
    struct fish fish = gulper();
    fish.position_m.y -= 0.006f;
    for (uint32_t tick = 0; tick < 240; tick++) {
        assert_float_equal(surface_gape(&fish, tick), 0.0f, 0.0f);
        assert_false(surface_gulps(&fish, tick, CORE_TICK_S));
    }
}

static void test_gulps_make_ripples(void **state)
{
    (void)state;
    float stirred[2];
    for (int bad = 0; bad < 2; bad++) {
        const struct tank_config config = config_with(bad ? 1.0f : 8.0f);
        open(&config);
        run(12.0f);
        memset(&tank.water, 0, sizeof tank.water);
        run(1.0f);
        stirred[bad] = 0.0f;
        for (uint32_t z = 0; z < RIPPLE_Z; z++) {
            for (uint32_t x = 0; x < RIPPLE_X; x++) {
                stirred[bad] += f_abs(tank.water.height_m[tank.water.newest][z][x]);
            }
        }
    }
    assert_true(stirred[1] > 3.0f * stirred[0]);
}

/* ---- Oxygen and startle --------------------------------------------------------------------- */

/* Returns the oxygen consumption of a fish in mg/h, which oxygen_tick() computes once a second. The
 * array has a second fish, which is on a poi and consumes nothing. */
static float asked_mg_h(const struct fish *fish)
{
    struct oxygen oxygen = { .temperature_c = 25.0f, .pressure_hpa = OXYGEN_PRESSURE_HPA };
    struct fish both[2] = { *fish, { .gait = GAIT_HELD } };
    oxygen_tick(&oxygen, both, 2, v3(0.85f, 0.12f, 0.55f), CORE_TICK_HZ / 2u - 1u);
    return oxygen.breath_mg_h;
}

static void test_a_gulping_fish_takes_no_oxygen_from_the_water(void **state)
{
    (void)state;
    struct fish fish = gulper();
    assert_float_equal(asked_mg_h(&fish), 0.0f, 0.0f);
    fish.position_m.y -= 0.01f;
    assert_float_equal(asked_mg_h(&fish), 0.65f, 0.02f);
    fish.gait = GAIT_BOWL;
    fish.air = AIR_ENOUGH;
    assert_float_equal(asked_mg_h(&fish), 0.0f, 0.0f);
}

static void test_bad_water_lowers_stamina_and_gulping_restores_it(void **state)
{
    (void)state;
    struct perception around = *pond_at(1, 0);
    around.oxygen_mg_l = 1.0f;
    around.dt_s = 1.0f;
    struct fish below = { WAKIN(0.05f), .stamina = 0.5f, .position_m = { 0.0f, -0.06f, 0.0f } };
    surface_tick(&below, 0, &around);
    assert_float_equal(below.stamina, 0.5f - 0.002f * 0.75f, 1e-5f);
    struct fish above = gulper();
    surface_tick(&above, 0, &around);
    assert_float_equal(above.stamina, 0.52f, 1e-5f);
    around.oxygen_mg_l = 5.0f;
    surface_tick(&below, 0, &around);
    assert_float_equal(below.stamina, 0.5f - 0.002f * 0.75f, 1e-5f);
}

static void test_a_startled_gulping_fish_submerges_before_it_escapes(void **state)
{
    (void)state;
    const struct tank_config config = config_with(1.0f);
    open(&config);
    run(20.0f);
    uint32_t gulpers = 0, soon = 0;
    for (uint32_t i = 0; i < tank.fish_count; i++) {
        struct fish *fish = &tank.fish[i];
        if (!surface_breathes(fish) || gulpers == 10u) {
            continue;
        }
        gulpers++;
        uint32_t ticks = 0;
        while (surface_ducks(fish)) {
            assert_int_equal(fish->gait, GAIT_SURFACE);
            assert_int_equal(fish->air, AIR_DUCKS);
            tank_tick(&tank, now++, NULL, 0);
            assert_true(++ticks < CORE_TICK_HZ);
        }
        soon += ticks <= 10u;
        assert_true(top_m(fish) <= 0.0f);
    }
    assert_int_equal(gulpers, 10);
    /* Most of the ten fish must be under water within 10 ticks (83 ms). The reason is that the
     * latency of an escape from a visual stimulus is 60 to 150 ms. */
    assert_true(soon >= 8);
}

static void test_a_gulping_fish_behaves_normally_after_scoop_and_return(void **state)
{
    (void)state;
    struct fish fish = gulper();
    /* Simulates a fish that was in a bowl. Its gait is GAIT_SWIM again, but `air` still has the
     * state of a gulping fish. */
    fish.gait = GAIT_SWIM;
    fish.position_m.y = -0.05f;
    assert_false(surface_breathes(&fish));
    assert_false(surface_tick(&fish, 0, pond_at(1, 0)));
    assert_int_equal(fish.air, AIR_ENOUGH);
}

static void test_a_gulping_fish_has_a_higher_startle_threshold(void **state)
{
    (void)state;
    struct fish fish = gulper();
    assert_true(surface_nerve(&fish) > 1.3f);
    fish.air = AIR_ENOUGH;
    assert_float_equal(surface_nerve(&fish), 1.0f, 0.0f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_gulping_probability_is_half_at_1_8_mg_l_and_0_in_good_water),
        cmocka_unit_test(test_a_tired_fish_rises_at_0_2_mg_l_more_oxygen),
        cmocka_unit_test(test_oxygen_starts_gulping_except_in_the_thesis_tank),
        cmocka_unit_test(test_low_stamina_starts_gulping_only_in_the_thesis_tank),
        cmocka_unit_test(test_200_fish_of_stamina_20_rise_within_seconds_and_dive_again),
        cmocka_unit_test(test_three_seconds_of_gulping_restore_stamina_and_the_fish_dives),
        cmocka_unit_test(test_gulpers_have_their_mouths_at_the_surface_and_their_bodies_below),
        cmocka_unit_test(test_bad_water_keeps_more_fish_at_the_surface_than_fair_water),
        cmocka_unit_test(test_gulpers_come_back_after_a_dive_while_the_water_is_bad),
        cmocka_unit_test(test_a_gulping_mouth_opens_67_to_95_times_a_minute),
        cmocka_unit_test(test_a_mouth_below_the_film_stays_shut),
        cmocka_unit_test(test_gulps_make_ripples),
        cmocka_unit_test(test_a_gulping_fish_takes_no_oxygen_from_the_water),
        cmocka_unit_test(test_bad_water_lowers_stamina_and_gulping_restores_it),
        cmocka_unit_test(test_a_startled_gulping_fish_submerges_before_it_escapes),
        cmocka_unit_test(test_a_gulping_fish_behaves_normally_after_scoop_and_return),
        cmocka_unit_test(test_a_gulping_fish_has_a_higher_startle_threshold),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
