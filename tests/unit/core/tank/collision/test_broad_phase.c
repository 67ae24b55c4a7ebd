/* test_broad_phase.c -- compares the broad phase, which is the search for near pairs, with a test
 * of all pairs. Checks also the contact list. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/base/mem.h"
#include "core/tank/behavior/swim.h"
#include "tests/unit/support/throng.h"

/* Checks that the contact list contains every pair of overlapping fish, which a test of all pairs
 * finds. Returns the number of such pairs. */
static uint32_t check_against_all_pairs(uint32_t count)
{
    static uint8_t listed[600][600];
    uint32_t overlaps = 0;
    for (uint32_t i = 0; i < count; i++) {
        for (uint32_t j = 0; j < count; j++) {
            listed[i][j] = 0;
        }
    }
    broad_phase_gather(&broad_phase, fish, count, 0.2f);
    look(0);
    for (uint32_t c = 0; c < broad_phase.contact_count; c++) {
        const uint32_t a = broad_phase.contact[c].a, b = broad_phase.contact[c].b;
        /* The list may contain each pair only once. */
        assert_int_equal(listed[a][b], 0);
        listed[a][b] = listed[b][a] = 1;
    }
    for (uint32_t i = 0; i < count; i++) {
        for (uint32_t j = 0; j < i; j++) {
            const struct box a = fish_box(&fish[i]), b = fish_box(&fish[j]);
            if (box_depth_m(&a, &b) > 0.0f) {
                assert_int_equal(listed[i][j], 1);
                overlaps++;
            }
        }
    }
    return overlaps;
}

static void test_the_grid_finds_every_pair_of_the_exhaustive_search(void **state)
{
    (void)state;
    fill_at_random(600, 0.5f, 0.08f);
    assert_true(check_against_all_pairs(600) > 50);
    fill_at_random(600, 1.5f, 0.05f);
    assert_true(check_against_all_pairs(600) > 20);
}

static void test_the_grid_finds_pairs_across_cell_borders(void **state)
{
    (void)state;
    /* Shifts pairs of fish, which are nose to nose, in steps of 5 mm. A border between two cells is
     * then between the fish of each pair at least once. */
    for (uint32_t shift = 0; shift < 40; shift++) {
        for (uint32_t i = 0; i < 12; i += 2) {
            const float x = -0.6f + 0.2f * (float)(i / 2u) + 0.005f * (float)shift;
            const struct angles left = { 90.0f * F_DEG, 0.0f, 0.0f },
                                right = { -90.0f * F_DEG, 0.0f, 0.0f };
            fish[i] =
                (struct fish){ .position_m = { x, -0.1f, 0.0f }, .angles = right, WAKIN(0.08f) };
            fish[i + 1u] = (struct fish){ .position_m = { x + 0.0795f, -0.1f, 0.0f },
                                          .angles = left,
                                          WAKIN(0.08f) };
        }
        assert_true(check_against_all_pairs(12) >= 6);
    }
}

static void test_all_fish_in_one_corner_are_still_found(void **state)
{
    (void)state;
    fill_at_random(120, 0.5f, 0.05f);
    for (uint32_t i = 0; i < 120; i++) {
        fish[i].position_m =
            v3(draw(i, 7, 0.60f, 0.67f), draw(i, 8, -0.15f, -0.05f), draw(i, 9, 0.25f, 0.32f));
    }
    assert_true(check_against_all_pairs(120) > 500);
}

static void test_held_and_bowl_fish_are_not_in_the_broad_phase(void **state)
{
    (void)state;
    fill_at_random(10, 0.1f, 0.05f);
    fish[2].gait = GAIT_HELD;
    fish[7].gait = GAIT_BOWL;
    broad_phase_gather(&broad_phase, fish, 10, 0.2f);
    look(0);
    assert_int_equal(broad_phase.narrow_phase.grid.count, 8);
    for (uint32_t k = 0; k < broad_phase.narrow_phase.grid.count; k++) {
        assert_true(broad_phase.narrow_phase.grid.item[k] != 2 &&
                    broad_phase.narrow_phase.grid.item[k] != 7);
    }
}

/* ---- Ticks between full updates ------------------------------------------------------------- */

/* Gives the fish motions at the limits of what can occur: some fish rest, and others burst, turn
 * sharply and are pushed. */
static void randomize_motion(uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        fish[i].speed_m_s = fish[i].speed_goal_m_s = draw(i, 7, 0.0f, 0.3f);
        fish[i].heading_rad = draw(i, 8, -F_PI, F_PI);
        fish[i].turn_rate_max_rad_s = draw(i, 9, 0.5f, 12.0f);
        fish[i].haste = fish[i].brake = fish[i].room = 1.0f;
        fish[i].pitch_goal_rad = draw(i, 10, -0.4f, 0.4f);
        fish[i].push_m_s = v3(draw(i, 11, -0.02f, 0.02f), 0.0f, draw(i, 12, -0.02f, 0.02f));
        fish[i].gait = GAIT_SWIM;
    }
}

/* Moves `count` fish by one tick. The contact solver does not run. */
static void swim_on(uint32_t count)
{
    static vec3 before_m[601];
    const struct shoal shoal = {
        fish, broad_phase.body, broad_phase.way_m, before_m, count, pond_params(), 0.2f
    };
    for (uint32_t i = 0; i < count; i++) {
        before_m[i] = fish[i].position_m;
    }
    swim_move_all(&shoal, 0);
    broad_phase_mark(&broad_phase, fish, count);
    broad_phase_sync(&broad_phase, fish);
}

static uint32_t touching_pairs_all_listed(uint32_t count)
{
    static uint8_t listed[600][600];
    uint32_t touching = 0;
    memset(listed, 0, sizeof listed);
    broad_phase_select_contacts(&broad_phase);
    for (uint32_t c = 0; c < broad_phase.contact_count; c++) {
        listed[broad_phase.contact[c].a][broad_phase.contact[c].b] = 1;
    }
    for (uint32_t i = 0; i < count; i++) {
        for (uint32_t j = 0; j < i; j++) {
            const struct box a = fish_box(&fish[i]), b = fish_box(&fish[j]);
            if (box_depth_m(&a, &b) > 0.0f) {
                assert_true(listed[i][j] || listed[j][i]);
                touching++;
            }
        }
    }
    return touching;
}

static void test_a_valid_pair_list_contains_every_touching_pair(void **state)
{
    (void)state;
    enum { COUNT = 300 };
    uint32_t fresh = 0, stale = 0, touching = 0, listed = 0, near = 0;
    for (uint32_t round = 0; round < 12; round++) {
        fill_at_random(COUNT, 0.4f, 0.05f);
        randomize_motion(COUNT);
        broad_phase_gather(&broad_phase, fish, COUNT, 0.2f);
        look(round);
        for (uint32_t tick = 0; tick < 12; tick++) {
            swim_on(COUNT);
            if (broad_phase_is_stale(&broad_phase)) {
                stale++;
                break;
            }
            fresh++;
            touching += touching_pairs_all_listed(COUNT);
            listed += broad_phase.contact_count;
            near += broad_phase.near_count;
        }
    }
    print_message("%u ticks after a look, %u pairs touch, %u could, %u stay near; %u looks ended\n",
                  fresh, touching, listed, near, stale);
    assert_true(fresh >= 12u * BROAD_PHASE_UPDATE_TICKS && stale == 12u);
    assert_true(touching > 200u && listed < 6u * touching && listed < near);
}

static void test_a_large_move_or_a_new_fish_invalidates_the_pair_list(void **state)
{
    (void)state;
    fill_at_random(20, 0.0f, 0.05f);
    fish[3].gait = GAIT_HELD;
    broad_phase_gather(&broad_phase, fish, 20, 0.2f);
    look(0);
    swim_on(20);
    assert_false(broad_phase_is_stale(&broad_phase));
    broad_phase.body[7].centre_m.x += 0.006f;
    broad_phase_sync(&broad_phase, fish);
    assert_true(broad_phase_is_stale(&broad_phase));
    assert_true(fish[7].position_m.x == broad_phase.body[7].centre_m.x);
    look(1);
    assert_false(broad_phase_is_stale(&broad_phase));
    fish[3].gait = GAIT_REST;
    swim_on(20);
    assert_true(broad_phase_is_stale(&broad_phase));
}

static void test_an_update_of_fish_that_moved_far_makes_the_list_complete(void **state)
{
    (void)state;
    enum { COUNT = 300 };
    uint32_t again = 0, touching = 0;
    for (uint32_t round = 0; round < 12; round++) {
        fill_at_random(COUNT, 0.4f, 0.05f);
        randomize_motion(COUNT);
        broad_phase_gather(&broad_phase, fish, COUNT, 0.2f);
        look(round);
        for (uint32_t tick = 0; tick < 12; tick++) {
            swim_on(COUNT);
            const uint32_t hurried = 12u * round + tick;
            broad_phase.body[hurried].centre_m.x *= 0.8f;
            broad_phase_sync(&broad_phase, fish);
            if (!broad_phase_is_stale(&broad_phase)) {
                continue;
            }
            if (!broad_phase_update_moved(&broad_phase, fish)) {
                break;
            }
            again++;
            assert_false(broad_phase_is_stale(&broad_phase));
            touching += touching_pairs_all_listed(COUNT);
        }
    }
    assert_true(again >= 40u && touching > 500u);
}

static void test_too_many_moved_fish_require_a_full_update(void **state)
{
    (void)state;
    fill_at_random(60, 0.0f, 0.05f);
    broad_phase_gather(&broad_phase, fish, 60, 0.2f);
    look(0);
    const uint32_t near_count = broad_phase.near_count;
    for (uint32_t i = 0; i < 60; i++) {
        broad_phase.body[i].centre_m.y += 0.02f;
    }
    broad_phase_sync(&broad_phase, fish);
    assert_true(broad_phase_is_stale(&broad_phase));
    assert_false(broad_phase_update_moved(&broad_phase, fish));
    assert_int_equal(broad_phase.near_count, near_count);
    assert_true(broad_phase_is_stale(&broad_phase));
}

static void test_a_full_contact_list_drops_other_pairs_each_tick(void **state)
{
    (void)state;
    static uint8_t served[200][200];
    enum { COUNT = 200 };
    /* All 200 fish overlap each other. Their 19,900 pairs do not fit in the list, which has room
     * for 8,192 pairs. */
    for (uint32_t i = 0; i < COUNT; i++) {
        fish[i] = (struct fish){ .position_m = { 0.00004f * (float)i, -0.1f, 0.0f }, WAKIN(0.05f) };
    }
    uint32_t pairs = 0;
    for (uint32_t tick = 0; tick < 48; tick++) {
        broad_phase_gather(&broad_phase, fish, COUNT, 0.2f);
        look(tick);
        assert_int_equal(broad_phase.contact_count, BROAD_PHASE_CONTACT_MAX);
        assert_true(broad_phase.overlap_count > 2u * BROAD_PHASE_CONTACT_MAX);
        for (uint32_t c = 0; c < broad_phase.contact_count; c++) {
            const uint32_t a = broad_phase.contact[c].a, b = broad_phase.contact[c].b;
            pairs += !served[a][b];
            served[a][b] = served[b][a] = 1;
        }
    }
    assert_true(pairs == broad_phase.overlap_count);
}

static void test_personal_space_shrinks_only_in_a_crowd(void **state)
{
    (void)state;
    fill_at_random(600, 0.0f, 0.05f);
    assert_float_equal(broad_phase_space(fish, 50, tank_m, pond_params()), 0.2f, 1e-6f);
    const float small_tank = broad_phase_space(fish, 600, v3(0.5f, 0.1f, 0.4f), pond_params());
    assert_true(small_tank >= 0.04f && small_tank < 0.18f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_grid_finds_every_pair_of_the_exhaustive_search),
        cmocka_unit_test(test_the_grid_finds_pairs_across_cell_borders),
        cmocka_unit_test(test_all_fish_in_one_corner_are_still_found),
        cmocka_unit_test(test_held_and_bowl_fish_are_not_in_the_broad_phase),
        cmocka_unit_test(test_a_valid_pair_list_contains_every_touching_pair),
        cmocka_unit_test(test_a_large_move_or_a_new_fish_invalidates_the_pair_list),
        cmocka_unit_test(test_an_update_of_fish_that_moved_far_makes_the_list_complete),
        cmocka_unit_test(test_too_many_moved_fish_require_a_full_update),
        cmocka_unit_test(test_a_full_contact_list_drops_other_pairs_each_tick),
        cmocka_unit_test(test_personal_space_shrinks_only_in_a_crowd),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
