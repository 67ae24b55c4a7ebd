/* test_thesis_pass.c -- checks how simulated fish pass each other by section 3.4 of the 2013
 * thesis. The tests cover the distance at which the fish react, and the encounters of figures 4.1
 * to 4.12. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "tests/unit/support/thesis.h"

#define SEEDS 60u

static struct tank_stage swimmer(float x_cm, float y_cm, float z_cm, float yaw_deg)
{
    return (struct tank_stage){
        /* With a stamina of 0.60, a fish stays at a depth of 13 cm, at which most of these tests
         * place it. */
        .position_m = { 0.01f * x_cm, 0.01f * y_cm, 0.01f * z_cm },
        .angles = { .yaw_rad = yaw_deg * F_DEG },
        .speed_m_s = 0.0525f * 0.92f,
        .stamina = 0.60f,
        .gait = GAIT_SWIM,
    };
}

/* Returns the distance between the centres of the two fish when the first of them reacts, or 0 if
 * no fish reacts. */
static float reacts_at_m(const struct tank_stage stage[2])
{
    struct tank *tank = thesis_stage(stage, 2, 4);
    for (uint32_t tick = 0; tick < 3u * CORE_TICK_HZ; tick++) {
        const vec3 apart = v3_sub(tank->fish[0].position_m, tank->fish[1].position_m);
        tank_tick(tank, tick, NULL, 0);
        if (tank->fish[0].avoiding != AVOID_NONE || tank->fish[1].avoiding != AVOID_NONE) {
            return v3_length(apart);
        }
    }
    return 0.0f;
}

/* Returns the distance at which two fish that swim toward each other react. One fish is shifted by
 * `aside_cm` and `above_cm`. A fish that is 5 cm higher gets the stamina that belongs to its
 * depth. */
static float meets_head_on_m(float aside_cm, float above_cm)
{
    struct tank_stage stage[] = { swimmer(0.0f, -13.0f, 5.0f, 0.0f),
                                  swimmer(aside_cm, -13.0f + above_cm, -5.0f, 180.0f) };
    stage[1].stamina = above_cm > 4.0f ? 0.40f : 0.60f;
    return reacts_at_m(stage);
}

/* Fish must react when their personal spaces (boxes) touch, which is at a gap of 2 cm between the
 * bodies. The text of section 3.4 would also allow a reaction when a space touches a body, at half
 * of this gap. */
static void test_3_4_personal_spaces_of_7_by_4_by_3_cm_meet_box_against_box(void **state)
{
    (void)state;
    assert_float_equal(meets_head_on_m(0.0f, 0.0f), 0.07f, 0.004f);
    assert_float_equal(meets_head_on_m(2.8f, 0.0f), 0.0754f, 0.004f);
    assert_float_equal(meets_head_on_m(3.2f, 0.0f), 0.0f, 0.0f);
    assert_true(meets_head_on_m(0.0f, 3.8f) > 0.07f);
    assert_float_equal(meets_head_on_m(0.0f, 5.0f), 0.0f, 0.0f);
}

static void test_3_4_personal_space_never_shrinks_in_the_thesis(void **state)
{
    (void)state;
    static struct tank tank;
    const uint32_t counts[] = { 50, 600, 1500, 2000 };
    for (uint32_t i = 0; i < 4; i++) {
        open_tank(&tank, TANK_PRESET_THESIS, counts[i], 1);
        assert_float_equal(0.05f * tank.space, 0.01f, 1e-7f);
    }
    /* In the championship's tank, 1,000 personal spaces of 7 x 4 x 3 cm would fill 95 % of the
     * water. The spaces of this tank must therefore be smaller. */
    open_tank(&tank, TANK_PRESET_OFFICIAL, 1000, 1);
    assert_true(tank.space < 0.19f && tank.space > 0.15f);
    open_tank(&tank, TANK_PRESET_OFFICIAL, 2000, 1);
    assert_true(tank.space < 0.15f && tank.space > 0.04f);
}

/* Places fish 1 ahead of fish 0, and fish 2 at the side of fish 0. Returns the fish that fish 0
 * avoids, which must be the fish that it would touch first. */
static fish_index gives_way_to(float ahead_gap_cm, float aside_gap_cm)
{
    const struct tank_stage stage[] = {
        swimmer(0.0f, -13.0f, 0.0f, 0.0f),
        swimmer(0.0f, -13.0f, -5.0f - ahead_gap_cm, 180.0f),
        swimmer(3.0f + aside_gap_cm, -13.0f, 0.0f, 90.0f),
    };
    struct tank *tank = thesis_stage(stage, 3, 2);
    for (uint32_t tick = 0; tank->fish[0].avoiding == AVOID_NONE && tick < 8; tick++) {
        tank_tick(tank, tick, NULL, 0);
    }
    assert_int_equal(tank->fish[0].avoiding, AVOID_YAW);
    return tank->fish[0].avoid_with;
}

static void test_3_4_a_fish_reacts_to_the_soonest_of_several_meetings(void **state)
{
    (void)state;
    assert_int_equal(gives_way_to(0.6f, 1.6f), 1);
    assert_int_equal(gives_way_to(1.6f, 0.4f), 2);
}

static void test_3_4_repulsion_separates_resting_fish(void **state)
{
    (void)state;
    struct tank_stage stage[] = { swimmer(0.0f, -13.0f, 0.0f, 0.0f),
                                  swimmer(1.2f, -13.0f, 0.0f, 0.0f) };
    stage[0].gait = stage[1].gait = GAIT_REST;
    stage[0].speed_m_s = stage[1].speed_m_s = 0.0f;
    struct tank *tank = thesis_stage(stage, 2, 2);
    float pushed_m_s = 0.0f;
    for (uint32_t tick = 0; tick < 5u * CORE_TICK_HZ; tick++) {
        tank_tick(tank, tick, NULL, 0);
        for (uint32_t i = 0; i < 2; i++) {
            /* The fish do not approach each other, so they must not avoid each other. Only the
             * repulsion separates them. */
            assert_int_equal(tank->fish[i].avoiding, AVOID_NONE);
            pushed_m_s = f_max(pushed_m_s, v3_length(tank->fish[i].push_m_s));
        }
    }
    const float apart_m = tank->fish[1].position_m.x - tank->fish[0].position_m.x;
    assert_true(apart_m > 0.017f && apart_m < 0.03f);
    assert_true(pushed_m_s > 0.005f && pushed_m_s < 0.0225f);
}

/* ---- Figures 4.1 to 4.12 ------------------------------------------------------------------ */

struct encounter {
    /* Ticks in which the avoidance started and ended; 0 if the fish did not react. */
    uint32_t start_tick, done_tick;
    /* Angles by which the two fish have turned since the start. */
    float turned_rad[2];
    /* Smallest gap between the fish, and deepest overlap. */
    float gap_m, depth_m;
    /* Distance between the centres at the end, and one second before the end. */
    float apart_m, before_m;
    uint8_t pitched, still_avoiding;
};

static float middles_m(const struct tank *tank)
{
    return v3_length(v3_sub(tank->fish[0].position_m, tank->fish[1].position_m));
}

static struct encounter play(const struct tank_stage stage[2], uint32_t seed)
{
    struct tank *tank = thesis_stage(stage, 2, seed);
    struct encounter e = { .gap_m = 1.0f };
    for (uint32_t tick = 1; tick <= 5u * CORE_TICK_HZ; tick++) {
        e.before_m = tick == 4u * CORE_TICK_HZ ? middles_m(tank) : e.before_m;
        tank_tick(tank, tick, NULL, 0);
        const struct box a = fish_box(&tank->fish[0]), b = fish_box(&tank->fish[1]);
        e.gap_m = f_min(e.gap_m, box_gap(&a, 0.5f, &b, 0.5f).body_m);
        e.depth_m = f_max(e.depth_m, box_depth_m(&a, &b));
        e.still_avoiding = 0;
        for (uint32_t i = 0; i < 2; i++) {
            e.still_avoiding |= tank->fish[i].avoiding;
            e.pitched |= tank->fish[i].avoiding == AVOID_PITCH;
            e.turned_rad[i] = f_wrap_angle(tank->fish[i].angles.yaw_rad - stage[i].angles.yaw_rad);
        }
        if (e.still_avoiding) {
            e.start_tick = e.start_tick ? e.start_tick : tick;
            e.done_tick = tick;
        }
    }
    e.apart_m = middles_m(tank);
    return e;
}

/* Checks the course of an encounter. The avoidance must start and end within three seconds.
 * Afterwards the fish must separate or swim side by side. */
static void check_phases(const struct encounter *e)
{
    assert_true(e->start_tick > 0);
    assert_in_range(e->done_tick - e->start_tick, CORE_TICK_HZ / 12u, 3u * CORE_TICK_HZ);
    assert_int_equal(e->still_avoiding, 0);
    assert_true(e->apart_m > 0.03f && e->apart_m > e->before_m - 0.001f);
    assert_true(e->depth_m == 0.0f);
}

static void test_figs_4_1_to_4_4_head_on_fish_pass_without_a_touch(void **state)
{
    (void)state;
    const struct tank_stage stage[] = { swimmer(0.0f, -13.0f, 6.0f, 0.0f),
                                        swimmer(0.0f, -13.0f, -6.0f, 180.0f) };
    float gap_m = 1.0f;
    uint32_t left = 0;
    for (uint32_t seed = 1; seed <= SEEDS; seed++) {
        const struct encounter e = play(stage, seed);
        check_phases(&e);
        /* The product is positive if both fish turn left or both fish turn right, each from its own
         * view. */
        assert_true(e.turned_rad[0] * e.turned_rad[1] > 0.0f);
        assert_false(e.pitched);
        left += e.turned_rad[0] > 0.0f;
        gap_m = f_min(gap_m, e.gap_m);
    }
    print_message("head-on: %u of %u to the left, least gap %.1f mm\n", left, SEEDS,
                  (double)(1000.0f * gap_m));
    assert_in_range(left, SEEDS / 4u, 3u * SEEDS / 4u);
    assert_true(gap_m > 0.003f);
}

static void test_figs_4_5_to_4_8_fish_from_the_side_pass_without_a_touch(void **state)
{
    (void)state;
    const struct tank_stage stage[] = { swimmer(0.0f, -13.0f, 7.0f, 0.0f),
                                        swimmer(4.5f, -13.0f, 0.0f, 90.0f) };
    float gap_m = 1.0f, worst_m = 1.0f;
    uint32_t behind = 0;
    for (uint32_t seed = 1; seed <= SEEDS; seed++) {
        const struct encounter e = play(stage, seed);
        check_phases(&e);
        behind += e.turned_rad[0] < 0.0f;
        worst_m = f_min(worst_m, e.gap_m);
        gap_m = e.turned_rad[0] < 0.0f ? f_min(gap_m, e.gap_m) : gap_m;
    }
    print_message("from the side: %u of %u behind, least gap %.1f mm, of the others %.1f mm\n",
                  behind, SEEDS, (double)(1000.0f * gap_m), (double)(1000.0f * worst_m));
    assert_in_range(behind, 4u * SEEDS / 5u, SEEDS - 1u);
    assert_true(gap_m > 0.002f);
}

static void test_figs_4_9_to_4_12_a_fish_from_behind_passes_without_a_touch(void **state)
{
    (void)state;
    struct tank_stage stage[] = { swimmer(0.0f, -13.0f, 12.0f, 0.0f),
                                  swimmer(0.0f, -13.0f, 2.0f, 0.0f) };
    stage[0].gait = GAIT_BURST;
    stage[0].speed_m_s = 0.15f * 0.92f;
    float gap_m = 1.0f;
    uint32_t left = 0;
    for (uint32_t seed = 1; seed <= SEEDS; seed++) {
        const struct encounter e = play(stage, seed);
        assert_true(e.start_tick > 0 && e.depth_m == 0.0f);
        left += e.turned_rad[0] > 0.0f;
        gap_m = f_min(gap_m, e.gap_m);
    }
    print_message("from behind: %u of %u to the left, least gap %.1f mm\n", left, SEEDS,
                  (double)(1000.0f * gap_m));
    assert_in_range(left, SEEDS / 4u, 3u * SEEDS / 4u);
    assert_true(gap_m > 0.003f);
}

/* Only the follower may avoid the leader. After the follower has turned by 20 degrees, the headings
 * alone would mean an encounter from the side, in which the leader would turn too. */
static void check_leader(const struct tank_stage stage[2], uint32_t seed, uint32_t *met)
{
    struct tank *tank = thesis_stage(stage, 2, seed);
    const struct fish *follower = &tank->fish[0], *leader = &tank->fish[1];
    uint8_t gave_way = 0;
    for (uint32_t tick = 1; tick <= 4u * CORE_TICK_HZ; tick++) {
        tank_tick(tank, tick, NULL, 0);
        gave_way |= follower->avoiding == AVOID_YAW && follower->avoid_kind == MEET_REAR_END;
        assert_int_equal(leader->avoiding, AVOID_NONE);
        assert_float_equal(leader->angles.yaw_rad, 0.0f, 1e-6f);
    }
    *met += gave_way;
}

static void test_3_4_the_leader_never_turns_for_a_follower(void **state)
{
    (void)state;
    uint32_t met = 0;
    for (uint32_t seed = 1; seed <= 4u * SEEDS; seed++) {
        const float off_cm = 0.25f * (float)(seed % 9u) - 1.0f;
        struct tank_stage stage[] = { swimmer(off_cm, -13.0f, 12.0f, 0.0f),
                                      swimmer(0.0f, -13.0f, 3.0f, 0.0f) };
        stage[0].gait = GAIT_BURST;
        stage[0].speed_m_s = 0.138f;
        stage[1].stamina = 0.26f + 0.01f * (float)(seed % 70u);
        check_leader(stage, seed, &met);
        /* In this second encounter, the follower (stage[0]) is only slightly faster than the
         * leader. The avoidance therefore lasts for seconds, and the follower must continue it by
         * pitch. */
        stage[0].gait = GAIT_SWIM;
        stage[0].position_m.z = 0.10f;
        stage[0].speed_m_s = 0.0525f;
        stage[0].stamina = 1.0f;
        stage[1].speed_m_s = 0.02f;
        stage[1].gait = GAIT_REST;
        check_leader(stage, seed, &met);
    }
    print_message("from behind: %u of %u followers gave way, no leader did\n", met, 8u * SEEDS);
    assert_true(met > 7u * SEEDS);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_3_4_personal_spaces_of_7_by_4_by_3_cm_meet_box_against_box),
        cmocka_unit_test(test_3_4_personal_space_never_shrinks_in_the_thesis),
        cmocka_unit_test(test_3_4_a_fish_reacts_to_the_soonest_of_several_meetings),
        cmocka_unit_test(test_3_4_repulsion_separates_resting_fish),
        cmocka_unit_test(test_figs_4_1_to_4_4_head_on_fish_pass_without_a_touch),
        cmocka_unit_test(test_figs_4_5_to_4_8_fish_from_the_side_pass_without_a_touch),
        cmocka_unit_test(test_figs_4_9_to_4_12_a_fish_from_behind_passes_without_a_touch),
        cmocka_unit_test(test_3_4_the_leader_never_turns_for_a_follower),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
