/* test_refunds.c -- checks when the credit of a round is refunded: after the loss of a controller,
 * from the operator's menu, or after a power cut. A credit may be refunded at most once. A round
 * that is not refunded keeps its score and tickets. */
#include "core/game/accounting/accounts.h"
#include "core/game/phases.h"
#include "tests/unit/support/paid_fixture.h"

#define SPENT_TICKS (2u * ROUND_S * CORE_TICK_HZ / 3u)
/* Number of fish that the player catches. Five fish give one ticket, so 14 fish give two. */
#define FISH 14u
#define TICKETS 2u

/* State of the open round. The test computes it from the ledger entries in the same way as the
 * store. */
static struct ledger_stand stand;
static uint32_t seen_id;

/* Updates `stand` with the new ledger entries, as the store does. */
static void note_entries(void)
{
    while (seen_id != output.entry_id) {
        stand = round_standing_after(stand, balance_entry(&output, ++seen_id));
    }
}

static void noted_steps(uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        step();
        note_entries();
    }
}

/* Simulates a power cut at a moment when all written entries are on the disk. */
static void cut_power(void)
{
    static uint32_t boots = 1;
    note_entries();
    struct core_config config = core.config;
    config.session = (struct game_session){ 0 };
    config.persistent.audits = core.game.accounts.audits;
    config.persistent.ranking = core.game.accounts.ranking;
    config.persistent.ledger = (struct ledger_start){
        .last_id = output.entry_id,
        .boots = ++boots,
        .balance = balance_entry(&output, output.entry_id)->balance,
        .stand = stand,
    };
    assert_int_equal(core_init(&core, &config), CORE_OK);
    const uint32_t last_id = output.entry_id;
    memset(&input, 0, sizeof input);
    memset(&output, 0, sizeof output);
    output.entry_id = input.record_saved_id = last_id;
    hold_at(ABOVE_M);
    noted_steps(3);
}

static int setup_refunds(void **state)
{
    setup_paid(state);
    stand = (struct ledger_stand){ 0 };
    seen_id = 0;
    return 0;
}

/* Starts a round that an available credit pays for, and plays its first `ticks` ticks. */
static void play(uint32_t ticks)
{
    hold_at(ABOVE_M);
    while (core.game.phase != PHASE_ATTRACT) {
        noted_steps(1);
    }
    noted_steps(CORE_TICK_HZ);
    press(INPUT_START);
    noted_steps(GAME_READY_TICKS);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    core.game.player[0].caught = FISH;
    noted_steps(ticks);
}

static void lose_controller(void)
{
    input.poi[0].link = POI_SOURCE_LOST;
    while (core.game.phase == PHASE_ROUND) {
        noted_steps(1);
    }
    noted_steps(20);
}

static void open_menu(void)
{
    press(INPUT_TEST);
    press(INPUT_TEST);
    assert_int_equal(core.game.phase, PHASE_MENU);
    noted_steps(20);
}

static void expect_refunded(void)
{
    assert_int_equal(audit(AUDIT_REFUNDS), 1);
    assert_int_equal(credits(), 1);
    assert_int_equal(audit(AUDIT_ROUNDS), 0);
    assert_int_equal(audit(AUDIT_TICKETS), 0);
    assert_int_equal(balance()->open, PAYMENT_NONE);
}

/* Checks that the round is scored and that its credit is not refunded. This is the case if the
 * round was nearly over, or if the credit was already refunded once. */
static void expect_kept(uint32_t refunds)
{
    assert_int_equal(audit(AUDIT_REFUNDS), refunds);
    assert_int_equal(credits(), 0);
    assert_int_equal(audit(AUDIT_ROUNDS), 1);
    assert_int_equal(audit(AUDIT_CAUGHT), FISH);
    assert_int_equal(audit(AUDIT_TICKETS), TICKETS);
    assert_int_equal(core.game.accounts.ranking.row[MODE_FESTIVAL][RANK_EVER][0].caught, FISH);
    assert_int_equal(balance()->open, PAYMENT_NONE);
}

typedef void (*cut_round)(void);
static const cut_round ways[] = { lose_controller, open_menu, cut_power };
#define WAYS (sizeof ways / sizeof ways[0])

static void test_a_round_cut_before_two_thirds_is_refunded_and_not_scored(void **state)
{
    for (size_t i = 0; i < WAYS; i++) {
        setup_refunds(state);
        drop(PRICE);
        play(SPENT_TICKS - 10u);
        ways[i]();
        expect_refunded();
    }
}

/* The rounds are paid with coins, with a service credit, or free of charge in turn. */
static void test_a_round_cut_after_two_thirds_keeps_score_and_tickets(void **state)
{
    for (size_t i = 0; i < 3u * WAYS; i++) {
        setup_refunds(state);
        if (i / WAYS == 0) {
            drop(PRICE);
        } else if (i / WAYS == 1) {
            press(INPUT_SERVICE);
        } else {
            core.config.credit_coins = 0;
        }
        play(SPENT_TICKS + 10u);
        ways[i % WAYS]();
        expect_kept(0);
    }
}

static void test_a_credit_is_refunded_at_most_once(void **state)
{
    for (size_t i = 0; i < WAYS * WAYS; i++) {
        setup_refunds(state);
        drop(PRICE);
        play(10);
        ways[i / WAYS]();
        expect_refunded();
        if (core.game.phase == PHASE_MENU) {
            cut_power();
        }
        play(10);
        ways[i % WAYS]();
        expect_kept(1);
    }
}

static void test_a_refunded_credit_stays_marked_after_a_restart(void **state)
{
    (void)state;
    drop(PRICE);
    play(10);
    lose_controller();
    cut_power();
    assert_int_equal(balance()->returned, PAYMENT_PAID);
    /* New coins pay for another credit. This credit can be refunded, although the earlier credit
     * has already been refunded once. */
    drop(PRICE);
    assert_int_equal(credits(), 2);
    play(10);
    assert_int_equal(balance()->open, PAYMENT_PAID | PAYMENT_SPENT);
    lose_controller();
    assert_int_equal(audit(AUDIT_REFUNDS), 1);
    assert_int_equal(credits(), 1);
    play(10);
    assert_int_equal(balance()->open, PAYMENT_PAID);
    lose_controller();
    assert_int_equal(audit(AUDIT_REFUNDS), 2);
    assert_int_equal(credits(), 1);
}

static void test_a_service_credit_is_refunded_at_most_once(void **state)
{
    (void)state;
    press(INPUT_SERVICE);
    noted_steps(3);
    play(10);
    lose_controller();
    assert_int_equal(balance()->service, 1);
    assert_int_equal(balance()->returned, PAYMENT_SERVICE);
    play(10);
    lose_controller();
    assert_int_equal(balance()->service, 0);
    assert_int_equal(audit(AUDIT_REFUNDS), 1);
}

/* One credit must not pay for two whole rounds, in whatever second of the round the controller is
 * lost. */
static void test_one_credit_pays_for_less_than_two_rounds(void **state)
{
    for (uint32_t at = 1; at < ROUND_S; at += 3) {
        uint32_t played = 0;
        setup_refunds(state);
        drop(PRICE);
        for (uint32_t times = 0; credits() > 0; times++) {
            assert_true(times < 3u);
            play(at * CORE_TICK_HZ);
            played += at;
            lose_controller();
        }
        assert_true(played < 2u * ROUND_S);
    }
}

static void test_a_power_cut_keeps_the_catch_of_the_last_entry_of_the_round(void **state)
{
    (void)state;
    drop(PRICE);
    play(SPENT_TICKS + 10u);
    core.game.player[0].caught = FISH + 1u;
    core.game.player[1].plays = 1;
    core.game.player[1].caught = 2;
    noted_steps(3);
    cut_power();
    assert_int_equal(audit(AUDIT_CAUGHT), FISH + 3u);
    assert_int_equal(audit(AUDIT_PLAYERS), 2);
    assert_int_equal(audit(AUDIT_CRASHED_ROUNDS), 1);
    assert_int_equal(audit(AUDIT_REFUNDS), 0);
}

static void test_a_recording_of_format_7_refunds_every_credit(void **state)
{
    (void)state;
    core.config.rules = 7;
    drop(PRICE);
    play(ROUND_S * CORE_TICK_HZ - CORE_TICK_HZ);
    lose_controller();
    expect_refunded();
    assert_int_equal(balance()->returned, PAYMENT_NONE);
    assert_int_equal(balance_count(&output, LEDGER_STAND), 0);
}

static void test_a_recording_of_format_8_refunds_no_mostly_played_round(void **state)
{
    (void)state;
    core.config.rules = 8;
    drop(PRICE);
    play(SPENT_TICKS + 10u);
    lose_controller();
    assert_int_equal(audit(AUDIT_REFUNDS), 0);
    assert_int_equal(credits(), 0);
}

/* ---- Repeated losses of a controller -------------------------------------------------------- */

static void lose_for(uint32_t ticks)
{
    input.poi[0].link = POI_SOURCE_LOST;
    noted_steps(ticks);
    hold_at(ABOVE_M);
    noted_steps(CORE_TICK_HZ);
    assert_int_equal(core.game.paused, 0);
}

static void test_repeated_losses_of_a_controller_are_counted(void **state)
{
    (void)state;
    drop(PRICE);
    play(10);
    /* A loss of half a second is too short to count. The loss after it is therefore the first loss
     * of the round, and not a repeated one. */
    lose_for(CORE_TICK_HZ / 2u);
    lose_for(2u * CORE_TICK_HZ);
    assert_int_equal(audit(AUDIT_LOST_AGAIN), 0);
    lose_for(2u * CORE_TICK_HZ);
    assert_int_equal(audit(AUDIT_LOST_AGAIN), 1);
    lose_for(5u * CORE_TICK_HZ);
    assert_int_equal(audit(AUDIT_LOST_AGAIN), 2);
    assert_int_equal(audit(AUDIT_LOST_AGAIN + 1), 0);
}

static void test_losses_far_apart_do_not_count_as_repeated(void **state)
{
    (void)state;
    drop(PRICE);
    play(10);
    lose_for(2u * CORE_TICK_HZ);
    core.game.health_log.loss_tick[0] = core.game.tick - HEALTH_LOG_LOSS_AGAIN_TICKS;
    lose_for(2u * CORE_TICK_HZ);
    assert_int_equal(audit(AUDIT_LOST_AGAIN), 0);
}

int main(void)
{
#define TEST(test) cmocka_unit_test_setup(test, setup_refunds)
    const struct CMUnitTest tests[] = {
        TEST(test_a_round_cut_before_two_thirds_is_refunded_and_not_scored),
        TEST(test_a_round_cut_after_two_thirds_keeps_score_and_tickets),
        TEST(test_a_credit_is_refunded_at_most_once),
        TEST(test_a_refunded_credit_stays_marked_after_a_restart),
        TEST(test_a_service_credit_is_refunded_at_most_once),
        TEST(test_one_credit_pays_for_less_than_two_rounds),
        TEST(test_a_power_cut_keeps_the_catch_of_the_last_entry_of_the_round),
        TEST(test_a_recording_of_format_7_refunds_every_credit),
        TEST(test_a_recording_of_format_8_refunds_no_mostly_played_round),
        TEST(test_repeated_losses_of_a_controller_are_counted),
        TEST(test_losses_far_apart_do_not_count_as_repeated),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
