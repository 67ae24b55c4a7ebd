/* test_wetting.c -- checks water in the paper: wetting, wicking (the spread of water in the paper),
 * the line between wet and dry paper, and softening. */
#include "tests/unit/support/poi_fixture.h"

#include "core/poi/paper/strain.h"

#define RADIUS_M 0.040f
#define MIDDLE (SHEET_SIDE / 2u)

static const struct sheet_wetting in_air = { 0.0f, 0.0f, -1.0f };
static const struct sheet_wetting left_half = { 1.0f, 0.0f, 0.0f };
static struct sheet sheet;

static void soak(struct sheet_wetting wet, float seconds)
{
    for (uint32_t i = 0; (float)i < seconds * (float)CORE_TICK_HZ; i++) {
        paper_wetting_tick(&sheet, wet);
    }
}

/* Returns the distance in metres by which the water has wicked from the water line. The end is the
 * point where the wetness is 0.33, which is interpolated between cells. */
static float front_m(void)
{
    const float *row = &sheet.wetness[MIDDLE * SHEET_SIDE];
    for (uint32_t column = MIDDLE; column < SHEET_SIDE; column++) {
        if (row[column] < 0.33f) {
            const float share = (row[column - 1u] - 0.33f) / (row[column - 1u] - row[column]);
            return ((float)(column - MIDDLE) - 0.5f + share) * sheet_cell_m(&sheet);
        }
    }
    return 1.0f;
}

static void test_the_wet_front_advances_with_the_root_of_time(void **state)
{
    (void)state;
    float fronts[4];
    sheet_init(&sheet, 5, RADIUS_M, 1);
    soak(left_half, 16.0f);
    /* Measures the distance of the wet front after 16, 64, 144 and 256 s. The square roots of these
     * times are 4, 8, 12 and 16. */
    for (uint32_t i = 0; i < 4; i++) {
        const float root = (float)(i + 1u);
        fronts[i] = front_m();
        soak(left_half, 16.0f * (2.0f * root + 1.0f));
    }
    /* The first measurement is not compared, because the wet front is still within one cell of the
     * water line. */
    assert_float_equal(fronts[2] / fronts[1], 1.5f, 0.08f);
    assert_float_equal(fronts[3] / fronts[1], 2.0f, 0.12f);
    /* The wicking coefficient of the paper is 0.0014 m per root of a second. The number 16 is the
     * root of 256 s. */
    assert_float_equal(fronts[3] / 16.0f, 0.0014f, 0.0002f);
}

static void test_water_wicks_in_air_and_never_leaves_wet_paper(void **state)
{
    (void)state;
    sheet_init(&sheet, 5, RADIUS_M, 1);
    soak(left_half, 6.0f);
    const uint32_t dry = MIDDLE * SHEET_SIDE + MIDDLE, wet = dry - 2u;
    const float was_dry = sheet.wetness[dry], was_wet = sheet.wetness[wet];
    soak(in_air, 10.0f);
    assert_true(sheet.wetness[dry] > was_dry + 0.1f);
    assert_true(sheet.wetness[wet] >= was_wet);
}

static void test_dry_paper_in_air_stays_dry(void **state)
{
    (void)state;
    sheet_init(&sheet, 5, RADIUS_M, 1);
    soak(in_air, 5.0f);
    assert_int_equal(sheet.touched, 0);
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        assert_float_equal(sheet.wetness[cell], 0.0f, 0.0f);
        assert_int_equal(sheet.soak_ticks[cell], 0);
    }
}

/* Returns the fraction of the initial wet strength that a cell still has after softening. */
static float softened(const struct sheet *paper, uint32_t cell)
{
    return 1.0f - SHEET_SOFTENING * (float)paper->soak_ticks[cell] / (float)SHEET_SOAK_TICKS;
}

static void test_softening_takes_at_most_a_quarter_of_the_wet_strength(void **state)
{
    (void)state;
    const uint32_t cell = MIDDLE * SHEET_SIDE + MIDDLE;
    sheet_init(&sheet, 5, RADIUS_M, 1);
    fixture_plain_paper(&sheet, 1.0f);
    sheet.soaked = 1;
    assert_float_equal(softened(&sheet, cell), 1.0f, 0.0f);
    soak(in_air, 30.0f);
    assert_float_equal(softened(&sheet, cell), 0.875f, 1e-4f);
    soak(in_air, 30.0f);
    assert_float_equal(softened(&sheet, cell), 0.75f, 1e-4f);
    soak(in_air, 30.0f);
    assert_float_equal(softened(&sheet, cell), 0.75f, 1e-4f);
}

static void test_softened_paper_tears_at_three_quarters_of_the_tension(void **state)
{
    (void)state;
    float torn_pa[2];
    for (uint32_t minute = 0; minute < 2; minute++) {
        float pressure_pa = 100.0f;
        uint32_t torn = 0;
        while (torn == 0) {
            pressure_pa *= 1.01f;
            sheet_init(&sheet, 5, RADIUS_M, 1);
            sheet_idealise(&sheet);
            fixture_plain_paper(&sheet, 1.0f);
            sheet.soaked = 1;
            for (uint32_t i = 0; minute && i < SHEET_CELL_COUNT; i++) {
                sheet.soak_ticks[i] = SHEET_SOAK_TICKS;
            }
            for (uint32_t i = 0; i < 6; i++) {
                torn += sheet_tick(&sheet, pressure_pa, in_air, NULL, 0).cells_torn;
            }
        }
        torn_pa[minute] = pressure_pa;
    }
    const float share = sheet_tension_centre(sheet_grade(5), torn_pa[1], RADIUS_M) /
                        sheet_tension_centre(sheet_grade(5), torn_pa[0], RADIUS_M);
    assert_float_equal(share, 0.75f, 0.01f);
}

static void test_the_wet_line_is_full_only_where_wet_meets_dry(void **state)
{
    (void)state;
    sheet_init(&sheet, 5, RADIUS_M, 1);
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        sheet.wetness[cell] = cell % SHEET_SIDE < MIDDLE ? 1.0f : 0.0f;
    }
    /* Checks all rows, including row 0 at the ring. */
    for (uint32_t row = 0; row < SHEET_SIDE; row++) {
        assert_float_equal(paper_wetting_line(&sheet, row, MIDDLE - 1u), 1.0f, 0.0f);
        assert_float_equal(paper_wetting_line(&sheet, row, MIDDLE), 1.0f, 0.0f);
    }
    assert_float_equal(paper_wetting_line(&sheet, MIDDLE, MIDDLE - 3u), 0.0f, 0.0f);
    assert_float_equal(paper_wetting_line(&sheet, MIDDLE, MIDDLE + 2u), 0.0f, 0.0f);
    /* A difference of wetness of at least 0.5 has the full effect of 1. The difference of 0.25 in
     * this cell has half of this effect. */
    sheet.wetness[MIDDLE * SHEET_SIDE + MIDDLE + 1u] = 0.75f;
    assert_float_equal(paper_wetting_line(&sheet, MIDDLE, MIDDLE), 0.5f, 1e-6f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_wet_front_advances_with_the_root_of_time),
        cmocka_unit_test(test_water_wicks_in_air_and_never_leaves_wet_paper),
        cmocka_unit_test(test_dry_paper_in_air_stays_dry),
        cmocka_unit_test(test_softening_takes_at_most_a_quarter_of_the_wet_strength),
        cmocka_unit_test(test_softened_paper_tears_at_three_quarters_of_the_tension),
        cmocka_unit_test(test_the_wet_line_is_full_only_where_wet_meets_dry),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
