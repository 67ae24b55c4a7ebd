/* test_carried_fish.c -- checks how a single fish moves on the paper of a tilted poi. */
#include "tests/unit/support/poi_fixture.h"
#include "tests/unit/support/pond.h"

static struct fish fish;
static struct carried_fish carried;

static void lay(float heading_rad)
{
    fish = (struct fish){ WAKIN(0.05f), .stamina = 1.0f };
    carried = (struct carried_fish){
        .side = 1, .lie = 1.0f, .height_m = 0.005f, .heading_rad = heading_rad, .rest_s = 1e6f
    };
}

/* Returns the surface of flat paper whose right side is lowered by the angle `roll_rad`. */
static struct paper_surface tilted(float roll_rad)
{
    return (struct paper_surface){ .pull_m_s2 = { GRAVITY_M_S2 * f_sin(roll_rad),
                                                  -GRAVITY_M_S2 * f_cos(roll_rad), 0.0f },
                                   .uphill_x = -f_sin(roll_rad),
                                   .radius_m = 0.040f };
}

static void ride_for(float roll_rad, float seconds)
{
    const struct paper_surface ride = tilted(roll_rad);
    for (uint32_t i = 0; (float)i < seconds * (float)CORE_TICK_HZ; i++) {
        carried_fish_tick(&carried, &fish, &ride, 1.0f, 1, i);
    }
}

static void test_a_five_centimetre_fish_weighs_nearly_three_grams(void **state)
{
    (void)state;
    assert_float_equal(fish_mass_kg(0.05f), 0.0029f, 0.0001f);
    assert_float_equal(fish_mass_kg(0.04f), 0.00146f, 0.0001f);
    assert_float_equal(fish_mass_kg(0.08f), 0.0122f, 0.0004f);
}

static void test_friction_holds_a_fish_on_a_slight_slope(void **state)
{
    (void)state;
    lay(0.0f);
    ride_for(15.0f * F_DEG, 2.0f);
    assert_float_equal(carried.x_m, 0.0f, 0.0f);
}

static void test_a_fish_on_a_steeper_slope_slides_to_the_ring_and_stops(void **state)
{
    (void)state;
    lay(0.0f);
    ride_for(28.0f * F_DEG, 2.0f);
    assert_true(carried.x_m > 0.030f);
    assert_true(carried.x_m < 0.040f);
}

static void test_a_fish_passes_the_3_mm_ring_wall_on_a_steep_slope(void **state)
{
    (void)state;
    lay(0.0f);
    ride_for(50.0f * F_DEG, 1.0f);
    assert_true(carried.x_m > 0.0465f);
}

static void test_a_head_up_fish_calms_down_sooner(void **state)
{
    (void)state;
    /* The paper is rolled to the right, so its left side is higher. The head of the fish points to
     * the left. */
    lay(0.5f * F_PI);
    carried.vigour = 1.0f;
    ride_for(18.0f * F_DEG, 1.0f);
    const float head_up = carried.vigour;
    lay(-0.5f * F_PI);
    carried.vigour = 1.0f;
    ride_for(18.0f * F_DEG, 1.0f);
    assert_true(head_up < 0.75f * carried.vigour);
}

static void test_slaps_have_5_to_10_hz_and_the_measured_force(void **state)
{
    (void)state;
    const struct paper_surface level = tilted(0.0f);
    uint32_t slaps = 0;
    float hardest = 0.0f, softest = 1.0f;
    for (uint32_t seed = 0; seed < 50; seed++) {
        lay(0.0f);
        carried.rest_s = 0.0f;
        for (uint32_t i = 0; i < CORE_TICK_HZ; i++) {
            carried.vigour = 1.0f;
            const float force_n = carried_fish_tick(&carried, &fish, &level, 1.0f, seed, i);
            slaps += force_n > 0.0f;
            hardest = f_max(hardest, force_n);
            softest = force_n > 0.0f ? f_min(softest, force_n) : softest;
        }
    }
    assert_in_range(slaps / 50u, 4, 10);
    assert_float_equal(softest, 0.03f, 0.006f);
    assert_float_equal(hardest, 0.087f, 0.006f);
}

static void test_the_tail_is_behind_the_nose(void **state)
{
    (void)state;
    float x, z;
    lay(0.0f);
    carried_fish_tail(&carried, 0.05f, &x, &z);
    assert_float_equal(x, 0.0f, 1e-6f);
    /* The head of the fish points to -z, so the tail is 21 mm from the middle of the body toward
     * +z. */
    assert_float_equal(z, 0.021f, 1e-6f);
    const struct basis level = vec_basis_from_angles((struct angles){ 0.0f, 0.0f, 0.0f });
    carried.heading_rad = 1.0f;
    const struct paper_surface flat = tilted(0.0f);
    carried_fish_pose(&carried, &flat, v3(0.1f, 0.2f, 0.3f), &level, &fish);
    assert_float_equal(fish.angles.yaw_rad, 1.0f, 1e-4f);
    assert_float_equal(f_abs(fish.angles.roll_rad), 80.0f * F_DEG, 1e-3f);
    assert_float_equal(fish.position_m.y, 0.205f, 1e-5f);
}

static void test_slaps_move_a_fish_down_a_slope_that_friction_would_hold(void **state)
{
    (void)state;
    const struct paper_surface ride = tilted(12.0f * F_DEG);
    float still = 0.0f, shaken = 0.0f;
    for (uint32_t seed = 0; seed < 20; seed++) {
        lay(0.0f);
        ride_for(12.0f * F_DEG, 2.0f);
        still += carried.x_m;
        lay(0.0f);
        carried.rest_s = 0.1f;
        for (uint32_t i = 0; i < 2u * CORE_TICK_HZ; i++) {
            carried.vigour = 0.5f;
            carried_fish_tick(&carried, &fish, &ride, 1.0f, seed, i);
        }
        shaken += carried.x_m;
    }
    assert_float_equal(still, 0.0f, 0.0f);
    /* The slaps must move the fish by more than 10 mm on average. The slaps move the fish down the
     * slope, to the right. */
    assert_true(shaken / 20.0f > 0.010f);
}

/* Lays 50 fish on the paper, one after another, each 20 mm beside the middle. Each fish slaps for
 * `seconds` seconds. Returns their mean distance from the middle at the end. */
static float drawn_in_m(float belly_m, float give_per_n, float seconds)
{
    struct paper_surface ride = tilted(0.0f);
    float sum_m = 0.0f;
    ride.belly_m = belly_m;
    ride.give_per_n = give_per_n;
    for (uint32_t seed = 0; seed < 50; seed++) {
        lay(F_TAU * (float)seed / 50.0f);
        carried.x_m = 0.020f;
        carried.rest_s = 0.1f;
        for (uint32_t i = 0; (float)i < seconds * (float)CORE_TICK_HZ; i++) {
            carried.vigour = 0.4f;
            carried_fish_tick(&carried, &fish, &ride, 1.0f, seed, i);
        }
        sum_m += f_sqrt(carried.x_m * carried.x_m + carried.z_m * carried.z_m);
    }
    return sum_m / 50.0f;
}

static void test_a_fish_slides_toward_the_middle_of_the_belly(void **state)
{
    (void)state;
    const float board_m = drawn_in_m(0.0f, 0.0f, 3.0f);
    const float belly_m = drawn_in_m(0.003f, 1.0f / (F_TAU * 2.0f), 3.0f);
    print_message("from 20 mm: on a board to %.1f mm, on paper that sags 3 mm to %.1f mm\n",
                  1e3 * (double)board_m, 1e3 * (double)belly_m);
    assert_true(board_m > 0.020f);
    assert_true(belly_m < 0.014f);
}

static void test_a_fish_that_lies_still_slides_into_a_deep_belly(void **state)
{
    (void)state;
    struct paper_surface ride = tilted(0.0f);
    ride.belly_m = 0.008f;
    ride.give_per_n = 1.0f / (F_TAU * 2.0f);
    lay(0.0f);
    carried.x_m = 0.036f;
    for (uint32_t i = 0; i < CORE_TICK_HZ; i++) {
        carried_fish_tick(&carried, &fish, &ride, 1.0f, 1, i);
    }
    assert_true(carried.x_m < 0.030f);
}

static float vigour_after(float belly_m)
{
    struct paper_surface ride = tilted(0.0f);
    ride.belly_m = belly_m;
    lay(0.0f);
    carried.vigour = 1.0f;
    for (uint32_t i = 0; i < CORE_TICK_HZ; i++) {
        carried_fish_tick(&carried, &fish, &ride, 1.0f, 1, i);
    }
    return carried.vigour;
}

static void test_paper_that_sags_around_a_fish_calms_it(void **state)
{
    (void)state;
    const float flat = vigour_after(0.0f), cradled = vigour_after(0.003f);
    assert_float_equal(1.0f - cradled, 1.45f * (1.0f - flat), 0.15f * (1.0f - flat));
    /* Paper that bulges upward does not surround the fish. Such paper must therefore not calm the
     * fish. */
    assert_true(vigour_after(-0.003f) >= flat);
}

static void test_a_fish_lies_in_the_belly_and_not_over_it(void **state)
{
    (void)state;
    const struct basis level = vec_basis_from_angles((struct angles){ 0.0f, 0.0f, 0.0f });
    struct paper_surface ride = tilted(0.0f);
    ride.belly_m = 0.003f;
    lay(0.0f);
    carried_fish_pose(&carried, &ride, v3(0.0f, 0.0f, 0.0f), &level, &fish);
    assert_float_equal(fish.position_m.y, 0.002f, 1e-6f);
    /* The paper does not sag at the ring, so the fish lies 3 mm higher there than in the middle. */
    carried.x_m = 0.040f;
    carried_fish_pose(&carried, &ride, v3(0.0f, 0.0f, 0.0f), &level, &fish);
    assert_float_equal(fish.position_m.y, 0.005f, 1e-6f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_five_centimetre_fish_weighs_nearly_three_grams),
        cmocka_unit_test(test_friction_holds_a_fish_on_a_slight_slope),
        cmocka_unit_test(test_a_fish_on_a_steeper_slope_slides_to_the_ring_and_stops),
        cmocka_unit_test(test_a_fish_passes_the_3_mm_ring_wall_on_a_steep_slope),
        cmocka_unit_test(test_a_head_up_fish_calms_down_sooner),
        cmocka_unit_test(test_slaps_have_5_to_10_hz_and_the_measured_force),
        cmocka_unit_test(test_the_tail_is_behind_the_nose),
        cmocka_unit_test(test_slaps_move_a_fish_down_a_slope_that_friction_would_hold),
        cmocka_unit_test(test_a_fish_slides_toward_the_middle_of_the_belly),
        cmocka_unit_test(test_a_fish_that_lies_still_slides_into_a_deep_belly),
        cmocka_unit_test(test_paper_that_sags_around_a_fish_calms_it),
        cmocka_unit_test(test_a_fish_lies_in_the_belly_and_not_over_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
