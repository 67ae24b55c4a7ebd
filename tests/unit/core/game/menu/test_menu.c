/* test_menu.c -- checks the operator's menu. Two buttons or a poi must be able to reach every page.
 * While the menu is open, no round may run and no inserted coin may give a credit. Each command
 * must be sent once. */
#include "tests/unit/support/menu_fixture.h"
#include "tests/unit/support/newest_record.h"

/* ---- Opening and leaving -------------------------------------------------------------------- */

static void test_test_opens_the_menu_immediately_outside_a_round(void **state)
{
    (void)state;
    press(INPUT_TEST);
    assert_int_equal(core.game.phase, PHASE_MENU);
    /* The press of TEST that opens the menu must not also activate the page's first tag (menu
     * entry). */
    assert_int_equal(menu()->page, MENU_TOP);
    setup(state);
    play_into_result();
    press(INPUT_TEST);
    assert_int_equal(core.game.phase, PHASE_MENU);
}

static void test_test_in_a_round_asks_first_and_one_press_ends_nothing(void **state)
{
    (void)state;
    play_into_round();
    press(INPUT_TEST);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    assert_true(menu_is_confirming(&core.game));
    steps(MENU_CONFIRM_TICKS);
    assert_false(menu_is_confirming(&core.game));
    /* The first press requested a confirmation, which has timed out. The second press must request
     * a new one. */
    press(INPUT_TEST);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    assert_true(menu_is_confirming(&core.game));
}

static void test_a_second_test_ends_the_round_without_a_result_and_refunds_it(void **state)
{
    (void)state;
    core.config.credit_coins = 1;
    core.game.accounts.ledger.balance.paid = core.game.accounts.ledger.committed.paid = 2;
    play_into_round();
    core.game.player[0].caught = 7;
    assert_int_equal(balance_credits(&core), 1);
    press(INPUT_TEST);
    press(INPUT_TEST);
    assert_int_equal(core.game.phase, PHASE_MENU);
    assert_int_equal(balance_credits(&core), 2);
    assert_int_equal(balance_audit(&core, AUDIT_REFUNDS), 1);
    assert_int_equal(newest_record(&output)->id, 0);
    assert_int_equal(core.game.accounts.ranking.row[MODE_FESTIVAL][RANK_DAY][0].caught, 2);
}

static void test_the_question_does_not_carry_over_to_the_next_round(void **state)
{
    (void)state;
    play_into_round();
    press(INPUT_TEST);
    core.game.phase = PHASE_RESULT;
    assert_false(menu_is_confirming(&core.game));
}

static void test_the_last_tag_of_the_menu_reopens_the_kiosk(void **state)
{
    (void)state;
    /* LEFT moves the selection from the first menu entry to the last one, which closes the menu. */
    push(INPUT_LEFT);
    assert_int_equal(pointed(), leave());
    push(INPUT_TEST);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

static void test_an_idle_menu_closes_itself(void **state)
{
    (void)state;
    steps(MENU_IDLE_TICKS / 2u);
    /* A press shows that a person is present, so it restarts the menu's timeout. */
    push(INPUT_SERVICE);
    steps(MENU_IDLE_TICKS - 2u * MENU_TAKE_TICKS);
    assert_int_equal(core.game.phase, PHASE_MENU);
    steps(3u * MENU_TAKE_TICKS);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
}

static void test_the_start_button_in_the_menu_begins_no_round(void **state)
{
    (void)state;
    push(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_MENU);
    assert_int_equal(menu()->page, MENU_DEVICES);
    assert_int_equal(core.game.round_count, 0);
}

/* ---- Two buttons ---------------------------------------------------------------------------- */

static void test_service_cycles_the_selection_and_skips_empty_rows(void **state)
{
    (void)state;
    go_to_controllers();
    static const uint8_t way[] = { 0, 3, ROWS_BACK, 0, 3 };
    for (size_t i = 0; i < sizeof way; i++) {
        assert_int_equal(pointed(), way[i]);
        push(INPUT_SERVICE);
    }
}

static void test_service_adds_no_credit_in_the_menu(void **state)
{
    (void)state;
    core.config.credit_coins = 1;
    push(INPUT_SERVICE);
    assert_int_equal(balance_credits(&core), 0);
    assert_int_equal(balance_audit(&core, AUDIT_CREDITS_SERVICE), 0);
}

/* Opens every page with TEST and SERVICE alone, and leaves the page by its last tag. */
static void test_two_buttons_reach_every_page_and_return(void **state)
{
    /* Bit mask of the reached pages. Pages that no menu entry opens are set at the start, because
     * other tests open them. */
    uint32_t seen = 1u << MENU_TOP;
    for (uint8_t page = 1; page < MENU_PAGE_COUNT; page++) {
        seen |= menu_tag_of(page) == MENU_TAG_MAX ? 1u << page : 0u;
    }
    for (uint8_t page = 1; page < MENU_PAGE_COUNT; page++) {
        uint8_t way[4];
        uint32_t depth = 0;
        setup_open(state);
        input.controllers.update = UPDATE_IDLE; /* Without updates, one page is not offered. */
        step();
        for (uint8_t at = page; at != MENU_TOP && at < MENU_PAGE_COUNT;) {
            way[depth++] = at;
            at = menu_page_desc_of(at)->parent;
        }
        for (uint32_t i = depth; i > 0 && menu_tag_of(way[i - 1u]) < MENU_TAG_MAX; i--) {
            go_to(way[i - 1u]);
            seen |= 1u << way[i - 1u];
        }
        for (uint32_t i = 0; i <= depth && core.game.phase == PHASE_MENU; i++) {
            /* LEFT moves the selection from the first enabled menu entry to the last one. */
            push(INPUT_LEFT);
            while (pointed() != menu_tag_count(menu()->page, false) - 1u) {
                push(INPUT_SERVICE);
            }
            push(INPUT_TEST);
        }
        assert_int_equal(core.game.phase, PHASE_ATTRACT);
    }
    assert_int_equal(seen, (1u << MENU_PAGE_COUNT) - 1u);
}

static void test_a_bouncing_button_activates_a_tag_once(void **state)
{
    (void)state;
    go_to_controllers();
    press(INPUT_TEST);
    press(INPUT_TEST);
    press(INPUT_TEST);
    assert_int_equal(menu()->page, MENU_CONTROLLER);
    assert_int_equal(output.command_count, 0);
}

/* ---- Buttons and coins ---------------------------------------------------------------------- */

static void drop(uint32_t coins)
{
    input.coin_count[0] = coins;
    step();
    input.coin_count[0] = 0;
}

static void test_a_coin_on_the_lines_page_is_a_test_coin_and_only_metered(void **state)
{
    (void)state;
    core.config.credit_coins = 1;
    static struct scene scene;
    go_to_lines();
    /* On this page the coin slot must be open, so that coins reach the coin mechanism that is
     * tested. */
    assert_int_equal(output.coin_lockout, 0);
    for (uint32_t i = 0; i < 5; i++) {
        drop(1);
    }
    core_scene(&core, &scene);
    assert_int_equal(scene.menu.test_coins, 5);
    assert_int_equal(core.game.accounts.ledger.balance.units + balance_credits(&core), 0);
    /* The test coins fall into the cash box, so the coin meter must count them. */
    assert_int_equal(output.coins_counted, 5);
    push(INPUT_TEST);
    assert_int_equal(menu()->page, MENU_DEVICES);
    assert_int_equal(output.coin_lockout, 1);
}

/* On all other pages the coin slot is closed. If a coin is inserted in spite of this, it counts as
 * a test coin. */
static void test_other_pages_reject_coins_and_an_inserted_one_is_a_test_coin(void **state)
{
    (void)state;
    core.config.credit_coins = 2;
    for (uint8_t page = 0; page < MENU_PAGE_COUNT; page++) {
        if (page == MENU_LINES || page == MENU_SELF_TEST) {
            continue;
        }
        const uint32_t before = output.coins_counted;
        menu_turn(&core.game.menu, &core.game, &core.config.persistent.settings,
                  (enum menu_page)page);
        step();
        assert_int_equal(output.coin_lockout, 1);
        drop(1);
        drop(1);
        assert_int_equal(core.game.accounts.ledger.balance.units + balance_credits(&core), 0);
        assert_int_equal(output.coins_counted, before + 2u);
        assert_int_equal(balance_audit(&core, AUDIT_TEST_COINS), output.coins_counted);
    }
}

/* A coin falls in the tick in which the page changes. The meter and the audits must count it
 * once. */
static void test_a_test_coin_in_the_tick_of_a_page_change_counts_once(void **state)
{
    (void)state;
    core.config.credit_coins = 1;
    for (uint32_t i = 1; i <= 60u; i++) {
        menu_turn(&core.game.menu, &core.game, &core.config.persistent.settings,
                  i % 20u < 10u ? MENU_DEVICES : MENU_LINES);
        /* Each pass of this loop inserts a coin. In every tenth pass, TEST is pressed in the same
         * tick and opens or leaves the page LINES. */
        if (i % 10u == 0) {
            core.game.menu.tag[MENU_DEVICES] = (uint8_t)menu_tag_of(MENU_LINES);
            input.pressed = INPUT_TEST;
        }
        drop(1);
        assert_int_equal(output.coins_counted, i);
        assert_int_equal(menu()->test_coins, i);
        assert_int_equal(balance_audit(&core, AUDIT_TEST_COINS), i);
    }
    assert_int_equal(balance_credits(&core), 0);
}

static void test_the_lines_page_shows_inputs_and_only_test_leaves_it(void **state)
{
    (void)state;
    static struct scene scene;
    uint16_t before[INPUT_BUTTON_COUNT];
    go_to_lines();
    /* Stores the counters before the test, because they may contain earlier presses. */
    memcpy(before, menu()->pressed_count, sizeof before);
    const uint32_t shown = INPUT_START | INPUT_OK | INPUT_LEFT | INPUT_RIGHT | INPUT_TILT;
    input.held = shown;
    push(shown);
    push(shown);
    core_scene(&core, &scene);
    assert_int_equal(menu()->page, MENU_LINES);
    assert_int_equal(scene.menu.held, shown);
    for (uint32_t i = 0; i < INPUT_BUTTON_COUNT; i++) {
        assert_int_equal(scene.menu.pressed_count[i], before[i] + (shown >> i & 1u ? 2u : 0u));
    }
    push(INPUT_TEST);
    assert_int_equal(menu()->page, MENU_DEVICES);
}

static void test_the_start_lamp_follows_the_button_on_the_lines_page(void **state)
{
    (void)state;
    go_to_lines();
    step();
    assert_int_equal(output.start_lamp, 0);
    input.held = INPUT_START;
    step();
    assert_int_equal(output.start_lamp, 1);
}

static void test_counters_stop_at_their_largest_shown_value(void **state)
{
    (void)state;
    go_to_lines();
    for (uint32_t i = 0; i < MENU_COUNT_MAX + 10u; i++) {
        press(INPUT_DOOR);
    }
    assert_int_equal(menu()->pressed_count[8], MENU_COUNT_MAX);
    input.coin_count[0] = UINT32_MAX;
    step();
    assert_int_equal(menu()->test_coins, MENU_COUNT_MAX);
    step();
    assert_int_equal(menu()->test_coins, MENU_COUNT_MAX);
}

static void test_a_shake_while_the_menu_is_open_is_not_counted(void **state)
{
    (void)state;
    push(INPUT_TILT);
    assert_int_equal(core.game.accounts.credit.shakes, 0);
}

/* ---- Input validation ------------------------------------------------------------------------ */

static void test_a_controller_status_out_of_range_fails_an_assertion(void **state)
{
    (void)state;
    input.controllers.state[2] = CONTROLLER_STATE_COUNT;
    expect_assert_failure(step());
    input.controllers.state[2] = 0;
    input.controllers.learn_row = CONTROLLER_MAX;
    expect_assert_failure(step());
    input.controllers.learn_row = 0;
    input.controllers.learn_step = LEARN_STEP_COUNT;
    expect_assert_failure(step());
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_test_opens_the_menu_immediately_outside_a_round, setup),
        cmocka_unit_test_setup(test_test_in_a_round_asks_first_and_one_press_ends_nothing, setup),
        cmocka_unit_test_setup(test_a_second_test_ends_the_round_without_a_result_and_refunds_it,
                               setup),
        cmocka_unit_test_setup(test_the_question_does_not_carry_over_to_the_next_round, setup),
        IN_MENU(test_the_last_tag_of_the_menu_reopens_the_kiosk),
        IN_MENU(test_an_idle_menu_closes_itself),
        IN_MENU(test_the_start_button_in_the_menu_begins_no_round),
        IN_MENU(test_service_cycles_the_selection_and_skips_empty_rows),
        IN_MENU(test_service_adds_no_credit_in_the_menu),
        cmocka_unit_test(test_two_buttons_reach_every_page_and_return),
        IN_MENU(test_a_bouncing_button_activates_a_tag_once),
        IN_MENU(test_a_coin_on_the_lines_page_is_a_test_coin_and_only_metered),
        IN_MENU(test_other_pages_reject_coins_and_an_inserted_one_is_a_test_coin),
        IN_MENU(test_a_test_coin_in_the_tick_of_a_page_change_counts_once),
        IN_MENU(test_the_lines_page_shows_inputs_and_only_test_leaves_it),
        IN_MENU(test_the_start_lamp_follows_the_button_on_the_lines_page),
        IN_MENU(test_counters_stop_at_their_largest_shown_value),
        IN_MENU(test_a_shake_while_the_menu_is_open_is_not_counted),
        IN_MENU(test_a_controller_status_out_of_range_fails_an_assertion),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
