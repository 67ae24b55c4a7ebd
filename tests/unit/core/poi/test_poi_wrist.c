/* test_poi_wrist.c -- tests that the poi turns automatically over its bowl, and that the ring does
 * not enter the bowl's hull. */
#include "tests/unit/support/poi_fixture.h"

/* The fixture is static, because the struct is too large for some stacks. */
static struct poi_fixture fixture;

static void test_over_the_bowl_the_poi_turns_toward_it_by_55_degrees_and_back(void **state)
{
    (void)state;
    fixture_init(&fixture, 6, 1);
    fixture.laden = 1;
    fixture_move(&fixture, v3(0.18f, 0.05f, 0.15f), 0.5f);
    fixture_wait(&fixture, 0.2f);
    assert_true(vec_basis_from_angles(fixture.poi.angles).up.y > 0.999f);
    fixture_move(&fixture, v3(0.27f, 0.05f, 0.15f), 0.3f);
    fixture_wait(&fixture, 1.0f);
    const struct basis over = vec_basis_from_angles(fixture.poi.angles);
    assert_float_equal(f_acos(over.up.y), 55.0f * F_DEG, 0.02f);
    /* The bowl is on the right of the poi, so the right edge of the poi must be lowered. */
    assert_true(over.up.x > 0.8f);
    const float low_m = fixture.poi.position_m.y - POI_OUTER_RADIUS_M * f_sin(55.0f * F_DEG);
    assert_true(low_m > fixture.bowl.position_m.y);
    fixture_move(&fixture, v3(0.10f, 0.05f, 0.0f), 0.5f);
    fixture_wait(&fixture, 1.0f);
    assert_true(vec_basis_from_angles(fixture.poi.angles).up.y > 0.999f);
}

static float tilt_rad(void)
{
    return f_acos(vec_basis_from_angles(fixture.poi.angles).up.y);
}

static void test_an_empty_poi_does_not_turn_over_the_bowl(void **state)
{
    (void)state;
    fixture_init(&fixture, 6, 1);
    fixture_move(&fixture, v3(0.27f, 0.05f, 0.15f), 0.3f);
    fixture_wait(&fixture, 1.0f);
    assert_true(tilt_rad() < 2.0f * F_DEG);
    fixture.laden = 1;
    fixture_wait(&fixture, 1.0f);
    assert_float_equal(tilt_rad(), 55.0f * F_DEG, 0.02f);
    fixture.laden = 0;
    /* The poi no longer carries a fish, so it must turn back to level. */
    fixture.poi.laden_ticks = 0;
    fixture_wait(&fixture, 0.6f);
    assert_true(tilt_rad() < 2.0f * F_DEG);
}

static void test_the_wrist_never_lowers_the_handle_into_the_bowl(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < 16; i++) {
        const float angle = F_TAU * (float)i / 16.0f;
        fixture_init(&fixture, 6, 1);
        fixture.laden = 1;
        bowl_init(&fixture.bowl, v3(0.15f * f_cos(angle), 0.02f, 0.15f * f_sin(angle)));
        fixture_move(&fixture, v3(fixture.bowl.position_m.x, 0.035f, fixture.bowl.position_m.z),
                     0.3f);
        float steepest = 1.0f;
        for (uint32_t tick = 0; tick < CORE_TICK_HZ; tick++) {
            fixture_tick(&fixture);
            const struct basis axes = vec_basis_from_angles(fixture.poi.angles);
            /* The back axis points from the ring along the handle to the grip. The grip must not be
             * lower than the ring, because the handle would otherwise enter the bowl. */
            assert_true(axes.back.y > -0.01f);
            steepest = f_min(steepest, axes.up.y);
        }
        /* The tilt must nevertheless reach 55 degrees, because the fish would otherwise not slide
         * into the bowl. */
        assert_float_equal(steepest, f_cos(55.0f * F_DEG), 0.02f);
    }
}

static void test_controller_orientation_disables_the_automatic_turn(void **state)
{
    (void)state;
    fixture_init(&fixture, 6, 1);
    fixture.has_wrist = 1;
    fixture.laden = 1;
    fixture_move(&fixture, v3(0.30f, 0.05f, 0.15f), 0.5f);
    fixture_wait(&fixture, 1.0f);
    assert_true(vec_basis_from_angles(fixture.poi.angles).up.y > 0.999f);
}

/* Returns 1 if the whole centre line of the ring is outside the bowl's hull. */
static int clear_of_bowl(void)
{
    const struct basis axes = vec_basis_from_angles(fixture.poi.angles);
    for (uint32_t i = 0; i < 32; i++) {
        const float a = F_TAU * (float)i / 32.0f;
        const vec3 rim = v3_scale(v3(f_cos(a), 0.0f, f_sin(a)), 0.043f);
        const vec3 at = v3_sub(v3_add(fixture.poi.position_m, vec_basis_to_world(&axes, rim)),
                               fixture.bowl.position_m);
        const float wide = (at.x * at.x + at.z * at.z) / (BOWL_RADIUS_M * BOWL_RADIUS_M);
        if (at.y < 0.0f && wide + at.y * at.y / (BOWL_DEPTH_M * BOWL_DEPTH_M) < 0.9f) {
            return 0;
        }
    }
    return 1;
}

static void test_the_ring_does_not_pass_through_the_bowl(void **state)
{
    (void)state;
    const vec3 bowl = v3(0.30f, 0.0f, 0.15f);
    /* The player presses the ring onto the bowl: first from above, then from the side, and finally
     * from below. */
    fixture_init(&fixture, 4, 1);
    fixture_move(&fixture, v3(bowl.x, 0.10f, bowl.z), 0.5f);
    fixture.hand.position_m.y = -0.10f;
    for (uint32_t i = 0; i < CORE_TICK_HZ; i++) {
        fixture_tick(&fixture);
        assert_true(clear_of_bowl());
    }
    fixture_init(&fixture, 4, 1);
    fixture_dip(&fixture);
    fixture.hand.position_m = v3(bowl.x, -0.02f, bowl.z);
    for (uint32_t i = 0; i < 2u * CORE_TICK_HZ; i++) {
        fixture_tick(&fixture);
        assert_true(clear_of_bowl());
    }
    fixture_init(&fixture, 4, 1);
    fixture_move(&fixture, v3(0.0f, -0.12f, 0.0f), 0.2f);
    fixture_move(&fixture, v3(bowl.x, -0.12f, bowl.z), 0.3f);
    fixture.hand.position_m = v3(bowl.x, 0.08f, bowl.z);
    for (uint32_t i = 0; i < CORE_TICK_HZ; i++) {
        fixture_tick(&fixture);
        assert_true(clear_of_bowl());
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_over_the_bowl_the_poi_turns_toward_it_by_55_degrees_and_back),
        cmocka_unit_test(test_an_empty_poi_does_not_turn_over_the_bowl),
        cmocka_unit_test(test_the_wrist_never_lowers_the_handle_into_the_bowl),
        cmocka_unit_test(test_controller_orientation_disables_the_automatic_turn),
        cmocka_unit_test(test_the_ring_does_not_pass_through_the_bowl),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
