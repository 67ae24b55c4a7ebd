/* test_targeting.c -- checks which fish the bot chooses, from which side the bot approaches this
 * fish, and the path of its poi. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/game/bot/bot.h"

/* Returns a snapshot with a distant bowl, whole paper and `count` visible fish. */
static struct snapshot snapshot_with(uint32_t count, const struct snapshot_fish *fish)
{
    struct snapshot snapshot = {
        .tank_m = { 0.85f, 0.12f, 0.55f },
        .poi = { .present = 1, .radius_m = 0.040f, .paper_left = 1.0f },
        .bowl = { .present = 1, .position_m = { 0.335f, 0.012f, 0.185f }, .radius_m = 0.075f },
        .paper = { .wet = 1.0f, .left = 1.0f, .holds = 1, .middle = 1 },
        .near_count = count,
    };
    snapshot.prey.fish = SNAPSHOT_NO_FISH;
    memcpy(snapshot.near, fish, count * sizeof *fish);
    return snapshot;
}

static struct snapshot_fish fish_at(uint16_t number, float x_m, float y_m, float z_m)
{
    return (struct snapshot_fish){
        .fish = number, .position_m = { x_m, y_m, z_m }, .heading_rad = F_PI, .length_m = 0.04f
    };
}

static uint16_t chosen(const struct technique *technique, struct snapshot_fish a,
                       struct snapshot_fish b)
{
    const struct snapshot_fish two[] = { a, b };
    const struct snapshot snapshot = snapshot_with(2, two);
    float yaw_rad = 0.0f;
    const struct snapshot_fish *best =
        targeting_choose(technique, &snapshot, v3(0.0f, 0.06f, 0.0f), 0.0f, &yaw_rad);
    return best ? best->fish : SNAPSHOT_NO_FISH;
}

static void test_a_slanted_entry_moves_along_the_paper_and_a_flat_one_down(void **state)
{
    (void)state;
    const struct snapshot snapshot = snapshot_with(0, NULL);
    struct technique technique = technique_expert;
    struct approach_path way;
    assert_true(
        targeting_approach(&technique, &snapshot, v3(0.0f, -0.03f, 0.0f), 0.05f, 0.0f, &way));
    const vec3 slide = v3_sub(way.stop_m, way.entry_m);
    /* At yaw 0 the slide path points toward -z and down, so its angle below the horizontal is
     * atan2(-y, -z). */
    const float slope_rad = f_atan2(-slide.y, -slide.z);
    assert_true(f_abs(slope_rad - technique.entry_deg * F_DEG) < 0.01f);
    technique.entry_deg = 0.0f;
    assert_true(
        targeting_approach(&technique, &snapshot, v3(0.0f, -0.03f, 0.0f), 0.05f, 0.0f, &way));
    assert_true(f_abs(way.stop_m.z - way.entry_m.z) < 1e-4f && way.stop_m.y < way.entry_m.y);
}

static void test_the_target_point_of_the_paper_is_the_middle_or_the_far_edge(void **state)
{
    (void)state;
    const struct snapshot snapshot = snapshot_with(0, NULL);
    const vec3 fish_m = v3(0.0f, -0.03f, 0.0f);
    struct technique technique = technique_expert;
    struct approach_path way;
    technique.place = PLACE_CENTRE;
    assert_true(targeting_approach(&technique, &snapshot, fish_m, 0.07f, 0.0f, &way));
    assert_true(f_abs(way.under_m.z) < 1e-4f && way.under_m.y < fish_m.y);
    technique.place = PLACE_RIM;
    assert_true(targeting_approach(&technique, &snapshot, fish_m, 0.07f, 0.0f, &way));
    const float tail_m = way.under_m.z - (fish_m.z - 0.42f * 0.07f);
    assert_true(way.under_m.z > 0.01f);
    /* The tail of the fish is outside the ring, so it cannot slap the paper. */
    assert_true(tail_m > snapshot.poi.radius_m);
}

static void test_a_hole_in_the_middle_moves_the_target_point(void **state)
{
    (void)state;
    struct snapshot snapshot = snapshot_with(0, NULL);
    struct approach_path way;
    snapshot.paper.middle = 0;
    snapshot.paper.x_m = 0.02f;
    assert_true(targeting_approach(&technique_expert, &snapshot, v3(0.0f, -0.03f, 0.0f), 0.05f,
                                   0.0f, &way));
    assert_true(f_abs(way.under_m.x + 0.02f) < 1e-4f);
}

static void test_walls_and_the_own_bowl_block_a_path(void **state)
{
    (void)state;
    const struct snapshot snapshot = snapshot_with(0, NULL);
    const vec3 free_m = v3(0.0f, -0.03f, 0.0f), walled_m = v3(-0.42f, -0.03f, 0.0f);
    const vec3 under_bowl_m = v3(0.335f, -0.03f, 0.185f);
    struct approach_path way;
    assert_true(targeting_approach(&technique_expert, &snapshot, free_m, 0.04f, 0.35f, &way));
    assert_false(targeting_approach(&technique_expert, &snapshot, walled_m, 0.04f, 0.35f, &way));
    assert_false(
        targeting_approach(&technique_expert, &snapshot, under_bowl_m, 0.04f, 0.35f, &way));
}

static void test_shallow_slow_gulping_fish_have_priority(void **state)
{
    (void)state;
    const struct snapshot_fish plain = fish_at(1, 0.0f, -0.03f, -0.05f);
    struct snapshot_fish other = fish_at(2, 0.0f, -0.03f, -0.05f);
    other.position_m.y = -0.07f;
    assert_int_equal(chosen(&technique_expert, plain, other), 1);
    other = fish_at(2, 0.0f, -0.03f, -0.05f);
    other.velocity_m_s = v3(0.10f, 0.0f, 0.0f);
    assert_int_equal(chosen(&technique_expert, other, plain), 1);
    other = fish_at(2, 0.0f, -0.03f, -0.05f);
    other.gulps = 1;
    assert_int_equal(chosen(&technique_expert, plain, other), 2);
    other = fish_at(2, 0.0f, -0.03f, -0.05f);
    other.length_m = 0.08f;
    assert_int_equal(chosen(&technique_expert, other, plain), 1);
}

static void test_fish_near_another_players_poi_are_avoided(void **state)
{
    (void)state;
    const struct snapshot_fish two[] = { fish_at(1, 0.0f, -0.03f, -0.05f),
                                         fish_at(2, -0.16f, -0.03f, -0.05f) };
    struct snapshot snapshot = snapshot_with(2, two);
    float yaw_rad = 0.0f;
    const vec3 hand_m = v3(0.0f, 0.06f, 0.0f);
    assert_int_equal(targeting_choose(&technique_expert, &snapshot, hand_m, 0.0f, &yaw_rad)->fish,
                     1);
    snapshot.rival_count = 1;
    snapshot.rival_m[0] = v3(0.03f, 0.05f, -0.05f);
    assert_int_equal(targeting_choose(&technique_expert, &snapshot, hand_m, 0.0f, &yaw_rad)->fish,
                     2);
}

static void test_head_first_scoops_come_from_ahead_and_tail_first_from_behind(void **state)
{
    (void)state;
    struct snapshot_fish fish = fish_at(1, 0.0f, -0.03f, 0.0f);
    struct technique technique = technique_expert;
    fish.heading_rad = -2.6f;
    assert_true(f_abs(targeting_yaw(&technique, &fish, 9.0f) - (F_PI - 2.6f)) < 1e-4f);
    assert_true(targeting_yaw(&technique_novice, &fish, 0.2f) == 0.2f);
    technique.side = SIDE_TAIL;
    /* A human wrist cannot turn as far as this fish requires, so the yaw stays unchanged. */
    assert_true(targeting_yaw(&technique, &fish, 0.2f) == 0.2f);
    fish.heading_rad = 0.5f;
    assert_true(targeting_yaw(&technique, &fish, 0.2f) == 0.5f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_slanted_entry_moves_along_the_paper_and_a_flat_one_down),
        cmocka_unit_test(test_the_target_point_of_the_paper_is_the_middle_or_the_far_edge),
        cmocka_unit_test(test_a_hole_in_the_middle_moves_the_target_point),
        cmocka_unit_test(test_walls_and_the_own_bowl_block_a_path),
        cmocka_unit_test(test_shallow_slow_gulping_fish_have_priority),
        cmocka_unit_test(test_fish_near_another_players_poi_are_avoided),
        cmocka_unit_test(test_head_first_scoops_come_from_ahead_and_tail_first_from_behind),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
