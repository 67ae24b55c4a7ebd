/* test_sheet.c -- checks a sheet of paper: tension, wetness, wear and tears. */
#include "core/poi/poi_fields.h"
#include "tests/unit/support/poi_fixture.h"

#define RADIUS_M 0.040f
/* Pressure of a resting fish in Pa: 2.9 g on 50 cm^2 of paper. */
#define STILL_FISH_PA 5.6f
#define FILM_PA 6.0f /* Pressure of the film of water on wet paper, in Pa. */

static const struct sheet_wetting in_air = { 0.0f, 0.0f, -1.0f };
static const struct sheet_wetting under_water = { 0.0f, 0.0f, 1.0f };

static uint32_t press(struct sheet *sheet, float pressure_pa, float seconds)
{
    uint32_t torn = 0;
    for (uint32_t i = 0; (float)i < seconds * (float)CORE_TICK_HZ; i++) {
        torn += sheet_tick(sheet, pressure_pa, in_air, NULL, 0).cells_torn;
    }
    return torn;
}

static struct sheet plain(uint8_t grade, float wetness)
{
    struct sheet sheet;
    sheet_init(&sheet, grade, RADIUS_M, 1);
    fixture_plain_paper(&sheet, wetness);
    return sheet;
}

static void test_the_membrane_follows_henckys_table(void **state)
{
    (void)state;
    const struct paper_grade *grade = sheet_grade(6);
    const float rows[][3] = {
        /* Columns: pressure in Pa, tension in N/m, sag in mm. */
        { 2.8f, 1.3f, 1.0f },    { 5.6f, 2.0f, 1.3f },    { 50.0f, 8.4f, 2.6f },
        { 140.0f, 17.0f, 3.7f }, { 560.0f, 42.0f, 6.0f },
    };
    for (uint32_t i = 0; i < 5; i++) {
        assert_float_equal(sheet_tension_centre(grade, rows[i][0], RADIUS_M), rows[i][1],
                           0.05f * rows[i][1]);
        assert_float_equal(1000.0f * sheet_belly(grade, rows[i][0], RADIUS_M), rows[i][2],
                           0.06f * rows[i][2]);
    }
    assert_float_equal(sheet_tension_edge(grade, 50.0f, RADIUS_M) /
                           sheet_tension_centre(grade, 50.0f, RADIUS_M),
                       0.328f / 0.423f, 1e-4f);
}

static void test_a_push_from_below_tightens_and_bulges_upward(void **state)
{
    (void)state;
    struct sheet sheet = plain(6, 1.0f);
    press(&sheet, 50.0f, 0.5f);
    assert_float_equal(sheet.sag_m, -0.0026f, 0.0002f);
    press(&sheet, -50.0f, 0.5f);
    assert_float_equal(sheet.sag_m, 0.0026f, 0.0002f);
}

static void test_the_ultimate_pressure_tears_wet_paper_and_not_dry_paper(void **state)
{
    (void)state;
    for (uint8_t number = SHEET_GRADE_MIN; number <= SHEET_GRADE_MAX; number++) {
        const struct paper_grade *grade = sheet_grade(number);
        float pressure_pa = 10.0f;
        while (sheet_tension_centre(grade, pressure_pa, RADIUS_M) < grade->wet_n_m) {
            pressure_pa *= 1.02f;
        }
        struct sheet wet = plain(number, 1.0f), dry = plain(number, 0.0f),
                     damage_immune = plain(number, 1.0f);
        assert_true(press(&wet, 1.05f * pressure_pa, 0.05f) > 0);
        assert_int_equal(press(&dry, 1.05f * pressure_pa, 0.05f), 0);
        assert_int_equal(press(&damage_immune, 0.35f * pressure_pa, 0.05f), 0);
    }
}

static void test_a_still_fish_in_air_tears_no_grade_in_a_minute(void **state)
{
    (void)state;
    const struct sheet_load fish = { 0.01f, -0.01f, 0.020f, -0.028f };
    for (uint8_t grade = SHEET_GRADE_MIN; grade <= SHEET_GRADE_MAX; grade++) {
        for (uint32_t seed = 0; seed < 4; seed++) {
            struct sheet sheet;
            sheet_init(&sheet, grade, RADIUS_M, seed);
            for (uint32_t i = 0; i < SHEET_CELL_COUNT; i++) {
                sheet.wetness[i] = 1.0f;
            }
            sheet.touched = 1;
            for (uint32_t i = 0; i < 60u * CORE_TICK_HZ; i++) {
                const struct sheet_events events =
                    sheet_tick(&sheet, -STILL_FISH_PA - FILM_PA, in_air, &fish, 1);
                assert_int_equal(events.cells_torn, 0);
            }
        }
    }
}

static void test_a_footprint_strains_by_its_circumference(void **state)
{
    (void)state;
    struct sheet sheet = plain(4, 0.0f);
    const struct sheet_load slap = { 0.0f, 0.0f, 0.002f, -0.09f };
    const struct sheet_events events = sheet_tick(&sheet, 0.0f, in_air, &slap, 1);
    assert_float_equal(events.tension_max_n_m, 14.3f, 1.0f);
}

static void test_hard_slaps_on_one_spot_wear_through_weak_paper(void **state)
{
    (void)state;
    struct sheet sheet = plain(7, 1.0f);
    const struct sheet_load slap = { 0.0f, 0.0f, 0.003f, -0.15f };
    uint32_t slaps = 0;
    while (sheet_holds(&sheet, 0.0f, 0.0f) && slaps < 200) {
        for (uint32_t i = 0; i < 3; i++) {
            sheet_tick(&sheet, -STILL_FISH_PA - FILM_PA, in_air, &slap, 1);
        }
        slaps++;
    }
    assert_in_range(slaps, 2, 60);
}

static void test_water_softens_with_a_time_constant_of_a_second(void **state)
{
    (void)state;
    struct sheet sheet = plain(6, 0.0f);
    for (uint32_t i = 0; i < CORE_TICK_HZ; i++) {
        sheet_tick(&sheet, 0.0f, under_water, NULL, 0);
    }
    assert_float_equal(sheet.wetness[SHEET_CELL_COUNT / 2u + SHEET_SIDE / 2u], 0.632f, 0.01f);
}

static struct sheet half_wet(void)
{
    struct sheet sheet = plain(6, 0.0f);
    const struct sheet_wetting left_half = { 1.0f, 0.0f, 0.0f };
    for (uint32_t i = 0; i < 4u * CORE_TICK_HZ; i++) {
        sheet_tick(&sheet, 0.0f, left_half, NULL, 0);
    }
    return sheet;
}

static void test_only_paper_under_the_water_line_gets_wet_and_water_wicks_a_little(void **state)
{
    (void)state;
    const struct sheet sheet = half_wet();
    const uint32_t row = SHEET_SIDE / 2u * SHEET_SIDE;
    assert_true(sheet.wetness[row + 4u] > 0.97f);
    assert_true(sheet.wetness[row + SHEET_SIDE / 2u] > 0.01f);
    assert_true(sheet.wetness[row + SHEET_SIDE / 2u + 4u] < 0.02f);
}

static void test_the_line_between_wet_and_dry_tears_first(void **state)
{
    (void)state;
    struct sheet sheet = half_wet();
    float pressure_pa = 20.0f;
    while (press(&sheet, pressure_pa, 0.1f) == 0) {
        pressure_pa *= 1.05f;
    }
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        if (sheet.state[cell] == CELL_HOLE) {
            assert_in_range(cell % SHEET_SIDE, SHEET_SIDE / 2u - 2u, SHEET_SIDE / 2u);
        }
    }
    struct sheet wet = plain(6, 1.0f);
    assert_int_equal(press(&wet, pressure_pa, 0.1f), 0);
}

static void test_a_tear_grows_from_cell_to_cell_and_leaves_one_hole(void **state)
{
    (void)state;
    struct sheet sheet = plain(6, 1.0f);
    const uint32_t middle = SHEET_SIDE / 2u * SHEET_SIDE + SHEET_SIDE / 2u;
    sheet.state[middle] = CELL_HOLE;
    sheet.paper_cells--;
    struct sheet whole = plain(6, 1.0f);
    assert_int_equal(press(&whole, 140.0f, 0.1f), 0);
    assert_true(press(&sheet, 140.0f, 0.1f) >= 4);
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        if (sheet.state[cell] == CELL_HOLE && cell != middle) {
            const int touches = sheet.state[cell - 1u] == CELL_HOLE ||
                                sheet.state[cell + 1u] == CELL_HOLE ||
                                sheet.state[cell - SHEET_SIDE] == CELL_HOLE ||
                                sheet.state[cell + SHEET_SIDE] == CELL_HOLE ||
                                sheet.state[cell - SHEET_SIDE - 1u] == CELL_HOLE ||
                                sheet.state[cell - SHEET_SIDE + 1u] == CELL_HOLE ||
                                sheet.state[cell + SHEET_SIDE - 1u] == CELL_HOLE ||
                                sheet.state[cell + SHEET_SIDE + 1u] == CELL_HOLE;
            assert_true(touches);
        }
    }
}

static void test_paper_cells_equals_the_number_of_paper_cells(void **state)
{
    (void)state;
    struct sheet sheet = plain(7, 1.0f);
    press(&sheet, 300.0f, 0.2f);
    uint32_t cells = 0;
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        cells += sheet.state[cell] == CELL_PAPER;
    }
    assert_int_equal(cells, sheet.paper_cells);
    assert_true(sheet_left(&sheet) < 1.0f);
}

static void test_specimens_differ_by_twelve_percent(void **state)
{
    (void)state;
    float sum = 0.0f, squares = 0.0f;
    for (uint32_t seed = 0; seed < 400; seed++) {
        struct sheet sheet;
        float mean = 0.0f;
        sheet_init(&sheet, 5, RADIUS_M, seed);
        for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
            mean += sheet.state[cell] == CELL_PAPER ? sheet.strength[cell] : 0.0f;
        }
        mean /= (float)sheet.paper_cells_new;
        sum += mean;
        squares += mean * mean;
    }
    const float mean = sum / 400.0f;
    assert_float_equal(mean, 0.99f, 0.03f);
    assert_float_equal(f_sqrt(squares / 400.0f - mean * mean), 0.12f, 0.02f);
}

static void test_the_same_seed_gives_the_same_tears(void **state)
{
    (void)state;
    struct sheet first, second, other;
    sheet_init(&first, 6, RADIUS_M, 77);
    sheet_init(&second, 6, RADIUS_M, 77);
    sheet_init(&other, 6, RADIUS_M, 78);
    for (uint32_t i = 0; i < 200; i++) {
        sheet_tick(&first, 160.0f, under_water, NULL, 0);
        sheet_tick(&second, 160.0f, under_water, NULL, 0);
        sheet_tick(&other, 160.0f, under_water, NULL, 0);
    }
    assert_true(field_hash(HASH_START, &sheet_fields, &first) ==
                field_hash(HASH_START, &sheet_fields, &second));
    assert_true(field_hash(HASH_START, &sheet_fields, &first) !=
                field_hash(HASH_START, &sheet_fields, &other));
}

static void test_points_outside_the_ring_have_no_paper(void **state)
{
    (void)state;
    const struct sheet sheet = plain(6, 0.0f);
    assert_true(sheet_holds(&sheet, 0.0f, 0.0f));
    assert_true(sheet_holds(&sheet, 0.0395f, 0.0f));
    assert_false(sheet_holds(&sheet, 0.0401f, 0.0f));
    assert_false(sheet_holds(&sheet, 0.03f, -0.03f));
}

/* Samples the disc inside the ring at points that are 0.2 mm apart, which is finer than the grid of
 * cells. Counts all points (`asked`) and the points that are on paper (`held`). */
static void count_held(const struct sheet *sheet, uint32_t *held, uint32_t *asked)
{
    *held = *asked = 0;
    for (uint32_t i = 0; i < 400u * 400u; i++) {
        const float x = ((float)(i % 400u) + 0.5f) * 2e-4f - RADIUS_M;
        const float z = ((float)(i / 400u) + 0.5f) * 2e-4f - RADIUS_M;
        if (x * x + z * z < RADIUS_M * RADIUS_M) {
            *asked += 1;
            *held += (uint32_t)sheet_holds(sheet, x, z);
        }
    }
}

static void test_whole_paper_reaches_the_ring_and_a_bare_ring_has_none(void **state)
{
    (void)state;
    uint32_t held, asked;
    struct sheet sheet = plain(6, 0.0f);
    count_held(&sheet, &held, &asked);
    assert_int_equal(held, asked);
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        sheet.state[cell] = sheet.state[cell] == CELL_PAPER ? CELL_HOLE : sheet.state[cell];
    }
    const uint32_t middle = SHEET_SIDE / 2u * SHEET_SIDE + SHEET_SIDE / 2u;
    /* Leaves only one cell of paper, in the middle. */
    sheet.state[middle] = CELL_PAPER;
    sheet.paper_cells = 1;
    count_held(&sheet, &held, &asked);
    assert_in_range(held, 1, 200);
    sheet.state[middle] = CELL_HOLE;
    sheet.paper_cells = 0;
    count_held(&sheet, &held, &asked);
    assert_int_equal(held, 0);
}

static float stress_at(const struct sheet *sheet, uint32_t row, uint32_t column)
{
    return (float)sheet->stress[row * SHEET_SIDE + column] / 255.0f;
}

static void test_the_stress_map_shows_load_over_strength_and_stress_concentration(void **state)
{
    (void)state;
    const uint32_t middle = SHEET_SIDE / 2u;
    struct sheet sheet = plain(5, 1.0f);
    sheet.soaked = 1;
    const float pressure_pa = 120.0f;
    press(&sheet, pressure_pa, 0.01f);
    const float centre =
        sheet_tension_centre(sheet_grade(5), pressure_pa, RADIUS_M) / sheet_grade(5)->wet_n_m;
    const float edge = 1.5f * 0.328f / 0.423f * centre;
    assert_float_equal(stress_at(&sheet, middle, middle), centre, 0.01f);
    assert_float_equal(stress_at(&sheet, middle, 0), edge, 0.03f);
    /* The corner of the grid is outside the round paper, so it must have no stress. */
    assert_float_equal(stress_at(&sheet, 0, 0), 0.0f, 0.0f);
    press(&sheet, 3000.0f, 0.01f);
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        assert_true(sheet.state[cell] == CELL_PAPER || sheet.stress[cell] == 0);
    }
    press(&sheet, 0.0f, 0.01f);
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        assert_int_equal(sheet.stress[cell], 0);
    }
}

static void test_stress_factors_multiply_where_the_wet_line_meets_the_ring(void **state)
{
    (void)state;
    struct sheet sheet = plain(5, 0.0f);
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        sheet.wetness[cell] = cell % SHEET_SIDE < SHEET_SIDE / 2u ? 1.0f : 0.0f;
    }
    sheet.touched = 1;
    press(&sheet, 40.0f, 0.01f);
    /* Index of the last wet column, where the stress is highest. This column is beside the line
     * between wet and dry paper. */
    const uint32_t line = SHEET_SIDE / 2u - 1u;
    const float off = stress_at(&sheet, SHEET_SIDE / 2u, line - 4u);
    assert_float_equal(stress_at(&sheet, SHEET_SIDE / 2u, line) / off, 2.5f, 0.1f);
    /* Stress at the ring (row 0), in a column that is two columns away from the boundary between
     * wet and dry paper. */
    const float ring = stress_at(&sheet, 0, line - 2u);
    assert_float_equal(stress_at(&sheet, 0, line) / ring, 2.5f, 0.15f);
    assert_float_equal(ring / stress_at(&sheet, 3, line - 2u), 1.5f, 0.15f);
}

static void test_a_laboratory_sheet_is_uniform_without_stress_concentration(void **state)
{
    (void)state;
    struct sheet sheet;
    sheet_init(&sheet, 5, RADIUS_M, 9);
    const uint64_t hash = field_hash(HASH_START, &sheet_fields, &sheet);
    sheet_idealise(&sheet);
    assert_true(field_hash(HASH_START, &sheet_fields, &sheet) != hash);
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        const float strength = sheet.state[cell] == CELL_PAPER ? 1.0f : 0.0f;
        assert_float_equal(sheet.strength[cell], strength, 0.0f);
        sheet.wetness[cell] = cell % SHEET_SIDE < SHEET_SIDE / 2u ? 1.0f : 0.9f;
    }
    sheet.touched = 1;
    press(&sheet, 150.0f, 0.01f);
    const float middle = stress_at(&sheet, SHEET_SIDE / 2u, SHEET_SIDE / 2u - 2u);
    assert_float_equal(stress_at(&sheet, SHEET_SIDE / 2u, 0) / middle, 0.328f / 0.423f, 0.02f);
}

/* Examines 200 sheets with random weak spots. Most sheets must have a thin spot. The strength must
 * vary over distances greater than a cell, and the fibres must point in all directions. */
static void test_each_specimen_has_its_own_weak_spots_clouds_and_fibres(void **state)
{
    (void)state;
    uint32_t with_spot = 0, ways[4] = { 0 };
    float together = 0.0f, apart = 0.0f, squares = 0.0f;
    for (uint32_t seed = 0; seed < 200; seed++) {
        struct sheet sheet;
        float mean = 0.0f;
        sheet_init(&sheet, 5, RADIUS_M, seed);
        for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
            mean += sheet.strength[cell] / (float)sheet.paper_cells_new;
        }
        with_spot += sheet.strength_min < 0.87f * mean;
        const float angle = f_atan2(sheet.fibre_z, sheet.fibre_x);
        ways[(uint32_t)(4.0f * f_clamp(angle / F_PI, 0.0f, 0.999f))]++;
        for (uint32_t row = 8; row < 24; row++) {
            const float *at = &sheet.strength[row * SHEET_SIDE + 8u];
            const float one = at[0] - mean;
            together += one * (at[1] - mean);
            apart += one * (at[16] - mean);
            squares += one * one;
        }
        assert_float_equal(sheet.fibre_x * sheet.fibre_x + sheet.fibre_z * sheet.fibre_z, 1.0f,
                           1e-4f);
    }
    assert_true(with_spot > 180);
    /* The strengths of neighbouring cells have a correlation above 0.4, because weak spots are
     * wider than a cell. */
    assert_true(together / squares > 0.4f);
    /* The strengths of cells at a distance of 4 cm have a correlation below 0.2, because weak spots
     * are not as wide as the paper. */
    assert_true(apart / squares < 0.2f);
    for (uint32_t i = 0; i < 4; i++) {
        assert_in_range(ways[i], 30, 70);
    }
}

static void test_the_danger_rises_with_the_load_and_with_the_damage(void **state)
{
    (void)state;
    static struct sheet sheet;
    const uint32_t cell = SHEET_CELL_COUNT / 2u + SHEET_SIDE / 2u;
    sheet_init(&sheet, 6, RADIUS_M, 1);
    assert_float_equal(sheet_warning(&sheet), 0.0f, 0.0f);
    float before = 0.0f;
    for (uint8_t stress = 160; stress < 220; stress = (uint8_t)(stress + 10)) {
        sheet.stress[cell] = stress;
        assert_true(sheet_warning(&sheet) > before);
        before = sheet_warning(&sheet);
    }
    sheet.stress[cell] = 0;
    sheet.damage[cell] = 0.5f;
    assert_in_range((int)(100.0f * sheet_warning(&sheet)), 49, 51);
    sheet.damage[cell] = 0.9f;
    assert_float_equal(sheet_warning(&sheet), 1.0f, 0.0f);
    /* The cell has already torn, so it gives no warning. */
    sheet.state[cell] = CELL_HOLE;
    assert_float_equal(sheet_warning(&sheet), 0.0f, 0.0f);
}

static void test_an_unknown_grade_fails_an_assertion(void **state)
{
    (void)state;
    struct sheet sheet;
    expect_assert_failure(sheet_init(&sheet, 3, RADIUS_M, 1));
    expect_assert_failure(sheet_init(&sheet, 8, RADIUS_M, 1));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_membrane_follows_henckys_table),
        cmocka_unit_test(test_a_push_from_below_tightens_and_bulges_upward),
        cmocka_unit_test(test_the_ultimate_pressure_tears_wet_paper_and_not_dry_paper),
        cmocka_unit_test(test_a_still_fish_in_air_tears_no_grade_in_a_minute),
        cmocka_unit_test(test_a_footprint_strains_by_its_circumference),
        cmocka_unit_test(test_hard_slaps_on_one_spot_wear_through_weak_paper),
        cmocka_unit_test(test_water_softens_with_a_time_constant_of_a_second),
        cmocka_unit_test(test_only_paper_under_the_water_line_gets_wet_and_water_wicks_a_little),
        cmocka_unit_test(test_the_line_between_wet_and_dry_tears_first),
        cmocka_unit_test(test_a_tear_grows_from_cell_to_cell_and_leaves_one_hole),
        cmocka_unit_test(test_paper_cells_equals_the_number_of_paper_cells),
        cmocka_unit_test(test_specimens_differ_by_twelve_percent),
        cmocka_unit_test(test_the_same_seed_gives_the_same_tears),
        cmocka_unit_test(test_points_outside_the_ring_have_no_paper),
        cmocka_unit_test(test_whole_paper_reaches_the_ring_and_a_bare_ring_has_none),
        cmocka_unit_test(test_the_stress_map_shows_load_over_strength_and_stress_concentration),
        cmocka_unit_test(test_stress_factors_multiply_where_the_wet_line_meets_the_ring),
        cmocka_unit_test(test_a_laboratory_sheet_is_uniform_without_stress_concentration),
        cmocka_unit_test(test_each_specimen_has_its_own_weak_spots_clouds_and_fibres),
        cmocka_unit_test(test_the_danger_rises_with_the_load_and_with_the_damage),
        cmocka_unit_test(test_an_unknown_grade_fails_an_assertion),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
