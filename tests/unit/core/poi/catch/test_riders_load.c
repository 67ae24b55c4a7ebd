/* test_riders_load.c -- what fish on paper press on it with, and what bears them. */
#include "core/poi/catch/carried_fish.h"
#include "tests/unit/support/poi_stand.h"

static struct stand stand;

static uint32_t lifted(uint8_t grade, uint32_t seed, float off_x_m)
{
    return stand_lift(&stand, grade, seed, off_x_m, 0.0f);
}

static void test_a_fish_slaps_and_calms_down(void **state)
{
    (void)state;
    lifted(4, 1, 0.0f);
    uint32_t early = 0, late = 0;
    for (uint32_t tick = 0; tick < 10u * CORE_TICK_HZ; tick++) {
        stand_tick(&stand);
        assert_int_equal(stand.poi.carried_count, 1);
        const struct carried_fish *carried = &stand.poi.carried_fish[0];
        assert_true(carried->slap_n <= 0.15f);
        early += tick < 2u * CORE_TICK_HZ && carried->slap_s > 0.0f && carried->slap_n > 0.02f;
        late += tick >= 8u * CORE_TICK_HZ && carried->slap_s > 0.0f && carried->slap_n > 0.02f;
    }
    assert_true(early > 10);
    assert_true(late < early / 4u);
}

static void test_one_that_was_taken_by_surprise_slaps_by_half(void **state)
{
    (void)state;
    lifted(4, 1, 0.0f);
    const float wild = stand.poi.carried_fish[0].vigour;
    stand_init(&stand, 4, 1);
    stand_dip(&stand);
    stand_fish(&stand, v3(0.0f, -0.045f, 0.005f), 0.045f); /* It rests. */
    stand_move(&stand, v3(0.0f, 0.06f, 0.0f), 0.18f);
    assert_int_equal(stand.poi.carried_count, 1);
    assert_float_equal(stand.poi.carried_fish[0].vigour, 0.55f * wild, 0.02f);
}

static void test_every_rider_may_slap_at_once_and_none_of_their_weight_is_lost(void **state)
{
    (void)state;
    stand_init(&stand, 4, 1);
    float weight_n = 0.0f;
    for (uint32_t i = 0; i < POI_CARRIED_MAX; i++) {
        const uint32_t fish = stand_fish(&stand, v3(0.0f, 0.06f, 0.0f), 0.03f);
        const float x_m = 0.012f * (float)(i % 4u) - 0.018f;
        const float z_m = 0.012f * (float)(i / 4u) - 0.018f;
        stand.tank.fish[fish].gait = GAIT_HELD;
        stand.poi.carried_fish[i] = (struct carried_fish){ .fish = (uint16_t)fish,
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
    stand.poi.carried_count = POI_CARRIED_MAX;
    const struct stall stall = { &stand.tank, &stand.bowl, 1 };
    struct catch_result caught[POI_MAX] = { 0 };
    catch_tick(&stand.poi, 0, &stall, 0, &stand.output, caught);
    assert_int_equal(stand.poi.carried_count, POI_CARRIED_MAX);
    assert_int_equal(stand.poi.load_count, 2u * POI_CARRIED_MAX);
    float force_n = 0.0f;
    for (uint32_t i = 0; i < stand.poi.load_count; i++) {
        force_n -= stand.poi.loads[i].force_n;
    }
    assert_float_equal(force_n, weight_n, 1e-3f * weight_n);
}

/* ---- Where a slap falls --------------------------------------------------------------------- */

/* A dry poi in the air with one fish on it whose slap of 0.05 N has `left_s` to go. */
static void lay_slapping(float x_m, float heading_rad, float left_s)
{
    stand_init(&stand, 4, 1);
    struct carried_fish *carried = stand_lay(&stand, 0.05f, x_m, 0.0f, heading_rad);
    carried->slap_s = left_s;
    carried->slap_n = 0.05f;
    const struct basis level = vec_basis_from_angles(stand.poi.angles);
    carried_load_gather(&stand.poi, &level, -GRAVITY_M_S2, stand.tank.fish);
}

static void test_a_slap_falls_where_the_tail_is(void **state)
{
    (void)state;
    lay_slapping(0.0f, 0.5f * F_PI, 0.02f); /* Its nose to the left, its tail to the right. */
    assert_int_equal(stand.poi.load_count, 2);
    assert_int_equal(stand.poi.slap_count, 1);
    assert_float_equal(stand.poi.loads[0].x_m, 0.021f, 1e-5f);
    assert_float_equal(stand.poi.loads[0].z_m, 0.0f, 1e-5f);
    assert_float_equal(stand.poi.loads[0].diameter_m, 0.003f, 0.0f);
    assert_float_equal(stand.poi.loads[0].force_n, -0.05f, 0.0f);
    assert_float_equal(stand.poi.loads[1].x_m, 0.0f, 0.0f); /* Its weight, on 20 mm. */
    assert_float_equal(stand.poi.loads[1].diameter_m, 0.020f, 0.0f);
    assert_float_equal(stand.poi.loads[1].force_n, -0.0285f, 0.001f);
}

static void test_a_slap_lasts_twenty_milliseconds_to_a_part_of_a_tick(void **state)
{
    (void)state;
    float impulse_n_s = 0.0f;
    for (float left_s = 0.020f; left_s > 0.0f; left_s -= CORE_TICK_S) {
        lay_slapping(0.0f, 0.0f, left_s);
        impulse_n_s -= stand.poi.loads[0].force_n * CORE_TICK_S;
    }
    assert_float_equal(impulse_n_s, 0.05f * 0.020f, 1e-6f);
}

static void test_a_tail_beyond_the_ring_slaps_no_paper_but_its_body_takes_the_kick(void **state)
{
    (void)state;
    lay_slapping(0.025f, 0.5f * F_PI, 0.02f); /* The tail 46 mm out, the body on the paper. */
    assert_int_equal(stand.poi.load_count, 2);
    assert_float_equal(stand.poi.loads[0].x_m, 0.025f, 0.0f);
    assert_float_equal(stand.poi.loads[0].diameter_m, 0.020f, 0.0f);
    assert_float_equal(stand.poi.loads[0].force_n, -0.05f, 0.0f);
}

static void test_a_tail_over_a_hole_slaps_no_paper(void **state)
{
    (void)state;
    stand_init(&stand, 4, 1);
    stand_punch(&stand, 0.021f, 0.0f, 0.006f);
    struct carried_fish *carried = stand_lay(&stand, 0.05f, 0.0f, 0.0f, 0.5f * F_PI);
    carried->slap_s = 0.02f;
    carried->slap_n = 0.05f;
    const struct basis level = vec_basis_from_angles(stand.poi.angles);
    carried_load_gather(&stand.poi, &level, -GRAVITY_M_S2, stand.tank.fish);
    assert_float_equal(stand.poi.loads[0].diameter_m, 0.020f, 0.0f);
}

/* Under what hangs in the air: water, and the fish with or without its slap. */
static float hardest_n_m(float x_m, float left_s)
{
    lay_slapping(x_m, 0.5f * F_PI, left_s);
    stand_plain_paper(&stand.poi.sheet, 1.0f);
    const struct sheet_wetting dry = { 0.0f, 0.0f, -1.0f };
    return sheet_tick(&stand.poi.sheet, -20.0f, dry, stand.poi.loads, stand.poi.load_count)
        .tension_max_n_m;
}

static void test_head_first_with_the_tail_off_the_paper_a_slap_strains_it_by_a_fifth(void **state)
{
    (void)state;
    const float on_n_m = hardest_n_m(0.0f, 0.02f) - hardest_n_m(0.0f, 0.0f);
    const float off_n_m = hardest_n_m(0.025f, 0.02f) - hardest_n_m(0.025f, 0.0f);
    print_message("a slap of 0.05 N adds %.2f N/m with the tail on the paper, %.2f with it off\n",
                  (double)on_n_m, (double)off_n_m);
    assert_true(on_n_m > 2.0f);
    assert_true(off_n_m < 0.2f * on_n_m);
}

static void test_a_fish_taken_up_near_the_rim_has_its_tail_beyond_the_ring(void **state)
{
    (void)state;
    uint32_t beyond = 0;
    for (uint32_t seed = 0; seed < 10; seed++) {
        float x_m, z_m;
        stand_init(&stand, 4, seed);
        stand_dip(&stand);
        const uint32_t fish = stand_fish(&stand, v3(0.030f, -0.045f, 0.0f), 0.045f);
        stand.tank.fish[fish].angles.yaw_rad = 0.5f * F_PI; /* Looks in over the paper. */
        stand_move(&stand, v3(0.0f, 0.01f, 0.0f), 0.18f);
        assert_int_equal(stand.poi.carried_count, 1);
        carried_fish_tail(&stand.poi.carried_fish[0], 0.045f, &x_m, &z_m);
        beyond += !sheet_holds(&stand.poi.sheet, x_m, z_m);
    }
    assert_in_range(beyond, 9, 10);
}

static void test_water_bears_it_by_as_much_as_it_is_under(void **state)
{
    (void)state;
    const struct basis level = vec_basis_from_angles((struct angles){ 0.0f, 0.0f, 0.0f });
    stand_init(&stand, 4, 1);
    struct carried_fish *carried = stand_lay(&stand, 0.05f, 0.0f, 0.0f, 0.0f);
    const struct fish *fish = &stand.tank.fish[carried->fish];
    const float y_m[] = { 0.01f, 0.0f, -0.5f * fish->width_m, -fish->width_m, -0.05f };
    const float dry[] = { 1.0f, 1.0f, 0.5f, 0.0f, 0.0f };
    for (int i = 0; i < 5; i++) {
        stand.poi.position_m.y = y_m[i];
        assert_float_equal(carried_load_dryness(&stand.poi, &level, carried, fish), dry[i], 1e-5f);
        carried_load_gather(&stand.poi, &level, -GRAVITY_M_S2, stand.tank.fish);
        const float bears_n = stand.poi.load_count > 0 ? -stand.poi.loads[0].force_n : 0.0f;
        assert_float_equal(bears_n, dry[i] * fish_mass_kg(0.05f) * GRAVITY_M_S2, 1e-6f);
    }
}

/* ---- What bears it -------------------------------------------------------------------------- */

static void test_a_fish_falls_through_a_hole_that_is_under_it(void **state)
{
    (void)state;
    const uint32_t fish = lifted(4, 1, 0.0f);
    const struct carried_fish carried = stand.poi.carried_fish[0];
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        const float x = ((float)(cell % SHEET_SIDE) + 0.5f) * 0.0025f - 0.04f - carried.x_m;
        const float z = ((float)(cell / SHEET_SIDE) + 0.5f) * 0.0025f - 0.04f - carried.z_m;
        if (stand.poi.sheet.state[cell] == CELL_PAPER && x * x + z * z < 0.015f * 0.015f) {
            stand.poi.sheet.state[cell] = CELL_HOLE;
            stand.poi.sheet.paper_cells--;
        }
    }
    stand_wait(&stand, 0.05f);
    assert_int_equal(stand.poi.carried_fish[0].state, CARRIED_FALLING);
    stand_wait(&stand, 0.5f);
    assert_int_equal(stand.poi.carried_count, 0);
    assert_int_not_equal(stand.tank.fish[fish].gait, GAIT_HELD);
    assert_true(stand.tank.fish[fish].position_m.y < 0.0f);
    assert_int_equal(stand.landed, 0);
}

static void test_a_hole_elsewhere_drops_nobody(void **state)
{
    (void)state;
    lifted(4, 1, 0.0f);
    const float away = stand.poi.carried_fish[0].x_m > 0.0f ? -0.03f : 0.03f;
    const uint32_t column = (uint32_t)((away + 0.04f) / 0.0025f);
    stand.poi.sheet.state[SHEET_SIDE / 2u * SHEET_SIDE + column] = CELL_HOLE;
    stand.poi.sheet.paper_cells--;
    stand_wait(&stand, 0.5f);
    assert_int_equal(stand.poi.carried_count, 1);
}

/* Whether a fish of 5 cm whose nose looks to the left stays up at a place. */
static int stays(float x_m, float z_m)
{
    struct carried_fish *carried = stand_lay(&stand, 0.05f, x_m, z_m, 0.5f * F_PI);
    return carried_support_holds(&stand.poi.sheet, carried, &stand.tank.fish[carried->fish]);
}

static void test_a_pinhole_under_its_middle_drops_nobody_and_one_of_its_girth_does(void **state)
{
    (void)state;
    stand_init(&stand, 4, 1);
    stand_punch(&stand, 0.0f, 0.0f, 0.0025f);
    assert_true(sheet_left(&stand.poi.sheet) < 1.0f);
    assert_true(stays(0.0f, 0.0f));
    stand_punch(&stand, 0.0f, 0.0f, 0.009f);
    assert_false(stays(0.0f, 0.0f));
    assert_true(stays(-0.018f, 0.0f)); /* Its tail alone is over it. */
    assert_true(stays(0.0f, 0.017f));  /* It lies beside it. */
}

static void test_a_strip_under_its_middle_alone_bears_nobody(void **state)
{
    (void)state;
    stand_init(&stand, 4, 1);
    stand_punch(&stand, -0.016f, 0.0f, 0.013f);
    assert_true(stays(0.0f, 0.0f)); /* Its rear half still lies on something. */
    stand_punch(&stand, 0.016f, 0.0f, 0.013f);
    assert_true(sheet_holds(&stand.poi.sheet, 0.0f, 0.0f));
    assert_false(stays(0.0f, 0.0f));
}

static void test_the_ring_bears_whom_the_paper_does_not(void **state)
{
    (void)state;
    stand_init(&stand, 4, 1);
    stand_punch(&stand, 0.0f, 0.0f, 0.036f); /* A fringe is left. */
    assert_true(stays(0.0f, 0.043f));        /* Along it. */
    assert_false(stays(0.043f, 0.0f));       /* Across it, half in the air: it tips over. */
    assert_false(stays(0.0f, 0.0f));
    assert_false(stays(0.048f, 0.0f)); /* Its middle beyond the ring: it slips off. */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_fish_slaps_and_calms_down),
        cmocka_unit_test(test_one_that_was_taken_by_surprise_slaps_by_half),
        cmocka_unit_test(test_every_rider_may_slap_at_once_and_none_of_their_weight_is_lost),
        cmocka_unit_test(test_a_slap_falls_where_the_tail_is),
        cmocka_unit_test(test_a_slap_lasts_twenty_milliseconds_to_a_part_of_a_tick),
        cmocka_unit_test(test_a_tail_beyond_the_ring_slaps_no_paper_but_its_body_takes_the_kick),
        cmocka_unit_test(test_a_tail_over_a_hole_slaps_no_paper),
        cmocka_unit_test(test_head_first_with_the_tail_off_the_paper_a_slap_strains_it_by_a_fifth),
        cmocka_unit_test(test_a_fish_taken_up_near_the_rim_has_its_tail_beyond_the_ring),
        cmocka_unit_test(test_water_bears_it_by_as_much_as_it_is_under),
        cmocka_unit_test(test_a_fish_falls_through_a_hole_that_is_under_it),
        cmocka_unit_test(test_a_hole_elsewhere_drops_nobody),
        cmocka_unit_test(test_a_pinhole_under_its_middle_drops_nobody_and_one_of_its_girth_does),
        cmocka_unit_test(test_a_strip_under_its_middle_alone_bears_nobody),
        cmocka_unit_test(test_the_ring_bears_whom_the_paper_does_not),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
