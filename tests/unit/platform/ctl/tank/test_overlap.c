/* test_overlap.c -- Tests the measured overlap of two fish against depths from geometry, and the
 * search for overlaps against a comparison of all pairs. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "platform/ctl/tank/overlap.h"

static struct tank tank;
static struct overlap overlap;

static struct fish fish_at(double x_cm, double y_cm, double z_cm)
{
    return (struct fish){
        .position_m = { (float)(0.01 * x_cm), (float)(0.01 * y_cm), (float)(0.01 * z_cm) },
        .length_m = 0.05f,
        .height_m = 0.02f,
        .width_m = 0.01f,
        .gait = GAIT_SWIM,
    };
}

static double depth_mm(const struct fish *a, const struct fish *b)
{
    const struct overlap_box box_a = overlap_box_of(a), box_b = overlap_box_of(b);
    return 1000.0 * overlap_depth_m(&box_a, &box_b);
}

static void expect_depth(const struct fish *a, const struct fish *b, double expected_mm)
{
    assert_true(fabs(depth_mm(a, b) - expected_mm) < 1e-3);
    assert_true(fabs(depth_mm(b, a) - expected_mm) < 1e-3);
}

static void test_the_overlap_of_upright_boxes_is_the_smallest_face_depth(void **state)
{
    const struct fish a = fish_at(0, 0, 0);
    (void)state;
    const struct fish aside = fish_at(0.9, 0, 0), above = fish_at(0, 1.8, 0.5);
    const struct fish behind = fish_at(0.2, 0.3, 4.95), touching = fish_at(1.0, 0, 0);
    expect_depth(&a, &aside, 1.0);
    expect_depth(&a, &above, 2.0);
    expect_depth(&a, &behind, 0.5);
    expect_depth(&a, &touching, 0.0);
}

/* Fish b is turned by 90 degrees, so its length lies along x. Without an overlap, the centres are
 * at least 2.5 + 0.5 cm apart: half the length of b and half the width of a. */
static void test_the_extent_of_a_rotated_box_is_its_length(void **state)
{
    const struct fish a = fish_at(0, 0, 0);
    struct fish b = fish_at(2.7, 0, 0);
    (void)state;
    b.angles.yaw_rad = 0.5f * F_PI;
    expect_depth(&a, &b, 3.0);
    /* Fish b points upwards and is 5 cm high, so the boxes overlap by 1.3 cm vertically. The result
     * is the smaller overlap sideways: the full width of 1 cm. */
    b = fish_at(0, 2.2, 0);
    b.angles.pitch_rad = 0.5f * F_PI;
    expect_depth(&a, &b, 10.0);
    /* Fish b lies on its side. Without an overlap, the centres are at least 1 + 0.5 cm apart: half
     * the height of a and half the width of b. */
    b = fish_at(0, 1.3, 0);
    b.angles.roll_rad = 0.5f * F_PI;
    expect_depth(&a, &b, 2.0);
}

/* Two boxes stand on edges that are at right angles to each other. Along the normals of all faces,
 * the boxes seem to overlap. Only the cross product of the two edges separates them. */
static void test_crossed_edges_are_separated_by_an_edge_edge_axis(void **state)
{
    struct fish a = fish_at(0, 0, 0), b = fish_at(0, 0, 0);
    (void)state;
    a.height_m = a.width_m = b.height_m = b.width_m = 0.02f;
    /* Each box stands on an edge and is 2 * sqrt(2) cm high. */
    a.angles.roll_rad = b.angles.roll_rad = 0.25f * F_PI;
    b.angles.yaw_rad = 0.5f * F_PI;
    b.position_m.y = 0.0285f; /* The edges touch at a distance of 28.28 mm, so these boxes are
                                 separated. */
    expect_depth(&a, &b, 0.0);
    b.position_m.y = 0.0273f;
    assert_true(depth_mm(&a, &b) > 0.95 && depth_mm(&a, &b) < 1.0);
}

static void test_held_fish_and_fish_in_a_bowl_are_not_counted(void **state)
{
    struct overlap_count total = { 0 };
    (void)state;
    tank.size_m = v3(1.36f, 0.20f, 0.65f);
    tank.fish_count = 3;
    tank.fish[0] = tank.fish[1] = tank.fish[2] = fish_at(0, -5, 0);
    tank.fish[1].gait = GAIT_HELD;
    tank.fish[2].gait = GAIT_BOWL;
    overlap_add(&overlap, &tank, &total);
    assert_int_equal(total.pairs, 0);
    tank.fish[2].gait = GAIT_ESCAPE;
    overlap_add(&overlap, &tank, &total);
    assert_int_equal(total.pairs, 1);
    assert_true(fabs(total.deepest_mm - 10.0) < 1e-3);
}

static float draw(uint32_t seed, uint32_t fish, uint32_t which, float low, float high)
{
    return rng_range((struct rng_key){ seed, which, fish, RNG_FISH_LOOK }, low, high);
}

static void scatter(uint32_t seed, uint32_t count)
{
    tank.fish_count = count;
    for (uint32_t i = 0; i < count; i++) {
        struct fish *fish = &tank.fish[i];
        *fish = fish_at(0, 0, 0);
        /* Places the fish at random, in some cases outside the tank. */
        fish->position_m = v3(draw(seed, i, 1, -0.7f, 0.7f), draw(seed, i, 2, -0.2f, 0.0f),
                              draw(seed, i, 3, -0.34f, 0.34f));
        fish->angles.yaw_rad = draw(seed, i, 4, -3.1f, 3.1f);
        fish->angles.pitch_rad = draw(seed, i, 5, -1.5f, 1.5f);
        fish->angles.roll_rad = draw(seed, i, 6, -3.1f, 3.1f);
        fish->length_m = draw(seed, i, 7, 0.02f, 0.08f);
    }
}

static void test_the_grid_finds_the_same_overlaps_as_all_pairs(void **state)
{
    (void)state;
    for (uint32_t seed = 1; seed <= 5; seed++) {
        struct overlap_count total = { 0 };
        uint64_t expected = 0;
        double deepest_mm = 0.0;
        scatter(seed, 700);
        for (uint32_t i = 0; i < tank.fish_count; i++) {
            for (uint32_t j = 0; j < i; j++) {
                const double depth = depth_mm(&tank.fish[i], &tank.fish[j]);
                expected += depth > OVERLAP_DEEP_MM;
                deepest_mm = fmax(deepest_mm, depth);
            }
        }
        overlap_add(&overlap, &tank, &total);
        assert_true(expected > 100);
        assert_int_equal(total.pairs, expected);
        assert_true(fabs(total.deepest_mm - deepest_mm) < 1e-9);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_overlap_of_upright_boxes_is_the_smallest_face_depth),
        cmocka_unit_test(test_the_extent_of_a_rotated_box_is_its_length),
        cmocka_unit_test(test_crossed_edges_are_separated_by_an_edge_edge_axis),
        cmocka_unit_test(test_held_fish_and_fish_in_a_bowl_are_not_counted),
        cmocka_unit_test(test_the_grid_finds_the_same_overlaps_as_all_pairs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
