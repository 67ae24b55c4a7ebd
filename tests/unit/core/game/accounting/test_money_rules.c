/* test_money_rules.c -- each small rule of money alone: what ends a bonus, what no coin buys, what
 * waits for the card, what a start finds again. */
#include "core/game/phases.h"
#include "core/game/accounting/credit.h"
#include "core/game/accounting/ledger_writer.h"
#include "tests/unit/support/game_stand.h"

#define PRICE 3u
#define EXPIRY_MIN 5u

static void open_at(uint32_t price, struct ledger_start start)
{
    const struct core_config config = { .seed = 7,
                                        .fish_count = 12,
                                        .round_s = ROUND_S,
                                        .credit_coins = (uint8_t)price,
                                        .persistent.ledger = start };
    assert_int_equal(core_init(&core, &config), CORE_OK);
    memset(&input, 0, sizeof input);
    memset(&output, 0, sizeof output);
    output.entry_id = start.last_id;
    input.record_saved_id = start.last_id;
    clear_sounds();
    store_is_late = 0;
    hold_at(ABOVE_M);
    input.store_well = 1;
    steps(3);
}

static int open_paid(void **state)
{
    (void)state;
    open_at(PRICE, (struct ledger_start){ .boots = 1 });
    return 0;
}

static int close_stand(void **state)
{
    (void)state;
    store_is_late = 0;
    return 0;
}

static void drop(uint32_t coins)
{
    input.coin_count[0] = coins;
    step();
    input.coin_count[0] = 0;
    step();
}

static void fill_ring(void)
{
    store_is_late = 1;
    for (uint32_t i = 0; i < LEDGER_RING; i++) {
        drop(PRICE);
    }
}

static const struct balance *balance(void)
{
    return &core.game.accounts.ledger.balance;
}

/* ---- Coins and credits ---------------------------------------------------------------------- */

static void test_a_round_between_two_coins_ends_the_way_to_a_bonus(void **state)
{
    (void)state;
    core.config.persistent.settings.value[SET_BONUS_UNITS] = 2 * (int)PRICE;
    drop(PRICE);
    assert_int_equal(balance()->bonus_units, PRICE);
    press(INPUT_START);
    assert_int_equal(balance()->open, PAYMENT_PAID);
    assert_int_equal(balance()->bonus_units, 0);
    drop(PRICE);
    assert_int_equal(purse_credits(&core), 1);
    drop(PRICE); /* The sixth in a row. */
    assert_int_equal(purse_credits(&core), 3);
}

static void test_what_fell_before_there_was_a_bonus_earns_none(void **state)
{
    (void)state;
    core.config.persistent.settings.value[SET_BONUS_UNITS] = 0;
    drop(3u * PRICE);
    core.config.persistent.settings.value[SET_BONUS_UNITS] = 2 * (int)PRICE;
    steps(3);
    assert_int_equal(purse_credits(&core), 3);
    drop(2u * PRICE);
    assert_true(purse_credits(&core) > 5);
}

static void test_a_coin_of_free_play_is_no_credit_when_there_is_a_price_again(void **state)
{
    (void)state;
    open_at(0, (struct ledger_start){ .boots = 1 });
    drop(2u * PRICE);
    core.config.credit_coins = PRICE;
    steps(3);
    assert_int_equal(balance()->units, 0);
    assert_int_equal(balance()->bonus_units, 0);
    assert_int_equal(purse_credits(&core), 0);
}

static void test_nothing_lapses_while_the_card_has_not_all_of_it(void **state)
{
    (void)state;
    core.config.persistent.settings.value[SET_CREDIT_EXPIRY_MIN] = EXPIRY_MIN;
    store_is_late = 1;
    drop(PRICE);
    steps((EXPIRY_MIN * 60u + 1u) * CORE_TICK_HZ);
    assert_int_equal(purse_credits(&core), 1);
    store_is_late = 0;
    steps(3);
    assert_int_equal(purse_credits(&core), 0);
    assert_int_equal(purse_count(&output, LEDGER_EXPIRED), 1);
}

static void test_a_service_credit_that_is_not_on_disk_is_not_the_one_that_is_spent(void **state)
{
    (void)state;
    drop(PRICE);
    step();
    store_is_late = 1;
    press(INPUT_SERVICE);
    assert_int_equal(balance()->service, 1);
    assert_int_equal(ledger_committed_credits(&core.game.accounts.ledger).service, 0);
    press(INPUT_START);
    assert_int_equal(balance()->open, PAYMENT_PAID);
    assert_int_equal(balance()->service, 1);
    assert_int_equal(balance()->paid, 0);
}

static void test_a_free_round_whose_poi_went_is_no_refund(void **state)
{
    (void)state;
    open_at(0, (struct ledger_start){ .boots = 1 });
    press(INPUT_START);
    steps(GAME_READY_TICKS);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    assert_int_equal(balance()->open, PAYMENT_FREE);
    input.poi[0].link = POI_SOURCE_ABSENT;
    for (uint32_t i = 0; i < 2u * ROUND_S * CORE_TICK_HZ + GAME_LOST_TICKS_MAX; i++) {
        step();
        assert_int_equal(purse_count(&output, LEDGER_REFUND), 0);
    }
    assert_int_equal(balance()->open, PAYMENT_NONE);
    assert_int_equal(purse_count(&output, LEDGER_BEGIN), 1);
}

/* ---- The ring and the card ------------------------------------------------------------------ */

static void test_nothing_is_sold_whose_end_could_not_be_told(void **state)
{
    (void)state;
    drop(PRICE);
    assert_true(credit_can_play(&core.game.accounts.ledger, &core.config));
    fill_ring();
    assert_true(ledger_committed_credits(&core.game.accounts.ledger).paid > 0);
    assert_false(ledger_has_room(&core.game.accounts.ledger, LEDGER_COINS));
    assert_false(credit_can_play(&core.game.accounts.ledger, &core.config));
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    assert_int_equal(balance()->open, PAYMENT_NONE);
}

static void test_coins_leave_room_for_the_end_of_a_round(void **state)
{
    (void)state;
    drop(PRICE);
    press(INPUT_START);
    steps(GAME_READY_TICKS);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    fill_ring();
    assert_int_equal(core.game.accounts.ledger.last_id - core.game.accounts.ledger.saved_id,
                     LEDGER_RING - LEDGER_RESERVE);
    steps(ROUND_S * CORE_TICK_HZ);
    assert_int_equal(core.game.phase, PHASE_RESULT);
    assert_int_equal(core.game.accounts.ledger.uncommitted, 0);
    assert_int_equal(purse_count(&output, LEDGER_ROUND), 1);
    assert_int_equal(balance()->open, PAYMENT_NONE);
}

static void test_a_card_that_is_silent_for_two_seconds_closes_the_slot(void **state)
{
    (void)state;
    store_is_late = 1;
    input.coin_count[0] = 1;
    step();
    input.coin_count[0] = 0;
    steps(2u * CORE_TICK_HZ - 1u);
    assert_int_equal(output.coin_lockout, 0);
    steps(3);
    assert_int_equal(output.coin_lockout, 1);
    assert_true(core.game.accounts.credit.warnings & WARN_STORE);
    store_is_late = 0;
    steps(3);
    assert_int_equal(output.coin_lockout, 0);
}

static void test_an_entry_that_was_never_written_is_never_on_disk(void **state)
{
    (void)state;
    store_is_late = 1;
    drop(PRICE);
    const uint32_t saved_id = core.game.accounts.ledger.saved_id;
    input.record_saved_id = output.entry_id + 1u;
    step();
    assert_int_equal(core.game.accounts.ledger.saved_id, saved_id);
    assert_int_equal(ledger_committed_credits(&core.game.accounts.ledger).paid, 0);
    assert_false(credit_can_play(&core.game.accounts.ledger, &core.config));
    input.record_saved_id = output.entry_id;
    step();
    assert_int_equal(core.game.accounts.ledger.saved_id, output.entry_id);
    assert_int_equal(ledger_committed_credits(&core.game.accounts.ledger).paid, 1);
}

/* ---- The next start and the next chapter ---------------------------------------------------- */

static void test_units_that_found_no_room_before_the_plug_was_pulled_are_there_again(void **state)
{
    (void)state;
    open_at(PRICE, (struct ledger_start){
                       .last_id = 5, .boots = 2, .balance = { .units = 1, .unlogged = PRICE } });
    assert_int_equal(balance()->unlogged, 0);
    assert_int_equal(balance()->paid, 1);
    assert_int_equal(balance()->units, 1);
    assert_int_equal(purse_entry(&output, 6)->kind, LEDGER_BOOT);
    assert_int_equal(purse_entry(&output, 6)->value, PRICE);
}

static void open_with_untold(int32_t bonus_units, uint8_t rules_7)
{
    struct core_config config = {
        .seed = 7,
        .fish_count = 12,
        .round_s = ROUND_S,
        .credit_coins = PRICE,
        .rules_7 = rules_7,
        .persistent.ledger = { .last_id = 5, .boots = 2, .balance = { .unlogged = PRICE } },
    };
    settings_reset(&config.persistent.settings);
    config.persistent.settings.value[SET_BONUS_UNITS] = bonus_units;
    assert_int_equal(core_init(&core, &config), CORE_OK);
    memset(&input, 0, sizeof input);
    memset(&output, 0, sizeof output);
    output.entry_id = input.record_saved_id = 5;
    steps(3);
}

static void test_units_from_before_a_power_cut_count_toward_a_configured_bonus(void **state)
{
    (void)state;
    open_with_untold(2 * (int)PRICE, 0);
    assert_int_equal(balance()->bonus_units, PRICE);
    drop(PRICE);
    assert_int_equal(purse_credits(&core), 3);
}

static void test_units_from_before_a_power_cut_count_toward_no_bonus_where_none_is(void **state)
{
    (void)state;
    open_with_untold(0, 0);
    assert_int_equal(balance()->bonus_units, 0);
    core.config.persistent.settings.value[SET_BONUS_UNITS] = 2 * (int)PRICE;
    drop(PRICE);
    assert_int_equal(balance()->bonus_units, PRICE);
    assert_int_equal(purse_credits(&core), 2);
}

static void test_a_recording_of_format_7_keeps_its_count_toward_a_bonus(void **state)
{
    (void)state;
    open_with_untold(0, 1);
    assert_int_equal(balance()->bonus_units, PRICE);
}

static void test_a_chapter_begins_with_the_purse_as_it_is(void **state)
{
    (void)state;
    drop(PRICE + 1u);
    session_restart(&core.game, &core.config);
    const struct ledger_start *start = &core.config.persistent.ledger;
    assert_int_equal(start->balance.paid, 1);
    assert_int_equal(start->balance.units, 1);
    assert_int_equal(start->last_id, output.entry_id);
}

int main(void)
{
#define TEST(test) cmocka_unit_test_setup_teardown(test, open_paid, close_stand)
    const struct CMUnitTest tests[] = {
        TEST(test_what_fell_before_there_was_a_bonus_earns_none),
        TEST(test_a_round_between_two_coins_ends_the_way_to_a_bonus),
        TEST(test_a_coin_of_free_play_is_no_credit_when_there_is_a_price_again),
        TEST(test_nothing_lapses_while_the_card_has_not_all_of_it),
        TEST(test_a_service_credit_that_is_not_on_disk_is_not_the_one_that_is_spent),
        TEST(test_a_free_round_whose_poi_went_is_no_refund),
        TEST(test_nothing_is_sold_whose_end_could_not_be_told),
        TEST(test_coins_leave_room_for_the_end_of_a_round),
        TEST(test_a_card_that_is_silent_for_two_seconds_closes_the_slot),
        TEST(test_an_entry_that_was_never_written_is_never_on_disk),
        TEST(test_units_that_found_no_room_before_the_plug_was_pulled_are_there_again),
        TEST(test_units_from_before_a_power_cut_count_toward_a_configured_bonus),
        TEST(test_units_from_before_a_power_cut_count_toward_no_bonus_where_none_is),
        TEST(test_a_recording_of_format_7_keeps_its_count_toward_a_bonus),
        TEST(test_a_chapter_begins_with_the_purse_as_it_is),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
