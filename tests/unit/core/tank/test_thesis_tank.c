/* test_thesis_tank.c -- checks whole tanks by sections 3.1, 3.2, 3.3 and 3.6 of the 2013 thesis:
 * the size of the tank, initial states, walls and depths, and the motion of 600 fish. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/tank/behavior/gait.h"
#include "core/tank/collision/contact_solver.h"
#include "tests/unit/support/thesis.h"

#define FISH 600u

static struct tank tank;

static void test_3_1_the_tank_is_136_by_65_cm_with_walls_of_23_and_water_of_20(void **state)
{
    (void)state;
    open_tank(&tank, TANK_PRESET_THESIS, FISH, 1);
    assert_float_equal(tank.size_m.x, 1.36f, 1e-6f);
    /* The water depth of 20 cm is given in section 3.6 of the thesis. */
    assert_float_equal(tank.size_m.y, 0.20f, 1e-6f);
    assert_float_equal(tank.size_m.z, 0.65f, 1e-6f);
    assert_float_equal(tank.wall_height_m, 0.23f, 1e-6f);
    /* The number of fish is given in section 4.1 of the thesis. */
    assert_int_equal(tank_preset(TANK_PRESET_THESIS)->fish_count, FISH);
}

static void test_3_1_every_fish_is_a_box_of_5_by_2_by_1_cm(void **state)
{
    (void)state;
    open_tank(&tank, TANK_PRESET_THESIS, FISH, 1);
    for (uint32_t i = 0; i < FISH; i++) {
        const struct box box = fish_box(&tank.fish[i]);
        assert_float_equal(2.0f * box.half_m.z, 0.05f, 1e-6f);
        assert_float_equal(2.0f * box.half_m.y, 0.02f, 1e-6f);
        assert_float_equal(2.0f * box.half_m.x, 0.01f, 1e-6f);
    }
}

static void test_3_2_initial_stamina_is_uniform_from_30_to_100(void **state)
{
    static float drawn[5u * FISH];
    (void)state;
    for (uint32_t seed = 0; seed < 5; seed++) {
        open_tank(&tank, TANK_PRESET_THESIS, FISH, seed);
        for (uint32_t i = 0; i < FISH; i++) {
            drawn[seed * FISH + i] = 100.0f * tank.fish[i].stamina;
        }
    }
    assert_true(uniform_misfit(drawn, 5u * FISH, 30.0f, 100.0f) < UNIFORM_MISFIT_MAX(5u * FISH));
    /* uniform_misfit() has sorted the values, so the first value is the lowest and the last value
     * is the highest. */
    assert_true(drawn[0] >= 30.0f && drawn[5u * FISH - 1u] < 100.0f);
}

/* The expected shares follow from equations 3.1 to 3.3 with a burst of 2 s, swimming and rest of
 * 12.5 s each, and an initial stamina that is uniform from 30 to 100. */
static void test_3_2_initial_gaits_are_1_1_percent_burst_and_38_percent_swim(void **state)
{
    uint32_t count[GAIT_COUNT] = { 0 };
    const uint32_t seeds = 20, draws = seeds * FISH;
    (void)state;
    for (uint32_t seed = 0; seed < seeds; seed++) {
        open_tank(&tank, TANK_PRESET_THESIS, FISH, seed);
        for (uint32_t i = 0; i < FISH; i++) {
            count[tank.fish[i].gait]++;
        }
    }
    assert_float_equal((float)count[GAIT_BURST] / (float)draws, 0.0110f, 0.003f);
    assert_float_equal((float)count[GAIT_SWIM] / (float)draws, 0.383f, 0.012f);
    assert_int_equal(count[GAIT_BURST] + count[GAIT_SWIM] + count[GAIT_REST], draws);
}

static void test_3_3_initial_headings_are_uniform_from_0_to_360_degrees(void **state)
{
    static float drawn[5u * FISH];
    (void)state;
    for (uint32_t seed = 0; seed < 5; seed++) {
        open_tank(&tank, TANK_PRESET_THESIS, FISH, seed);
        for (uint32_t i = 0; i < FISH; i++) {
            const float yaw_rad = tank.fish[i].angles.yaw_rad;
            drawn[seed * FISH + i] = yaw_rad < 0.0f ? yaw_rad + F_TAU : yaw_rad;
            assert_float_equal(tank.fish[i].angles.pitch_rad, 0.0f, 0.0f);
            /* A fish must start without turning, so the heading that it wants must be its current
             * heading. */
            assert_true(tank.fish[i].heading_rad == yaw_rad);
        }
    }
    assert_true(uniform_misfit(drawn, 5u * FISH, 0.0f, F_TAU) < UNIFORM_MISFIT_MAX(5u * FISH));
}

/* Returns a tank with one fish that swims toward a wall. `off_deg` is the angle between the fish's
 * course and the normal of the wall. */
static struct tank *toward_wall(float off_deg, uint32_t seed)
{
    const struct tank_stage start = {
        .position_m = { 0.0f, -0.13f, -0.20f },
        .angles = { .yaw_rad = off_deg * F_DEG },
        .speed_m_s = 0.05f,
        .stamina = 0.7f,
        .gait = GAIT_SWIM,
    };
    return thesis_stage(&start, 1, seed);
}

/* By section 3.4, a fish reacts to objects within its personal space. This space ends 1 cm ahead of
 * the nose. */
static void test_3_1_a_fish_yaws_away_from_a_wall_when_it_hits_the_wall(void **state)
{
    (void)state;
    for (uint32_t seed = 1; seed <= 10; seed++) {
        struct tank *t = toward_wall(0.0f, seed);
        const struct fish *fish = &t->fish[0];
        uint32_t tick = 0;
        for (; fish->position_m.z > -0.325f + 0.036f; tick++) {
            assert_float_equal(fish->angles.yaw_rad, 0.0f, 1e-4f);
            assert_true(tick < 4u * CORE_TICK_HZ);
            tank_tick(t, tick, NULL, 0);
        }
        for (const uint32_t end = tick + 3u * CORE_TICK_HZ; tick < end; tick++) {
            const struct box box = fish_box(fish);
            assert_true(fish->position_m.z - box_extent_m(&box).z > -0.325f - 1e-5f);
            tank_tick(t, tick, NULL, 0);
        }
        /* The wall is in the direction -z. After the fish has been at the wall for 3 s, it must
         * face away from the wall. */
        assert_true(f_cos(fish->angles.yaw_rad) < 0.0f);
        const float z_m = fish->position_m.z;
        for (const uint32_t end = tick + CORE_TICK_HZ; tick < end; tick++) {
            tank_tick(t, tick, NULL, 0);
        }
        /* One second later, the fish must be farther from the wall. */
        assert_true(fish->position_m.z > z_m);
    }
}

static void test_3_1_a_fish_that_grazes_a_wall_turns_to_the_side_it_came_from(void **state)
{
    (void)state;
    for (int side = -1; side <= 1; side += 2) {
        struct tank *t = toward_wall(60.0f * (float)side, 3);
        for (uint32_t tick = 0; tick < 5u * CORE_TICK_HZ; tick++) {
            tank_tick(t, tick, NULL, 0);
        }
        const float yaw_deg = t->fish[0].angles.yaw_rad / F_DEG * (float)side;
        assert_true(yaw_deg > 90.0f && yaw_deg < 150.0f);
    }
}

/* Checks that a fish swims to the depth that belongs to its stamina (8, 13 or 18 cm), whatever its
 * initial depth and gait are. By section 3.6, a fish changes its depth by pitch while it swims. In
 * the code a resting fish also rises, because a tired fish rests most of its time. */
static void check_depth(float stamina, uint8_t gait, float from_m, float depth_m)
{
    const struct tank_stage start = {
        .position_m = { 0.0f, -from_m, 0.3f }, .stamina = stamina, .speed_m_s = 0.03f, .gait = gait
    };
    struct tank *t = thesis_stage(&start, 1, 9);
    float climb_max_m_s = 0.0f, pitch_max_rad = 0.0f;
    for (uint32_t tick = 0; tick < 18u * CORE_TICK_HZ; tick++) {
        const float y_m = t->fish[0].position_m.y;
        tank_tick(t, tick, NULL, 0);
        const float climb_m_s = f_abs(t->fish[0].position_m.y - y_m) * (float)CORE_TICK_HZ;
        climb_max_m_s = f_max(climb_max_m_s, climb_m_s);
        pitch_max_rad = f_max(pitch_max_rad, f_abs(t->fish[0].angles.pitch_rad));
    }
    assert_float_equal(t->fish[0].position_m.y, -depth_m, 0.005f);
    assert_true(climb_max_m_s <= 0.0301f);
    /* On the way to another depth the fish must pitch, instead of rising or sinking
     * horizontally. */
    assert_true(pitch_max_rad > 5.0f * F_DEG);
}

static void test_3_6_depth_follows_stamina_at_rest_too_and_climbs_at_3_cm_s_at_most(void **state)
{
    (void)state;
    const uint8_t gaits[] = { GAIT_SWIM, GAIT_REST };
    for (uint32_t g = 0; g < 2; g++) {
        check_depth(0.95f, gaits[g], 0.08f, 0.18f);
        check_depth(0.60f, gaits[g], 0.18f, 0.13f);
        check_depth(0.35f, gaits[g], 0.15f, 0.08f);
    }
}

static void test_3_6_the_bands_change_at_75_50_and_25_of_100(void **state)
{
    (void)state;
    const float stamina[] = { 1.00f, 0.75f, 0.749f, 0.50f, 0.499f, 0.25f, 0.249f, 0.0f };
    const float depth_m[] = { 0.18f, 0.18f, 0.13f, 0.13f, 0.08f, 0.08f, 0.03f, 0.03f };
    for (uint32_t i = 0; i < 8; i++) {
        assert_float_equal(gait_depth_m(stamina[i], 0.20f), -depth_m[i], 1e-6f);
        assert_float_equal(gait_depth_m(stamina[i], 0.10f), -0.5f * depth_m[i], 1e-6f);
    }
}

/* The thesis has no startle response, so a fast disc must startle no fish. */
static void test_fish_of_the_thesis_do_not_flee_or_doze_or_turn_at_random(void **state)
{
    (void)state;
    const struct behavior_params *params = thesis_params();
    assert_false(params->escapes || params->glides || params->banks || params->shade_frights);
    assert_float_equal(params->flow_share, 0.0f, 0.0f);
    assert_false(params->air_by_oxygen);
    assert_float_equal(params->kick_rad + params->wall_follow + params->depth_stray, 0.0f, 0.0f);
    assert_float_equal(params->brake_s + params->meet_within_s + params->meet_miss, 0.0f, 0.0f);
    open_tank(&tank, TANK_PRESET_THESIS, 200, 1);
    for (uint32_t tick = 0; tick < 2u * CORE_TICK_HZ; tick++) {
        struct obstacle disc = {
            .kind = OBSTACLE_DISC,
            .centre_m = { -0.5f + 0.5f * (float)tick * CORE_TICK_S, -0.10f, 0.0f },
            .normal = { 1.0f, 0.0f, 0.0f },
            .velocity_m_s = { 0.5f, 0.0f, 0.0f },
            .radius_m = 0.045f,
        };
        tank_tick(&tank, tick, &disc, 1);
        for (uint32_t i = 0; i < 200; i++) {
            assert_int_not_equal(tank.fish[i].gait, GAIT_ESCAPE);
            assert_float_equal(tank.fish[i].angles.roll_rad, 0.0f, 1e-6f);
        }
    }
}

/* By the thesis, a fish in a full tank returns to its depth after it has avoided another fish. At
 * least 3/4 of the fish must therefore be within 2 cm of the depth that belongs to their
 * stamina. */
static void test_3_6_six_hundred_fish_keep_their_depths(void **state)
{
    (void)state;
    uint32_t near = 0, all = 0;
    open_tank(&tank, TANK_PRESET_THESIS, FISH, 3);
    for (uint32_t tick = 0; tick < 30u * CORE_TICK_HZ; tick++) {
        tank_tick(&tank, tick, NULL, 0);
        for (uint32_t i = 0; tick % CORE_TICK_HZ == 0 && tick >= 15u * CORE_TICK_HZ && i < FISH;
             i++) {
            const struct fish *fish = &tank.fish[i];
            near += f_abs(fish->position_m.y - gait_depth_m(fish->stamina, 0.20f)) < 0.02f;
            all++;
        }
    }
    print_message("%.2f of them within 2 cm of the depth of their band\n",
                  (double)near / (double)all);
    assert_true((float)near > 0.75f * (float)all);
}

/* ---- A full tank -------------------------------------------------------------------------- */

struct activity {
    /* Mean speed of the fish with each gait, as a fraction of the mean speed that a single fish
     * has. */
    float pace[GAIT_COUNT];
    /* Number of reversals per second and fish. A reversal is a turn of over 30 degrees per second
     * to one side, followed by such a turn to the other side. */
    float reversals_per_s;
    float yaw_rate_max_rad_s;
    /* Shares of the fish that are within 3/4 of a length of a wall: the measured share, and the
     * share that an even distribution would give. */
    float at_walls, at_walls_if_even;
};

struct bustle_sums {
    float speed[GAIT_COUNT], alone[GAIT_COUNT], walls, fish_ticks;
    uint32_t reversals;
    float last_turn[TANK_FISH_MAX];
};

static void watch(struct bustle_sums *sums, struct activity *activity, uint32_t tick)
{
    struct perception around = { .params = tank_behavior_params(&tank),
                                 .size_m = tank.size_m,
                                 .tick = tick };
    /* Disables the alternation of beats and glides, so that gait_speed_m_s() returns the mean
     * speed. */
    struct behavior_params even = *around.params;
    even.glides = 0;
    around.params = &even;
    for (uint32_t i = 0; i < tank.fish_count; i++) {
        const struct fish *fish = &tank.fish[i];
        const vec3 v = fish->velocity_m_s;
        sums->speed[fish->gait] += f_sqrt(v.x * v.x + v.z * v.z);
        sums->alone[fish->gait] += gait_speed_m_s(fish, &around);
        const float turn = fish->yaw_rate_rad_s;
        activity->yaw_rate_max_rad_s = f_max(activity->yaw_rate_max_rad_s, f_abs(turn));
        if (f_abs(turn) > 30.0f * F_DEG) {
            sums->reversals += sums->last_turn[i] * turn < 0.0f;
            sums->last_turn[i] = turn;
        }
        const float wall_m = f_min(0.5f * tank.size_m.x - f_abs(fish->position_m.x),
                                   0.5f * tank.size_m.z - f_abs(fish->position_m.z));
        sums->walls += wall_m < 0.75f * fish->length_m ? 1.0f : 0.0f;
        sums->fish_ticks += 1.0f;
    }
}

/* Runs a tank for half a minute and measures its last 20 s. */
static struct activity activity_of(uint8_t preset, uint32_t fish_count)
{
    static struct bustle_sums sums;
    struct activity activity = { 0 };
    sums = (struct bustle_sums){ 0 };
    open_tank(&tank, preset, fish_count, 2013);
    for (uint32_t tick = 0; tick < 30u * CORE_TICK_HZ; tick++) {
        tank_tick(&tank, tick, NULL, 0);
        if (tick >= 10u * CORE_TICK_HZ) {
            watch(&sums, &activity, tick);
        }
    }
    for (uint32_t gait = GAIT_REST; gait <= GAIT_BURST; gait++) {
        activity.pace[gait] = sums.speed[gait] / f_max(sums.alone[gait], 1e-6f);
    }
    const float band_m = 1.5f * (preset == TANK_PRESET_OFFICIAL ? 0.04f : 0.05f);
    activity.reversals_per_s = (float)sums.reversals / (20.0f * (float)fish_count);
    activity.at_walls = sums.walls / sums.fish_ticks;
    activity.at_walls_if_even = 1.0f - (tank.size_m.x - band_m) * (tank.size_m.z - band_m) /
                                           (tank.size_m.x * tank.size_m.z);
    print_message("%s, %u fish: swimmers keep %.2f of their pace, bursts %.2f; %.2f reversals a "
                  "fish and second, %.0f degrees/s at most; %.3f at walls (%.3f if even)\n",
                  tank_preset(preset)->name, fish_count, (double)activity.pace[GAIT_SWIM],
                  (double)activity.pace[GAIT_BURST], (double)activity.reversals_per_s,
                  (double)(activity.yaw_rate_max_rad_s / F_DEG), (double)activity.at_walls,
                  (double)activity.at_walls_if_even);
    return activity;
}

static void check_bustle(uint8_t preset, uint32_t fish_count)
{
    const struct activity activity = activity_of(preset, fish_count);
    /* A fish without neighbours has the pace 1. With a pace above 0.5, the fish do not block each
     * other. */
    assert_true(activity.pace[GAIT_SWIM] > 0.5f);
    assert_true(activity.pace[GAIT_BURST] > 0.5f);
    /* With at most one reversal per second, the fish do not tremble. */
    assert_true(activity.reversals_per_s < 1.0f);
    assert_true(activity.yaw_rate_max_rad_s < 721.0f * F_DEG);
    /* The share of fish near the walls must be less than 1.5 times the expected share, because fish
     * must not crowd there. */
    assert_true(activity.at_walls < 1.5f * activity.at_walls_if_even);
}

static void test_4_1_six_hundred_fish_keep_moving_naturally(void **state)
{
    (void)state;
    check_bustle(TANK_PRESET_THESIS, 600);
}

static void test_a_thousand_fish_of_the_championship_keep_moving_naturally(void **state)
{
    (void)state;
    check_bustle(TANK_PRESET_OFFICIAL, 1000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_3_1_the_tank_is_136_by_65_cm_with_walls_of_23_and_water_of_20),
        cmocka_unit_test(test_3_1_every_fish_is_a_box_of_5_by_2_by_1_cm),
        cmocka_unit_test(test_3_2_initial_stamina_is_uniform_from_30_to_100),
        cmocka_unit_test(test_3_2_initial_gaits_are_1_1_percent_burst_and_38_percent_swim),
        cmocka_unit_test(test_3_3_initial_headings_are_uniform_from_0_to_360_degrees),
        cmocka_unit_test(test_3_1_a_fish_yaws_away_from_a_wall_when_it_hits_the_wall),
        cmocka_unit_test(test_3_1_a_fish_that_grazes_a_wall_turns_to_the_side_it_came_from),
        cmocka_unit_test(test_3_6_depth_follows_stamina_at_rest_too_and_climbs_at_3_cm_s_at_most),
        cmocka_unit_test(test_3_6_the_bands_change_at_75_50_and_25_of_100),
        cmocka_unit_test(test_3_6_six_hundred_fish_keep_their_depths),
        cmocka_unit_test(test_fish_of_the_thesis_do_not_flee_or_doze_or_turn_at_random),
        cmocka_unit_test(test_4_1_six_hundred_fish_keep_moving_naturally),
        cmocka_unit_test(test_a_thousand_fish_of_the_championship_keep_moving_naturally),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
