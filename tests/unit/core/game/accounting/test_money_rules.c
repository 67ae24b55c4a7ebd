/* test_money_rules.c -- checks single rules of coins, credits and the ledger: the bonus, free play,
 * pending entries, and the state that is restored at a start. */
#include "core/game/phases.h"
#include "core/game/accounting/accounts.h"
#include "tests/unit/support/game_fixture.h"

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

static void test_a_round_between_two_coins_resets_the_bonus_count(void **state)
{
    (void)state;
    core.config.persistent.settings.value[SET_BONUS_UNITS] = 2 * (int)PRICE;
    drop(PRICE);
    assert_int_equal(balance()->bonus_units, PRICE);
    press(INPUT_START);
    assert_int_equal(balance()->open, PAYMENT_PAID);
    assert_int_equal(balance()->bonus_units, 0);
    drop(PRICE);
    assert_int_equal(balance_credits(&core), 1);
    /* The coins give a bonus, because no round was played between them. */
    drop(PRICE);
    assert_int_equal(balance_credits(&core), 3);
}

static void test_a_bonus_of_one_unit_is_given_for_each_unit(void **state)
{
    (void)state;
    core.config.persistent.settings.value[SET_BONUS_UNITS] = 1;
    drop(PRICE);
    assert_int_equal(balance()->paid, 1u + PRICE);
    assert_int_equal(balance()->bonus_units, 0);
    assert_int_equal(balance_audit(&core, AUDIT_CREDITS_BONUS), PRICE);
}

static void test_coins_inserted_before_a_bonus_was_configured_earn_none(void **state)
{
    (void)state;
    core.config.persistent.settings.value[SET_BONUS_UNITS] = 0;
    drop(3u * PRICE);
    core.config.persistent.settings.value[SET_BONUS_UNITS] = 2 * (int)PRICE;
    steps(3);
    assert_int_equal(balance_credits(&core), 3);
    drop(2u * PRICE);
    assert_true(balance_credits(&core) > 5);
}

static void test_a_coin_in_free_play_gives_no_credit_after_a_price_is_set(void **state)
{
    (void)state;
    open_at(0, (struct ledger_start){ .boots = 1 });
    drop(2u * PRICE);
    core.config.credit_coins = PRICE;
    steps(3);
    assert_int_equal(balance()->units, 0);
    assert_int_equal(balance()->bonus_units, 0);
    assert_int_equal(balance_credits(&core), 0);
}

static void test_credits_expire_only_after_all_entries_are_stored(void **state)
{
    (void)state;
    core.config.persistent.settings.value[SET_CREDIT_EXPIRY_MIN] = EXPIRY_MIN;
    store_is_late = 1;
    drop(PRICE);
    steps((EXPIRY_MIN * 60u + 1u) * CORE_TICK_HZ);
    assert_int_equal(balance_credits(&core), 1);
    store_is_late = 0;
    steps(3);
    assert_int_equal(balance_credits(&core), 0);
    assert_int_equal(balance_count(&output, LEDGER_EXPIRED), 1);
}

static void test_an_unstored_service_credit_is_not_spent(void **state)
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

static void test_a_free_round_with_a_lost_poi_gives_no_refund(void **state)
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
        assert_int_equal(balance_count(&output, LEDGER_REFUND), 0);
    }
    assert_int_equal(balance()->open, PAYMENT_NONE);
    assert_int_equal(balance_count(&output, LEDGER_BEGIN), 1);
}

/* ---- Date and time of ledger entries --------------------------------------------------------- */

/* Asserts that the audit counter `id` has the name `name`. */
static void expect_name(uint32_t id, const char *name)
{
    char found[AUDIT_NAME_SIZE];
    audits_name(id, found);
    assert_string_equal(found, name);
}

static void test_a_sold_round_has_its_time_in_the_ledger_and_in_the_audits(void **state)
{
    (void)state;
    input.day = 9800; /* 2026-10-31, a Saturday. */
    input.minute = 23u * 60u + 59u;
    drop(PRICE);
    press(INPUT_START);
    steps(2);
    assert_int_equal(balance()->open, PAYMENT_PAID);
    for (uint32_t id = output.entry_id - 2u; id <= output.entry_id; id++) {
        assert_int_equal(balance_entry(&output, id)->day, 9800);
        assert_int_equal(balance_entry(&output, id)->minute, 23u * 60u + 59u);
    }
    for (uint32_t id = AUDIT_HOUR; id < AUDIT_BOOTS; id++) {
        assert_int_equal(balance_audit(&core, id),
                         id == AUDIT_HOUR + 23u || id == AUDIT_WEEKDAY + 5);
    }
}

static void test_the_names_of_hours_and_weekdays_have_no_leading_zero(void **state)
{
    (void)state;
    expect_name(AUDIT_HOUR, "hour-0");
    expect_name(AUDIT_HOUR + 9, "hour-9");
    expect_name(AUDIT_HOUR + 10, "hour-10");
    expect_name(AUDIT_HOUR + 23, "hour-23");
    expect_name(AUDIT_WEEKDAY, "weekday-1");
    expect_name(AUDIT_WEEKDAY + 6, "weekday-7");
}

/* ---- The ledger ring and the store ---------------------------------------------------------- */

static void test_no_round_is_sold_without_room_for_its_end_entry(void **state)
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
    assert_int_equal(balance_count(&output, LEDGER_ROUND), 1);
    assert_int_equal(balance()->open, PAYMENT_NONE);
}

static void test_a_store_silent_for_two_seconds_closes_the_coin_slot(void **state)
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

static void test_an_unwritten_entry_never_counts_as_stored(void **state)
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

/* ---- The next start and the next session ---------------------------------------------------- */

static void test_units_without_room_before_a_power_cut_are_restored(void **state)
{
    (void)state;
    open_at(PRICE, (struct ledger_start){
                       .last_id = 5, .boots = 2, .balance = { .units = 1, .unlogged = PRICE } });
    assert_int_equal(balance()->unlogged, 0);
    assert_int_equal(balance()->paid, 1);
    assert_int_equal(balance()->units, 1);
    assert_int_equal(balance_entry(&output, 6)->kind, LEDGER_BOOT);
    assert_int_equal(balance_entry(&output, 6)->value, PRICE);
}

static void open_with_unlogged(int32_t bonus_units, uint8_t rules)
{
    struct core_config config = {
        .seed = 7,
        .fish_count = 12,
        .round_s = ROUND_S,
        .credit_coins = PRICE,
        .rules = rules,
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
    open_with_unlogged(2 * (int)PRICE, 0);
    assert_int_equal(balance()->bonus_units, PRICE);
    drop(PRICE);
    assert_int_equal(balance_credits(&core), 3);
}

static void test_units_from_before_a_power_cut_count_toward_no_unconfigured_bonus(void **state)
{
    (void)state;
    open_with_unlogged(0, 0);
    assert_int_equal(balance()->bonus_units, 0);
    core.config.persistent.settings.value[SET_BONUS_UNITS] = 2 * (int)PRICE;
    drop(PRICE);
    assert_int_equal(balance()->bonus_units, PRICE);
    assert_int_equal(balance_credits(&core), 2);
}

static void test_a_recording_of_format_7_keeps_its_count_toward_a_bonus(void **state)
{
    (void)state;
    open_with_unlogged(0, 7);
    assert_int_equal(balance()->bonus_units, PRICE);
}

static void test_a_new_session_starts_with_the_present_balance(void **state)
{
    (void)state;
    drop(PRICE + 1u);
    session_restart(&core.game, &core.config);
    const struct ledger_start *start = &core.config.persistent.ledger;
    assert_int_equal(start->balance.paid, 1);
    assert_int_equal(start->balance.units, 1);
    assert_int_equal(start->last_id, output.entry_id);
}

/* The store has read its log, but cannot write the log again, for example because another program
 * has locked the database. The entries of the log may then not be on disk. */
static void test_loaded_credits_are_playable_only_if_they_are_on_disk(void **state)
{
    (void)state;
    const struct ledger_start start = { .last_id = 9,
                                        .boots = 2,
                                        .balance = { .paid = 2, .tickets = 3 } };
    open_at(PRICE, start);
    assert_int_equal(ledger_committed_credits(&core.game.accounts.ledger).paid, 2);

    const struct core_config config = core.config;
    assert_int_equal(core_init(&core, &config), CORE_OK);
    store_is_late = 1;
    input.record_saved_id = 0;
    input.store_well = 0;
    output.tickets = 0;
    steps(240);
    assert_int_equal(ledger_committed_credits(&core.game.accounts.ledger).paid, 0);
    assert_true(core.game.accounts.credit.warnings & WARN_STORE);
    press(INPUT_START);
    dip();
    steps(2u * CREDIT_AWAIT_TICKS);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);
    assert_int_equal(output.tickets, 0);

    store_is_late = 0;
    steps(2);
    assert_int_equal(ledger_committed_credits(&core.game.accounts.ledger).paid, 2);
    assert_int_equal(balance()->paid, 2);
    steps(10);
    assert_int_equal(output.tickets, 3);
}

int main(void)
{
#define TEST(test) cmocka_unit_test_setup_teardown(test, open_paid, close_stand)
    const struct CMUnitTest tests[] = {
        TEST(test_coins_inserted_before_a_bonus_was_configured_earn_none),
        TEST(test_a_bonus_of_one_unit_is_given_for_each_unit),
        TEST(test_a_round_between_two_coins_resets_the_bonus_count),
        TEST(test_a_coin_in_free_play_gives_no_credit_after_a_price_is_set),
        TEST(test_credits_expire_only_after_all_entries_are_stored),
        TEST(test_an_unstored_service_credit_is_not_spent),
        TEST(test_a_free_round_with_a_lost_poi_gives_no_refund),
        TEST(test_a_sold_round_has_its_time_in_the_ledger_and_in_the_audits),
        TEST(test_the_names_of_hours_and_weekdays_have_no_leading_zero),
        TEST(test_no_round_is_sold_without_room_for_its_end_entry),
        TEST(test_coins_leave_room_for_the_end_of_a_round),
        TEST(test_a_store_silent_for_two_seconds_closes_the_coin_slot),
        TEST(test_an_unwritten_entry_never_counts_as_stored),
        TEST(test_units_without_room_before_a_power_cut_are_restored),
        TEST(test_units_from_before_a_power_cut_count_toward_a_configured_bonus),
        TEST(test_units_from_before_a_power_cut_count_toward_no_unconfigured_bonus),
        TEST(test_a_recording_of_format_7_keeps_its_count_toward_a_bonus),
        TEST(test_a_new_session_starts_with_the_present_balance),
        TEST(test_loaded_credits_are_playable_only_if_they_are_on_disk),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
