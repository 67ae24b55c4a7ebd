/* test_failsafe.c -- the ways of a poi that nobody leads: by themselves too slow to tear wet paper
 * of the weakest grade, spared or not. */
#include "tests/unit/support/poi_stand.h"

#include "core/game/control/controller.h"

static struct stand stand;

static void soak_half(struct sheet *sheet)
{
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        sheet->wetness[cell] = cell % SHEET_SIDE < SHEET_SIDE / 2u ? 0.0f : 1.0f;
    }
    sheet->touched = 1;
    sheet->soaked = 0;
}

/* At rest at `at_m`, turned, its paper half wet: the worst there is. */
static void begin(vec3 at_m, struct angles angles)
{
    stand_init(&stand, SHEET_GRADE_MAX, 9);
    stand.has_wrist = 1;
    stand.hand = (struct poi_target){ .position_m = at_m, .angles = angles };
    poi_init(&stand.poi, SHEET_GRADE_MAX, at_m, 9);
    stand.poi.angles = angles;
    stand_wait(&stand, 0.5f);
    sheet_init(&stand.poi.sheet, SHEET_GRADE_MAX, POI_RADIUS_M, 9);
    soak_half(&stand.poi.sheet);
}

static float damage_max(void)
{
    float most = 0.0f;
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        most = f_max(most, stand.poi.sheet.damage[cell]);
    }
    return most;
}

static void drift(uint32_t ticks)
{
    stand.hand = failsafe_begin(&stand.poi, stand.hand);
    for (uint32_t i = 0; i < ticks; i++) {
        stand.hand = failsafe_withdraw(&stand.poi, stand.hand);
        stand_tick(&stand);
    }
}

static void test_from_any_depth_and_tilt_it_leaves_the_water_whole(void **state)
{
    (void)state;
    float worst = 0.0f;
    for (uint32_t i = 0; i < 3u * 5u * 3u; i++) {
        const float depth_m = 0.03f + 0.04f * (float)(i % 3u);
        const float pitch_rad = -0.8f + 0.4f * (float)(i / 3u % 5u);
        const float z_m = -0.2f + 0.2f * (float)(i / 15u);
        begin(v3(0.05f, -depth_m, z_m), (struct angles){ 0.0f, pitch_rad, 0.0f });
        drift(480);
        assert_true(stand.poi.immersed <= 0.0f);
        assert_float_equal(stand.poi.position_m.y, FAILSAFE_HOVER_M, 0.005f);
        assert_int_equal(stand.poi.sheet.paper_cells, stand.poi.sheet.paper_cells_new);
        worst = f_max(worst, damage_max());
    }
    print_message("worst damage of a cell on the way out: %.1e of 1\n", (double)worst);
    assert_true(worst < 0.1f);
}

static void test_it_goes_back_into_the_deep_whole(void **state)
{
    (void)state;
    float worst = 0.0f;
    for (uint32_t i = 0; i < 8; i++) {
        const struct poi_target wanted = {
            .position_m = v3(i % 2u ? 0.3f : 0.02f, -0.09f, 0.1f),
            .angles = { 0.0f, i & 2u ? 0.6f : 0.0f, i & 4u ? -0.5f : 0.0f },
        };
        uint32_t ticks = 1;
        begin(v3(0.0f, FAILSAFE_HOVER_M, 0.0f), (struct angles){ 0.0f, 0.0f, 0.0f });
        do {
            stand.hand = failsafe_return(stand.hand, wanted, ticks);
            stand_tick(&stand);
            ticks++;
            assert_true(ticks < 600);
        } while (!failsafe_is_returned(stand.hand, wanted, ticks));
        assert_true(ticks >= FAILSAFE_RETURN_TICKS_MIN);
        stand.hand = wanted;
        stand_wait(&stand, 0.5f);
        assert_int_equal(stand.poi.sheet.paper_cells, stand.poi.sheet.paper_cells_new);
        worst = f_max(worst, damage_max());
    }
    print_message("worst damage of a cell on the way back: %.1e of 1\n", (double)worst);
    assert_true(worst < 0.1f);
}

static void test_a_hand_in_motion_is_caught(void **state)
{
    (void)state;
    struct poi_target hand = { .position_m = v3(0.0f, FAILSAFE_HOVER_M, 0.0f) };
    struct poi_target wanted = { .position_m = v3(0.2f, -0.05f, 0.0f) };
    uint32_t ticks = 1;
    for (; !failsafe_is_returned(hand, wanted, ticks); ticks++) {
        wanted.position_m.x += 0.5f * CORE_TICK_S; /* Faster than it sets off. */
        hand = failsafe_return(hand, wanted, ticks);
        assert_true(ticks < 6u * CORE_TICK_HZ);
    }
    print_message("caught after %u ticks\n", ticks);
}

static void test_turns_go_the_short_way_round(void **state)
{
    (void)state;
    struct poi_target hand = { .angles = { 3.0f, 0.0f, 0.0f } };
    const struct poi_target wanted = { .angles = { -3.0f, 0.0f, 0.0f } };
    for (uint32_t ticks = 1; !failsafe_is_returned(hand, wanted, ticks); ticks++) {
        hand = failsafe_return(hand, wanted, ticks);
        assert_true(f_abs(hand.angles.yaw_rad) > 2.9f);
    }
}

/* What moved at the loss glides to rest: less than a fish on level paper would slide by. */
static void test_a_hand_that_is_lost_in_motion_comes_to_rest_softly(void **state)
{
    (void)state;
    begin(v3(-0.3f, 0.08f, 0.0f), (struct angles){ 0.0f, 0.0f, 0.0f });
    stand_move(&stand, v3(0.0f, 0.08f, 0.0f), 0.6f);
    vec3 before_m_s = stand.poi.velocity_m_s;
    assert_true(v3_length(before_m_s) > 0.5f);
    stand.hand = failsafe_begin(&stand.poi, stand.hand);
    float hardest_m_s2 = 0.0f;
    for (uint32_t i = 0; i < 120; i++) {
        stand.hand = failsafe_withdraw(&stand.poi, stand.hand);
        stand_tick(&stand);
        const vec3 gain_m_s = v3_sub(stand.poi.velocity_m_s, before_m_s);
        hardest_m_s2 = f_max(hardest_m_s2, v3_length(gain_m_s) * (float)CORE_TICK_HZ);
        before_m_s = stand.poi.velocity_m_s;
    }
    print_message("hardest braking %.1f m/s2\n", (double)hardest_m_s2);
    assert_true(v3_length(stand.poi.velocity_m_s) < 0.01f);
    assert_true(hardest_m_s2 < 12.0f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_from_any_depth_and_tilt_it_leaves_the_water_whole),
        cmocka_unit_test(test_it_goes_back_into_the_deep_whole),
        cmocka_unit_test(test_a_hand_in_motion_is_caught),
        cmocka_unit_test(test_turns_go_the_short_way_round),
        cmocka_unit_test(test_a_hand_that_is_lost_in_motion_comes_to_rest_softly),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
