/* test_tear_clip.c -- checks the cause of a tear, and the recording of the tear that is shown in
 * slow motion. */
#include "tests/unit/support/poi_fixture.h"

#include "core/poi/tear_clip.h"

static struct poi_fixture fixture;
static struct tear_clip clip;
static struct scene_tear shown;

static int setup(void **state)
{
    (void)state;
    fixture_init(&fixture, 6, 3);
    memset(&clip, 0, sizeof clip);
    return 0;
}

/* Turns a wet poi, which is 6 cm under water, to the pitch `pitch_rad`. Then moves the poi by
 * `step_m` in each tick until its paper tears. Returns the cause of the first tear, or TEAR_NONE if
 * the paper has not torn after a quarter of a second. */
static uint8_t cause_of_motion(float pitch_rad, vec3 step_m)
{
    fixture_init(&fixture, 6, 3);
    fixture_dip(&fixture);
    fixture.has_wrist = 1;
    fixture_turn(&fixture, pitch_rad, 0.0f, 0.5f);
    for (uint32_t i = 0; i < CORE_TICK_HZ / 4u; i++) {
        fixture.hand.position_m = v3_add(fixture.hand.position_m, step_m);
        fixture_tick(&fixture);
        if (fixture.poi.strain.cells_torn > 0) {
            return tear_cause_of(&clip, &fixture.poi);
        }
    }
    return TEAR_NONE;
}

static void test_paper_that_is_pulled_up_level_tears_because_it_was_flat(void **state)
{
    (void)state;
    assert_int_equal(cause_of_motion(0.0f, v3(0.0f, 0.008f, 0.0f)), TEAR_FLAT);
}

static void test_slanted_paper_tears_because_it_was_fast(void **state)
{
    (void)state;
    /* In this case the ring moves at an angle of 30 degrees to its plane. */
    assert_int_equal(cause_of_motion(30.0f * F_DEG, v3(0.0f, 0.0f, 0.02f)), TEAR_FAST);
}

static void test_a_slow_glide_does_not_tear(void **state)
{
    (void)state;
    assert_int_equal(cause_of_motion(30.0f * F_DEG, v3(0.0f, 0.0f, 0.001f)), TEAR_NONE);
}

/* Sets the state of a poi whose paper tears in this tick. `tension_share` is the tension as a
 * fraction of the strength of wet paper. */
static struct poi *torn_by(float tension_share, struct sheet_load load, bool is_slap)
{
    struct poi *poi = &fixture.poi;
    poi->strain.cells_torn = 1;
    poi->strain.tension_max_n_m = tension_share * sheet_grade(poi->sheet.grade)->wet_n_m;
    poi->loads[0] = load;
    poi->load_count = 1;
    poi->slap_count = is_slap;
    return poi;
}

static void test_fish_tear_the_paper_by_a_slap_or_by_their_weight(void **state)
{
    (void)state;
    const struct sheet_load load = { 0.0f, 0.0f, 0.004f, -0.2f };
    assert_int_equal(tear_cause_of(&clip, torn_by(1.0f, load, true)), TEAR_SLAP);
    assert_int_equal(tear_cause_of(&clip, torn_by(1.0f, load, false)), TEAR_WEIGHT);
    fixture.poi.strain.cells_torn = 0;
    assert_int_equal(tear_cause_of(&clip, &fixture.poi), TEAR_NONE);
}

static void test_water_above_the_surface_tears_by_its_weight_unless_the_poi_is_jerked(void **state)
{
    (void)state;
    struct poi *poi = torn_by(1.0f, (struct sheet_load){ 0 }, false);
    poi->load_count = 0;
    poi->immersed = 0.0f;
    poi->pressure_pa = -200.0f;
    assert_int_equal(tear_cause_of(&clip, poi), TEAR_WEIGHT);
    poi->acceleration_m_s2 = v3(0.0f, 6.0f, 0.0f);
    assert_int_equal(tear_cause_of(&clip, poi), TEAR_FAST);
}

static void soak(uint32_t ticks)
{
    for (uint32_t i = 0; i < SHEET_CELL_COUNT; i++) {
        fixture.poi.sheet.soak_ticks[i] = (uint16_t)ticks;
    }
}

static void test_a_moderate_load_tears_only_paper_that_was_wet_for_long(void **state)
{
    (void)state;
    const struct sheet_load load = { 0.0f, 0.0f, 0.004f, -0.2f };
    soak(SHEET_SOAK_TICKS / 10u);
    assert_int_equal(tear_cause_of(&clip, torn_by(0.5f, load, true)), TEAR_SLAP);
    soak(SHEET_SOAK_TICKS);
    assert_int_equal(tear_cause_of(&clip, torn_by(0.5f, load, true)), TEAR_SOAKED);
    assert_int_equal(tear_cause_of(&clip, torn_by(1.0f, load, true)), TEAR_SLAP);
}

/* Records 100 ticks in which the tension is `tension_share` of the paper's wet strength and no cell
 * tears. */
static void wear_out(float tension_share)
{
    struct poi *poi = torn_by(tension_share, (struct sheet_load){ 0 }, false);
    poi->load_count = poi->strain.cells_torn = 0;
    for (uint32_t tick = 0; tick < 100u; tick++) {
        tear_clip_tick(&clip, poi, tick);
    }
}

static void test_soaked_paper_that_earlier_haste_damaged_tears_because_of_haste(void **state)
{
    (void)state;
    const struct sheet_load load = { 0.0f, 0.0f, 0.004f, 0.0f };
    fixture.poi.immersed = 1.0f;
    fixture.poi.velocity_m_s = v3(0.4f, 0.0f, 0.0f);
    soak(SHEET_SOAK_TICKS / 4u);
    wear_out(0.5f);
    assert_int_equal(tear_cause_of(&clip, torn_by(0.5f, load, false)), TEAR_SOAKED);
    wear_out(0.7f);
    assert_int_equal(tear_cause_of(&clip, torn_by(0.5f, load, false)), TEAR_FAST);
}

static void test_the_recording_is_the_second_around_the_first_tear(void **state)
{
    (void)state;
    struct poi *poi = &fixture.poi;
    for (uint32_t tick = 0; tick < 400u; tick++) {
        poi->position_m = v3(0.001f * (float)tick, -0.0312f, 0.25f);
        poi->strain.cells_torn = tick == 300u;
        tear_clip_tick(&clip, poi, tick);
    }
    assert_int_equal(clip.count, TEAR_CLIP_FRAMES);
    assert_int_equal(clip.after, TEAR_CLIP_FRAMES_AFTER);
    tear_clip_show(&clip, 0, &shown);
    assert_int_equal(shown.cause, clip.cause);
    assert_float_equal(shown.time_s, -0.75f, 1e-4f);
    assert_float_equal(shown.position_m.x, 0.210f, 1e-4f);
    assert_float_equal(shown.position_m.y, -0.0312f, 1e-4f);
    assert_float_equal(shown.position_m.z, 0.25f, 1e-4f);
    assert_float_equal(v3_length(shown.velocity_m_s), 0.0f, 1e-6f);
    /* Checks the frame in which the paper tears, and the last frame, which is shown until the slow
     * motion starts again. */
    tear_clip_show(&clip, 45u * TEAR_CLIP_SHOWN_TICKS, &shown);
    assert_float_equal(shown.time_s, 0.0f, 1e-4f);
    assert_float_equal(shown.position_m.x, 0.300f, 1e-4f);
    assert_float_equal(shown.velocity_m_s.x, 0.12f, 1e-3f);
    tear_clip_show(&clip, TEAR_CLIP_LOOP_TICKS - 1u, &shown);
    assert_float_equal(shown.position_m.x, 0.328f, 1e-4f);
    tear_clip_show(&clip, TEAR_CLIP_LOOP_TICKS, &shown);
    assert_float_equal(shown.position_m.x, 0.210f, 1e-4f);
}

static void test_the_recording_of_an_early_tear_is_shorter(void **state)
{
    (void)state;
    for (uint32_t tick = 0; tick < 100u; tick++) {
        fixture.poi.strain.cells_torn = tick == 20u;
        tear_clip_tick(&clip, &fixture.poi, tick);
    }
    assert_int_equal(clip.count, 10u + TEAR_CLIP_FRAMES_AFTER);
    tear_clip_show(&clip, 0, &shown);
    assert_float_equal(shown.time_s, -10.0f / 60.0f, 1e-4f);
}

static void test_without_a_tear_nothing_is_shown(void **state)
{
    (void)state;
    for (uint32_t tick = 0; tick < 200u; tick++) {
        tear_clip_tick(&clip, &fixture.poi, tick);
    }
    memset(&shown, 0x5a, sizeof shown);
    tear_clip_show(&clip, 30u, &shown);
    assert_int_equal(shown.cause, TEAR_NONE);
    assert_int_equal(shown.load[TEAR_CELL_COUNT / 2u], 0);
}

static void test_a_frame_has_the_load_of_each_cell_and_the_pose(void **state)
{
    (void)state;
    struct poi *poi = &fixture.poi;
    const uint32_t row = 8u, column = 7u, cell = row * TEAR_SIDE + column;
    const uint32_t at = 2u * row * SHEET_SIDE + 2u * column;
    memset(poi->sheet.stress, 0, sizeof poi->sheet.stress);
    /* Each cell of the clip covers four cells of the paper, and shows the highest load of these
     * four. */
    poi->sheet.stress[at + SHEET_SIDE + 1u] = 255;
    poi->sheet.stress[at + 2u] = 128;
    /* If one of its four cells has torn, a cell of the clip shows a hole (load 0). */
    poi->sheet.state[at + 4u] = CELL_HOLE;
    poi->angles = (struct angles){ 1.5f, -0.25f, 0.125f };
    poi->strain.cells_torn = 1;
    tear_clip_tick(&clip, poi, 0);
    tear_clip_show(&clip, 0, &shown);
    assert_int_equal(shown.load[cell], 255);
    assert_in_range(shown.load[cell + 1u], 128, 144);
    assert_int_equal(shown.load[cell + 2u], 0);
    assert_int_equal(shown.load[cell - 1u], 17);
    assert_int_equal(shown.load[0], 0);
    assert_float_equal(shown.angles.yaw_rad, 1.5f, 1e-4f);
    assert_float_equal(shown.angles.pitch_rad, -0.25f, 1e-4f);
    assert_float_equal(shown.angles.roll_rad, 0.125f, 1e-4f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_paper_that_is_pulled_up_level_tears_because_it_was_flat, setup),
        cmocka_unit_test_setup(test_slanted_paper_tears_because_it_was_fast, setup),
        cmocka_unit_test_setup(test_a_slow_glide_does_not_tear, setup),
        cmocka_unit_test_setup(test_fish_tear_the_paper_by_a_slap_or_by_their_weight, setup),
        cmocka_unit_test_setup(
            test_water_above_the_surface_tears_by_its_weight_unless_the_poi_is_jerked, setup),
        cmocka_unit_test_setup(test_a_moderate_load_tears_only_paper_that_was_wet_for_long, setup),
        cmocka_unit_test_setup(test_soaked_paper_that_earlier_haste_damaged_tears_because_of_haste,
                               setup),
        cmocka_unit_test_setup(test_the_recording_is_the_second_around_the_first_tear, setup),
        cmocka_unit_test_setup(test_the_recording_of_an_early_tear_is_shorter, setup),
        cmocka_unit_test_setup(test_without_a_tear_nothing_is_shown, setup),
        cmocka_unit_test_setup(test_a_frame_has_the_load_of_each_cell_and_the_pose, setup),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
