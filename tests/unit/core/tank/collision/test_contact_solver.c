/* test_contact_solver.c -- checks how well the contact solver separates the fish of a crowd. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/base/mem.h"
#include "core/input.h"
#include "core/tank/collision/contact_solver.h"
#include "tests/unit/support/throng.h"

static struct contact_solver solver;
static struct solver_context place = { .bounds = { { -0.68f, -0.20f, -0.325f },
                                                   { 0.68f, 0.0f, 0.325f } } };

static void begin_step(uint32_t count, float push_max_m)
{
    place.fish = fish;
    place.push_max_m = push_max_m;
    broad_phase_gather(&broad_phase, fish, count, 0.2f);
    contact_solver_substep_count(&solver, &place);
    contact_solver_substep(&solver, &broad_phase, &place, 0);
    contact_solver_project(&solver, &broad_phase, &place);
}

/* Prepares the contact solver with the bodies of the fish. `before_m` has the previous positions of
 * the fish; null means that the fish did not move. */
static void gather(uint32_t count, const vec3 *before_m)
{
    contact_solver_begin(&solver, fish, count);
    for (uint32_t i = 0; i < count && before_m; i++) {
        solver.began_m[i] = before_m[i];
    }
    begin_step(count, before_m ? SOLVER_PUSH_M : 0.05f);
}

static float depth_m(uint32_t first, uint32_t second)
{
    const struct box a = body_box(&broad_phase.body[first]),
                     b = body_box(&broad_phase.body[second]);
    return box_depth_m(&a, &b);
}

static void test_the_solver_removes_overlaps_and_keeps_fish_inside_walls(void **state)
{
    (void)state;
    fill_at_random(400, 0.3f, 0.06f);
    gather(400, NULL);
    for (int tick = 0; tick < 40; tick++) {
        look(0);
        contact_solver_relax(&solver, &broad_phase, &place);
        contact_solver_project(&solver, &broad_phase, &place);
    }
    float deepest_m = 0.0f;
    for (uint32_t i = 0; i < broad_phase.count; i++) {
        const vec3 p = broad_phase.body[i].centre_m, extent = body_extent_m(&broad_phase.body[i]);
        assert_true(f_abs(p.x) + extent.x < 0.68f + 1e-5f);
        assert_true(f_abs(p.z) + extent.z < 0.325f + 1e-5f);
        assert_true(p.y + extent.y < 1e-5f && p.y - extent.y > -0.20f - 1e-5f);
        for (uint32_t j = 0; j < i; j++) {
            deepest_m = f_max(deepest_m, depth_m(i, j));
        }
    }
    assert_true(deepest_m < 1e-5f);
}

static void test_the_solver_moves_a_fish_at_most_2_mm_beyond_its_own_motion(void **state)
{
    (void)state;
    static vec3 before_m[300];
    fill_at_random(300, 0.3f, 0.06f);
    /* Moves the fish together, into a quarter of the area. Each fish gets a motion of 2 mm in this
     * tick. */
    for (uint32_t i = 0; i < 300; i++) {
        fish[i].position_m = v3_scale(fish[i].position_m, 0.5f);
        fish[i].position_m.y -= 0.05f;
        before_m[i] = v3_add(fish[i].position_m, v3(0.002f, 0.0f, 0.0f));
    }
    gather(300, before_m);
    look(0);
    const uint32_t before = broad_phase.overlap_count;
    contact_solver_relax(&solver, &broad_phase, &place);
    float farthest_m = 0.0f;
    for (uint32_t i = 0; i < broad_phase.count; i++) {
        const vec3 step = v3_sub(broad_phase.body[i].centre_m, before_m[i]);
        farthest_m = f_max(farthest_m, v3_length(v3(step.x, 0.0f, step.z)));
    }
    print_message("%u overlaps, farthest step %.2f mm\n", before, (double)(1000.0f * farthest_m));
    assert_true(before > 100);
    assert_true(farthest_m > 0.003f && farthest_m < 0.00401f);
}

static void test_a_blocked_fish_leaves_the_correction_to_the_other(void **state)
{
    (void)state;
    /* In this tick the large fish has moved 24 mm and overlaps the small resting fish by 8 mm. The
     * solver must move the large fish back, because the small fish did not move. */
    const vec3 before_m[2] = { { 0.0f, -0.1f, 0.0f }, { 0.028f, -0.1f, 0.0f } };
    fish[0] = (struct fish){ .position_m = { 0.0f, -0.1f, 0.0f }, WAKIN(0.04f) };
    fish[1] = (struct fish){ .position_m = { 0.004f, -0.1f, 0.0f }, WAKIN(0.08f) };
    gather(2, before_m);
    look(0);
    contact_solver_relax(&solver, &broad_phase, &place);
    assert_true(broad_phase.body[0].centre_m.x > -0.00201f);
    assert_true(depth_m(0, 1) < 1e-5f);
}

static void test_the_larger_of_two_fish_moves_less(void **state)
{
    (void)state;
    fish[0] = (struct fish){ .position_m = { 0.0f, -0.1f, 0.0f }, WAKIN(0.08f) };
    fish[1] = (struct fish){ .position_m = { 0.009f, -0.1f, 0.0f }, WAKIN(0.04f) };
    gather(2, NULL);
    look(0);
    contact_solver_relax(&solver, &broad_phase, &place);
    const float large_m = -broad_phase.body[0].centre_m.x,
                small_m = broad_phase.body[1].centre_m.x - 0.009f;
    assert_true(large_m > 0.0f);
    /* The large fish is twice as long and has eight times the mass, so the solver must push it an
     * eighth as far. */
    assert_float_equal(small_m / large_m, 8.0f, 0.2f);
}

/* Two fish lie side by side at a wall, and a third fish turns into them. No push can separate the
 * fish, so the third fish must get its old pose again. */
static void test_an_unsolved_fish_gets_its_old_pose_bit_for_bit(void **state)
{
    (void)state;
    struct fish was[3];
    for (uint32_t i = 0; i < 3; i++) {
        const float x = -0.674f + 0.0103f * (float)i;
        was[i] = fish[i] =
            (struct fish){ .position_m = { x, -0.1f, 0.0f }, .yaw_rate_rad_s = 1.0f, WAKIN(0.05f) };
    }
    contact_solver_begin(&solver, fish, 3);
    fish[2].angles.yaw_rad = 0.9f;
    begin_step(3, SOLVER_PUSH_M);
    look(0);
    contact_solver_finish(&solver, &broad_phase, &place);
    contact_solver_write_back(&broad_phase, fish);
    contact_solver_end(&solver, &broad_phase, &place);
    assert_true(solver.reverted_count >= 1);
    assert_true(fish[2].angles.yaw_rad == 0.0f && fish[2].yaw_rate_rad_s == 0.0f);
    assert_true(fish[2].position_m.x == was[2].position_m.x);
    assert_true(depth_m(0, 1) <= SOLVER_FREE_M && depth_m(1, 2) <= SOLVER_FREE_M);
}

/* Moves a disc by 12 mm in one tick, in several substeps. The disc also turns. */
static void take_all_steps(struct obstacle *disc, uint8_t gave)
{
    *disc = (struct obstacle){ .kind = OBSTACLE_DISC,
                               .centre_m = { 0.112f, -0.05f, 0.0f },
                               .velocity_m_s = { 0.012f * CORE_TICK_HZ, 0.0f, 0.0f },
                               .step_m = { 0.012f, 0.0f, 0.0f },
                               .turned = 1 };
    fish[0] = (struct fish){ .position_m = { -0.3f, -0.1f, 0.0f }, WAKIN(0.04f) };
    place.obstacles = disc;
    place.obstacle_count = 1;
    place.fish = fish;
    broad_phase_gather(&broad_phase, fish, 1, 0.2f);
    contact_solver_begin(&solver, fish, 1);
    const uint32_t count = contact_solver_substep_count(&solver, &place);
    assert_true(count > 1);
    for (uint32_t station = 0; station < count; station++) {
        contact_solver_substep(&solver, &broad_phase, &place, station);
    }
    if (gave & REACTION_POSITION) {
        disc->centre_m.x -= 0.004f;
    }
    disc->reaction = gave;
    contact_solver_end(&solver, &broad_phase, &place);
    place.obstacles = NULL;
    place.obstacle_count = 0;
}

static void test_an_obstacle_ends_a_tick_with_the_motion_of_the_whole_tick(void **state)
{
    (void)state;
    struct obstacle disc;
    take_all_steps(&disc, 0);
    assert_float_equal(disc.centre_m.x, 0.112f, 1e-6f);
    assert_float_equal(disc.step_m.x, 0.012f, 1e-6f);
    assert_float_equal(disc.velocity_m_s.x, 0.012f * CORE_TICK_HZ, 0.0f);
    assert_int_equal(disc.turned, 1);
}

static void test_a_blocked_obstacle_loses_its_unused_speed_and_turn(void **state)
{
    (void)state;
    struct obstacle disc;
    take_all_steps(&disc, REACTION_POSITION | REACTION_ROTATION);
    assert_float_equal(disc.step_m.x, 0.008f, 1e-6f);
    assert_float_equal(disc.velocity_m_s.x, 0.008f * CORE_TICK_HZ, 1e-4f);
    assert_int_equal(disc.turned, 0);
}

/* Number of fish. The number is not divisible by any number of SIMD lanes, so the last block is
 * incomplete. */
enum { MANY = 203 };

/* Runs the solver on the crowd of begin_step() with `lanes` SIMD lanes. If `alone` is set, the
 * solver uses the scalar code for each fish. */
static void clear_crowd(uint8_t lanes, int alone)
{
    place.lanes = lanes;
    broad_phase_gather(&broad_phase, fish, MANY, 0.2f);
    for (uint32_t i = 0; i < MANY && alone; i++) {
        /* This flag makes the solver use the scalar code for the fish. */
        broad_phase.flags[i] |= BODY_NEAR_OBSTACLE;
    }
    contact_solver_substep_count(&solver, &place);
    contact_solver_substep(&solver, &broad_phase, &place, 0);
    contact_solver_project(&solver, &broad_phase, &place);
    place.lanes = 0;
}

static void test_simd_lanes_equal_the_scalar_form_at_walls_and_a_poi(void **state)
{
    (void)state;
    static struct body cleared[MANY];
    static float play_m[MANY], step_max_m[MANY];
    struct obstacle disc = { .kind = OBSTACLE_DISC,
                             .centre_m = { 0.1f, -0.05f, 0.0f },
                             .normal = { 0.0f, 1.0f, 0.0f },
                             .radius_m = 0.05f,
                             .axes = { { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } },
                             .step_m = { 0.001f, 0.0f, 0.0f } };
    fill_at_random(MANY, 1.2f, 0.06f);
    contact_solver_begin(&solver, fish, MANY);
    /* Places some fish beyond the walls, the floor and the surface. */
    for (uint32_t i = 0; i < MANY; i++) {
        fish[i].position_m.x *= 1.05f;
        fish[i].position_m.y += draw(i, 8, -0.008f, 0.008f);
        fish[i].angles.yaw_rad += draw(i, 9, -0.2f, 0.2f);
    }
    place.fish = fish;
    place.push_max_m = SOLVER_PUSH_M;
    place.obstacles = &disc;
    place.obstacle_count = 1;
    clear_crowd(0, 1);
    MEM_COPY(cleared, broad_phase.body, sizeof cleared);
    MEM_COPY(play_m, broad_phase.play_m, sizeof play_m);
    MEM_COPY(step_max_m, solver.step_max_m, sizeof step_max_m);
    const uint32_t beside = solver.beside_count;
    assert_true(beside > 2 && beside < MANY / 2);
    for (uint8_t lanes = 4; lanes <= SIMD_LANES_MAX; lanes *= 2) {
        disc.centre_m = v3(0.1f, -0.05f, 0.0f);
        disc.step_m = v3(0.001f, 0.0f, 0.0f);
        clear_crowd(lanes, 0);
        assert_int_equal(solver.beside_count, beside);
        assert_memory_equal(cleared, broad_phase.body, sizeof cleared);
        assert_memory_equal(play_m, broad_phase.play_m, sizeof play_m);
        assert_memory_equal(step_max_m, solver.step_max_m, sizeof step_max_m);
    }
    place.obstacles = NULL;
    place.obstacle_count = 0;
}

/* Moves and turns every fish at random, forty times. Two fish that did not overlap before must
 * never overlap afterwards. A few pairs overlap at the start, so a pair is checked only after its
 * fish were separate once. */
static void test_fish_without_an_overlap_stay_without_one(void **state)
{
    (void)state;
    enum { COUNT = 400 };
    static uint8_t was_free[COUNT][COUNT];
    uint32_t reverted_count = 0, free_count = 0;
    float deepest_m = 0.0f;
    fill_at_random(COUNT, 0.3f, 0.05f);
    /* Shrinks the area, so that the 400 fish are as dense as 2,000 fish in the whole tank. */
    for (uint32_t i = 0; i < COUNT; i++) {
        fish[i].position_m.x *= 0.4f;
        fish[i].position_m.z *= 0.5f;
    }
    gather(COUNT, NULL);
    for (int round = 0; round < 60; round++) {
        look(0);
        contact_solver_relax(&solver, &broad_phase, &place);
    }
    contact_solver_write_back(&broad_phase, fish);
    contact_solver_end(&solver, &broad_phase, &place);
    for (uint32_t i = 0; i < COUNT; i++) {
        for (uint32_t j = 0; j < i; j++) {
            was_free[i][j] = depth_m(i, j) <= SOLVER_FREE_M;
            free_count += was_free[i][j];
        }
    }
    assert_true(free_count + 20u > COUNT * (COUNT - 1u) / 2u);
    for (uint32_t tick = 1; tick <= 40; tick++) {
        contact_solver_begin(&solver, fish, COUNT);
        for (uint32_t i = 0; i < COUNT; i++) {
            fish[i].position_m.x += draw(i + COUNT * tick, 11, -0.005f, 0.005f);
            fish[i].position_m.y += draw(i + COUNT * tick, 12, -0.005f, 0.005f);
            fish[i].angles.yaw_rad += draw(i + COUNT * tick, 13, -0.3f, 0.3f);
            fish[i].angles.pitch_rad += draw(i + COUNT * tick, 14, -0.05f, 0.05f);
        }
        begin_step(COUNT, SOLVER_PUSH_M);
        look(0);
        contact_solver_finish(&solver, &broad_phase, &place);
        contact_solver_write_back(&broad_phase, fish);
        contact_solver_end(&solver, &broad_phase, &place);
        reverted_count += solver.reverted_count;
        for (uint32_t i = 0; i < COUNT; i++) {
            for (uint32_t j = 0; j < i; j++) {
                const vec3 d = v3_sub(fish[i].position_m, fish[j].position_m);
                const float now_m = v3_dot(d, d) < 0.0036f ? depth_m(i, j) : 0.0f;
                deepest_m = was_free[i][j] ? f_max(deepest_m, now_m) : deepest_m;
                was_free[i][j] |= now_m <= SOLVER_FREE_M;
            }
        }
    }
    print_message("%u put back, deepest %.3f mm\n", reverted_count, (double)(1000.0f * deepest_m));
    assert_true(reverted_count > 5);
    assert_true(deepest_m <= SOLVER_FREE_M + 1e-6f);
}

/* Each fish is 0.5 mm from its neighbours and may touch up to 26 of them. The contact list cannot
 * hold so many pairs. */
static void test_no_fish_overlap_when_the_contact_list_is_full(void **state)
{
    (void)state;
    enum { COUNT = 768, ROW = 16, LAYER = ROW * 8 };
    uint32_t moved = 0;
    float deepest_m = 0.0f;
    for (uint32_t i = 0; i < COUNT; i++) {
        const vec3 at =
            v3((float)(i % ROW) * 0.0085f - 0.15f, (float)(i / LAYER) * -0.0149f - 0.02f,
               (float)(i / ROW % 8u) * 0.0405f - 0.15f);
        fish[i] = (struct fish){ .position_m = at, WAKIN(0.04f) };
    }
    for (uint32_t tick = 1; tick <= 6; tick++) {
        contact_solver_begin(&solver, fish, COUNT);
        for (uint32_t i = 0; i < COUNT; i++) {
            fish[i].position_m.x += draw(i + COUNT * tick, 11, -0.002f, 0.002f);
            fish[i].position_m.y += draw(i + COUNT * tick, 12, -0.001f, 0.001f);
            fish[i].angles.yaw_rad += draw(i + COUNT * tick, 13, -0.05f, 0.05f);
        }
        begin_step(COUNT, SOLVER_PUSH_M);
        look(tick);
        assert_true(broad_phase.touch_count > BROAD_PHASE_CONTACT_MAX);
        contact_solver_finish(&solver, &broad_phase, &place);
        contact_solver_write_back(&broad_phase, fish);
        contact_solver_end(&solver, &broad_phase, &place);
        moved += COUNT - solver.reverted_count;
        for (uint32_t i = 0; i < COUNT; i++) {
            for (uint32_t j = 0; j < i; j++) {
                const vec3 d = v3_sub(fish[i].position_m, fish[j].position_m);
                deepest_m = v3_dot(d, d) < 0.0025f ? f_max(deepest_m, depth_m(i, j)) : deepest_m;
            }
        }
    }
    print_message("%u contacts, %u fish-ticks free, deepest %.3f mm\n", broad_phase.touch_count,
                  moved, (double)(1000.0f * deepest_m));
    assert_true(moved > 0);
    assert_true(deepest_m <= SOLVER_FREE_M + 1e-6f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_solver_removes_overlaps_and_keeps_fish_inside_walls),
        cmocka_unit_test(test_the_solver_moves_a_fish_at_most_2_mm_beyond_its_own_motion),
        cmocka_unit_test(test_a_blocked_fish_leaves_the_correction_to_the_other),
        cmocka_unit_test(test_the_larger_of_two_fish_moves_less),
        cmocka_unit_test(test_an_unsolved_fish_gets_its_old_pose_bit_for_bit),
        cmocka_unit_test(test_simd_lanes_equal_the_scalar_form_at_walls_and_a_poi),
        cmocka_unit_test(test_no_fish_overlap_when_the_contact_list_is_full),
        cmocka_unit_test(test_an_obstacle_ends_a_tick_with_the_motion_of_the_whole_tick),
        cmocka_unit_test(test_a_blocked_obstacle_loses_its_unused_speed_and_turn),
        cmocka_unit_test(test_fish_without_an_overlap_stay_without_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
