/* test_startle.c -- checks what startles a fish: approaching objects, pressure and shadows. Checks
 * also how a fish gets used to stimuli (habituation), and how long it takes to respond. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "core/input.h"
#include "core/tank/behavior/startle.h"
#include "core/tank/collision/obstacle.h"
#include "tests/unit/support/pond.h"

#define NEVER 1000u

/* Returns a timid fish. Its `look`, which holds the random bits of its individual traits, is 0. */
static struct fish fish_at(vec3 position_m)
{
    return (struct fish){ WAKIN(0.05f), .stamina = 1.0f,   .brake = 1.0f,
                          .room = 1.0f, .gait = GAIT_SWIM, .position_m = position_m };
}

static struct obstacle disc_at(vec3 centre_m, vec3 velocity_m_s)
{
    return (struct obstacle){ .kind = OBSTACLE_DISC,
                              .centre_m = centre_m,
                              .normal = { 0.0f, 1.0f, 0.0f },
                              .velocity_m_s = velocity_m_s,
                              .radius_m = 0.0465f };
}

/* Returns a disc that stands on edge, faces +x and moves toward +x. */
static struct obstacle broadside_disc(float speed_m_s)
{
    struct obstacle disc = disc_at(v3(0.0f, -0.05f, 0.0f), v3(speed_m_s, 0.0f, 0.0f));
    disc.normal = v3(1.0f, 0.0f, 0.0f);
    return disc;
}

static struct perception beside(const struct obstacle *disc, uint32_t seed, uint32_t tick)
{
    struct perception around = *pond_at(seed, tick);
    around.obstacles = disc;
    around.obstacle_count = 1;
    return around;
}

/* Returns the number of ticks after which a fish beside a disc begins to escape (C-start). Neither
 * the fish nor the disc changes its position. */
static uint32_t ticks_to_start(struct obstacle disc, struct fish fish, uint32_t seed)
{
    for (uint32_t tick = 0; tick < NEVER; tick++) {
        const struct perception around = beside(&disc, seed, tick);
        startle_tick(&fish, 0, &around);
        if (fish.gait == GAIT_ESCAPE) {
            return tick;
        }
    }
    return NEVER;
}

static float alarm_per_s(struct obstacle disc, vec3 position_m)
{
    const struct fish fish = fish_at(position_m);
    return startle_of_disc(&disc, &fish).alarm_per_s;
}

static void test_the_visual_angle_follows_geometry_and_grows_with_approach(void **state)
{
    (void)state;
    const struct obstacle disc = broadside_disc(0.3f);
    const struct startle_view view = startle_view(&disc, v3(0.10f, -0.05f, 0.0f));
    assert_float_equal(view.size_rad, 2.0f * f_atan2(0.0465f, 0.10f), 1e-5f);
    struct obstacle later = disc;
    /* Moves the disc by 0.3 mm, which it covers in one millisecond at 0.3 m/s. The growth of its
     * image in this time gives the rate of growth. */
    later.centre_m.x += 0.0003f;
    const struct startle_view grown = startle_view(&later, v3(0.10f, -0.05f, 0.0f));
    assert_float_equal(1000.0f * (grown.size_rad - view.size_rad), view.growth_rad_s, 0.02f);
    assert_true(startle_view(&disc, v3(-0.10f, -0.05f, 0.0f)).growth_rad_s < 0.0f);
}

static void test_an_edge_on_disc_has_a_small_visual_angle(void **state)
{
    (void)state;
    const struct obstacle broad = broadside_disc(0.3f);
    const struct obstacle edge = disc_at(v3(0.0f, -0.05f, 0.0f), v3(0.3f, 0.0f, 0.0f));
    const vec3 eye_m = { 0.10f, -0.05f, 0.0f };
    assert_true(startle_view(&edge, eye_m).size_rad < 0.33f * startle_view(&broad, eye_m).size_rad);
}

static void test_a_small_image_never_looms(void **state)
{
    (void)state;
    struct obstacle disc = broadside_disc(4.0f);
    /* Places the disc in the air, where it causes no pressure. Only its image can then startle the
     * fish. */
    disc.centre_m.y = 0.05f;
    /* This fish sees the disc at an angle of 33 degrees, which is above the threshold of a timid
     * fish (20 degrees). */
    const struct fish near = fish_at(v3(0.14f, -0.01f, 0.0f));
    /* This fish sees the disc at an angle of 17 degrees, which is below the threshold of 20
     * degrees. */
    const struct fish far = fish_at(v3(0.30f, -0.01f, 0.0f));
    assert_int_equal(startle_of_disc(&disc, &near).cause, STARTLE_LOOM);
    assert_int_equal(startle_of_disc(&disc, &far).cause, STARTLE_NONE);
}

/* A disc causes no pressure in the air, and too little pressure at a low speed. */
static void test_a_pressure_stimulus_grows_with_speed_squared_and_is_zero_in_air(void **state)
{
    (void)state;
    /* The disc moves away from this position, so the disc does not grow in the eye of the fish. */
    const vec3 behind = { -0.04f, -0.05f, 0.0f };
    struct obstacle fast = broadside_disc(0.4f);
    assert_int_equal(ticks_to_start(broadside_disc(0.08f), fish_at(behind), 1), NEVER);
    assert_in_range(ticks_to_start(fast, fish_at(behind), 1), 1, CORE_TICK_HZ / 4u);
    assert_true(alarm_per_s(fast, behind) > 4.0f * alarm_per_s(broadside_disc(0.2f), behind));
    fast.centre_m.y = 0.05f;
    assert_float_equal(alarm_per_s(fast, v3(-0.04f, -0.01f, 0.0f)), 0.0f, 0.0f);
}

static void test_a_slow_or_distant_disc_startles_no_fish(void **state)
{
    (void)state;
    const struct obstacle slow = disc_at(v3(0.0f, -0.05f, 0.0f), v3(0.14f, 0.0f, 0.0f));
    const struct obstacle fast = disc_at(v3(0.0f, -0.05f, 0.0f), v3(0.6f, 0.0f, 0.0f));
    assert_int_equal(ticks_to_start(slow, fish_at(v3(0.06f, -0.05f, 0.0f)), 1), NEVER);
    assert_int_equal(ticks_to_start(fast, fish_at(v3(0.14f, -0.05f, 0.0f)), 1), NEVER);
}

static void test_an_approaching_disc_alarms_more_than_a_receding_one(void **state)
{
    (void)state;
    const struct obstacle disc = broadside_disc(0.3f);
    assert_true(alarm_per_s(disc, v3(0.06f, -0.05f, 0.0f)) >
                1.5f * alarm_per_s(disc, v3(-0.06f, -0.05f, 0.0f)));
}

static void test_a_disc_that_glides_edge_on_alarms_little(void **state)
{
    (void)state;
    const struct obstacle broad = broadside_disc(0.4f);
    const struct obstacle edge = disc_at(v3(0.0f, -0.05f, 0.0f), v3(0.4f, 0.0f, 0.0f));
    const struct obstacle slow = disc_at(v3(0.0f, -0.05f, 0.0f), v3(0.2f, 0.0f, 0.0f));
    const vec3 ahead_of_edge = v3(broad.radius_m + 0.03f, -0.05f, 0.0f);
    const float alarm = alarm_per_s(edge, ahead_of_edge);
    assert_true(alarm > 0.0f);
    assert_true(alarm < 0.3f * alarm_per_s(broad, v3(0.03f, -0.05f, 0.0f)));
    assert_int_equal(ticks_to_start(slow, fish_at(ahead_of_edge), 1), NEVER);
}

/* Measures only the latency: the time from the tick in which a stimulus exceeds the threshold to
 * the start of the escape. */
static void latency(enum startle_cause cause, uint8_t gait, float *mean_s, float *least_s,
                    float *most_s)
{
    const uint32_t trials = 2000;
    *mean_s = *most_s = 0.0f;
    *least_s = 1.0f;
    for (uint32_t i = 0; i < trials; i++) {
        struct fish fish = fish_at(v3(0.0f, -0.05f, 0.0f));
        uint32_t ticks = 0;
        fish.gait = gait;
        startle_alarm(&fish, cause, v3(0.05f, -0.05f, 0.0f), 2.0f, i, pond_at(4, 0));
        while (fish.gait != GAIT_ESCAPE) {
            ticks++;
            assert_true(ticks < CORE_TICK_HZ);
            startle_tick(&fish, i, pond_at(4, ticks));
        }
        const float s = (float)ticks * CORE_TICK_S;
        *mean_s += s / (float)trials;
        *least_s = f_min(*least_s, s);
        *most_s = f_max(*most_s, s);
    }
    print_message("latency %.1f ms (%.1f .. %.1f)\n", (double)(1e3f * *mean_s),
                  (double)(1e3f * *least_s), (double)(1e3f * *most_s));
}

static void test_latency_is_8_to_15_ms_for_pressure_and_60_to_150_ms_for_sight(void **state)
{
    (void)state;
    /* An escape starts at a whole tick, so a measured latency may differ by half a tick. */
    const float half_tick_s = 0.5f * CORE_TICK_S + 1e-5f;
    float mean_s, least_s, most_s;
    latency(STARTLE_PRESSURE, GAIT_SWIM, &mean_s, &least_s, &most_s);
    assert_float_equal(mean_s, 0.0115f, 0.0005f);
    assert_true(least_s > 0.008f - half_tick_s && most_s < 0.015f + half_tick_s);
    latency(STARTLE_LOOM, GAIT_SWIM, &mean_s, &least_s, &most_s);
    assert_float_equal(mean_s, 0.105f, 0.002f);
    assert_true(least_s > 0.060f - half_tick_s && least_s < 0.068f);
    assert_true(most_s < 0.150f + half_tick_s && most_s > 0.142f);
    /* With a shadow, this latency begins when the alarm of the fish has reached its threshold. The
     * latency is therefore shorter than the total time of up to 150 ms. */
    latency(STARTLE_SHADOW, GAIT_SWIM, &mean_s, &least_s, &most_s);
    assert_true(least_s >= 0.060f && most_s < 0.115f + half_tick_s);
}

static void test_a_gulping_fish_reacts_later_and_to_stronger_alarms(void **state)
{
    (void)state;
    float mean_s, least_s, most_s;
    latency(STARTLE_LOOM, GAIT_SURFACE, &mean_s, &least_s, &most_s);
    assert_float_equal(mean_s, 1.5f * 0.105f, 0.003f);
    struct fish calm = fish_at(v3(0.0f, -0.05f, 0.0f)), gulping = calm;
    gulping.gait = GAIT_SURFACE;
    gulping.air = AIR_GULPS;
    startle_alarm(&calm, STARTLE_LOOM, v3(0.05f, 0.0f, 0.0f), 0.6f, 0, pond_at(1, 0));
    startle_alarm(&gulping, STARTLE_LOOM, v3(0.05f, 0.0f, 0.0f), 0.6f, 0, pond_at(1, 0));
    assert_int_equal(calm.startle, STARTLE_LOOM);
    assert_int_equal(gulping.startle, STARTLE_NONE);
}

static void test_a_pressure_stimulus_overtakes_a_pending_visual_stimulus(void **state)
{
    (void)state;
    struct fish fish = fish_at(v3(0.0f, -0.05f, 0.0f));
    startle_alarm(&fish, STARTLE_LOOM, v3(0.05f, 0.0f, 0.0f), 2.0f, 0, pond_at(1, 0));
    assert_true(fish.startle_s >= 0.060f);
    startle_alarm(&fish, STARTLE_PRESSURE, v3(0.0f, 0.0f, 0.05f), 2.0f, 0, pond_at(1, 0));
    assert_int_equal(fish.startle, STARTLE_PRESSURE);
    assert_true(fish.startle_s < 0.015f);
    assert_float_equal(fish.startle_from_m.z, 0.05f, 0.0f);
}

static void test_bold_fish_have_twice_the_threshold_and_small_fish_hear_better(void **state)
{
    (void)state;
    struct fish timid = fish_at(v3(0.03f, -0.05f, 0.0f)), bold = timid, small = timid;
    bold.look = 31u << 3;
    fish_grow(&small, 0.033f, pond_params());
    assert_float_equal(startle_threshold(&bold), 2.0f * startle_threshold(&timid), 1e-6f);
    const struct obstacle disc = disc_at(v3(-0.03f, -0.05f, 0.0f), v3(0.5f, 0.0f, 0.0f));
    assert_true(startle_of_disc(&disc, &small).alarm_per_s >
                1.4f * startle_of_disc(&disc, &timid).alarm_per_s);
}

static void test_habituation_grows_with_startles_and_fades(void **state)
{
    (void)state;
    struct fish fish = fish_at(v3(0.0f, -0.05f, 0.0f));
    const float fresh = startle_threshold(&fish);
    for (uint32_t start = 0; start < 4; start++) {
        fish.gait = GAIT_SWIM;
        fish.refractory_s = 0.0f;
        startle_alarm(&fish, STARTLE_PRESSURE, v3(0.05f, 0.0f, 0.0f), 2.0f, 0, pond_at(1, start));
        while (fish.gait != GAIT_ESCAPE) {
            startle_tick(&fish, 0, pond_at(1, start));
        }
    }
    const float stale = startle_threshold(&fish);
    assert_true(stale > 1.5f * fresh && stale < 2.0f * fresh);
    for (uint32_t tick = 0; tick < 180u * CORE_TICK_HZ; tick++) {
        startle_tick(&fish, 0, pond_at(1, tick));
    }
    assert_float_equal(startle_threshold(&fish), fresh, 0.05f * fresh);
    for (uint32_t tick = 0; tick < 600u * CORE_TICK_HZ; tick++) {
        startle_tick(&fish, 0, pond_at(1, tick));
    }
    /* The habituation must have decayed to exactly 0. */
    assert_float_equal(fish.habit, 0.0f, 0.0f);
}

static void test_a_fish_that_just_fled_is_not_startled_again_immediately(void **state)
{
    (void)state;
    struct fish fish = fish_at(v3(0.0f, -0.05f, 0.0f));
    escape_start(&fish, v3(0.05f, 0.0f, 0.0f), 0, pond_at(1, 0));
    fish.gait = GAIT_SWIM;
    startle_alarm(&fish, STARTLE_PRESSURE, v3(0.05f, 0.0f, 0.0f), 2.0f, 0, pond_at(1, 1));
    assert_int_equal(fish.startle, STARTLE_NONE);
    for (uint32_t tick = 0; tick < 2u * CORE_TICK_HZ; tick++) {
        startle_tick(&fish, 0, pond_at(1, tick));
    }
    startle_alarm(&fish, STARTLE_PRESSURE, v3(0.05f, 0.0f, 0.0f), 2.0f, 0, pond_at(1, 300));
    assert_int_equal(fish.startle, STARTLE_PRESSURE);
}

static void test_parameters_without_escapes_never_startle(void **state)
{
    (void)state;
    struct obstacle disc = broadside_disc(1.0f);
    struct fish fish = fish_at(v3(0.03f, -0.05f, 0.0f));
    struct perception around = beside(&disc, 1, 0);
    around.params = &tank_preset(TANK_PRESET_THESIS)->params;
    for (around.tick = 0; around.tick < CORE_TICK_HZ; around.tick++) {
        startle_tick(&fish, 0, &around);
    }
    assert_int_equal(fish.gait, GAIT_SWIM);
    assert_float_equal(fish.alarm, 0.0f, 0.0f);
}

static void test_a_fast_disc_startles_within_a_quarter_of_a_second(void **state)
{
    (void)state;
    for (uint32_t seed = 1; seed <= 50; seed++) {
        const uint32_t ticks =
            ticks_to_start(broadside_disc(0.4f), fish_at(v3(0.03f, -0.05f, 0.0f)), seed);
        assert_in_range(ticks, 1, CORE_TICK_HZ / 4u);
    }
}

static void test_only_startled_fish_and_fish_near_a_moving_disc_update_in_every_tick(void **state)
{
    (void)state;
    const struct obstacle moving = broadside_disc(0.3f), still = broadside_disc(0.0f);
    struct fish fish = fish_at(v3(0.1f, -0.05f, 0.0f)), far = fish_at(v3(0.4f, -0.05f, 0.0f));
    const struct perception by_moving = beside(&moving, 1, 0), by_still = beside(&still, 1, 0);
    assert_true(startle_alert(&fish, &by_moving));
    assert_false(startle_alert(&fish, &by_still));
    assert_false(startle_alert(&far, &by_moving));
    fish.alarm = 0.1f;
    assert_true(startle_alert(&fish, &by_still));
}

static float drawn(uint32_t trial, uint32_t which, float low, float high)
{
    return rng_range((struct rng_key){ 9, trial, which, RNG_TEST }, low, high);
}

static void test_a_fish_alarmed_by_a_disc_updates_in_every_tick(void **state)
{
    (void)state;
    uint32_t frightened = 0;
    for (uint32_t i = 0; i < 20000; i++) {
        struct obstacle disc = disc_at(v3(0.0f, drawn(i, 0, -0.1f, 0.1f), 0.0f),
                                       v3(drawn(i, 1, -0.8f, 0.8f), drawn(i, 2, -0.8f, 0.8f), 0));
        disc.normal = v3_normalize_or(
            v3(drawn(i, 3, -1, 1), drawn(i, 4, -1, 1), drawn(i, 5, -1, 1)), v3(0, 1.0f, 0));
        struct fish fish =
            fish_at(v3(drawn(i, 6, -0.35f, 0.35f), -0.05f, drawn(i, 7, -0.35f, 0.35f)));
        const struct perception around = beside(&disc, 1, 0);
        if (startle_of_disc(&disc, &fish).alarm_per_s > 0.0f) {
            frightened++;
            assert_true(startle_alert(&fish, &around));
        }
    }
    assert_in_range(frightened, 500, 10000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_visual_angle_follows_geometry_and_grows_with_approach),
        cmocka_unit_test(test_an_edge_on_disc_has_a_small_visual_angle),
        cmocka_unit_test(test_a_small_image_never_looms),
        cmocka_unit_test(test_a_pressure_stimulus_grows_with_speed_squared_and_is_zero_in_air),
        cmocka_unit_test(test_a_slow_or_distant_disc_startles_no_fish),
        cmocka_unit_test(test_an_approaching_disc_alarms_more_than_a_receding_one),
        cmocka_unit_test(test_a_disc_that_glides_edge_on_alarms_little),
        cmocka_unit_test(test_latency_is_8_to_15_ms_for_pressure_and_60_to_150_ms_for_sight),
        cmocka_unit_test(test_a_gulping_fish_reacts_later_and_to_stronger_alarms),
        cmocka_unit_test(test_a_pressure_stimulus_overtakes_a_pending_visual_stimulus),
        cmocka_unit_test(test_bold_fish_have_twice_the_threshold_and_small_fish_hear_better),
        cmocka_unit_test(test_habituation_grows_with_startles_and_fades),
        cmocka_unit_test(test_a_fish_that_just_fled_is_not_startled_again_immediately),
        cmocka_unit_test(test_parameters_without_escapes_never_startle),
        cmocka_unit_test(test_a_fast_disc_startles_within_a_quarter_of_a_second),
        cmocka_unit_test(test_a_fish_alarmed_by_a_disc_updates_in_every_tick),
        cmocka_unit_test(test_only_startled_fish_and_fish_near_a_moving_disc_update_in_every_tick),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
