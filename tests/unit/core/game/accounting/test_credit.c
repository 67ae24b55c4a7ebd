/* test_credit.c -- money: no coin is lost, none counts twice, and nobody plays for nothing. */
#include "core/game/phases.h"
#include "tests/unit/support/paid_stand.h"

/* ---- Coins ---------------------------------------------------------------------------------- */

static void test_without_a_coin_neither_start_nor_a_dip_plays(void **state)
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

static void test_who_wants_to_play_in_vain_is_seen(void **state)
{
    (void)state;
    static struct scene scene;
    core_scene(&core, &scene);
    assert_true(scene.credit.asked_s > 1000.0f);
    press(INPUT_START);
    core_scene(&core, &scene);
    assert_true(scene.credit.asked_s < 0.1f);
    assert_int_equal(sounds[SOUND_FOUL], 1); /* Heard, too. */
    assert_true(scene.credit.unpaid);
}

static void test_coins_become_a_credit_when_the_last_one_falls(void **state)
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

static void test_a_coin_that_falls_with_start_is_in_time(void **state)
{
    (void)state;
    drop(PRICE - 1u);
    input.coin_count[0] = 1;
    press(INPUT_START);
    input.coin_count[0] = 0;
    step(); /* It is on disk. */
    assert_int_equal(core.game.phase, PHASE_READY);
    assert_int_equal(credits(), 0);
}

static void test_more_coins_than_a_round_costs_wait_for_the_next(void **state)
{
    (void)state;
    drop(2u * PRICE + 1u);
    assert_int_equal(credits(), 2);
    assert_int_equal(balance()->units, 1);
    press(INPUT_START);
    assert_int_equal(credits(), 1);
    drop(PRICE - 1u); /* In the round. */
    assert_int_equal(credits(), 2);
}

static void test_a_full_plate_sends_coins_back_and_loses_none_that_falls(void **state)
{
    (void)state;
    assert_int_equal(output.coin_lockout, 0);
    drop(CREDITS_MAX * PRICE);
    assert_int_equal(credits(), CREDITS_MAX);
    assert_int_equal(output.coin_lockout, 1);
    drop(PRICE); /* It was on its way. */
    assert_int_equal(credits(), CREDITS_MAX);
    assert_int_equal(balance()->units, PRICE);
    press(INPUT_START);
    step();
    assert_int_equal(credits(), CREDITS_MAX);
    assert_int_equal(balance()->units, 0);
}

static void test_in_free_play_coins_are_sent_back_and_what_falls_is_metered(void **state)
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

static void test_service_gives_one_that_no_coin_is_counted_for(void **state)
{
    (void)state;
    press(INPUT_SERVICE);
    assert_int_equal(credits(), 1);
    assert_int_equal(audit(AUDIT_CREDITS_SERVICE), 1);
    assert_int_equal(output.coins_counted, 0);
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_READY);
}

static void test_service_in_free_play_gives_nothing(void **state)
{
    (void)state;
    setup(state);
    press(INPUT_SERVICE);
    assert_int_equal(credits(), 0);
    assert_int_equal(audit(AUDIT_CREDITS_SERVICE), 0);
}

/* ---- Rounds --------------------------------------------------------------------------------- */

static void test_a_round_takes_one_credit_and_keeps_it(void **state)
{
    (void)state;
    play_a_paid_round();
    steps(ROUND_S * CORE_TICK_HZ);
    assert_int_equal(core.game.phase, PHASE_RESULT);
    assert_int_equal(credits(), 0);
    assert_int_equal(audit(AUDIT_REFUNDS), 0);
    steps(GAME_AGAIN_DIP_TICKS);
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_RESULT); /* Nobody paid for another. */
    drop(PRICE);
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_READY);
}

static void test_who_looks_at_the_choice_and_leaves_has_paid_nothing(void **state)
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

static void test_a_stall_of_the_lab_alone_opens_it_for_nothing_only_when_it_is_free(void **state)
{
    (void)state;
    struct core_config config = { .seed = 7, .modes = 1u << CHOICE_LAB, .credit_coins = 1 };
    assert_int_equal(core_init(&core, &config), CORE_OK);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    config.credit_coins = 0;
    assert_int_equal(core_init(&core, &config), CORE_OK);
    assert_int_equal(core.game.phase, PHASE_LAB);
}

static void test_the_credit_comes_back_when_the_poi_is_lost_for_good(void **state)
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
    assert_int_equal(credits(), 1); /* Once. */
}

static void test_a_poi_that_comes_back_brings_no_credit_with_it(void **state)
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

static void test_a_free_round_has_nothing_to_give_back(void **state)
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

/* A plug that is pulled with a full bowl is worth neither prize nor place. */
static void test_a_round_that_was_given_back_counts_for_nothing(void **state)
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
    assert_int_equal(output.record.id, 0);
    assert_int_equal(core.game.accounts.ranking.row[MODE_FESTIVAL][RANK_DAY][0].caught, 0);
    core_scene(&core, &scene);
    assert_true(scene.credit.came_back);
    steps(GAME_AGAIN_TICKS);
    hold_at(ABOVE_M);
    press(INPUT_START);
    steps(GAME_READY_TICKS + ROUND_S * CORE_TICK_HZ);
    assert_int_equal(core.game.phase, PHASE_RESULT); /* The next is played to its end. */
    assert_int_equal(purse_entry(&output, output.record.id)->kind, LEDGER_ROUND);
    core_scene(&core, &scene);
    assert_false(scene.credit.came_back);
}

static void test_a_free_round_whose_poi_is_lost_is_a_score(void **state)
{
    (void)state;
    setup(state);
    play_into_round();
    steps(10);
    core.game.player[0].caught = 14;
    input.poi[0].link = POI_SOURCE_LOST;
    steps(GAME_LOST_TICKS_MAX + 3u);
    assert_int_equal(core.game.phase, PHASE_RESULT);
    assert_int_equal(output.record.caught, 14);
    assert_int_equal(core.game.accounts.ranking.row[MODE_FESTIVAL][RANK_DAY][0].caught, 14);
}

static void test_prices_and_tickets_out_of_range_are_refused(void **state)
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

/* Whatever falls whenever: each coin is a credit's share, and each credit is a round or waits. */
static void test_over_a_wild_day_every_coin_is_accounted_for(void **state)
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
        cmocka_unit_test_setup(test_without_a_coin_neither_start_nor_a_dip_plays, setup_paid),
        cmocka_unit_test_setup(test_who_wants_to_play_in_vain_is_seen, setup_paid),
        cmocka_unit_test_setup(test_coins_become_a_credit_when_the_last_one_falls, setup_paid),
        cmocka_unit_test_setup(test_a_coin_that_falls_with_start_is_in_time, setup_paid),
        cmocka_unit_test_setup(test_more_coins_than_a_round_costs_wait_for_the_next, setup_paid),
        cmocka_unit_test_setup(test_a_full_plate_sends_coins_back_and_loses_none_that_falls,
                               setup_paid),
        cmocka_unit_test(test_in_free_play_coins_are_sent_back_and_what_falls_is_metered),
        cmocka_unit_test_setup(test_service_gives_one_that_no_coin_is_counted_for, setup_paid),
        cmocka_unit_test(test_service_in_free_play_gives_nothing),
        cmocka_unit_test_setup(test_a_round_takes_one_credit_and_keeps_it, setup_paid),
        cmocka_unit_test_setup(test_who_looks_at_the_choice_and_leaves_has_paid_nothing,
                               setup_paid),
        cmocka_unit_test_setup(test_the_growth_lab_costs_a_credit_too, setup_paid),
        cmocka_unit_test(test_a_stall_of_the_lab_alone_opens_it_for_nothing_only_when_it_is_free),
        cmocka_unit_test_setup(test_the_credit_comes_back_when_the_poi_is_lost_for_good,
                               setup_paid),
        cmocka_unit_test_setup(test_a_poi_that_comes_back_brings_no_credit_with_it, setup_paid),
        cmocka_unit_test(test_a_free_round_has_nothing_to_give_back),
        cmocka_unit_test_setup(test_a_round_that_was_given_back_counts_for_nothing, setup_paid),
        cmocka_unit_test(test_a_free_round_whose_poi_is_lost_is_a_score),
        cmocka_unit_test(test_prices_and_tickets_out_of_range_are_refused),
        cmocka_unit_test_setup(test_over_a_wild_day_every_coin_is_accounted_for, setup_paid),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
