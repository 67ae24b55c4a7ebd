/* test_paper_lab.c -- Tests `kingyoctl paper`, which moves a poi through water on a simulated
 * carriage, against physical reference values. */
#include "tests/unit/support/poi_fixture.h"

#include "core/base/fmath.h"
#include "platform/ctl/play/paper_lab.h"

#define SEEDS 4u

static struct paper_lab lab;

static struct paper_options wet(uint8_t grade)
{
    return (struct paper_options){
        .grade = grade,
        .wetness = 1.0f,
        .wet_fraction = 1.0f,
        .tilt_rad = 0.5f * F_PI,
        .fish_m = 0.05f,
        .tick_count = 6,
        .seed = 1,
    };
}

static void run(const struct paper_options *plan)
{
    paper_lab_open(&lab, plan);
    while (lab.tick < plan->tick_count) {
        paper_lab_tick(&lab);
    }
}

/* Returns the lowest speed in m/s at which the paper tears within 0.05 s. The speed is found by
 * binary search, with a relative error of 0.001. */
static float instant_m_s(struct paper_options plan)
{
    float low = 0.05f, high = 4.0f;
    plan.tick_count = 7;
    while (high - low > 0.001f * low) {
        plan.speed_m_s = 0.5f * (low + high);
        run(&plan);
        if (paper_lab_is_instant(&lab)) {
            high = plan.speed_m_s;
        } else {
            low = plan.speed_m_s;
        }
    }
    return high;
}

static void test_the_broadside_force_at_0_3_m_s_is_a_quarter_newton(void **state)
{
    (void)state;
    for (uint8_t grade = SHEET_GRADE_MIN; grade <= SHEET_GRADE_MAX; grade++) {
        struct paper_options plan = wet(grade);
        plan.speed_m_s = 0.3f;
        run(&plan);
        assert_float_equal(lab.force_n, 0.25f, 0.025f);
        assert_float_equal(lab.tension_n_m,
                           sheet_tension_centre(sheet_grade(grade), 50.0f, POI_RADIUS_M),
                           0.05f * lab.tension_n_m);
    }
}

static void test_an_edge_on_motion_has_only_friction(void **state)
{
    (void)state;
    struct paper_options plan = wet(5);
    plan.speed_m_s = 0.3f;
    plan.tilt_rad = 0.0f;
    run(&plan);
    assert_true(lab.force_n > 0.001f);
    assert_true(lab.force_n < 0.01f);
}

static void test_an_angle_of_twenty_degrees_gives_lift(void **state)
{
    (void)state;
    struct paper_options plan = wet(5);
    plan.speed_m_s = 0.3f;
    plan.tilt_rad = 20.0f * F_DEG;
    run(&plan);
    assert_float_equal(lab.force_n, 0.68f * 0.5f * 1000.0f * 5.03e-3f * 0.09f, 0.008f);
}

static void test_a_still_fish_in_air_tears_no_paper_grade_in_a_minute(void **state)
{
    (void)state;
    for (uint8_t grade = SHEET_GRADE_MIN; grade <= SHEET_GRADE_MAX; grade++) {
        for (uint32_t seed = 0; seed < SEEDS; seed++) {
            struct paper_options plan = wet(grade);
            plan.in_air = plan.still = 1;
            plan.fish_count = 1;
            plan.seed = seed;
            plan.tick_count = 60u * CORE_TICK_HZ;
            run(&plan);
            assert_int_equal(lab.poi.carried_count, 1);
            assert_float_equal(lab.poi.carried_kg, 0.0029f, 0.0001f);
            assert_int_equal(lab.tore_tick, 0);
        }
    }
}

static void test_slapping_fish_increase_the_paper_stress(void **state)
{
    (void)state;
    struct paper_options plan = wet(5);
    plan.in_air = plan.still = 1;
    plan.fish_count = 3;
    plan.tick_count = 2u * CORE_TICK_HZ;
    run(&plan);
    const float still_n_m = lab.tension_n_m;
    plan.still = 0;
    run(&plan);
    print_message("still %.2f N/m, slapping %.2f\n", (double)still_n_m, (double)lab.tension_n_m);
    assert_true(lab.tension_n_m > 1.5f * still_n_m);
}

static void test_paper_tears_at_the_speed_of_the_membrane_formula(void **state)
{
    (void)state;
    for (uint8_t number = SHEET_GRADE_MIN; number <= SHEET_GRADE_MAX; number++) {
        const struct paper_grade *grade = sheet_grade(number);
        struct paper_options plan = wet(number);
        plan.ideal = 1;
        /* A pressure p stretches a round membrane with the tension T = 0.423 (Y p^2 a^2)^(1/3),
         * where Y is the stiffness and a the radius. A flow with the speed v has the pressure p =
         * 1.17 rho v^2 / 2. The code solves these formulas for the speed at which T equals the wet
         * strength. */
        const float stretch = grade->wet_n_m / 0.423f;
        const float pressure_pa =
            f_sqrt(stretch * stretch * stretch / grade->stiffness_n_m) / POI_RADIUS_M;
        const float formula_m_s = f_sqrt(2.0f * pressure_pa / (1.17f * 1000.0f));
        const float speed_m_s = instant_m_s(plan);
        print_message("No. %u: %.3f m/s, by the formula %.3f\n", number, (double)speed_m_s,
                      (double)formula_m_s);
        assert_float_equal(speed_m_s, formula_m_s, 0.02f * formula_m_s);
    }
}

static void test_half_wet_paper_tears_at_the_expected_speed(void **state)
{
    (void)state;
    for (uint8_t grade = SHEET_GRADE_MIN; grade <= SHEET_GRADE_MAX; grade++) {
        for (uint32_t seed = 1; seed <= SEEDS; seed++) {
            struct paper_options plan = wet(grade);
            plan.seed = seed;
            const float whole_m_s = instant_m_s(plan);
            plan.wet_fraction = 0.5f;
            const float share = instant_m_s(plan) / whole_m_s;
            assert_float_equal(share, 0.52f, 0.06f);
        }
    }
}

static void test_an_inverted_poi_holds_fifteen_grams(void **state)
{
    (void)state;
    struct paper_options plan = wet(5);
    plan.in_air = plan.upside_down = 1;
    run(&plan);
    assert_float_equal(lab.water_kg, 0.015f, 0.0015f);
    plan.upside_down = 0;
    run(&plan);
    assert_true(lab.water_kg < 0.004f);
}

static void
test_dry_paper_carries_no_water_and_survives_the_speed_that_tears_wet_paper(void **state)
{
    (void)state;
    struct paper_options plan = wet(6);
    plan.wetness = 0.0f;
    plan.in_air = 1;
    run(&plan);
    assert_float_equal(lab.water_kg, 0.0f, 0.0f);
    plan.in_air = 0;
    assert_true(instant_m_s(plan) > 3.0f * instant_m_s(wet(6)));
}

static void test_the_wetness_is_constant_and_the_water_line_does_not_move(void **state)
{
    (void)state;
    struct paper_options plan = wet(5);
    plan.wet_fraction = 0.3f;
    plan.wetness = 0.8f;
    plan.tick_count = 3u * CORE_TICK_HZ;
    run(&plan);
    float sum = 0.0f;
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        sum += lab.poi.sheet.wetness[cell];
    }
    assert_float_equal(sum / (float)lab.poi.sheet.paper_cells, 0.3f * 0.8f, 0.02f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_broadside_force_at_0_3_m_s_is_a_quarter_newton),
        cmocka_unit_test(test_an_edge_on_motion_has_only_friction),
        cmocka_unit_test(test_an_angle_of_twenty_degrees_gives_lift),
        cmocka_unit_test(test_a_still_fish_in_air_tears_no_paper_grade_in_a_minute),
        cmocka_unit_test(test_slapping_fish_increase_the_paper_stress),
        cmocka_unit_test(test_paper_tears_at_the_speed_of_the_membrane_formula),
        cmocka_unit_test(test_half_wet_paper_tears_at_the_expected_speed),
        cmocka_unit_test(test_an_inverted_poi_holds_fifteen_grams),
        cmocka_unit_test(
            test_dry_paper_carries_no_water_and_survives_the_speed_that_tears_wet_paper),
        cmocka_unit_test(test_the_wetness_is_constant_and_the_water_line_does_not_move),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
