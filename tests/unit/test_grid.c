/* test_grid.c -- the grid holds every point once, and near points in neighbouring cells. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/base/rng.h"
#include "core/tank/grid.h"

static struct grid grid;
static struct body bodies[TANK_FISH_MAX];
static uint8_t flags[TANK_FISH_MAX];

static float draw(uint32_t who, uint32_t purpose, float low, float high)
{
    return rng_range((struct rng_key){ 5, 0, who, purpose }, low, high);
}

static void fill(uint32_t count)
{
    memset(flags, 1, sizeof flags);
    grid_fill(&grid, bodies, flags, 1, count);
}

static void fill_at_random(uint32_t count, float width, float breadth)
{
    for (uint32_t i = 0; i < count; i++) {
        /* Some lie outside. */
        bodies[i].centre_m = v3(draw(i, 1, -0.55f * width, 0.55f * width), 0.0f,
                                draw(i, 2, -0.55f * breadth, 0.55f * breadth));
    }
    fill(count);
}

static void test_every_point_is_in_its_own_cell_exactly_once(void **state)
{
    (void)state;
    grid_layout(&grid, 0.85f, 0.55f, 0.05f);
    fill_at_random(1000, 0.85f, 0.55f);
    uint8_t seen[1000] = { 0 };
    const uint32_t cells = grid.columns * grid.rows;
    assert_int_equal(grid.start[0], 0);
    assert_int_equal(grid.start[cells], 1000);
    for (uint32_t cell = 0; cell < cells; cell++) {
        for (uint32_t k = grid.start[cell]; k < grid.start[cell + 1u]; k++) {
            assert_int_equal(grid_cell(&grid, bodies[grid.item[k]].centre_m), cell);
            seen[grid.item[k]]++;
        }
    }
    for (uint32_t i = 0; i < 1000; i++) {
        assert_int_equal(seen[i], 1);
    }
}

static void test_points_within_reach_lie_in_neighbouring_cells(void **state)
{
    (void)state;
    const float reach = 0.0861f;
    grid_layout(&grid, 1.36f, 0.65f, reach);
    fill_at_random(800, 1.36f, 0.65f);
    for (uint32_t i = 0; i < 800; i++) {
        for (uint32_t j = 0; j < i; j++) {
            const float dx = bodies[i].centre_m.x - bodies[j].centre_m.x,
                        dz = bodies[i].centre_m.z - bodies[j].centre_m.z;
            if (dx * dx + dz * dz >= reach * reach) {
                continue;
            }
            const int32_t a = (int32_t)grid_cell(&grid, bodies[i].centre_m),
                          b = (int32_t)grid_cell(&grid, bodies[j].centre_m);
            const int32_t columns = (int32_t)grid.columns;
            assert_in_range((uint64_t)(a % columns - b % columns + 1), 0, 2);
            assert_in_range((uint64_t)(a / columns - b / columns + 1), 0, 2);
        }
    }
}

static void test_a_tiny_reach_makes_larger_cells_rather_than_too_many(void **state)
{
    (void)state;
    grid_layout(&grid, 2.0f, 2.0f, 0.001f);
    assert_true(grid.columns * grid.rows <= GRID_CELL_MAX);
    assert_true(grid.cell_m >= 0.001f);
    grid_layout(&grid, 2.0f, 2.0f, 5.0f);
    assert_int_equal(grid.columns * grid.rows, 1);
}

static void test_no_points_at_all_leave_every_cell_empty(void **state)
{
    (void)state;
    grid_layout(&grid, 0.85f, 0.55f, 0.1f);
    fill(0);
    assert_int_equal(grid.start[grid.columns * grid.rows], 0);
}

static void test_who_lacks_the_flag_is_left_out(void **state)
{
    (void)state;
    grid_layout(&grid, 0.85f, 0.55f, 0.1f);
    fill_at_random(100, 0.85f, 0.55f);
    for (uint32_t i = 0; i < 100; i++) {
        flags[i] = i % 3u == 0 ? 5 : 4;
    }
    grid_fill(&grid, bodies, flags, 1, 100);
    assert_int_equal(grid.count, 34);
    for (uint32_t k = 0; k < grid.count; k++) {
        assert_int_equal(grid.item[k] % 3u, 0);
    }
}

static void test_more_points_than_the_grid_holds_are_a_bug(void **state)
{
    (void)state;
    grid_layout(&grid, 0.85f, 0.55f, 0.1f);
    expect_assert_failure(grid_fill(&grid, bodies, flags, 1, TANK_FISH_MAX + 1u));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_point_is_in_its_own_cell_exactly_once),
        cmocka_unit_test(test_points_within_reach_lie_in_neighbouring_cells),
        cmocka_unit_test(test_a_tiny_reach_makes_larger_cells_rather_than_too_many),
        cmocka_unit_test(test_no_points_at_all_leave_every_cell_empty),
        cmocka_unit_test(test_who_lacks_the_flag_is_left_out),
        cmocka_unit_test(test_more_points_than_the_grid_holds_are_a_bug),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
