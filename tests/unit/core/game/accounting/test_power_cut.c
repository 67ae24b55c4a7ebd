/* test_power_cut.c -- checks that a power cut at any time neither loses nor repeats a ledger entry
 * that the store had reported as saved. The test computes the expected balance from the inserted
 * coins and from the entries on a simulated disk. */
#include "core/game/accounting/accounts.h"
#include "core/game/phases.h"
#include "tests/unit/support/game_fixture.h"

#define PRICE 3u
#define LOG_MAX 60000u
#define CUTS 400u

/* Ledger entries so far. The index is the id. If a power cut loses an entry, a new entry with the
 * same id replaces it. */
static struct ledger_entry journal[LOG_MAX];
static struct disk {
    /* Id of the last ledger entry that is on the disk. */
    uint32_t id;
    uint32_t reported; /* Id of the newest entry that was reported to the kiosk as saved. */
    uint32_t ill;      /* Ticks until the store works again; 0 if the store works. */
    uint32_t boots;
} disk;
/* Value of all coins inserted since the last start of the kiosk, in coin units. */
static uint32_t fallen;
static uint32_t drawn;

static uint32_t draw(uint32_t count)
{
    return (uint32_t)((hash_u32(HASH_START, ++drawn) >> 20) % count);
}

/* Sums over the entries up to an id. They are computed from the single entries, so that they are
 * independent of the stored balances. */
struct sum {
    uint32_t units, credits, spent, back, service;
    uint32_t open; /* Number of rounds that have begun and not ended. */
};

/* Returns the number of open rounds after an entry of the kind `kind`. Checks that at most one
 * round is open. */
static uint32_t open_after(uint32_t open, uint8_t kind)
{
    const int ends = kind == LEDGER_ROUND || kind == LEDGER_REFUND || kind == LEDGER_LEFT;
    assert_true(kind != LEDGER_BEGIN || !open);
    assert_true(!ends || open);
    return kind == LEDGER_BEGIN || (open && !ends);
}

static struct sum sum_to(uint32_t id)
{
    struct sum sum = { 0 };
    for (uint32_t i = 1; i <= id; i++) {
        const struct ledger_entry *entry = &journal[i];
        sum.units +=
            entry->kind == LEDGER_COINS || entry->kind == LEDGER_BOOT ? (uint32_t)entry->value : 0u;
        sum.credits += entry->kind == LEDGER_CREDITS ? entry->count : 0u;
        sum.service += entry->kind == LEDGER_SERVICE;
        sum.spent += entry->kind == LEDGER_BEGIN;
        sum.back += entry->kind == LEDGER_REFUND ? entry->count : 0u;
        sum.open = open_after(sum.open, entry->kind);
    }
    return sum;
}

static void expect_balance(uint32_t id, const struct balance *balance)
{
    const struct sum sum = sum_to(id);
    assert_int_equal(sum.units, balance->units + PRICE * sum.credits);
    assert_int_equal(sum.credits + sum.service + sum.back,
                     balance->paid + balance->service + sum.spent);
    assert_int_equal(sum.open, balance->open != PAYMENT_NONE);
    /* No more credits may be refunded than were bought or given by SERVICE. */
    assert_true(sum.back <= sum.credits + sum.service);
}

static void start(void)
{
    struct core_config config = {
        .seed = 7, .fish_count = 4, .round_s = 10, .credit_coins = PRICE
    };
    config.persistent.ledger = (struct ledger_start){ .last_id = disk.id, .boots = ++disk.boots };
    if (disk.id > 0) {
        config.persistent.ledger.balance = journal[disk.id].balance;
        for (uint32_t id = 1; id <= disk.id; id++) {
            struct ledger_stand *stand = &config.persistent.ledger.stand;
            *stand = round_standing_after(*stand, &journal[id]);
        }
    }
    assert_int_equal(core_init(&core, &config), CORE_OK);
    memset(&input, 0, sizeof input);
    memset(&output, 0, sizeof output);
    output.entry_id = disk.id;
    disk.reported = disk.id;
    disk.ill = 0;
    fallen = 0;
    hold_at(ABOVE_M);
}

/* Copies the new entries of a tick. Checks that a round begins only with a credit whose entry was
 * already reported as saved. */
static void take_entries(uint32_t before)
{
    for (uint32_t id = before + 1u; id <= output.entry_id; id++) {
        assert_true(id < LOG_MAX);
        journal[id] = output.entries[id % LEDGER_RING];
        assert_int_equal(journal[id].id, id);
        if (journal[id].kind == LEDGER_BEGIN) {
            const struct sum safe = sum_to(disk.reported);
            assert_true(safe.credits + safe.service + safe.back >= sum_to(id).spent);
        }
    }
}

static void serve_disk(void)
{
    disk.ill = disk.ill > 0 ? disk.ill - 1u : draw(900) == 0 ? draw(900) : 0u;
    if (disk.ill == 0 && draw(12) == 0 && disk.id < output.entry_id) {
        disk.id += 1u + draw(output.entry_id - disk.id);
    }
    /* The store reports the saved entries late: only in one of four ticks on average. */
    if (draw(4) == 0) {
        disk.reported = disk.id;
    }
    input.record_saved_id = disk.reported;
    input.store_well = disk.ill == 0;
}

static void live(void)
{
    const uint32_t before = output.entry_id;
    serve_disk();
    const uint32_t lines = draw(40) == 0;
    input.coin_count[0] = lines * draw(4);
    input.coin_count[2] = lines * (draw(3) == 0);
    /* By default, a coin of input 0 is worth one unit, and a coin of input 2 is worth five
     * units. */
    fallen += input.coin_count[0] + 5u * input.coin_count[2];
    input.pressed = (draw(60) == 0 ? INPUT_START : 0u) | (draw(500) == 0 ? INPUT_SERVICE : 0u);
    input.poi[0].link = draw(300) == 0 ? POI_SOURCE_LOST : POI_SOURCE_LIVE;
    step();
    take_entries(before);
}

/* Checks that all coin units inserted since the last start are either in a ledger entry or still
 * wait for an entry. */
static void expect_no_coin_lost(uint32_t began)
{
    uint32_t reported = 0, waits = 0;
    for (uint32_t id = began + 1u; id <= output.entry_id; id++) {
        reported += journal[id].kind == LEDGER_COINS ? (uint32_t)journal[id].value : 0u;
    }
    for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
        waits += core.game.accounts.credit.pending_coins[line].owed;
    }
    assert_int_equal(reported + waits, fallen);
    assert_int_equal(core.game.accounts.ledger.balance.unlogged, waits);
    expect_balance(output.entry_id, &core.game.accounts.ledger.balance);
}

static void test_a_power_cut_at_any_tick_neither_loses_nor_repeats_stored_entries(void **state)
{
    (void)state;
    uint32_t open = 0, behind = 0, untold = 0, begun = 0;
    store_is_late = 1;
    memset(&disk, 0, sizeof disk);
    for (uint32_t cut = 0; cut < CUTS; cut++) {
        const uint32_t began = disk.id;
        start();
        for (uint32_t ticks = 1u + draw(3000); ticks > 0; ticks--) {
            live();
        }
        expect_no_coin_lost(began);
        untold += core.game.accounts.ledger.balance.unlogged > 0;
        begun += core.game.accounts.ledger.balance.open != PAYMENT_NONE;
        behind += disk.id < output.entry_id;
        assert_true(disk.id >= disk.reported);
        /* The kiosk starts again with the last entry on the disk. Later entries are lost, but none
         * of these had been reported as saved (`disk.reported`). */
        if (disk.id > 0) {
            const struct balance left = journal[disk.id].balance;
            expect_balance(disk.id, &left);
            open += left.open != PAYMENT_NONE;
            start();
            disk.boots--;
            step();
            const struct balance *now = &core.game.accounts.ledger.balance;
            assert_int_equal(now->open, PAYMENT_NONE);
            const uint32_t back = left.open != PAYMENT_NONE && !(left.open & PAYMENT_SPENT);
            assert_int_equal(PRICE * (now->paid + now->service) + now->units,
                             PRICE * (left.paid + left.service + back) + left.units +
                                 left.unlogged);
        }
    }
    store_is_late = 0;
    print_message(
        "# %u power cuts: %u with a round open on disk, %u with entries under way, %u with "
        "coins untold, %u in a round\n",
        CUTS, open, behind, untold, begun);
    assert_true(open > CUTS / 20u && behind > CUTS / 20u && untold > 0 && begun > CUTS / 40u);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_power_cut_at_any_tick_neither_loses_nor_repeats_stored_entries),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
