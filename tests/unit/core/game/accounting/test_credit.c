/* test_credit.c -- checks that no coin is lost or counted twice, and that no round starts without
 * payment. */
#include "core/game/phases.h"
#include "tests/unit/support/paid_fixture.h"
#include "tests/unit/support/newest_record.h"

/* ---- Coins ---------------------------------------------------------------------------------- */

static void test_start_and_a_dip_begin_no_round_without_a_coin(void **state)
{
    (void)state;
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    dip();
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    assert_int_equal(output.start_lamp, 0);
    steps(HINT_TICKS_MIN);
    assert_int_equal(core.game.hints.shown, HINT_COIN);
}

static void test_a_start_without_a_credit_is_shown(void **state)
{
    (void)state;
    static struct scene scene;
    core_scene(&core, &scene);
    assert_true(scene.credit.request_s > 1000.0f);
    press(INPUT_START);
    core_scene(&core, &scene);
    assert_true(scene.credit.request_s < 0.1f);
    /* A start that the core rejects plays the sound of a foul. */
    assert_int_equal(sounds[SOUND_FOUL], 1);
    assert_true(scene.credit.unpaid);
}

static void test_coins_become_a_credit_with_the_last_coin(void **state)
{
    (void)state;
    for (uint32_t coins = 1; coins < PRICE; coins++) {
        drop(1);
        assert_int_equal(balance()->units, coins);
        press(INPUT_START);
        assert_int_equal(core.game.phase, PHASE_ATTRACT);
    }
    drop(1);
    assert_int_equal(balance()->units, 0);
    assert_int_equal(credits(), 1);
    assert_int_equal(output.coins_counted, PRICE);
    assert_int_equal(sounds[SOUND_COIN], PRICE);
}

static void test_a_coin_in_the_tick_of_start_counts(void **state)
{
    (void)state;
    drop(PRICE - 1u);
    input.coin_count[0] = 1;
    press(INPUT_START);
    input.coin_count[0] = 0;
    /* In this step the store reports that the ledger entry of the payment is saved, so the round
     * begins. */
    step();
    assert_int_equal(core.game.phase, PHASE_READY);
    assert_int_equal(credits(), 0);
}

static void test_surplus_coins_count_toward_the_next_round(void **state)
{
    (void)state;
    drop(2u * PRICE + 1u);
    assert_int_equal(credits(), 2);
    assert_int_equal(balance()->units, 1);
    press(INPUT_START);
    assert_int_equal(credits(), 1);
    /* One of the two credits paid for the current round. The surplus coin and these PRICE - 1 coins
     * give one more credit during the round. */
    drop(PRICE - 1u);
    assert_int_equal(credits(), 2);
}

static void test_a_full_credit_count_rejects_coins_and_loses_no_inserted_coin(void **state)
{
    (void)state;
    assert_int_equal(output.coin_lockout, 0);
    drop(CREDITS_MAX * PRICE);
    assert_int_equal(credits(), CREDITS_MAX);
    assert_int_equal(output.coin_lockout, 1);
    /* Inserts more coins, as if they had been in the slot when it closed. The value of these coins
     * stays in the balance as units. */
    drop(PRICE);
    assert_int_equal(credits(), CREDITS_MAX);
    assert_int_equal(balance()->units, PRICE);
    press(INPUT_START);
    step();
    assert_int_equal(credits(), CREDITS_MAX);
    assert_int_equal(balance()->units, 0);
}

static void test_free_play_rejects_coins_and_meters_inserted_ones(void **state)
{
    (void)state;
    setup(state);
    hold_at(ABOVE_M);
    step();
    assert_int_equal(output.coin_lockout, 1);
    drop(2);
    assert_int_equal(output.coins_counted, 2);
    assert_int_equal(credits(), 0);
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_READY);
}

static void test_service_adds_a_credit_without_a_coin(void **state)
{
    (void)state;
    press(INPUT_SERVICE);
    assert_int_equal(credits(), 1);
    assert_int_equal(audit(AUDIT_CREDITS_SERVICE), 1);
    assert_int_equal(output.coins_counted, 0);
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_READY);
}

static void test_service_in_free_play_adds_no_credit(void **state)
{
    (void)state;
    setup(state);
    press(INPUT_SERVICE);
    assert_int_equal(credits(), 0);
    assert_int_equal(audit(AUDIT_CREDITS_SERVICE), 0);
}

/* ---- Rounds --------------------------------------------------------------------------------- */

static void test_a_finished_round_costs_one_credit(void **state)
{
    (void)state;
    play_a_paid_round();
    steps(ROUND_S * CORE_TICK_HZ);
    assert_int_equal(core.game.phase, PHASE_RESULT);
    assert_int_equal(credits(), 0);
    assert_int_equal(audit(AUDIT_REFUNDS), 0);
    steps(GAME_AGAIN_DIP_TICKS);
    press(INPUT_START);
    /* No credit is left, so START cannot begin another round. */
    assert_int_equal(core.game.phase, PHASE_RESULT);
    drop(PRICE);
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_READY);
}

static void test_leaving_the_mode_selection_costs_no_credit(void **state)
{
    (void)state;
    core.config.modes = 1u << MODE_FESTIVAL | 1u << MODE_PRACTICE;
    drop(PRICE);
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_MODE_SELECT);
    assert_int_equal(credits(), 1);
    steps(GAME_MODE_SELECT_TICKS_MAX);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    assert_int_equal(credits(), 1);
}

static void test_the_growth_lab_costs_a_credit_too(void **state)
{
    (void)state;
    core.config.modes = 1u << CHOICE_LAB;
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    drop(PRICE);
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_LAB);
    assert_int_equal(credits(), 0);
}

static void test_a_kiosk_with_only_the_lab_opens_it_by_itself_only_in_free_play(void **state)
{
    (void)state;
    struct core_config config = { .seed = 7, .modes = 1u << CHOICE_LAB, .credit_coins = 1 };
    assert_int_equal(core_init(&core, &config), CORE_OK);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    config.credit_coins = 0;
    assert_int_equal(core_init(&core, &config), CORE_OK);
    assert_int_equal(core.game.phase, PHASE_LAB);
}

/* coins_tick() closes an ended game before each phase runs. Therefore credit_take() never replaces
 * the payment of an open game. */
static void test_a_credit_is_not_taken_while_a_game_is_open(void **state)
{
    (void)state;
    drop(PRICE);
    step();
    assert_true(credit_can_play(&core.game.accounts.ledger, &core.config));
    core.game.accounts.ledger.balance.open = PAYMENT_FREE;
    expect_assert_failure(
        credit_take(&core.game.accounts, &core.game, &core.config, MODE_FESTIVAL, &output));
    step();
    assert_int_equal(balance()->open, PAYMENT_NONE);
    credit_take(&core.game.accounts, &core.game, &core.config, MODE_FESTIVAL, &output);
    assert_int_equal(balance()->open, PAYMENT_PAID);
}

static void test_a_permanently_lost_poi_refunds_the_credit(void **state)
{
    (void)state;
    play_a_paid_round();
    input.poi[0].link = POI_SOURCE_LOST;
    steps(GAME_LOST_TICKS_MAX);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    assert_int_equal(credits(), 0);
    steps(3);
    assert_int_equal(core.game.phase, PHASE_RESULT);
    assert_int_equal(credits(), 1);
    assert_int_equal(audit(AUDIT_REFUNDS), 1);
    assert_int_equal(core.game.hints.shown, HINT_PAID_BACK);
    steps(GAME_RESULT_TICKS);
    /* The return to attract mode has not refunded the credit a second time. */
    assert_int_equal(credits(), 1);
}

static void test_a_restored_poi_refunds_no_credit(void **state)
{
    (void)state;
    play_a_paid_round();
    input.poi[0].link = POI_SOURCE_LOST;
    steps(GAME_LOST_TICKS_MAX / 2u);
    input.poi[0].link = POI_SOURCE_LIVE;
    steps(ROUND_S * CORE_TICK_HZ + CORE_TICK_HZ);
    assert_int_equal(core.game.phase, PHASE_RESULT);
    assert_int_equal(credits(), 0);
    assert_int_equal(audit(AUDIT_REFUNDS), 0);
}

static void test_a_free_round_is_not_refunded(void **state)
{
    (void)state;
    setup(state);
    play_into_round();
    input.poi[0].link = POI_SOURCE_LOST;
    steps(GAME_LOST_TICKS_MAX + 3u);
    assert_int_equal(core.game.phase, PHASE_RESULT);
    assert_int_equal(credits(), 0);
    assert_int_equal(audit(AUDIT_REFUNDS), 0);
}

/* If the controller stays lost, the round is refunded. A refunded round gives neither tickets nor a
 * rank, however many fish were caught. */
static void test_a_refunded_round_is_not_scored(void **state)
{
    (void)state;
    static struct scene scene;
    drop(PRICE);
    hold_at(ABOVE_M);
    press(INPUT_START);
    steps(GAME_READY_TICKS + 10u);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    core.game.player[0].caught = 14;
    input.poi[0].link = POI_SOURCE_LOST;
    steps(GAME_LOST_TICKS_MAX + 3u);
    assert_int_equal(core.game.phase, PHASE_RESULT);
    assert_int_equal(credits(), 1);
    assert_int_equal(audit(AUDIT_REFUNDS), 1);
    assert_int_equal(audit(AUDIT_TICKETS), 0);
    assert_int_equal(output.tickets, 0);
    assert_int_equal(newest_record(&output)->id, 0);
    assert_int_equal(core.game.accounts.ranking.row[MODE_FESTIVAL][RANK_DAY][0].caught, 0);
    core_scene(&core, &scene);
    assert_true(scene.credit.came_back);
    steps(GAME_AGAIN_TICKS);
    hold_at(ABOVE_M);
    press(INPUT_START);
    steps(GAME_READY_TICKS + ROUND_S * CORE_TICK_HZ);
    /* In this round the controller was not lost. The round was therefore played to its end without
     * a refund. */
    assert_int_equal(core.game.phase, PHASE_RESULT);
    assert_int_equal(balance_entry(&output, newest_record(&output)->id)->kind, LEDGER_ROUND);
    core_scene(&core, &scene);
    assert_false(scene.credit.came_back);
}

static void test_a_free_round_with_a_lost_poi_is_scored(void **state)
{
    (void)state;
    setup(state);
    play_into_round();
    steps(10);
    core.game.player[0].caught = 14;
    input.poi[0].link = POI_SOURCE_LOST;
    steps(GAME_LOST_TICKS_MAX + 3u);
    assert_int_equal(core.game.phase, PHASE_RESULT);
    assert_int_equal(newest_record(&output)->caught, 14);
    assert_int_equal(core.game.accounts.ranking.row[MODE_FESTIVAL][RANK_DAY][0].caught, 14);
}

static void test_prices_and_tickets_out_of_range_are_rejected(void **state)
{
    (void)state;
    struct core_config config = { .seed = 7,
                                  .credit_coins = CREDIT_COINS_MAX,
                                  .ticket_fish = CREDIT_TICKET_FISH_MAX };
    assert_int_equal(core_init(&core, &config), CORE_OK);
    config.credit_coins++;
    assert_int_equal(core_init(&core, &config), CORE_ERR_RANGE);
    config.credit_coins--;
    config.ticket_fish++;
    assert_int_equal(core_init(&core, &config), CORE_ERR_RANGE);
}

/* Inserts random coins at random times. At the end, each coin must be part of a credit or of the
 * balance. Each credit must have paid for a round or still be available. */
static void test_every_coin_is_accounted_for_in_a_random_day(void **state)
{
    (void)state;
    uint32_t dropped = 0, given = 0, played = 0;
    for (uint32_t tick = 0; tick < 200u * CORE_TICK_HZ; tick++) {
        const uint32_t dice = hash_u32(HASH_START, tick) >> 7 & 1023u;
        const uint32_t before = core.game.round_count;
        input.coin_count[0] = dice < 4u ? dice : 0u;
        input.pressed = (dice >= 100u && dice < 120u ? INPUT_START : 0u) |
                        (dice == 300u ? INPUT_SERVICE : 0u) | (dice == 400u ? INPUT_TILT : 0u);
        input.poi[0].link = dice == 500u ? POI_SOURCE_LOST : POI_SOURCE_LIVE;
        dropped += input.coin_count[0];
        given += dice == 300u;
        step();
        played += core.game.round_count - before;
    }
    assert_true(dropped > 100u && played > 3u && given > 3u);
    assert_int_equal(output.coins_counted, dropped);
    assert_int_equal(audit(AUDIT_CREDITS_SERVICE), given);
    assert_int_equal(dropped + PRICE * given,
                     balance()->units + PRICE * (credits() + played - audit(AUDIT_REFUNDS)));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(test_start_and_a_dip_begin_no_round_without_a_coin, setup_paid),
        cmocka_unit_test_setup(test_a_start_without_a_credit_is_shown, setup_paid),
        cmocka_unit_test_setup(test_coins_become_a_credit_with_the_last_coin, setup_paid),
        cmocka_unit_test_setup(test_a_coin_in_the_tick_of_start_counts, setup_paid),
        cmocka_unit_test_setup(test_surplus_coins_count_toward_the_next_round, setup_paid),
        cmocka_unit_test_setup(test_a_full_credit_count_rejects_coins_and_loses_no_inserted_coin,
                               setup_paid),
        cmocka_unit_test(test_free_play_rejects_coins_and_meters_inserted_ones),
        cmocka_unit_test_setup(test_service_adds_a_credit_without_a_coin, setup_paid),
        cmocka_unit_test(test_service_in_free_play_adds_no_credit),
        cmocka_unit_test_setup(test_a_finished_round_costs_one_credit, setup_paid),
        cmocka_unit_test_setup(test_leaving_the_mode_selection_costs_no_credit, setup_paid),
        cmocka_unit_test_setup(test_the_growth_lab_costs_a_credit_too, setup_paid),
        cmocka_unit_test(test_a_kiosk_with_only_the_lab_opens_it_by_itself_only_in_free_play),
        cmocka_unit_test_setup(test_a_credit_is_not_taken_while_a_game_is_open, setup_paid),
        cmocka_unit_test_setup(test_a_permanently_lost_poi_refunds_the_credit, setup_paid),
        cmocka_unit_test_setup(test_a_restored_poi_refunds_no_credit, setup_paid),
        cmocka_unit_test(test_a_free_round_is_not_refunded),
        cmocka_unit_test_setup(test_a_refunded_round_is_not_scored, setup_paid),
        cmocka_unit_test(test_a_free_round_with_a_lost_poi_is_scored),
        cmocka_unit_test(test_prices_and_tickets_out_of_range_are_rejected),
        cmocka_unit_test_setup(test_every_coin_is_accounted_for_in_a_random_day, setup_paid),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
