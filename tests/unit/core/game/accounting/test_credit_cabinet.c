/* test_credit_cabinet.c -- checks a paid kiosk with the devices of its cabinet (tickets, coin
 * lockout, door switch, tilt switch) and with operating hours. */
#include "tests/unit/support/paid_fixture.h"
#include "core/game/phases.h"

/* ---- Tickets -------------------------------------------------------------------------------- */

static void test_tickets_count_only_complete_groups_of_own_fish(void **state)
{
    (void)state;
    play_a_paid_round();
    /* Five fish give one ticket. The 14 fish of the first player give two tickets, and the four
     * fish of the second player give none. */
    core.game.player[0].caught = 14;
    core.game.player[1].plays = core.game.player[1].out = 1;
    core.game.player[1].caught = 4;
    steps(ROUND_S * CORE_TICK_HZ);
    assert_int_equal(core.game.phase, PHASE_RESULT);
    assert_int_equal(balance()->tickets, 2);
    assert_int_equal(audit(AUDIT_TICKETS), 2);
    steps(GAME_RESULT_TICKS);
    assert_int_equal(output.tickets, 2);
    assert_int_equal(balance()->tickets, 0);
    assert_int_equal(audit(AUDIT_TICKETS_OUT), 2);
}

static void test_a_bot_wins_no_tickets(void **state)
{
    (void)state;
    play_a_paid_round();
    core.game.player[0].caught = 14;
    core.game.bot_played = 1;
    steps(ROUND_S * CORE_TICK_HZ + 10u);
    assert_int_equal(output.tickets, 0);
    assert_int_equal(audit(AUDIT_TICKETS), 0);
}

/* ---- Coin slot and lamps -------------------------------------------------------------------- */

static void test_coins_are_rejected_while_no_player_can_play(void **state)
{
    (void)state;
    assert_int_equal(output.coin_lockout, 0);
    input.poi[0].link = POI_SOURCE_ABSENT;
    step();
    assert_int_equal(output.coin_lockout, 1);
    assert_int_equal(core.game.accounts.credit.warnings, WARN_NO_POI);
    /* A second controller is connected. The kiosk is set to one player whose poi is missing, so the
     * second controller must not open the coin slot. */
    input.poi[1].link = POI_SOURCE_LIVE;
    step();
    assert_int_equal(output.coin_lockout, 1);
    input.poi[0].link = POI_SOURCE_LIVE;
    step();
    assert_int_equal(output.coin_lockout, 0);
}

static void test_an_open_door_warns_and_rejects_coins(void **state)
{
    (void)state;
    play_a_paid_round();
    input.held = INPUT_DOOR;
    step();
    assert_int_equal(core.game.accounts.credit.warnings, WARN_DOOR);
    assert_int_equal(output.coin_lockout, 1);
    steps(CORE_TICK_HZ);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    assert_int_equal(core.game.paused, 0);
    input.held = 0;
    step();
    assert_int_equal(core.game.accounts.credit.warnings, 0);
}

static void test_a_shake_warns_for_a_while_and_counts_once(void **state)
{
    (void)state;
    /* The tilt switch reports only one press, but the warning must last for CREDIT_TILT_TICKS. */
    press(INPUT_TILT);
    for (uint32_t i = 0; i < 3; i++) {
        assert_int_equal(core.game.accounts.credit.warnings, WARN_TILT);
        assert_int_equal(output.coin_lockout, 1);
        /* A second press during the warning counts as part of the same shake, so `shakes` stays
         * 1. */
        press(INPUT_TILT);
    }
    assert_int_equal(core.game.accounts.credit.shakes, 1);
    assert_int_equal(sounds[SOUND_FOUL], 1);
    steps(CREDIT_TILT_TICKS);
    assert_int_equal(core.game.accounts.credit.warnings, 0);
    press(INPUT_TILT);
    assert_int_equal(core.game.accounts.credit.shakes, 2);
}

static void test_a_shake_loses_no_inserted_coin(void **state)
{
    (void)state;
    input.held = INPUT_TILT;
    drop(PRICE);
    assert_int_equal(credits(), 1);
}

/* ---- Operating hours ------------------------------------------------------------------------ */

static void test_the_final_entry_completes_the_operating_time(void **state)
{
    (void)state;
    struct ledger_entry last;
    steps(130u * CORE_TICK_HZ);
    assert_in_range(audit(AUDIT_UP_S), 120, 130);
    assert_in_range(audit(AUDIT_UP_S_MAX), 120, 130);
    assert_int_equal(
        health_log_final(&core.game.accounts, &core.game.health_log, core.game.tick, &input, &last),
        0); /* Because the start number is 0, no store was found, so no final entry is returned. */
    core.game.accounts.ledger.boot = 3;
    const uint64_t hash = core_hash(&core);
    const uint32_t reported = audit(AUDIT_UP_S);
    assert_int_equal(
        health_log_final(&core.game.accounts, &core.game.health_log, core.game.tick, &input, &last),
        1);
    assert_int_equal(last.kind, LEDGER_HEALTH);
    assert_int_equal(last.id, core.game.accounts.ledger.last_id + 1u);
    assert_int_equal(last.boot, 3);
    /* The kiosk has run for 130 s. The audits contain some of these seconds, and the final entry
     * contains the others. */
    assert_int_equal(reported + (uint32_t)last.value, 130);
    assert_int_equal(last.health.up_s, 130);
    assert_true(core_hash(&core) == hash);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_tickets_count_only_complete_groups_of_own_fish, setup_paid),
        cmocka_unit_test_setup(test_a_bot_wins_no_tickets, setup_paid),
        cmocka_unit_test_setup(test_coins_are_rejected_while_no_player_can_play, setup_paid),
        cmocka_unit_test_setup(test_an_open_door_warns_and_rejects_coins, setup_paid),
        cmocka_unit_test_setup(test_a_shake_warns_for_a_while_and_counts_once, setup_paid),
        cmocka_unit_test_setup(test_a_shake_loses_no_inserted_coin, setup_paid),
        cmocka_unit_test_setup(test_the_final_entry_completes_the_operating_time, setup_paid),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
