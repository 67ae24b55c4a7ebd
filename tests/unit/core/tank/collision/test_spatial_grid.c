/* test_spatial_grid.c -- checks that the grid contains every point exactly once. Points that are
 * near each other must be in neighbouring cells. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "core/tank/collision/narrow_phase.h"

static struct spatial_grid grid;
static vec3 points[TANK_FISH_MAX];
static fish_index member[TANK_FISH_MAX + 1u];

static float draw(uint32_t who, uint32_t purpose, float low, float high)
{
    return rng_range((struct rng_key){ 5, 0, who, purpose }, low, high);
}

/* Returns the index of a point's cell. A point outside the grid belongs to the nearest cell at the
 * border. */
static uint32_t cell_at(const struct spatial_grid *plan, vec3 point_m)
{
    const float x = (point_m.x - plan->origin_x_m) * plan->cells_per_m;
    const float z = (point_m.z - plan->origin_z_m) * plan->cells_per_m;
    return (uint32_t)f_clamp(z, 0.0f, (float)(plan->rows - 1u)) * plan->columns +
           (uint32_t)f_clamp(x, 0.0f, (float)(plan->columns - 1u));
}

static void fill(uint32_t count)
{
    for (uint32_t m = 0; m < count; m++) {
        member[m] = (fish_index)m;
        grid.cell_of[m] = (fish_index)cell_at(&grid, points[m]);
    }
    narrow_grid_sort(&grid, member, count);
}

static void fill_at_random(uint32_t count, float width, float breadth)
{
    for (uint32_t i = 0; i < count; i++) {
        /* Some of these points lie outside the grid. */
        points[i] = v3(draw(i, 1, -0.55f * width, 0.55f * width), 0.0f,
                       draw(i, 2, -0.55f * breadth, 0.55f * breadth));
    }
    fill(count);
}

static void test_every_point_is_in_its_own_cell_exactly_once(void **state)
{
    (void)state;
    narrow_grid_layout(&grid, 0.85f, 0.55f, 0.05f, TANK_FISH_MAX);
    fill_at_random(1000, 0.85f, 0.55f);
    uint8_t seen[1000] = { 0 };
    const uint32_t cells = grid.columns * grid.rows;
    assert_int_equal(grid.start[0], 0);
    assert_int_equal(grid.start[cells], 1000);
    for (uint32_t cell = 0; cell < cells; cell++) {
        for (uint32_t k = grid.start[cell]; k < grid.start[cell + 1u]; k++) {
            assert_int_equal(cell_at(&grid, points[grid.item[k]]), cell);
            seen[grid.item[k]]++;
        }
    }
    for (uint32_t i = 0; i < 1000; i++) {
        assert_int_equal(seen[i], 1);
    }
}

static void test_points_within_the_query_radius_lie_in_neighbouring_cells(void **state)
{
    (void)state;
    const float reach = 0.0861f;
    narrow_grid_layout(&grid, 1.36f, 0.65f, reach, TANK_FISH_MAX);
    fill_at_random(800, 1.36f, 0.65f);
    for (uint32_t i = 0; i < 800; i++) {
        for (uint32_t j = 0; j < i; j++) {
            const float dx = points[i].x - points[j].x, dz = points[i].z - points[j].z;
            if (dx * dx + dz * dz >= reach * reach) {
                continue;
            }
            const int32_t a = (int32_t)cell_at(&grid, points[i]),
                          b = (int32_t)cell_at(&grid, points[j]);
            const int32_t columns = (int32_t)grid.columns;
            assert_in_range((uint64_t)(a % columns - b % columns + 1), 0, 2);
            assert_in_range((uint64_t)(a / columns - b / columns + 1), 0, 2);
        }
    }
}

static void test_a_tiny_query_radius_gives_larger_cells(void **state)
{
    (void)state;
    narrow_grid_layout(&grid, 2.0f, 2.0f, 0.001f, TANK_FISH_MAX);
    assert_true(grid.columns * grid.rows <= SPATIAL_GRID_CELL_MAX);
    assert_true(grid.cell_m >= 0.001f);
    narrow_grid_layout(&grid, 2.0f, 2.0f, 5.0f, TANK_FISH_MAX);
    assert_int_equal(grid.columns * grid.rows, 1);
}

static void test_a_grid_without_points_has_empty_cells(void **state)
{
    (void)state;
    narrow_grid_layout(&grid, 0.85f, 0.55f, 0.1f, TANK_FISH_MAX);
    fill(0);
    assert_int_equal(grid.start[grid.columns * grid.rows], 0);
}

static void test_members_of_a_cell_keep_their_order(void **state)
{
    (void)state;
    narrow_grid_layout(&grid, 0.85f, 0.55f, 0.1f, TANK_FISH_MAX);
    fill_at_random(500, 0.85f, 0.55f);
    for (uint32_t cell = 0; cell < grid.columns * grid.rows; cell++) {
        for (uint32_t k = grid.start[cell] + 1u; k < grid.start[cell + 1u]; k++) {
            assert_true(grid.item[k] > grid.item[k - 1u]);
        }
    }
}

/* Each cell visits only half of its neighbours. All cells together must visit each pair of
 * neighbouring cells exactly once. */
static void test_a_half_neighbourhood_visits_each_pair_of_cells_once(void **state)
{
    (void)state;
    narrow_grid_layout(&grid, 0.85f, 0.55f, 0.1f, TANK_FISH_MAX);
    fill_at_random(500, 0.85f, 0.55f);
    for (uint32_t i = 0; i < grid.count; i++) {
        const uint32_t a = cell_at(&grid, points[grid.item[i]]);
        const struct grid_range beside = narrow_grid_beside(&grid, a),
                                below = narrow_grid_below(&grid, a);
        assert_int_equal(beside.from, grid.start[a]);
        assert_int_equal(narrow_grid_cell_of_item(&grid, i, 0), a);
        for (uint32_t j = i + 1u; j < grid.count; j++) {
            const uint32_t b = cell_at(&grid, points[grid.item[j]]);
            const int32_t columns = (int32_t)grid.columns;
            const int32_t across = (int32_t)(b % grid.columns) - (int32_t)(a % grid.columns);
            const int32_t down = (int32_t)b / columns - (int32_t)a / columns;
            const int meets =
                (j >= beside.from && j < beside.to) + (j >= below.from && j < below.to);
            assert_int_equal(meets, across >= -1 && across <= 1 && down <= 1);
        }
    }
}

static void test_too_many_points_fail_an_assertion(void **state)
{
    (void)state;
    narrow_grid_layout(&grid, 0.85f, 0.55f, 0.1f, TANK_FISH_MAX);
    expect_assert_failure(narrow_grid_sort(&grid, member, TANK_FISH_MAX + 1u));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_point_is_in_its_own_cell_exactly_once),
        cmocka_unit_test(test_points_within_the_query_radius_lie_in_neighbouring_cells),
        cmocka_unit_test(test_a_tiny_query_radius_gives_larger_cells),
        cmocka_unit_test(test_a_grid_without_points_has_empty_cells),
        cmocka_unit_test(test_members_of_a_cell_keep_their_order),
        cmocka_unit_test(test_a_half_neighbourhood_visits_each_pair_of_cells_once),
        cmocka_unit_test(test_too_many_points_fail_an_assertion),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
