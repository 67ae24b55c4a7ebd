/* test_sim_player.c -- tests the state machine of the simulated players (make bench-players). The
 * pictures that the tests show to the players contain one or two fish that do not move. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/tank/preset.h"
#include "tests/bench/players/sim_player.h"

#define REACTION_FRAMES 12u

static const struct habits clicks = {
    .name = "test",
    .reaction_s = 0.2f,
    .pause_s = 0.1f,
    .cost_distance = 1.0f,
    .arm_px_s = 1000.0f,
    .reach_px = 20.0f,
    .patience_s = 2.0f,
    .hold_min_s = 0.1f,
    .hold_max_s = 0.2f,
    .rise_s = 0.5f,
    .carry_px_s = 700.0f,
};

static struct stand {
    struct sim_player player;
    struct sight sight;
    struct player_command command;
} stand;

/* Begins a round with one fish of 4 cm in the middle of the tank. */
static void begin(const struct habits *habits)
{
    const struct tank_preset *preset = tank_preset(TANK_PRESET_FESTIVAL);
    memset(&stand, 0, sizeof stand);
    sim_player_init(&stand.player, habits, &preset->view, 1);
    stand.sight = (struct sight){
        .in_round = true,
        .ring_m = v3(0.1f, 0.035f, 0.0f),
        .bowl_m = preset->bowl_m[0],
        .bowl_radius_m = preset->bowl_radius_m,
        .tank_m = preset->size_m,
        .fish_count = 1,
        .fish = { { .position_m = v3(0.0f, -0.02f, 0.0f), .length_m = 0.04f, .swims = true } },
    };
}

static void show(uint32_t frames)
{
    for (uint32_t i = 0; i < frames; i++) {
        stand.command = sim_player_frame(&stand.player, &stand.sight);
    }
}

/* Shows the same picture to the player until the player is in the state `state`. Returns the number
 * of frames. */
static uint32_t show_until(uint8_t state)
{
    uint32_t frames = 0;
    while (stand.player.state != state) {
        show(1);
        assert_true(++frames < 1000);
    }
    return frames;
}

/* Moves the ring to the position in the player's command, which is over the chosen fish. */
static void follow_command(void)
{
    const vec3 at_m = stand.sight.fish[stand.player.prey].position_m;
    stand.sight.ring_m = v3(at_m.x, 0.0f, at_m.z);
}

static void test_player_acts_on_the_picture_of_its_reaction_time_ago(void **state)
{
    (void)state;
    begin(&clicks);
    stand.sight.in_round = false;
    show(40);
    stand.sight.in_round = true;
    show(REACTION_FRAMES);
    assert_int_equal(stand.player.tries, 0);
    assert_in_range(show_until(PLAYER_REACH), 1, 10);
    const float x_px = stand.command.x_px;
    stand.sight.fish[0].position_m.x = 0.1f;
    show(REACTION_FRAMES);
    assert_float_equal(stand.command.x_px, x_px, 0.01);
    show(1);
    assert_true(stand.command.x_px > x_px + 50.0f);
}

static void test_player_prefers_a_shallow_fish_if_depth_has_a_cost(void **state)
{
    (void)state;
    struct habits careful = clicks;
    careful.cost_depth = 20.0f;
    begin(&careful);
    stand.sight.fish_count = 2;
    stand.sight.fish[1] = stand.sight.fish[0];
    stand.sight.fish[1].position_m = v3(0.1f, -0.08f, 0.0f);
    show_until(PLAYER_REACH);
    assert_int_equal(stand.player.prey, 0);
    begin(&clicks);
    stand.sight.fish_count = 2;
    stand.sight.fish[1] = stand.sight.fish[0];
    stand.sight.fish[1].position_m = v3(0.1f, -0.08f, 0.0f);
    show_until(PLAYER_REACH);
    assert_int_equal(stand.player.prey, 1);
}

static void test_player_chooses_no_fish_at_the_wall_or_at_the_bowl(void **state)
{
    (void)state;
    begin(&clicks);
    stand.sight.fish[0].position_m = v3(0.42f, -0.02f, 0.0f);
    show(60);
    assert_int_equal(stand.player.state, PLAYER_CHOOSE);
    stand.sight.fish[0].position_m = stand.sight.bowl_m;
    show(60);
    assert_int_equal(stand.player.state, PLAYER_CHOOSE);
}

static void test_click_holds_the_ring_down_for_the_time_of_its_habit(void **state)
{
    (void)state;
    begin(&clicks);
    show_until(PLAYER_REACH);
    follow_command();
    show_until(PLAYER_STILL);
    const uint32_t frames = show_until(PLAYER_RISE);
    assert_in_range(frames, 6, 13);
    show(1);
    assert_false(stand.command.dips);
    show_until(PLAYER_CHOOSE);
}

static void test_waiting_player_lifts_when_a_fish_is_over_the_ring(void **state)
{
    (void)state;
    struct habits waits = clicks;
    waits.hold_min_s = waits.hold_max_s = 5.0f;
    waits.until_px = 30.0f;
    begin(&waits);
    show_until(PLAYER_REACH);
    follow_command();
    show_until(PLAYER_STILL);
    stand.sight.ring_m = v3(0.2f, -0.05f, 0.0f);
    show(90);
    assert_int_equal(stand.player.state, PLAYER_STILL);
    assert_true(stand.command.dips);
    stand.sight.fish[0].position_m = v3(0.2f, -0.04f, 0.0f);
    assert_in_range(show_until(PLAYER_RISE), REACTION_FRAMES, REACTION_FRAMES + 2u);
}

static void test_catch_is_carried_to_the_bowl(void **state)
{
    (void)state;
    begin(&clicks);
    show_until(PLAYER_REACH);
    follow_command();
    show_until(PLAYER_RISE);
    stand.sight.has_catch = true;
    show_until(PLAYER_CARRY);
    stand.sight.ring_m = stand.sight.bowl_m;
    show(REACTION_FRAMES + 2u);
    float x_px, y_px;
    sim_player_to_screen(&stand.player.view, stand.sight.bowl_m, &x_px, &y_px);
    assert_float_equal(stand.command.x_px, x_px, 30.0);
    assert_true(stand.command.tips);
    stand.sight.has_catch = false;
    show_until(PLAYER_CHOOSE);
    show(1);
    assert_false(stand.command.tips);
}

static void test_end_of_the_round_lifts_the_ring(void **state)
{
    (void)state;
    begin(&clicks);
    show_until(PLAYER_REACH);
    follow_command();
    show_until(PLAYER_STILL);
    stand.sight.in_round = false;
    show(REACTION_FRAMES + 1u);
    assert_int_equal(stand.player.state, PLAYER_CHOOSE);
    assert_false(stand.command.dips);
}

static void test_each_row_of_the_table_has_a_name_and_a_valid_reaction_time(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < sim_player_table_count; i++) {
        assert_non_null(sim_player_table[i].name);
        for (uint32_t k = 0; k < i; k++) {
            assert_string_not_equal(sim_player_table[k].name, sim_player_table[i].name);
        }
        begin(&sim_player_table[i]);
        show(1);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_player_acts_on_the_picture_of_its_reaction_time_ago),
        cmocka_unit_test(test_player_prefers_a_shallow_fish_if_depth_has_a_cost),
        cmocka_unit_test(test_player_chooses_no_fish_at_the_wall_or_at_the_bowl),
        cmocka_unit_test(test_click_holds_the_ring_down_for_the_time_of_its_habit),
        cmocka_unit_test(test_waiting_player_lifts_when_a_fish_is_over_the_ring),
        cmocka_unit_test(test_catch_is_carried_to_the_bowl),
        cmocka_unit_test(test_end_of_the_round_lifts_the_ring),
        cmocka_unit_test(test_each_row_of_the_table_has_a_name_and_a_valid_reaction_time),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
