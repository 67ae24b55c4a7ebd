/* paid_fixture.h -- extends game_fixture.h by a price of three coins for a round. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_PAID_FIXTURE_H
#define KINGYO_TESTS_UNIT_SUPPORT_PAID_FIXTURE_H

#include "tests/unit/support/game_fixture.h"

#define PRICE 3u
/* Default of the setting SET_CREDIT_MAX, which is the largest number of credits. */
#define CREDITS_MAX 99u

/* Initializes the core with a price of PRICE coins; a cmocka setup function. */
static inline int setup_paid(void **state)
{
    (void)state;
    const struct core_config config = {
        .seed = 7, .fish_count = 12, .round_s = ROUND_S, .credit_coins = PRICE, .ticket_fish = 5
    };
    assert_int_equal(core_init(&core, &config), CORE_OK);
    memset(&input, 0, sizeof input);
    memset(&output, 0, sizeof output);
    clear_sounds();
    hold_at(ABOVE_M);
    input.store_well = 1;
    step();
    return 0;
}

/* Inserts `coins` coins within one tick. */
static inline void drop(uint32_t coins)
{
    input.coin_count[0] = coins;
    step();
    input.coin_count[0] = 0;
}

/* Returns the balance of coins and credits. */
static inline const struct balance *balance(void)
{
    return &core.game.accounts.ledger.balance;
}

/* Returns the number of paid and service credits. */
static inline uint32_t credits(void)
{
    return balance_credits(&core);
}

/* Returns the value of the audit counter `id`. */
static inline uint32_t audit(enum audit_id id)
{
    return balance_audit(&core, id);
}

/* Inserts the price of one round, presses START, and runs ticks until the round has begun. */
static inline void play_a_paid_round(void)
{
    drop(PRICE);
    press(INPUT_START);
    steps(GAME_READY_TICKS);
    assert_int_equal(core.game.phase, PHASE_ROUND);
    assert_int_equal(credits(), 0);
}

#endif
