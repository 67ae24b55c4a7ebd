/* test_full_ring.c -- checks the kiosk while its ring buffer of unsaved ledger entries is full,
 * because the store has failed, is late or appears later. No button may stop the kiosk, and no
 * round may start without payment. When the store works again, paid credits must be available
 * again. */
#include "tests/unit/support/game_fixture.h"
#include "core/game/accounting/accounts.h"
#include "core/game/phases.h"

#define PRICE 1u
/* Number of coins after which the ring buffer is full. Each coin writes two entries while there is
 * room. */
#define COINS_FOR_A_FULL_RING 40u

/* Opens a paid kiosk with three modes. `boots` is the number of starts of the kiosk; 0 means that
 * no store was found. */
static void open_paid(uint32_t boots)
{
    const struct core_config config = {
        .seed = 7,
        .fish_count = 12,
        .round_s = ROUND_S,
        .credit_coins = PRICE,
        .modes = 1u << MODE_FESTIVAL | 1u << MODE_CHAMPIONSHIP | 1u << CHOICE_LAB,
        .persistent.ledger.boots = boots,
    };
    assert_int_equal(core_init(&core, &config), CORE_OK);
    memset(&input, 0, sizeof input);
    memset(&output, 0, sizeof output);
    clear_sounds();
    hold_at(ABOVE_M);
    input.store_well = boots > 0;
    store_is_late = boots == 0;
    step();
}

static int close_stand(void **state)
{
    (void)state;
    store_is_late = 0;
    return 0;
}

static void drop_each(uint32_t coins)
{
    for (uint32_t i = 0; i < coins; i++) {
        input.coin_count[0] = 1;
        step();
        input.coin_count[0] = 0;
    }
}

/* Simulates that the store works again and has saved all entries. */
static void repair_store(void)
{
    store_is_late = 0;
    input.record_saved_id = output.entry_id;
    step();
    step();
}

static void choose_with_a_credit(void)
{
    drop_each(1);
    step();
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_MODE_SELECT);
    steps(GAME_MODE_SELECT_TICKS_MIN + 1u);
}

static void test_a_ring_that_fills_during_the_mode_selection_permits_a_retry(void **state)
{
    (void)state;
    open_paid(1);
    choose_with_a_credit();
    store_is_late = 1;
    drop_each(COINS_FOR_A_FULL_RING);
    const uint32_t fouls = sounds[SOUND_FOUL];
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_MODE_SELECT);
    assert_int_equal(core.game.accounts.ledger.balance.open, PAYMENT_NONE);
    press(INPUT_OK);
    dip();
    assert_int_equal(core.game.phase, PHASE_MODE_SELECT);
    assert_true(core.game.accounts.credit.request_tick != 0 ||
                core.game.accounts.credit.await_tick != 0);
    assert_true(sounds[SOUND_FOUL] > fouls || core.game.accounts.credit.await_tick != 0);
    repair_store();
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_READY);
    assert_int_equal(core.game.accounts.ledger.balance.open, PAYMENT_PAID);
    assert_int_equal(balance_credits(&core), COINS_FOR_A_FULL_RING);
}

static void test_a_full_store_only_delays_the_game(void **state)
{
    (void)state;
    for (uint32_t coins = 0; coins < LEDGER_RING; coins++) {
        open_paid(1);
        choose_with_a_credit();
        store_is_late = 1;
        input.store_well = 0;
        drop_each(coins / 2u);
        if (coins % 2u) {
            press(INPUT_SERVICE);
        }
        press(INPUT_START);
        const int plays = core.game.phase == PHASE_READY;
        assert_int_equal(plays, core.game.accounts.ledger.balance.open == PAYMENT_PAID);
        assert_true(plays || core.game.phase == PHASE_MODE_SELECT);
        /* Runs until the countdown of a started round is over, or until the mode selection has
         * timed out. */
        steps(GAME_READY_TICKS + RULES_MODE_SELECT_TICKS);
        drop_each(coins);
        input.poi[0].link = POI_SOURCE_ABSENT;
        steps(GAME_LOST_TICKS_MAX + GAME_AGAIN_TICKS);
        /* Leaves the result screen by button presses. Afterwards no ledger entry may be waiting for
         * room in the ring buffer. */
        for (uint32_t i = 0; i < 4; i++) {
            press(INPUT_START | INPUT_OK);
            steps(CORE_TICK_HZ);
        }
        assert_int_equal(core.game.accounts.ledger.uncommitted, 0);
    }
}

static uint32_t draw(uint32_t *seed, uint32_t below)
{
    /* Computes the next number of Knuth's linear congruential generator. Only the upper 16 bits are
     * used, because the lower bits are less random. */
    *seed = *seed * 1664525u + 1013904223u;
    return (*seed >> 16) % below;
}

/* Presses random buttons while the store responds only sometimes or never. */
static void press_random_buttons(uint32_t *seed, uint32_t ticks)
{
    static const uint32_t buttons[] = { INPUT_START, INPUT_OK,      INPUT_LEFT,    INPUT_RIGHT,
                                        INPUT_DOOR,  INPUT_SERVICE, INPUT_LANGUAGE };
    for (uint32_t i = 0; i < ticks; i++) {
        input.pressed = draw(seed, 20) == 0 ? buttons[draw(seed, 7)] : 0u;
        input.pressed = draw(seed, 4000) == 0 ? (uint32_t)INPUT_TEST : input.pressed;
        input.coin_count[0] = draw(seed, 120) == 0;
        hold_at(draw(seed, 40) == 0 ? BELOW_M : ABOVE_M);
        input.store_well = draw(seed, 200) != 0;
        step();
        if (draw(seed, 100) == 0) {
            input.record_saved_id += draw(seed, output.entry_id - input.record_saved_id + 1u);
        }
        assert_true(core.game.accounts.ledger.balance.open != PAYMENT_PAID ||
                    core.game.phase == PHASE_READY || core.game.phase == PHASE_ROUND ||
                    core.game.phase == PHASE_LAB || core.game.phase == PHASE_RESULT);
    }
    input.coin_count[0] = 0;
}

static void test_no_button_sequence_stops_the_kiosk_with_any_store(void **state)
{
    (void)state;
    uint32_t seed = 11;
    for (uint32_t boots = 0; boots < 2; boots++) {
        open_paid(boots);
        store_is_late = 1;
        press_random_buttons(&seed, 30000);
        print_message("# start %u: %u rounds begun, %u entries, %u of them on disk\n", boots,
                      core.game.round_count, output.entry_id, input.record_saved_id);
        assert_true(core.game.round_count > 2);
    }
}

static void test_a_store_that_appears_late_is_used_after_any_number_of_coins(void **state)
{
    (void)state;
    open_paid(0);
    drop_each(COINS_FOR_A_FULL_RING);
    assert_int_equal(core.game.accounts.ledger.balance.paid, COINS_FOR_A_FULL_RING);
    /* No store has saved the newest entry, so no credit is committed yet. */
    assert_int_equal(ledger_committed_credits(&core.game.accounts.ledger).paid, 0);
    assert_int_equal(output.coin_lockout, 1);
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_ATTRACT);

    const uint32_t before_id = output.entry_id;
    input.store_well = 1;
    step();
    assert_int_equal(ledger_committed_credits(&core.game.accounts.ledger).paid, 0);
    /* The first entry after the store appeared contains the balance of all coins. This includes the
     * coins that were inserted while the ring buffer was full. */
    assert_true(output.entry_id > before_id);
    assert_int_equal(balance_entry(&output, output.entry_id)->balance.paid, COINS_FOR_A_FULL_RING);
    repair_store();
    assert_int_equal(output.coin_lockout, 0);
    assert_int_equal(ledger_committed_credits(&core.game.accounts.ledger).paid,
                     COINS_FOR_A_FULL_RING);
    drop_each(1);
    step();
    assert_int_equal(core.game.accounts.ledger.balance.unlogged, 0);
    assert_int_equal(ledger_committed_credits(&core.game.accounts.ledger).paid,
                     COINS_FOR_A_FULL_RING + 1u);
    press(INPUT_START);
    assert_int_equal(core.game.phase, PHASE_MODE_SELECT);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_teardown(name, close_stand)
    const struct CMUnitTest tests[] = {
        TEST(test_a_ring_that_fills_during_the_mode_selection_permits_a_retry),
        TEST(test_a_full_store_only_delays_the_game),
        TEST(test_no_button_sequence_stops_the_kiosk_with_any_store),
        TEST(test_a_store_that_appears_late_is_used_after_any_number_of_coins),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
