/* test_failsafe.c -- checks how a poi moves automatically when its controller is lost or returns.
 * This motion must be too slow to tear wet paper of the weakest grade, even when damage is not
 * disabled. */
#include "tests/unit/support/poi_fixture.h"

#include "core/game/control/controller.h"

static struct poi_fixture fixture;

static void soak_half(struct sheet *sheet)
{
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        sheet->wetness[cell] = cell % SHEET_SIDE < SHEET_SIDE / 2u ? 0.0f : 1.0f;
    }
    sheet->touched = 1;
    sheet->soaked = 0;
}

/* Places the poi at rest at `at_m`. Its paper is half wet, because such paper tears most easily. */
static void begin(vec3 at_m, struct angles angles)
{
    fixture_init(&fixture, SHEET_GRADE_MAX, 9);
    fixture.has_wrist = 1;
    fixture.hand = (struct poi_target){ .position_m = at_m, .angles = angles };
    poi_init(&fixture.poi, SHEET_GRADE_MAX, at_m, 9);
    fixture.poi.angles = angles;
    fixture_wait(&fixture, 0.5f);
    sheet_init(&fixture.poi.sheet, SHEET_GRADE_MAX, POI_RADIUS_M, 9);
    soak_half(&fixture.poi.sheet);
}

static float damage_max(void)
{
    float most = 0.0f;
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        most = f_max(most, fixture.poi.sheet.damage[cell]);
    }
    return most;
}

static void drift(uint32_t ticks)
{
    fixture.hand = controller_failsafe_begin(&fixture.poi, fixture.hand);
    for (uint32_t i = 0; i < ticks; i++) {
        fixture.hand = controller_failsafe_withdraw(&fixture.poi, fixture.hand);
        fixture_tick(&fixture);
    }
}

static void test_a_poi_leaves_the_water_undamaged_from_any_depth_and_tilt(void **state)
{
    (void)state;
    float worst = 0.0f;
    for (uint32_t i = 0; i < 3u * 5u * 3u; i++) {
        const float depth_m = 0.03f + 0.04f * (float)(i % 3u);
        const float pitch_rad = -0.8f + 0.4f * (float)(i / 3u % 5u);
        const float z_m = -0.2f + 0.2f * (float)(i / 15u);
        begin(v3(0.05f, -depth_m, z_m), (struct angles){ 0.0f, pitch_rad, 0.0f });
        drift(480);
        assert_true(fixture.poi.immersed <= 0.0f);
        assert_float_equal(fixture.poi.position_m.y, FAILSAFE_HOVER_M, 0.005f);
        assert_int_equal(fixture.poi.sheet.paper_cells, fixture.poi.sheet.paper_cells_new);
        worst = f_max(worst, damage_max());
    }
    print_message("worst damage of a cell on the way out: %.1e of 1\n", (double)worst);
    assert_true(worst < 0.1f);
}

static void test_a_poi_returns_into_the_water_undamaged(void **state)
{
    (void)state;
    float worst = 0.0f;
    for (uint32_t i = 0; i < 8; i++) {
        const struct poi_target expected = {
            .position_m = v3(i % 2u ? 0.3f : 0.02f, -0.09f, 0.1f),
            .angles = { 0.0f, i & 2u ? 0.6f : 0.0f, i & 4u ? -0.5f : 0.0f },
        };
        uint32_t ticks = 1;
        begin(v3(0.0f, FAILSAFE_HOVER_M, 0.0f), (struct angles){ 0.0f, 0.0f, 0.0f });
        do {
            fixture.hand = controller_failsafe_return(fixture.hand, expected, ticks);
            fixture_tick(&fixture);
            ticks++;
            assert_true(ticks < 600);
        } while (!controller_failsafe_is_returned(fixture.hand, expected, ticks));
        assert_true(ticks >= FAILSAFE_RETURN_TICKS_MIN);
        fixture.hand = expected;
        fixture_wait(&fixture, 0.5f);
        assert_int_equal(fixture.poi.sheet.paper_cells, fixture.poi.sheet.paper_cells_new);
        worst = f_max(worst, damage_max());
    }
    print_message("worst damage of a cell on the way back: %.1e of 1\n", (double)worst);
    assert_true(worst < 0.1f);
}

static void test_a_poi_catches_up_with_a_moving_controller(void **state)
{
    (void)state;
    struct poi_target hand = { .position_m = v3(0.0f, FAILSAFE_HOVER_M, 0.0f) };
    struct poi_target expected = { .position_m = v3(0.2f, -0.05f, 0.0f) };
    uint32_t ticks = 1;
    for (; !controller_failsafe_is_returned(hand, expected, ticks); ticks++) {
        /* The player's target moves on at 0.5 m/s while the poi returns to the target. */
        expected.position_m.x += 0.5f * CORE_TICK_S;
        hand = controller_failsafe_return(hand, expected, ticks);
        assert_true(ticks < 6u * CORE_TICK_HZ);
    }
    print_message("caught after %u ticks\n", ticks);
}

static void test_turns_take_the_short_way_round(void **state)
{
    (void)state;
    struct poi_target hand = { .angles = { 3.0f, 0.0f, 0.0f } };
    const struct poi_target expected = { .angles = { -3.0f, 0.0f, 0.0f } };
    for (uint32_t ticks = 1; !controller_failsafe_is_returned(hand, expected, ticks); ticks++) {
        hand = controller_failsafe_return(hand, expected, ticks);
        assert_true(f_abs(hand.angles.yaw_rad) > 2.9f);
    }
}

/* A poi that loses its controller must decelerate until it rests. The deceleration must be so small
 * that a fish on level paper does not slide. */
static void test_a_poi_lost_in_motion_comes_to_rest_softly(void **state)
{
    (void)state;
    begin(v3(-0.3f, 0.08f, 0.0f), (struct angles){ 0.0f, 0.0f, 0.0f });
    fixture_move(&fixture, v3(0.0f, 0.08f, 0.0f), 0.6f);
    vec3 before_m_s = fixture.poi.velocity_m_s;
    assert_true(v3_length(before_m_s) > 0.5f);
    fixture.hand = controller_failsafe_begin(&fixture.poi, fixture.hand);
    float hardest_m_s2 = 0.0f;
    for (uint32_t i = 0; i < 120; i++) {
        fixture.hand = controller_failsafe_withdraw(&fixture.poi, fixture.hand);
        fixture_tick(&fixture);
        const vec3 gain_m_s = v3_sub(fixture.poi.velocity_m_s, before_m_s);
        hardest_m_s2 = f_max(hardest_m_s2, v3_length(gain_m_s) * (float)CORE_TICK_HZ);
        before_m_s = fixture.poi.velocity_m_s;
    }
    print_message("hardest braking %.1f m/s2\n", (double)hardest_m_s2);
    assert_true(v3_length(fixture.poi.velocity_m_s) < 0.01f);
    assert_true(hardest_m_s2 < 12.0f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_poi_leaves_the_water_undamaged_from_any_depth_and_tilt),
        cmocka_unit_test(test_a_poi_returns_into_the_water_undamaged),
        cmocka_unit_test(test_a_poi_catches_up_with_a_moving_controller),
        cmocka_unit_test(test_turns_take_the_short_way_round),
        cmocka_unit_test(test_a_poi_lost_in_motion_comes_to_rest_softly),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
