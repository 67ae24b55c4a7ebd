/* test_narrow_phase.c -- checks that the search for overlapping pairs finds the same pairs as a
 * test of all pairs.
 *
 * The fish are boxes of 5 x 2 x 1 cm with personal spaces of 7 x 4 x 3 cm, as in the 2013 thesis
 * (sections 3.1 and 3.4). Some tests use other sizes. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "core/tank/collision/narrow_phase.h"

#define COUNT_MAX 700u
#define FOUND_MAX (COUNT_MAX * COUNT_MAX / 2u)
/* Side of a grid cell in metres. The side equals the diagonal of a personal space of 7 x 4 x 3
 * cm. */
#define CELL_EXACT_M 0.08602f
#define ROUNDING_M 1e-6f

static struct narrow_phase pairs;
static struct body body[COUNT_MAX];
static uint8_t flags[COUNT_MAX];
static float reach_m[COUNT_MAX];
static struct narrow_phase_pair found[FOUND_MAX + NARROW_PHASE_BATCH + SIMD_LANES_MAX];
static struct narrow_phase_pair others[FOUND_MAX + NARROW_PHASE_BATCH + SIMD_LANES_MAX];
/* For each pair of fish, the index of the pair in `found` plus 1; 0 if the search did not find the
 * pair. */
static uint32_t listed[COUNT_MAX][COUNT_MAX];

static float draw(uint32_t who, uint32_t purpose, float low, float high)
{
    return rng_range((struct rng_key){ 31, 0, who, purpose }, low, high);
}

static void put(uint32_t index, vec3 centre_m, struct angles angles, float length_m)
{
    const struct box box = { centre_m,
                             vec_basis_from_angles(angles),
                             { 0.1f * length_m, 0.2f * length_m, 0.5f * length_m } };
    body[index] = body_of(&box, 0.2f * length_m);
    flags[index] = 1;
    reach_m[index] = 0.001f;
}

static struct angles any_angles(uint32_t who, float pitch_max, float roll_max)
{
    return (struct angles){ draw(who, 4, -F_PI, F_PI), draw(who, 5, -pitch_max, pitch_max),
                            draw(who, 6, -roll_max, roll_max) };
}

/* Places `count` fish at random positions in the thesis' tank. */
static void fill(uint32_t count, float pitch_max, float length_min, float length_max)
{
    for (uint32_t i = 0; i < count; i++) {
        const vec3 centre =
            v3(draw(i, 1, -0.68f, 0.68f), draw(i, 2, -0.20f, 0.0f), draw(i, 3, -0.325f, 0.325f));
        put(i, centre, any_angles(i, pitch_max, 0.0f), draw(i, 7, length_min, length_max));
    }
}

static uint32_t search(struct narrow_phase_pair *to, uint32_t count, uint8_t how, uint8_t lanes)
{
    const struct narrow_phase_query of = { .body = body,
                                           .flags = flags,
                                           .reach_m = reach_m,
                                           .count = count,
                                           .which = 1,
                                           .search = how,
                                           .lanes = lanes,
                                           .width_m = 1.36f,
                                           .breadth_m = 0.65f };
    uint32_t all = 0;
    /* Overwrites the structure with the byte 0x5a, because a search must not depend on old
     * contents. */
    memset(&pairs, 0x5a, sizeof pairs);
    narrow_phase_begin(&pairs, &of);
    for (uint32_t some; narrow_phase_next(&pairs, &of, &to[all], &some); all += some) {
        assert_true(some <= NARROW_PHASE_BATCH);
        assert_true(all <= FOUND_MAX);
    }
    return all;
}

static int same(const struct narrow_phase_pair *a, const struct narrow_phase_pair *b)
{
    return a->a == b->a && a->b == b->b && memcmp(&a->gap_m, &b->gap_m, sizeof a->gap_m) == 0 &&
           a->axis == b->axis && a->spaces == b->spaces;
}

/* Runs the search with every number of lanes and every search method. Each must find the same pairs
 * in the same order, bit for bit. */
static uint32_t search_every_way(uint32_t count)
{
    const uint32_t all = search(found, count, PAIR_SEARCH_GRID, 4);
    const uint8_t ways[][2] = { { PAIR_SEARCH_ALL, 4 },
                                { PAIR_SEARCH_GRID, SIMD_LANES_MAX },
                                { PAIR_SEARCH_ALL, SIMD_LANES_MAX } };
    for (uint32_t way = 0; way < sizeof ways / sizeof ways[0]; way++) {
        assert_int_equal(search(others, count, ways[way][0], ways[way][1]), all);
        for (uint32_t f = 0; f < all; f++) {
            assert_true(same(&found[f], &others[f]));
        }
    }
    return all;
}

/* Compares the search with box_gap() for every pair. Returns the number of pairs whose personal
 * spaces overlap. */
static uint32_t check(uint32_t count)
{
    const uint32_t all = search_every_way(count);
    uint32_t overlaps = 0;
    memset(listed, 0, sizeof listed);
    for (uint32_t f = 0; f < all; f++) {
        uint32_t *place = &listed[found[f].a][found[f].b];
        /* The search may find each pair only once. */
        assert_true(*place == 0 && listed[found[f].b][found[f].a] == 0);
        *place = listed[found[f].b][found[f].a] = f + 1u;
    }
    for (uint32_t i = 0; i < count; i++) {
        for (uint32_t j = i + 1u; j < count; j++) {
            const struct box a = body_box(&body[i]), b = body_box(&body[j]);
            const struct box_gap gap = box_gap(&a, body[i].margin_m, &b, body[j].margin_m);
            /* The margins of 1 m are so large that box_gap() computes the exact gap. */
            const float gap_m = box_gap(&a, 1.0f, &b, 1.0f).body_m;
            const int both = flags[i] & flags[j] & 1;
            const int near =
                gap.space_m < -ROUNDING_M || gap_m < reach_m[i] + reach_m[j] - ROUNDING_M;
            const int far =
                gap.space_m > ROUNDING_M && gap_m > reach_m[i] + reach_m[j] + ROUNDING_M;
            const uint32_t place = listed[i][j];
            overlaps += gap.space_m < 0.0f;
            assert_false(near && both && place == 0);
            assert_false((far || !both) && place != 0);
            if (place != 0) {
                assert_float_equal(found[place - 1u].gap_m, gap_m, ROUNDING_M);
            }
        }
    }
    return overlaps;
}

static void test_random_pairs_are_found_at_every_pitch(void **state)
{
    (void)state;
    for (int pitch_deg = 0; pitch_deg <= 90; pitch_deg += 30) {
        fill(600, (float)pitch_deg * F_DEG, 0.05f, 0.05f);
        const uint32_t overlaps = check(600);
        print_message("pitched within %d degrees: %.2f overlaps a fish\n", pitch_deg,
                      (double)overlaps / 600.0);
        assert_in_range(overlaps, 600, 1200);
    }
}

static void test_pairs_of_mixed_sizes_are_found(void **state)
{
    (void)state;
    fill(600, 0.5f, 0.03f, 0.08f);
    for (uint32_t i = 0; i < 600; i++) {
        put(i, body[i].centre_m, any_angles(i, 1.5f, F_PI), 2.0f * body[i].half_z_m);
    }
    assert_true(check(600) > 600);
}

static void test_pairs_of_vertical_fish_are_found(void **state)
{
    (void)state;
    fill(600, 0.5f, 0.05f, 0.05f);
    for (uint32_t i = 0; i < 600; i++) {
        const float pitch = i % 2u == 0 ? 90.0f * F_DEG : -90.0f * F_DEG;
        put(i, body[i].centre_m, (struct angles){ draw(i, 4, -F_PI, F_PI), pitch, 0.0f }, 0.05f);
    }
    assert_true(check(600) > 500);
}

static void test_pairs_outside_the_grid_are_found(void **state)
{
    (void)state;
    fill(400, 0.5f, 0.05f, 0.05f);
    for (uint32_t i = 0; i < 400; i++) {
        /* The grid extends to x = 0.68 m and z = 0.325 m, so most of these fish are outside the
         * grid. */
        body[i].centre_m =
            v3(draw(i, 1, 0.5f, 1.2f), draw(i, 2, -0.2f, 0.1f), draw(i, 3, 0.2f, 0.7f));
    }
    assert_true(check(400) > 200);
}

static void test_all_pairs_in_one_cell_are_found(void **state)
{
    (void)state;
    fill(COUNT_MAX, 0.5f, 0.05f, 0.05f);
    /* Places all fish in one cell. Their 244,650 pairs fill many batches, and a batch may end
     * between two pairs of the same fish. */
    for (uint32_t i = 0; i < COUNT_MAX; i++) {
        body[i].centre_m = v3(draw(i, 1, 0.0f, 0.01f), -0.1f, draw(i, 3, 0.0f, 0.01f));
    }
    assert_int_equal(check(COUNT_MAX), COUNT_MAX * (COUNT_MAX - 1u) / 2u);
}

/* The pairs of fish are placed around the corners of cells and across the borders between cells. */
static void test_pairs_at_the_corners_of_cells_are_found(void **state)
{
    (void)state;
    uint32_t count = 0;
    for (uint32_t row = 0; row < 7u; row++) {
        for (uint32_t column = 0; column < 15u; column++) {
            const vec3 corner = v3(-0.68f + CELL_EXACT_M * (float)(column + 1u), -0.1f,
                                   -0.325f + CELL_EXACT_M * (float)(row + 1u));
            const float yaw = F_PI * 0.25f * (float)(column % 4u);
            const vec3 along = v3(-f_sin(yaw), 0.0f, -f_cos(yaw));
            /* Places two fish nose to nose on both sides of the corner, so that their spaces
             * overlap by 0.2 mm. */
            for (uint32_t end = 0; end < 2u; end++) {
                const vec3 at = v3_muladd(corner, along, end == 0 ? 0.0349f : -0.0349f);
                put(count++, at, (struct angles){ yaw, 0.0f, 0.0f }, 0.05f);
            }
        }
    }
    assert_true(check(count) >= 105u);
}

/* Two spaces that touch have the greatest possible distance if their corners touch along the
 * diagonal. The search must find even such a pair in neighbouring cells. */
static void test_the_farthest_pair_that_overlaps_lies_within_one_cell(void **state)
{
    (void)state;
    uint32_t overlaps = 0;
    for (uint32_t shift = 0; shift < 200; shift++) {
        /* Rotates the box so that its diagonal is horizontal, because the grid uses only horizontal
         * distances. */
        put(0, v3(0.0005f * (float)shift, -0.1f, 0.0f), (struct angles){ 0.5f, 0.3f, 0.2f }, 0.05f);
        body[1] = body[0];
        const struct body *a = &body[0];
        vec3 corner = v3_add(v3_scale(a->right, 0.015f), v3_scale(a->up, 0.02f));
        corner = v3_muladd(corner, a->back, 0.035f);
        body[1].centre_m = v3_muladd(a->centre_m, corner, 1.9999f);
        flags[1] = 1;
        reach_m[1] = 0.001f;
        overlaps += check(2);
    }
    assert_int_equal(overlaps, 200);
    assert_float_equal(v3_length(v3_sub(body[1].centre_m, body[0].centre_m)), CELL_EXACT_M, 1e-4f);
}

static void test_a_fish_with_a_large_space_is_found_at_a_distance(void **state)
{
    (void)state;
    fill(600, 0.3f, 0.05f, 0.05f);
    for (uint32_t i = 0; i < 600; i += 50) {
        reach_m[i] = 0.03f;
    }
    const uint32_t all = search_every_way(600);
    uint32_t far = 0;
    (void)check(600);
    for (uint32_t f = 0; f < all; f++) {
        far += !found[f].spaces;
    }
    assert_true(far > 10);
}

static void test_a_fish_without_the_flag_is_not_found(void **state)
{
    (void)state;
    fill(600, 0.3f, 0.05f, 0.05f);
    for (uint32_t i = 0; i < 600; i += 3) {
        flags[i] = 6;
    }
    (void)check(600);
    memset(flags, 0, sizeof flags);
    assert_int_equal(search_every_way(600), 0);
    assert_int_equal(search_every_way(0), 0);
}

/* If two boxes are projected on the returned axis, the distance of the projections must equal the
 * returned gap. */
static void test_the_axis_of_a_pair_has_the_pairs_gap(void **state)
{
    (void)state;
    uint32_t by_edges = 0;
    fill(600, 1.0f, 0.03f, 0.08f);
    const uint32_t all = search(found, 600, PAIR_SEARCH_GRID, SIMD_LANES_MAX);
    for (uint32_t f = 0; f < all; f++) {
        const struct body *a = &body[found[f].a], *b = &body[found[f].b];
        const vec3 axis = narrow_phase_axis(a, b, found[f].axis),
                   d = v3_sub(b->centre_m, a->centre_m);
        const struct body *const both[2] = { a, b };
        float gap_m = v3_dot(axis, d);
        for (int which = 0; which < 2; which++) {
            gap_m -= f_abs(v3_dot(axis, both[which]->right)) * both[which]->half_x_m +
                     f_abs(v3_dot(axis, both[which]->up)) * both[which]->half_y_m +
                     f_abs(v3_dot(axis, both[which]->back)) * both[which]->half_z_m;
        }
        assert_float_equal(v3_length(axis), 1.0f, 1e-5f);
        assert_float_equal(gap_m, found[f].gap_m, 2e-6f);
        by_edges += found[f].axis >= 6u;
    }
    print_message("%u of %u pairs are parted by edges\n", by_edges, all);
    assert_true(by_edges > all / 20u);
}

/* Returns the share of the overlapping pairs whose fish are not in neighbouring cells. The grid has
 * `columns` x `rows` cells. */
static float missed_by_cells(float columns, float rows)
{
    uint32_t overlaps = 0, missed = 0;
    const uint32_t all = search(found, 600, PAIR_SEARCH_GRID, SIMD_LANES_MAX);
    for (uint32_t f = 0; f < all; f++) {
        if (found[f].spaces) {
            const vec3 a = body[found[f].a].centre_m, b = body[found[f].b].centre_m;
            const float across =
                f_floor((a.x + 0.68f) * columns / 1.36f) - f_floor((b.x + 0.68f) * columns / 1.36f);
            const float down =
                f_floor((a.z + 0.325f) * rows / 0.65f) - f_floor((b.z + 0.325f) * rows / 0.65f);
            missed += f_abs(across) > 1.0f || f_abs(down) > 1.0f;
            overlaps++;
        }
    }
    return (float)missed / (float)overlaps;
}

/* Section 3.7 of the thesis uses 40 x 20 cells of about 3.5 cm, and searches the nine cells around
 * each fish. This test shows how many pairs such a search misses. */
static void test_the_thesis_cells_miss_a_quarter_of_the_pairs(void **state)
{
    (void)state;
    fill(600, 30.0f * F_DEG, 0.05f, 0.05f);
    const float thesis = missed_by_cells(40.0f, 20.0f);
    const float middle = missed_by_cells(1.36f / 0.07f, 0.65f / 0.07f);
    const float exact = missed_by_cells(1.36f / CELL_EXACT_M, 0.65f / CELL_EXACT_M);
    print_message("40 x 20 cells of 3.5 cm miss %.1f %% of the pairs that overlap, those of 7 cm "
                  "%.1f %%, of 8.602 cm %.1f %%\n",
                  100.0 * (double)thesis, 100.0 * (double)middle, 100.0 * (double)exact);
    assert_true(thesis > 0.18f && thesis < 0.28f);
    assert_true(exact == 0.0f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_random_pairs_are_found_at_every_pitch),
        cmocka_unit_test(test_pairs_of_mixed_sizes_are_found),
        cmocka_unit_test(test_pairs_of_vertical_fish_are_found),
        cmocka_unit_test(test_pairs_outside_the_grid_are_found),
        cmocka_unit_test(test_all_pairs_in_one_cell_are_found),
        cmocka_unit_test(test_pairs_at_the_corners_of_cells_are_found),
        cmocka_unit_test(test_the_farthest_pair_that_overlaps_lies_within_one_cell),
        cmocka_unit_test(test_a_fish_with_a_large_space_is_found_at_a_distance),
        cmocka_unit_test(test_a_fish_without_the_flag_is_not_found),
        cmocka_unit_test(test_the_axis_of_a_pair_has_the_pairs_gap),
        cmocka_unit_test(test_the_thesis_cells_miss_a_quarter_of_the_pairs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
