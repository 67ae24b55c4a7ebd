/* test_carried_load.c -- checks how carried fish load the paper, and when a fish falls through a
 * hole in the paper. */
#include "core/poi/catch/carried_fish.h"
#include "tests/unit/support/poi_fixture.h"

static struct poi_fixture fixture;

static uint32_t lifted(uint8_t grade, uint32_t seed, float off_x_m)
{
    return fixture_lift(&fixture, grade, seed, off_x_m, 0.0f);
}

static void test_a_fish_slaps_and_calms_down(void **state)
{
    (void)state;
    lifted(4, 1, 0.0f);
    uint32_t early = 0, late = 0;
    for (uint32_t tick = 0; tick < 10u * CORE_TICK_HZ; tick++) {
        fixture_tick(&fixture);
        assert_int_equal(fixture.poi.carried_count, 1);
        const struct carried_fish *carried = &fixture.poi.carried_fish[0];
        assert_true(carried->slap_n <= 0.15f);
        early += tick < 2u * CORE_TICK_HZ && carried->slap_s > 0.0f && carried->slap_n > 0.02f;
        late += tick >= 8u * CORE_TICK_HZ && carried->slap_s > 0.0f && carried->slap_n > 0.02f;
    }
    assert_true(early > 10);
    assert_true(late < early / 4u);
}

static void test_a_surprised_fish_slaps_with_half_the_force(void **state)
{
    (void)state;
    lifted(4, 1, 0.0f);
    const float wild = fixture.poi.carried_fish[0].vigour;
    fixture_init(&fixture, 4, 1);
    fixture_dip(&fixture);
    /* This fish rested before the lift, so it slaps with only 55 % of the vigour. */
    fixture_add_fish(&fixture, v3(0.0f, -0.045f, 0.005f), 0.045f);
    fixture_move(&fixture, v3(0.0f, 0.06f, 0.0f), 0.18f);
    assert_int_equal(fixture.poi.carried_count, 1);
    assert_float_equal(fixture.poi.carried_fish[0].vigour, 0.55f * wild, 0.02f);
}

static void test_all_carried_fish_may_slap_together_and_keep_their_weight(void **state)
{
    (void)state;
    fixture_init(&fixture, 4, 1);
    float weight_n = 0.0f;
    for (uint32_t i = 0; i < POI_CARRIED_MAX; i++) {
        const uint32_t fish = fixture_add_fish(&fixture, v3(0.0f, 0.06f, 0.0f), 0.03f);
        const float x_m = 0.012f * (float)(i % 4u) - 0.018f;
        const float z_m = 0.012f * (float)(i / 4u) - 0.018f;
        fixture.tank.fish[fish].gait = GAIT_HELD;
        fixture.poi.carried_fish[i] = (struct carried_fish){ .fish = (uint16_t)fish,
                                                             .side = 1,
                                                             .x_m = x_m,
                                                             .z_m = z_m,
                                                             .height_m = 0.003f,
                                                             .lie = 1.0f,
                                                             .rest_s = 1.0f,
                                                             .slap_s = 0.02f,
                                                             .slap_n = 1e-3f,
                                                             .slap_d_m = 0.003f };
        weight_n += fish_mass_kg(0.03f) * GRAVITY_M_S2 + 1e-3f;
    }
    fixture.poi.carried_count = POI_CARRIED_MAX;
    const struct stall stall = { &fixture.tank, &fixture.bowl, 1, false };
    struct catch_result caught[POI_MAX] = { 0 };
    catch_tick(&fixture.poi, 0, &stall, 0, &fixture.output, caught);
    assert_int_equal(fixture.poi.carried_count, POI_CARRIED_MAX);
    assert_int_equal(fixture.poi.load_count, 2u * POI_CARRIED_MAX);
    float force_n = 0.0f;
    for (uint32_t i = 0; i < fixture.poi.load_count; i++) {
        force_n -= fixture.poi.loads[i].force_n;
    }
    assert_float_equal(force_n, weight_n, 1e-3f * weight_n);
}

/* ---- Position of a slap --------------------------------------------------------------------- */

/* Puts one fish on a dry poi in the air. The fish slaps with 0.05 N for `left_s` more seconds. */
static void lay_slapping(float x_m, float heading_rad, float left_s)
{
    fixture_init(&fixture, 4, 1);
    struct carried_fish *carried = fixture_place_fish(&fixture, 0.05f, x_m, 0.0f, heading_rad);
    carried->slap_s = left_s;
    carried->slap_n = 0.05f;
    const struct basis level = vec_basis_from_angles(fixture.poi.angles);
    carried_load_gather(&fixture.poi, &level, -GRAVITY_M_S2, fixture.tank.fish);
}

static void test_a_slap_loads_the_paper_at_the_tail(void **state)
{
    (void)state;
    /* The head of the fish points to the left, so the tail slaps 21 mm to the right of the middle
     * of the body. */
    lay_slapping(0.0f, 0.5f * F_PI, 0.02f);
    assert_int_equal(fixture.poi.load_count, 2);
    assert_int_equal(fixture.poi.slap_count, 1);
    assert_float_equal(fixture.poi.loads[0].x_m, 0.021f, 1e-5f);
    assert_float_equal(fixture.poi.loads[0].z_m, 0.0f, 1e-5f);
    assert_float_equal(fixture.poi.loads[0].diameter_m, 0.003f, 0.0f);
    assert_float_equal(fixture.poi.loads[0].force_n, -0.05f, 0.0f);
    /* The element loads[1] is the fish's weight. The weight acts at the middle of the body and is
     * spread over 20 mm. */
    assert_float_equal(fixture.poi.loads[1].x_m, 0.0f, 0.0f);
    assert_float_equal(fixture.poi.loads[1].diameter_m, 0.020f, 0.0f);
    assert_float_equal(fixture.poi.loads[1].force_n, -0.0285f, 0.001f);
}

static void test_a_slap_lasts_20_ms_with_subtick_precision(void **state)
{
    (void)state;
    float impulse_n_s = 0.0f;
    for (float left_s = 0.020f; left_s > 0.0f; left_s -= CORE_TICK_S) {
        lay_slapping(0.0f, 0.0f, left_s);
        impulse_n_s -= fixture.poi.loads[0].force_n * CORE_TICK_S;
    }
    assert_float_equal(impulse_n_s, 0.05f * 0.020f, 1e-6f);
}

static void test_a_tail_beyond_the_ring_slaps_no_paper_but_kicks_the_body(void **state)
{
    (void)state;
    /* The body is 25 mm from the middle of the paper. The tail is at 46 mm, which is beyond the
     * paper's radius of 40 mm, so it does not hit the paper. The force of the slap must therefore
     * act at the body. */
    lay_slapping(0.025f, 0.5f * F_PI, 0.02f);
    assert_int_equal(fixture.poi.load_count, 2);
    assert_float_equal(fixture.poi.loads[0].x_m, 0.025f, 0.0f);
    assert_float_equal(fixture.poi.loads[0].diameter_m, 0.020f, 0.0f);
    assert_float_equal(fixture.poi.loads[0].force_n, -0.05f, 0.0f);
}

static void test_a_tail_over_a_hole_slaps_no_paper(void **state)
{
    (void)state;
    fixture_init(&fixture, 4, 1);
    fixture_tear_hole(&fixture, 0.021f, 0.0f, 0.006f);
    struct carried_fish *carried = fixture_place_fish(&fixture, 0.05f, 0.0f, 0.0f, 0.5f * F_PI);
    carried->slap_s = 0.02f;
    carried->slap_n = 0.05f;
    const struct basis level = vec_basis_from_angles(fixture.poi.angles);
    carried_load_gather(&fixture.poi, &level, -GRAVITY_M_S2, fixture.tank.fish);
    assert_float_equal(fixture.poi.loads[0].diameter_m, 0.020f, 0.0f);
}

/* Returns the highest tension of the paper while it carries water and a fish in the air. If
 * `left_s` is above 0, the fish slaps. */
static float hardest_n_m(float x_m, float left_s)
{
    lay_slapping(x_m, 0.5f * F_PI, left_s);
    fixture_plain_paper(&fixture.poi.sheet, 1.0f);
    const struct sheet_wetting dry = { 0.0f, 0.0f, -1.0f };
    return sheet_tick(&fixture.poi.sheet, -20.0f, dry, fixture.poi.loads, fixture.poi.load_count)
        .tension_max_n_m;
}

static void test_a_slap_with_the_tail_off_the_paper_strains_it_a_fifth_as_much(void **state)
{
    (void)state;
    const float on_n_m = hardest_n_m(0.0f, 0.02f) - hardest_n_m(0.0f, 0.0f);
    const float off_n_m = hardest_n_m(0.025f, 0.02f) - hardest_n_m(0.025f, 0.0f);
    print_message("a slap of 0.05 N adds %.2f N/m with the tail on the paper, %.2f with it off\n",
                  (double)on_n_m, (double)off_n_m);
    assert_true(on_n_m > 2.0f);
    assert_true(off_n_m < 0.2f * on_n_m);
}

static void test_a_fish_captured_near_the_ring_has_its_tail_beyond_it(void **state)
{
    (void)state;
    uint32_t beyond = 0;
    for (uint32_t seed = 0; seed < 10; seed++) {
        float x_m, z_m;
        fixture_init(&fixture, 4, seed);
        fixture_dip(&fixture);
        const uint32_t fish = fixture_add_fish(&fixture, v3(0.030f, -0.045f, 0.0f), 0.045f);
        /* The head of the fish points to the middle of the paper, so the tail is beyond the
         * ring. */
        fixture.tank.fish[fish].angles.yaw_rad = 0.5f * F_PI;
        fixture_move(&fixture, v3(0.0f, 0.01f, 0.0f), 0.18f);
        assert_int_equal(fixture.poi.carried_count, 1);
        carried_fish_tail(&fixture.poi.carried_fish[0], 0.045f, &x_m, &z_m);
        beyond += !sheet_holds(&fixture.poi.sheet, x_m, z_m);
    }
    assert_in_range(beyond, 9, 10);
}

static void test_buoyancy_supports_the_immersed_part_of_a_fish(void **state)
{
    (void)state;
    const struct basis level = vec_basis_from_angles((struct angles){ 0.0f, 0.0f, 0.0f });
    fixture_init(&fixture, 4, 1);
    struct carried_fish *carried = fixture_place_fish(&fixture, 0.05f, 0.0f, 0.0f, 0.0f);
    const struct fish *fish = &fixture.tank.fish[carried->fish];
    const float y_m[] = { 0.01f, 0.0f, -0.5f * fish->width_m, -fish->width_m, -0.05f };
    const float dry[] = { 1.0f, 1.0f, 0.5f, 0.0f, 0.0f };
    for (int i = 0; i < 5; i++) {
        fixture.poi.position_m.y = y_m[i];
        assert_float_equal(carried_load_dryness(&fixture.poi, &level, carried, fish), dry[i],
                           1e-5f);
        carried_load_gather(&fixture.poi, &level, -GRAVITY_M_S2, fixture.tank.fish);
        const float bears_n = fixture.poi.load_count > 0 ? -fixture.poi.loads[0].force_n : 0.0f;
        assert_float_equal(bears_n, dry[i] * fish_mass_kg(0.05f) * GRAVITY_M_S2, 1e-6f);
    }
}

/* ---- Support of a fish ---------------------------------------------------------------------- */

static void test_a_fish_falls_through_a_hole_that_is_under_it(void **state)
{
    (void)state;
    const uint32_t fish = lifted(4, 1, 0.0f);
    const struct carried_fish carried = fixture.poi.carried_fish[0];
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        const float x = ((float)(cell % SHEET_SIDE) + 0.5f) * 0.0025f - 0.04f - carried.x_m;
        const float z = ((float)(cell / SHEET_SIDE) + 0.5f) * 0.0025f - 0.04f - carried.z_m;
        if (fixture.poi.sheet.state[cell] == CELL_PAPER && x * x + z * z < 0.015f * 0.015f) {
            fixture.poi.sheet.state[cell] = CELL_HOLE;
            fixture.poi.sheet.paper_cells--;
        }
    }
    fixture_wait(&fixture, 0.05f);
    assert_int_equal(fixture.poi.carried_fish[0].state, CARRIED_FALLING);
    fixture_wait(&fixture, 0.5f);
    assert_int_equal(fixture.poi.carried_count, 0);
    assert_int_not_equal(fixture.tank.fish[fish].gait, GAIT_HELD);
    assert_true(fixture.tank.fish[fish].position_m.y < 0.0f);
    assert_int_equal(fixture.landed, 0);
}

static void test_a_hole_elsewhere_drops_no_fish(void **state)
{
    (void)state;
    lifted(4, 1, 0.0f);
    const float away = fixture.poi.carried_fish[0].x_m > 0.0f ? -0.03f : 0.03f;
    const uint32_t column = (uint32_t)((away + 0.04f) / 0.0025f);
    fixture.poi.sheet.state[SHEET_SIDE / 2u * SHEET_SIDE + column] = CELL_HOLE;
    fixture.poi.sheet.paper_cells--;
    fixture_wait(&fixture, 0.5f);
    assert_int_equal(fixture.poi.carried_count, 1);
}

/* Returns 1 if the paper supports a fish of 5 cm at the position `x_m`, `z_m`. The head of the fish
 * points to the left. */
static int stays(float x_m, float z_m)
{
    struct carried_fish *carried = fixture_place_fish(&fixture, 0.05f, x_m, z_m, 0.5f * F_PI);
    return carried_support_holds(&fixture.poi.sheet, carried, &fixture.tank.fish[carried->fish]);
}

static void test_a_hole_as_wide_as_the_fish_drops_it_and_a_pinhole_does_not(void **state)
{
    (void)state;
    fixture_init(&fixture, 4, 1);
    fixture_tear_hole(&fixture, 0.0f, 0.0f, 0.0025f);
    assert_true(sheet_left(&fixture.poi.sheet) < 1.0f);
    assert_true(stays(0.0f, 0.0f));
    fixture_tear_hole(&fixture, 0.0f, 0.0f, 0.009f);
    assert_false(stays(0.0f, 0.0f));
    /* The hole of 9 mm is only under the tail of this fish. */
    assert_true(stays(-0.018f, 0.0f));
    /* The hole is beside this fish. */
    assert_true(stays(0.0f, 0.017f));
}

static void test_a_strip_under_the_middle_alone_supports_no_fish(void **state)
{
    (void)state;
    fixture_init(&fixture, 4, 1);
    fixture_tear_hole(&fixture, -0.016f, 0.0f, 0.013f);
    /* The hole is under the front half of the fish, but the rear half still lies on paper. */
    assert_true(stays(0.0f, 0.0f));
    fixture_tear_hole(&fixture, 0.016f, 0.0f, 0.013f);
    assert_true(sheet_holds(&fixture.poi.sheet, 0.0f, 0.0f));
    assert_false(stays(0.0f, 0.0f));
}

static void test_the_ring_supports_a_fish_without_paper(void **state)
{
    (void)state;
    fixture_init(&fixture, 4, 1);
    /* Leaves only a strip of paper along the ring. The strip is 4 mm wide, because the radius of
     * the ring is 40 mm. */
    fixture_tear_hole(&fixture, 0.0f, 0.0f, 0.036f);
    /* The fish lies along the ring, which supports the whole fish. */
    assert_true(stays(0.0f, 0.043f));
    /* The fish lies across the ring. Half of its body is over the hole, so the fish tips over. */
    assert_false(stays(0.043f, 0.0f));
    assert_false(stays(0.0f, 0.0f));
    /* The middle of the fish is outside the ring, so the fish slips off. */
    assert_false(stays(0.048f, 0.0f));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_fish_slaps_and_calms_down),
        cmocka_unit_test(test_a_surprised_fish_slaps_with_half_the_force),
        cmocka_unit_test(test_all_carried_fish_may_slap_together_and_keep_their_weight),
        cmocka_unit_test(test_a_slap_loads_the_paper_at_the_tail),
        cmocka_unit_test(test_a_slap_lasts_20_ms_with_subtick_precision),
        cmocka_unit_test(test_a_tail_beyond_the_ring_slaps_no_paper_but_kicks_the_body),
        cmocka_unit_test(test_a_tail_over_a_hole_slaps_no_paper),
        cmocka_unit_test(test_a_slap_with_the_tail_off_the_paper_strains_it_a_fifth_as_much),
        cmocka_unit_test(test_a_fish_captured_near_the_ring_has_its_tail_beyond_it),
        cmocka_unit_test(test_buoyancy_supports_the_immersed_part_of_a_fish),
        cmocka_unit_test(test_a_fish_falls_through_a_hole_that_is_under_it),
        cmocka_unit_test(test_a_hole_elsewhere_drops_no_fish),
        cmocka_unit_test(test_a_hole_as_wide_as_the_fish_drops_it_and_a_pinhole_does_not),
        cmocka_unit_test(test_a_strip_under_the_middle_alone_supports_no_fish),
        cmocka_unit_test(test_the_ring_supports_a_fish_without_paper),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
