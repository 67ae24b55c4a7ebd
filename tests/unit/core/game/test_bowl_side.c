/* test_bowl_side.c -- checks on which side of the tank the bowl of a single player is, for players
 * who hold the poi in the right or in the left hand. */
#include "tests/unit/support/core_fixture.h"

#define LEFT_M (-0.30f)
#define RIGHT_M 0.30f
/* Largest distance of a bowl from its home position when the bowl has arrived there. */
#define AT_HOME_M 0.03f

/* Opens a core with one mode, so that a dip in attract mode begins the game at once. */
static void open_side(int32_t side, uint8_t players, uint8_t rules)
{
    struct core_config config = {
        .seed = 5, .fish_count = 60, .modes = 1, .players = players, .rules = rules
    };
    settings_reset(&config.persistent.settings);
    config.persistent.settings.value[SET_SIDE] = side;
    open_core(&config);
}

static float bowl_x_m(uint32_t player)
{
    return core.world.bowl[player].position_m.x;
}

static float home_x_m(void)
{
    return tank_preset(core.world.tank.preset)->bowl_m[0].x;
}

/* Begins a game by a dip at `x_m`, and waits for the start of the round. */
static void dip_and_wait(float x_m)
{
    dip(0, x_m, 0.0f);
    assert_int_equal(core.game.phase, PHASE_READY);
    wait_for_phase(PHASE_ROUND, 10u * CORE_TICK_HZ);
}

static void test_the_first_dip_chooses_the_side_of_the_bowl(void **state)
{
    (void)state;
    static const struct {
        float dip_m, sign;
    } dips[] = { { LEFT_M, -1.0f }, { 0.0f, 1.0f }, { RIGHT_M, 1.0f }, { -0.1f, 1.0f } };
    for (size_t i = 0; i < sizeof dips / sizeof *dips; i++) {
        open_side(BOWL_BY_FIRST_DIP, 1, 0);
        dip_and_wait(dips[i].dip_m);
        assert_float_equal(bowl_x_m(0), dips[i].sign * home_x_m(), AT_HOME_M);
    }
}

static void test_the_hand_is_the_one_on_the_side_of_the_bowl(void **state)
{
    (void)state;
    open_side(BOWL_BY_FIRST_DIP, 1, 0);
    dip_and_wait(LEFT_M);
    assert_int_equal(look()->poi[0].left_hand, 1);
    open_side(BOWL_BY_FIRST_DIP, 2, 0);
    dip_and_wait(LEFT_M);
    hold(1, v3(LEFT_M, ABOVE_M, 0.0f));
    tick();
    assert_int_equal(look()->poi[0].left_hand, 0);
    assert_true(look()->poi[1].present);
    assert_int_equal(look()->poi[1].left_hand, 1);
}

static void test_start_gives_the_right_side(void **state)
{
    (void)state;
    open_side(BOWL_BY_FIRST_DIP, 1, 0);
    hold(0, v3(LEFT_M, ABOVE_M, 0.0f));
    ticks(60);
    press(INPUT_START);
    wait_for_phase(PHASE_ROUND, 10u * CORE_TICK_HZ);
    assert_float_equal(bowl_x_m(0), home_x_m(), AT_HOME_M);
}

static void test_the_setting_fixes_the_side(void **state)
{
    (void)state;
    open_side(BOWL_LEFT, 1, 0);
    dip_and_wait(RIGHT_M);
    assert_float_equal(bowl_x_m(0), -home_x_m(), AT_HOME_M);
    open_side(BOWL_RIGHT, 1, 0);
    dip_and_wait(LEFT_M);
    assert_float_equal(bowl_x_m(0), home_x_m(), AT_HOME_M);
}

static void test_the_bowls_of_several_players_keep_their_places(void **state)
{
    (void)state;
    open_side(BOWL_LEFT, 2, 0);
    dip_and_wait(LEFT_M);
    assert_float_equal(bowl_x_m(0), home_x_m(), AT_HOME_M);
    assert_float_equal(bowl_x_m(1), -home_x_m(), AT_HOME_M);
}

static void test_under_the_rules_of_format_9_the_bowl_is_on_the_right(void **state)
{
    (void)state;
    open_side(BOWL_BY_FIRST_DIP, 1, 9);
    dip_and_wait(LEFT_M);
    assert_float_equal(bowl_x_m(0), home_x_m(), AT_HOME_M);
}

/* On a portrait screen the player stands at the end of the tank with positive x. The player's left
 * is the side with positive z. */
static void test_on_a_portrait_screen_the_bowl_is_within_the_reach_of_the_player(void **state)
{
    (void)state;
    static const struct {
        int32_t side;
        float dip_z_m, sign;
        bool has_left_hand;
    } rounds[] = {
        { BOWL_BY_FIRST_DIP, 0.15f, 1.0f, true },    { BOWL_BY_FIRST_DIP, 0.0f, -1.0f, false },
        { BOWL_BY_FIRST_DIP, -0.15f, -1.0f, false }, { BOWL_LEFT, -0.15f, 1.0f, true },
        { BOWL_RIGHT, 0.15f, -1.0f, false },
    };
    for (size_t i = 0; i < sizeof rounds / sizeof *rounds; i++) {
        open_side(rounds[i].side, 1, 0);
        input.upright = input.is_turned = 1;
        ticks(60);
        dip(0, LEFT_M, rounds[i].dip_z_m);
        assert_int_equal(core.game.phase, PHASE_READY);
        wait_for_phase(PHASE_ROUND, 10u * CORE_TICK_HZ);
        const float home_z_m = tank_preset(core.world.tank.preset)->bowl_m[0].z;
        assert_float_equal(bowl_x_m(0), home_x_m(), AT_HOME_M);
        assert_float_equal(core.world.bowl[0].position_m.z, rounds[i].sign * home_z_m, AT_HOME_M);
        assert_int_equal(look()->poi[0].turned_left_hand, rounds[i].has_left_hand);
    }
}

static void test_the_bowl_follows_a_screen_that_is_turned_in_attract_mode(void **state)
{
    (void)state;
    open_side(BOWL_BY_FIRST_DIP, 1, 0);
    input.upright = input.is_turned = 1;
    ticks(6u * CORE_TICK_HZ);
    assert_true(core.world.bowl[0].position_m.z < 0.0f);
    input.upright = input.is_turned = 0;
    ticks(6u * CORE_TICK_HZ);
    assert_true(core.world.bowl[0].position_m.z > 0.0f);
}

static void test_under_the_rules_of_format_11_a_portrait_screen_makes_no_difference(void **state)
{
    (void)state;
    open_side(BOWL_BY_FIRST_DIP, 1, 11);
    input.upright = input.is_turned = 1;
    ticks(60);
    dip(0, LEFT_M, -0.15f);
    wait_for_phase(PHASE_ROUND, 10u * CORE_TICK_HZ);
    assert_float_equal(bowl_x_m(0), -home_x_m(), AT_HOME_M);
    assert_true(core.world.bowl[0].position_m.z > 0.0f);
}

/* The bowl floats to the other side. It must not jump, and it must not leave the tank. */
static void test_the_bowl_moves_slowly_through_the_water(void **state)
{
    (void)state;
    open_side(BOWL_BY_FIRST_DIP, 1, 0);
    dip(0, LEFT_M, 0.0f);
    float before_m = bowl_x_m(0);
    for (uint32_t i = 0; i < 3u * CORE_TICK_HZ; i++) {
        tick();
        assert_true(f_abs(bowl_x_m(0) - before_m) < 0.5f * CORE_TICK_S);
        assert_true(f_abs(bowl_x_m(0)) < 0.5f * core.world.tank.size_m.x - BOWL_RADIUS_M);
        before_m = bowl_x_m(0);
    }
}

static void test_the_bowl_returns_for_the_next_visitor(void **state)
{
    (void)state;
    open_side(BOWL_BY_FIRST_DIP, 1, 0);
    dip_and_wait(LEFT_M);
    assert_float_equal(bowl_x_m(0), -home_x_m(), AT_HOME_M);
    input.poi[0] = (struct poi_input){ 0 };
    wait_for_phase(PHASE_ATTRACT, 400u * CORE_TICK_HZ);
    ticks(6u * CORE_TICK_HZ);
    assert_float_equal(bowl_x_m(0), home_x_m(), AT_HOME_M);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_first_dip_chooses_the_side_of_the_bowl),
        cmocka_unit_test(test_the_hand_is_the_one_on_the_side_of_the_bowl),
        cmocka_unit_test(test_start_gives_the_right_side),
        cmocka_unit_test(test_the_setting_fixes_the_side),
        cmocka_unit_test(test_the_bowls_of_several_players_keep_their_places),
        cmocka_unit_test(test_under_the_rules_of_format_9_the_bowl_is_on_the_right),
        cmocka_unit_test(test_on_a_portrait_screen_the_bowl_is_within_the_reach_of_the_player),
        cmocka_unit_test(test_the_bowl_follows_a_screen_that_is_turned_in_attract_mode),
        cmocka_unit_test(test_under_the_rules_of_format_11_a_portrait_screen_makes_no_difference),
        cmocka_unit_test(test_the_bowl_moves_slowly_through_the_water),
        cmocka_unit_test(test_the_bowl_returns_for_the_next_visitor),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
