/* test_tear.c -- checks holes in the paper: the stress at the ends of a hole, its shape, and paper
 * that comes loose. */
#include "tests/unit/support/poi_fixture.h"

#include "core/base/rng.h"
#include "core/poi/paper/strain.h"

#define RADIUS_M 0.040f
#define MIDDLE (SHEET_SIDE / 2u)

static const struct sheet_wetting in_air = { 0.0f, 0.0f, -1.0f };
static struct sheet sheet;

static void plain(uint8_t grade)
{
    sheet_init(&sheet, grade, RADIUS_M, 1);
    fixture_plain_paper(&sheet, 1.0f);
    sheet.soaked = 1;
    sheet.fibre_x = 1.0f;
    sheet.fibre_z = 0.0f;
}

static void cut(uint32_t row, uint32_t column)
{
    uint8_t *state = &sheet.state[row * SHEET_SIDE + column];
    sheet.paper_cells -= *state == CELL_PAPER;
    *state = CELL_HOLE;
}

static uint32_t state_at(uint32_t row, uint32_t column)
{
    return sheet.state[row * SHEET_SIDE + column];
}

static float factor_at(uint32_t row, uint32_t column)
{
    const struct tear_map map = tear_map_of(&sheet);
    return tear_factor(&map, &sheet, row, column);
}

static void test_stress_beside_a_hole_rises_with_the_root_of_its_length(void **state)
{
    (void)state;
    plain(5);
    /* Makes the fibres diagonal, so that they favour neither rows nor columns. The stress factors
     * then depend only on the length of the slit. */
    sheet.fibre_x = sheet.fibre_z = 0.70710678f;
    const float factors[] = { 2.5f, 3.5355f, 4.0f, 4.0f, 4.0f };
    for (uint32_t i = 0; i < 5; i++) {
        cut(MIDDLE, 10u + i);
        assert_float_equal(factor_at(MIDDLE, 11u + i), factors[i], 1e-3f);
        assert_float_equal(factor_at(MIDDLE, 9u), factors[i], 1e-3f);
        /* The cell touches no hole, so it has no stress concentration. This is stored as the factor
         * 0. */
        assert_float_equal(factor_at(MIDDLE, 16u), 0.0f, 0.0f);
    }
    plain(5);
    sheet.fibre_x = sheet.fibre_z = 0.70710678f;
    cut(MIDDLE, MIDDLE);
    /* The two holes touch at a corner, so they form one slit, which is 2.8 cells long. */
    cut(MIDDLE - 1u, MIDDLE + 1u);
    assert_float_equal(factor_at(MIDDLE, MIDDLE - 1u), 4.0f, 1e-3f);
    assert_float_equal(factor_at(MIDDLE - 1u, MIDDLE + 2u), 4.0f, 1e-3f);
}

static void test_hole_measurements_equal_those_of_a_scan_of_each_hole(void **state)
{
    (void)state;
    plain(5);
    for (uint32_t i = 0; i < 220; i++) {
        const struct rng_key key = { 5, i, 0, RNG_TEST }, other = { 5, i, 1, RNG_TEST };
        cut((uint32_t)(32.0f * rng_unit(key)), (uint32_t)(32.0f * rng_unit(other)));
    }
    const struct tear_map map = tear_map_of(&sheet);
    for (uint32_t i = 0; i < SHEET_CELL_COUNT; i++) {
        const int32_t row = (int32_t)(i / SHEET_SIDE), column = (int32_t)(i % SHEET_SIDE);
        int32_t best = 0;
        for (int32_t way = 0; way < 4 && sheet.state[i] == CELL_HOLE; way++) {
            const int32_t dr = way == 0 ? 0 : 1, dc = way == 1 ? 0 : way == 3 ? -1 : 1;
            int32_t length = 1;
            for (int32_t sign = -1; sign <= 1; sign += 2) {
                int32_t r = row + sign * dr, c = column + sign * dc;
                while (r >= 0 && c >= 0 && r < 32 && c < 32 &&
                       sheet.state[r * 32 + c] == CELL_HOLE) {
                    length++;
                    r += sign * dr;
                    c += sign * dc;
                }
            }
            /* Diagonal neighbours are farther apart than others, so a diagonal slit of two cells
             * already has the highest level, 3. */
            const int32_t level = way > 1 && length > 1 ? 3 : length;
            best = level > best ? level : best;
        }
        assert_int_equal(map.wide[row] >> column & 1u, best >= 3);
        assert_int_equal((map.pair[row] | map.wide[row]) >> column & 1u, best >= 2);
    }
}

static void test_tears_follow_the_fibres(void **state)
{
    (void)state;
    plain(5);
    cut(MIDDLE, MIDDLE);
    assert_float_equal(factor_at(MIDDLE, MIDDLE + 1u), 2.5f * 1.08f, 1e-3f);
    assert_float_equal(factor_at(MIDDLE + 1u, MIDDLE), 2.5f * 0.92f, 1e-3f);
    assert_true(factor_at(MIDDLE + 1u, MIDDLE + 1u) < factor_at(MIDDLE, MIDDLE + 1u));
}

static void test_the_front_is_the_paper_that_touches_a_hole(void **state)
{
    (void)state;
    plain(5);
    cut(MIDDLE, MIDDLE);
    const struct tear_map map = tear_map_of(&sheet);
    assert_int_equal(tear_front(&map, MIDDLE - 2u), 0);
    assert_int_equal(tear_front(&map, MIDDLE - 1u), 7u << (MIDDLE - 1u));
    assert_int_equal(tear_front(&map, MIDDLE), 5u << (MIDDLE - 1u));
    assert_int_equal(tear_front(&map, MIDDLE + 1u), 7u << (MIDDLE - 1u));
}

static uint32_t drop(void)
{
    struct tear_map map = tear_map_of(&sheet);
    const uint32_t dropped = tear_drop_loose(&map, &sheet);
    const struct tear_map again = tear_map_of(&sheet);
    assert_memory_equal(&map, &again, sizeof map);
    return dropped;
}

static void test_paper_with_a_slit_detaches_no_cells(void **state)
{
    (void)state;
    plain(5);
    assert_int_equal(drop(), 0);
    for (uint32_t column = 4; column < 28; column++) {
        cut(MIDDLE, column);
    }
    assert_int_equal(drop(), 0);
    for (uint32_t column = 0; column < SHEET_SIDE; column++) {
        /* At the end, the slit reaches from ring to ring. Both halves of the paper are still
         * attached to the ring, so nothing drops. */
        cut(MIDDLE, column);
    }
    assert_int_equal(drop(), 0);
}

static void test_an_island_of_paper_is_removed(void **state)
{
    (void)state;
    plain(5);
    for (uint32_t i = 0; i < 9; i++) {
        cut(10, 10u + i);
        cut(18, 10u + i);
        cut(10u + i, 10);
        cut(10u + i, 18);
    }
    assert_int_equal(drop(), 7u * 7u);
    assert_int_equal(state_at(14, 14), CELL_HOLE);
    assert_int_equal(state_at(14, 9), CELL_PAPER);
}

static void test_a_flap_carries_no_load(void **state)
{
    (void)state;
    plain(5);
    /* Cuts three sides of a rectangular flap. The flap is then attached only at its upper side. */
    for (uint32_t i = 0; i < 9; i++) {
        cut(20, 12u + i);
        cut(12u + i, 12);
        cut(12u + i, 20);
    }
    /* Most of the 7 x 8 cells of the flap must drop. The cells at the attached side stay, because
     * diagonal neighbours hold them. */
    assert_true(drop() >= 30);
    assert_int_equal(state_at(18, 16), CELL_HOLE);
    assert_int_equal(state_at(10, 16), CELL_PAPER);
    assert_int_equal(state_at(16, 10), CELL_PAPER);
}

static void test_a_hole_reduces_the_load_by_its_area(void **state)
{
    (void)state;
    plain(4);
    for (uint32_t row = 1; row < 6; row++) {
        for (uint32_t column = 12; column < 20; column++) {
            cut(row, column);
        }
    }
    const float left = sheet_left(&sheet);
    assert_float_equal(left, 0.95f, 0.01f);
    /* The weight of this load is negligible. It must not be exactly 0, because sheet_tick() would
     * then skip it. */
    const struct sheet_load foot = { 0.0f, 0.02f, 0.02f, -1e-6f };
    const struct sheet_events events = sheet_tick(&sheet, 20.0f, in_air, &foot, 1);
    const float whole = sheet_tension_centre(sheet_grade(4), 20.0f * left, RADIUS_M);
    assert_float_equal(events.tension_max_n_m, whole, 0.005f * whole);
}

/* Returns the number of columns to which a tear has grown from the middle, in the middle row. */
static uint32_t reach(void)
{
    uint32_t far = 0;
    for (uint32_t column = MIDDLE; column < SHEET_SIDE; column++) {
        far = state_at(MIDDLE, column) == CELL_HOLE ? column - MIDDLE : far;
    }
    return far;
}

static void test_a_tear_grows_several_cells_a_tick_but_no_faster_than_its_steps(void **state)
{
    (void)state;
    plain(6);
    cut(MIDDLE, MIDDLE);
    /* The pressure of 250 Pa only tears paper that already has a hole. */
    sheet_tick(&sheet, 250.0f, in_air, NULL, 0);
    const uint32_t first = reach();
    assert_in_range(first, 4, SHEET_STEPS_MAX);
    sheet_tick(&sheet, 250.0f, in_air, NULL, 0);
    assert_true(reach() > first);
    plain(6);
    for (uint32_t i = 0; i < 3; i++) {
        assert_int_equal(sheet_tick(&sheet, 250.0f, in_air, NULL, 0).cells_torn, 0);
    }
}

static void test_holes_carry_no_stress_while_they_grow(void **state)
{
    (void)state;
    for (uint32_t seed = 0; seed < 12; seed++) {
        sheet_init(&sheet, 7, RADIUS_M, seed);
        fixture_plain_paper(&sheet, 1.0f);
        for (uint32_t t = 0; t < 40; t++) {
            const uint32_t was = sheet.paper_cells;
            const struct sheet_events events = sheet_tick(&sheet, 130.0f, in_air, NULL, 0);
            uint32_t left = 0;
            for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
                left += sheet.state[cell] == CELL_PAPER;
                assert_true(sheet.state[cell] == CELL_PAPER || sheet.stress[cell] == 0);
            }
            assert_int_equal(sheet.paper_cells, left);
            assert_int_equal(events.cells_torn, was - left);
        }
        assert_true(sheet_left(&sheet) < 0.9f);
    }
}

static void test_paper_breaks_after_the_same_time_in_small_steps_and_large(void **state)
{
    (void)state;
    /* A cell that touches no hole and is loaded to 80 % of its strength breaks after 0.05 s /
     * 0.8^10 = 0.466 s, which is 56 ticks. */
    plain(5);
    sheet_idealise(&sheet);
    const float goal = 0.8f * sheet_grade(5)->wet_n_m;
    float pressure_pa = 50.0f;
    while (sheet_tension_centre(sheet_grade(5), pressure_pa, RADIUS_M) < goal) {
        pressure_pa *= 1.001f;
    }
    uint32_t ticks = 1;
    while (sheet_tick(&sheet, pressure_pa, in_air, NULL, 0).cells_torn == 0 && ticks < 200) {
        ticks++;
    }
    assert_in_range(ticks, 54, 59);
}

/* Computes the elongation of the hole from its second moments. Writes the ratio of the longer to
 * the shorter axis, and the angle between the longer axis and the fibres. */
static void shape(float *aspect, float *off_rad)
{
    float n = 0.0f, x = 0.0f, z = 0.0f, xx = 0.0f, xz = 0.0f, zz = 0.0f;
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        if (sheet.state[cell] == CELL_HOLE) {
            const float column = (float)(cell % SHEET_SIDE), row = (float)(cell / SHEET_SIDE);
            n += 1.0f;
            x += column;
            z += row;
            xx += column * column;
            xz += column * row;
            zz += row * row;
        }
    }
    xx = xx / n - x * x / (n * n) + 1.0f / 12.0f;
    zz = zz / n - z * z / (n * n) + 1.0f / 12.0f;
    xz = xz / n - x * z / (n * n);
    const float half = 0.5f * (xx - zz), wide = f_sqrt(half * half + xz * xz);
    const float middle = 0.5f * (xx + zz);
    *aspect = f_sqrt((middle + wide) / f_max(middle - wide, 1e-3f));
    const float axis = 0.5f * f_atan2(2.0f * xz, xx - zz);
    const float off = f_wrap_angle(2.0f * (axis - f_atan2(sheet.fibre_z, sheet.fibre_x)));
    *off_rad = 0.5f * f_abs(off);
}

static void test_holes_are_longer_along_the_fibres(void **state)
{
    (void)state;
    float aspects = 0.0f, offs = 0.0f;
    for (uint32_t i = 0; i < 24; i++) {
        plain(6);
        sheet.fibre_x = f_cos(F_PI * (float)i / 24.0f);
        sheet.fibre_z = f_sin(F_PI * (float)i / 24.0f);
        cut(MIDDLE, MIDDLE);
        float aspect, off;
        for (uint32_t t = 0; t < 6000 && sheet_left(&sheet) > 0.95f; t++) {
            sheet_tick(&sheet, 60.0f, in_air, NULL, 0);
        }
        assert_in_range(100.0f * sheet_left(&sheet), 60, 95);
        shape(&aspect, &off);
        aspects += aspect / 24.0f;
        offs += off / 24.0f;
    }
    print_message("aspect %.2f, %.0f degrees off\n", (double)aspects, (double)(offs / F_DEG));
    assert_true(aspects > 1.5f);
    /* If the holes had random directions, they would differ from the fibres by 45 degrees on
     * average. */
    assert_true(offs < 20.0f * F_DEG);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_stress_beside_a_hole_rises_with_the_root_of_its_length),
        cmocka_unit_test(test_hole_measurements_equal_those_of_a_scan_of_each_hole),
        cmocka_unit_test(test_tears_follow_the_fibres),
        cmocka_unit_test(test_the_front_is_the_paper_that_touches_a_hole),
        cmocka_unit_test(test_paper_with_a_slit_detaches_no_cells),
        cmocka_unit_test(test_an_island_of_paper_is_removed),
        cmocka_unit_test(test_a_flap_carries_no_load),
        cmocka_unit_test(test_a_hole_reduces_the_load_by_its_area),
        cmocka_unit_test(test_a_tear_grows_several_cells_a_tick_but_no_faster_than_its_steps),
        cmocka_unit_test(test_holes_carry_no_stress_while_they_grow),
        cmocka_unit_test(test_paper_breaks_after_the_same_time_in_small_steps_and_large),
        cmocka_unit_test(test_holes_are_longer_along_the_fibres),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
