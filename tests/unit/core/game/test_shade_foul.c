/* test_shade_foul.c -- checks the foul of shade: before a championship starts, no player may hold a
 * shadow over fish. The core detects this foul from the motion of pois and fans. */
#include "tests/unit/support/core_fixture.h"

#include "core/game/phases.h"

#define READY_TICKS (5u * CORE_TICK_HZ)

/* Position for the poi outside the tank, in front of the near wall. */
static const vec3 aside_m = { 0.0f, ABOVE_M, 0.45f };

static void begin(uint8_t mode, uint32_t fish_count)
{
    const struct core_config config = {
        .seed = 3,
        .preset = TANK_PRESET_OFFICIAL,
        .fish_count = fish_count,
        .modes = (uint8_t)(1u << mode),
    };
    open_core(&config);
    hold(0, aside_m);
    tick();
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_READY);
}

static int championship(void **state)
{
    (void)state;
    begin(MODE_CHAMPIONSHIP, 0);
    return 0;
}

static void fan(int present, float x_m)
{
    input.shade[0] = (struct shade_input){
        .present = (uint8_t)present, .x_m = x_m, .z_m = 0.0f, .radius_m = 0.12f
    };
}

static void test_a_player_away_from_the_water_commits_no_foul(void **state)
{
    (void)state;
    ticks(READY_TICKS + 10u);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    assert_int_equal(look()->player[0].fouls, 0);
    assert_int_equal(sounds[SOUND_FOUL], 0);
}

static void test_a_fan_held_over_fish_before_the_start_is_one_foul(void **state)
{
    (void)state;
    fan(1, 0.1f);
    ticks(170);
    assert_int_equal(look()->player[0].fouls, 0);
    /* After these ticks the fan has been held still for 190 ticks. A foul needs 180 ticks (1.5
     * s). */
    ticks(20);
    assert_int_equal(look()->player[0].fouls, 1);
    assert_int_equal(scene.player[0].foul, FOUL_SHADE);
    assert_true(scene.player[0].foul_s < 0.2f);
    /* While the fan stays in place, it must count as only one foul. */
    ticks(READY_TICKS - 200u);
    assert_int_equal(look()->player[0].fouls, 1);
    assert_int_equal(sounds[SOUND_FOUL], 1);
}

static void test_a_fan_already_present_has_1_5_s_to_leave(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 3,
                                        .preset = TANK_PRESET_OFFICIAL,
                                        .modes = 1u << MODE_CHAMPIONSHIP };
    open_core(&config);
    hold(0, aside_m);
    fan(1, 0.1f);
    ticks(300);
    press(INPUT_START);
    ticks(170);
    assert_int_equal(look()->player[0].fouls, 0);
    ticks(20);
    assert_int_equal(look()->player[0].fouls, 1);
}

static void test_a_passing_or_waving_fan_is_no_foul(void **state)
{
    (void)state;
    for (uint32_t i = 0; i < READY_TICKS - 10u; i++) {
        const float share = (float)(i % 240u) / 120.0f;
        /* Moves the fan from side to side at 0.4 m/s. */
        fan(1, 0.4f * (share < 1.0f ? share : 2.0f - share));
        tick();
    }
    assert_int_equal(look()->player[0].fouls, 0);
}

static void test_a_fan_over_water_without_fish_is_no_foul(void **state)
{
    (void)state;
    begin(MODE_CHAMPIONSHIP, 1);
    const float away_m = core.world.tank.fish[0].position_m.x > 0.0f ? -0.5f : 0.5f;
    fan(1, away_m);
    ticks(READY_TICKS - 10u);
    assert_int_equal(look()->player[0].fouls, 0);
}

static void test_two_seconds_later_a_fan_is_another_foul(void **state)
{
    (void)state;
    fan(1, 0.1f);
    ticks(190);
    fan(0, 0.0f);
    ticks(70);
    fan(1, 0.1f);
    ticks(190);
    assert_int_equal(core.game.phase, PHASE_READY);
    assert_int_equal(look()->player[0].fouls, 2);
}

static void test_within_two_seconds_a_fan_is_the_same_foul(void **state)
{
    (void)state;
    fan(1, 0.1f);
    ticks(200);
    fan(0, 0.0f);
    ticks(10);
    fan(1, 0.1f);
    ticks(190);
    assert_int_equal(look()->player[0].fouls, 1);
}

static void test_a_poi_brought_over_fish_and_held_there_is_a_foul(void **state)
{
    (void)state;
    ticks(FOUL_SETTLE_TICKS);
    lead(0, v3(0.05f, ABOVE_M, 0.05f));
    ticks(300);
    assert_int_equal(core.game.phase, PHASE_READY);
    assert_int_equal(look()->player[0].fouls, 1);
    assert_int_equal(scene.player[0].foul, FOUL_SHADE);
}

static void test_a_poi_at_rest_since_ready_is_no_foul(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 3,
                                        .preset = TANK_PRESET_OFFICIAL,
                                        .modes = 1u << MODE_CHAMPIONSHIP };
    open_core(&config);
    /* Holds the poi in one place from before START is pressed. */
    hold(0, v3(0.05f, ABOVE_M, 0.05f));
    press(INPUT_START);
    /* The sensor noise lets the poi tremble by 1 mm. */
    for (uint32_t i = 0; i < READY_TICKS - 10u; i++) {
        input.poi[0].target.position_m.x = 0.05f + (i % 2u ? 0.001f : 0.0f);
        tick();
    }
    /* The shadow has been still for longer than FOUL_SHADE_S and lies on fish. This is not a foul,
     * because the player did not move the shadow to the fish after START. */
    assert_true(core.world.tank.shade[SHADE_MAX].still_s > FOUL_SHADE_S);
    assert_true(tank_shade_count(&core.world.tank, &core.world.tank.shade[SHADE_MAX].cast) > 0);
    assert_int_equal(look()->player[0].fouls, 0);
}

static void test_the_rule_is_shown_before_the_start(void **state)
{
    (void)state;
    ticks(20);
    assert_int_equal(look()->hint, HINT_NO_SHADE);
}

static void test_a_fan_is_a_foul_of_its_player(void **state)
{
    (void)state;
    const struct core_config config = { .preset = TANK_PRESET_OFFICIAL,
                                        .modes = 1u << MODE_CHAMPIONSHIP,
                                        .players = 2 };
    open_core(&config);
    press(INPUT_START);
    input.shade[1] = (struct shade_input){ .present = 1, .radius_m = 0.12f };
    input.shade[2] = (struct shade_input){ .present = 1, .x_m = 0.3f, .radius_m = 0.12f };
    ticks(200);
    assert_int_equal(look()->player[0].fouls, 0);
    assert_int_equal(scene.player[1].fouls, 1);
    /* Player 2 has no bowl and does not play, so the shadow of this player's fan is not a foul. */
    assert_int_equal(scene.player[2].fouls, 0);
}

static void test_shade_is_no_foul_in_a_festival(void **state)
{
    (void)state;
    begin(MODE_FESTIVAL, 0);
    fan(1, 0.1f);
    ticks(300);
    assert_int_equal(look()->player[0].fouls, 0);
    assert_int_equal(sounds[SOUND_FOUL], 0);
}

static void test_shade_is_no_foul_during_the_round(void **state)
{
    (void)state;
    ticks(READY_TICKS + 1u);
    fan(1, 0.1f);
    ticks(300);
    assert_int_equal(look()->player[0].fouls, 0);
}

static void test_the_shadow_of_a_lost_controller_is_no_foul(void **state)
{
    (void)state;
    /* Moves the poi over fish after START. Then the controller is lost. */
    lead(0, v3(0.1f, ABOVE_M, 0.0f));
    input.poi[0].link = POI_SOURCE_LOST;
    ticks(READY_TICKS - 180u);
    assert_int_equal(core.game.phase, PHASE_READY);
    assert_int_equal(look()->player[0].fouls, 0);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup(name, championship)
    const struct CMUnitTest tests[] = {
        TEST(test_a_player_away_from_the_water_commits_no_foul),
        TEST(test_a_fan_held_over_fish_before_the_start_is_one_foul),
        cmocka_unit_test(test_a_fan_already_present_has_1_5_s_to_leave),
        TEST(test_a_passing_or_waving_fan_is_no_foul),
        TEST(test_a_fan_over_water_without_fish_is_no_foul),
        TEST(test_two_seconds_later_a_fan_is_another_foul),
        TEST(test_within_two_seconds_a_fan_is_the_same_foul),
        TEST(test_a_poi_brought_over_fish_and_held_there_is_a_foul),
        TEST(test_a_poi_at_rest_since_ready_is_no_foul),
        TEST(test_the_shadow_of_a_lost_controller_is_no_foul),
        TEST(test_the_rule_is_shown_before_the_start),
        cmocka_unit_test(test_a_fan_is_a_foul_of_its_player),
        cmocka_unit_test(test_shade_is_no_foul_in_a_festival),
        TEST(test_shade_is_no_foul_during_the_round),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
