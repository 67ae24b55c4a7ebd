/* test_disc.c -- checks the forces on a tilted disc in water: drag, lift and added mass. Checks
 * also which fraction of the disc is immersed. */
#include "tests/unit/support/poi_fixture.h"

#define RADIUS_M 0.040f

static float broadside_n(float speed_m_s)
{
    return speed_m_s * disc_normal_n_s_m(RADIUS_M, speed_m_s, 0.0f);
}

static void test_broadside_drag_at_0_3_m_s_is_a_quarter_newton(void **state)
{
    (void)state;
    assert_float_equal(broadside_n(0.3f), 0.25f, 0.025f);
    assert_float_equal(broadside_n(0.5f), 0.70f, 0.07f);
    assert_float_equal(broadside_n(1.0f), 2.8f, 0.28f);
}

static void test_edge_on_drag_at_0_3_m_s_is_under_a_hundredth_of_a_newton(void **state)
{
    (void)state;
    const float friction_n = 0.3f * disc_edge_n_s_m(RADIUS_M, 0.3f);
    assert_true(friction_n > 0.002f);
    assert_true(friction_n < 0.010f);
}

static void test_a_small_angle_lifts_like_a_wing(void **state)
{
    (void)state;
    const float sine = f_sin(20.0f * F_DEG), cosine = f_cos(20.0f * F_DEG);
    const float force_n = 0.3f * sine * disc_normal_n_s_m(RADIUS_M, 0.3f * sine, 0.3f * cosine);
    assert_float_equal(force_n / (0.5f * WATER_KG_M3 * F_PI * RADIUS_M * RADIUS_M * 0.09f), 0.684f,
                       0.01f);
}

static void test_a_disc_at_rest_has_no_drag(void **state)
{
    (void)state;
    assert_float_equal(disc_normal_n_s_m(RADIUS_M, 0.0f, 0.0f), 0.0f, 0.0f);
    assert_float_equal(disc_edge_n_s_m(RADIUS_M, 0.0f), 0.0f, 0.0f);
}

static void test_half_a_disc_is_immersed_when_its_centre_is_at_the_surface(void **state)
{
    (void)state;
    const float ups[] = { 1.0f, 0.7f, 0.0f, -1.0f };
    for (uint32_t i = 0; i < 4; i++) {
        assert_float_equal(disc_immersed(RADIUS_M, 0.0f, ups[i]), 0.5f, 1e-3f);
        assert_float_equal(disc_immersed(RADIUS_M, 0.05f, ups[i]), 0.0f, 1e-6f);
        assert_float_equal(disc_immersed(RADIUS_M, -0.05f, ups[i]), 1.0f, 1e-6f);
    }
}

static void test_the_immersion_of_a_slanted_disc_rises_gradually(void **state)
{
    (void)state;
    float before = 0.0f;
    for (int mm = 35; mm >= -35; mm--) {
        const float now = disc_immersed(RADIUS_M, (float)mm * 0.001f, 0.7f);
        assert_true(now >= before);
        assert_true(now - before < 0.03f);
        before = now;
    }
}

static void test_added_mass_is_171_g_under_water_and_half_at_the_surface(void **state)
{
    (void)state;
    assert_float_equal(disc_added_mass_kg(RADIUS_M, -0.10f, 1.0f), 0.171f, 0.001f);
    assert_float_equal(disc_added_mass_kg(RADIUS_M, 0.0f, 1.0f), 0.0855f, 0.001f);
    assert_float_equal(disc_added_mass_kg(RADIUS_M, 0.05f, 0.0f), 0.0f, 0.0f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_broadside_drag_at_0_3_m_s_is_a_quarter_newton),
        cmocka_unit_test(test_edge_on_drag_at_0_3_m_s_is_under_a_hundredth_of_a_newton),
        cmocka_unit_test(test_a_small_angle_lifts_like_a_wing),
        cmocka_unit_test(test_a_disc_at_rest_has_no_drag),
        cmocka_unit_test(test_half_a_disc_is_immersed_when_its_centre_is_at_the_surface),
        cmocka_unit_test(test_the_immersion_of_a_slanted_disc_rises_gradually),
        cmocka_unit_test(test_added_mass_is_171_g_under_water_and_half_at_the_surface),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
