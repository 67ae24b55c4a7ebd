/* test_idle.c -- checks that the kiosk returns to attract mode from every state that players
 * abandon.
 *
 * The test enters every phase and every page of the operator's menu. It then leaves the kiosk
 * without a player, with a poi that swings on its cord, with a loose controller plug, or with stuck
 * buttons. */
#include "core/game/menu/menu_pages.h"
#include "core/game/phases.h"
#include "tests/unit/support/game_fixture.h"

#define LONGEST_TICKS (MENU_SWING_SPANS * MENU_IDLE_TICKS + CORE_TICK_HZ)
#define SWING_TICKS 170u /* Period of the swing in ticks, for a poi on a cord of half a metre. */
#define PLUG_TICKS 1200u

/* ---- Abandoned input ------------------------------------------------------------------------ */

enum left_behind { LEFT_NOTHING, LEFT_SWINGING, LEFT_LOOSE_PLUG, LEFT_STUCK, LEFT_COUNT };
static const char *const left_names[] = { "nothing", "a swinging poi", "a loose plug",
                                          "stuck buttons" };

static void swing(void)
{
    const float turn_rad = F_TAU * (float)(core.game.tick % SWING_TICKS) / (float)SWING_TICKS;
    hold_at(ABOVE_M);
    input.poi[0].target.position_m.x = 0.15f * f_sin(turn_rad);
    input.poi[0].target.position_m.z = 0.05f * f_cos(turn_rad);
}

static void pull_at_plug(void)
{
    const int is_in = core.game.tick / PLUG_TICKS % 2u == 0;
    hold_at(ABOVE_M);
    input.poi[0].link = is_in ? POI_SOURCE_LIVE : POI_SOURCE_LOST;
    input.controllers.state[0] = is_in ? CONTROLLER_ACTIVE : CONTROLLER_LOST;
}

static void leave(enum left_behind what)
{
    input.held = what == LEFT_STUCK ? (uint32_t)(INPUT_LEFT | INPUT_OK | INPUT_SERVICE) : 0u;
    input.poi[0].link = POI_SOURCE_ABSENT;
    if (what == LEFT_SWINGING) {
        swing();
    } else if (what == LEFT_LOOSE_PLUG) {
        pull_at_plug();
    }
}

/* ---- Phases that must time out -------------------------------------------------------------- */

static uint32_t seen; /* Bit mask of the phases that occurred while the kiosk returned to attract
                         mode. */

static void expect_attract_by_itself(enum left_behind what, const char *where)
{
    const uint32_t begin = core.game.tick;
    while (core.game.phase != PHASE_ATTRACT) {
        seen |= 1u << core.game.phase;
        leave(what);
        step();
        if (core.game.tick - begin > LONGEST_TICKS) {
            fail_msg("%s never ends with %s, in phase %u", where, left_names[what],
                     core.game.phase);
        }
    }
    input = (struct input){ 0 };
    leave(what);
    steps(60u * CORE_TICK_HZ);
    /* The abandoned input, for example a swinging poi, must start nothing within the next
     * minute. */
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

/* Opens a kiosk with all game modes. The kiosk has a store, so that players may enter names. */
static void open_fixture(void)
{
    struct core_config config = { .seed = 7, .fish_count = 12, .persistent.ledger.boots = 1 };
    settings_reset(&config.persistent.settings);
    config.persistent.settings.value[SET_MODES] = (1 << CHOICE_COUNT) - 1;
    config_apply_settings(&config, &config.persistent.settings);
    assert_int_equal(core_init(&core, &config), CORE_OK);
    memset(&input, 0, sizeof input);
    memset(&output, 0, sizeof output);
    hold_at(ABOVE_M);
    steps(10);
}

/* Presses buttons to go from the mode selection into a round of the mode `choice`. */
static void begin_playing(uint32_t choice)
{
    open_fixture();
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_MODE_SELECT);
    steps(GAME_MODE_SELECT_TICKS_MIN);
    while ((core.game.lab_chosen ? CHOICE_LAB : core.game.mode) != choice) {
        press(INPUT_RIGHT);
    }
    press(INPUT_OK);
}

static void finish_round_with_a_catch(void)
{
    begin_playing(MODE_FESTIVAL);
    steps(10u * CORE_TICK_HZ);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    core.game.player[0].caught = 9;
    core.game.album.fish_count = ALBUM_FISH_MAX;
    core.game.album.caught = 9;
    steps(60u * CORE_TICK_HZ);
    assert_int_equal(core.game.phase, PHASE_RESULT);
}

static void test_the_mode_selection_times_out(void **state)
{
    (void)state;
    for (enum left_behind what = 0; what < LEFT_COUNT; what++) {
        open_fixture();
        press(INPUT_START);
        assert_int_equal(core.game.phase, PHASE_MODE_SELECT);
        expect_attract_by_itself(what, "the choice");
    }
}

static void test_every_chosen_mode_times_out(void **state)
{
    (void)state;
    for (uint32_t choice = 0; choice < CHOICE_COUNT; choice++) {
        for (enum left_behind what = 0; what < LEFT_COUNT; what++) {
            begin_playing(choice);
            assert_int_equal(core.game.phase, choice == CHOICE_LAB ? PHASE_LAB : PHASE_READY);
            expect_attract_by_itself(what, "what was chosen");
        }
    }
}

static void test_the_result_and_the_following_phases_time_out(void **state)
{
    (void)state;
    for (enum left_behind what = 0; what < LEFT_COUNT; what++) {
        finish_round_with_a_catch();
        seen = 0;
        expect_attract_by_itself(what, "the result");
        const uint32_t all =
            1u << PHASE_RESULT | 1u << PHASE_NAME | 1u << PHASE_LEADERBOARD | 1u << PHASE_ALBUM;
        assert_int_equal(seen & all, all);
    }
}

static void test_every_page_of_the_menu_times_out(void **state)
{
    (void)state;
    for (uint32_t page = 0; page < MENU_PAGE_COUNT; page++) {
        for (enum left_behind what = 0; what < LEFT_COUNT; what++) {
            open_fixture();
            press(INPUT_TEST);
            assert_int_equal(core.game.phase, PHASE_MENU);
            menu_turn(&core.game.menu, &core.game, &core.config.persistent.settings,
                      (enum menu_page)page);
            seen = 0;
            expect_attract_by_itself(what, "a page of the menu");
            assert_int_equal(seen, 1u << PHASE_MENU);
        }
    }
}

/* An operator who checks the axes of a poi in the menu only moves the poi and presses no button.
 * The motion must keep the menu open, but only for a limited time. */
static void test_a_moving_poi_keeps_the_menu_open_for_15_minutes(void **state)
{
    (void)state;
    open_fixture();
    press(INPUT_TEST);
    const uint32_t begin = core.game.tick;
    while (core.game.phase == PHASE_MENU && core.game.tick - begin <= LONGEST_TICKS) {
        swing();
        step();
    }
    assert_in_range(core.game.tick - begin, MENU_SWING_SPANS * MENU_IDLE_TICKS - CORE_TICK_HZ,
                    MENU_SWING_SPANS * MENU_IDLE_TICKS + CORE_TICK_HZ);
}

static void test_occasional_buttons_keep_the_menu_open(void **state)
{
    (void)state;
    open_fixture();
    press(INPUT_TEST);
    for (uint32_t i = 0; i < 5u; i++) {
        steps(MENU_IDLE_TICKS - 10u);
        press(INPUT_SERVICE);
        assert_int_equal(core.game.phase, PHASE_MENU);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_mode_selection_times_out),
        cmocka_unit_test(test_every_chosen_mode_times_out),
        cmocka_unit_test(test_the_result_and_the_following_phases_time_out),
        cmocka_unit_test(test_every_page_of_the_menu_times_out),
        cmocka_unit_test(test_a_moving_poi_keeps_the_menu_open_for_15_minutes),
        cmocka_unit_test(test_occasional_buttons_keep_the_menu_open),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
