/* test_late_store.c -- Tests a kiosk that starts without its store while players insert coins.
 *
 * The store is a database on a memory card, which is removed before the start. When the card is
 * available again, each coin must be stored exactly once, without an action of the operator. The
 * kiosk and the store are real. The devices and the time are simulated. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cmocka.h>
#include <sqlite3.h>

#include "drivers/null.h"
#include "core/game/accounting/accounts.h"
#include "drivers/sim/hal_sim.h"
#include "platform/kiosk/kiosk.h"
#include "platform/store/storage.h"

#define FRAME_NS 16666667ull
#define PRICE 2u

static char dir[64], file[96], away[96];

static struct rig {
    struct clock_sim clock;
    struct storage storage;
    struct hal hal;
    struct kiosk kiosk;
    struct button_sample buttons; /* Button sample of the next frame. */
    uint32_t locked;              /* Last level of the coin lockout: 1 if the coin slot is
                                     locked. */
} rig;

static int poll_buttons(void *self, struct button_sample *out)
{
    (void)self;
    *out = rig.buttons;
    rig.buttons = (struct button_sample){ 0 };
    return HAL_OK;
}

static const char *describe(void *self)
{
    (void)self;
    return "a slot";
}

/* Reports a valid pose, because the coin slot opens only if a controller works. */
static int poll_pose(void *self, struct poi_sample *out, uint32_t max)
{
    (void)self;
    (void)max;
    *out = (struct poi_sample){ .time_ns = rig.clock.now_ns,
                                .has_wrist = 1,
                                .target.position_m = { 0.0f, 0.1f, 0.0f } };
    return 1;
}

static int open_hand(void *self)
{
    (void)self;
    return HAL_OK;
}

static int feel(void *self, const struct poi_force *force)
{
    (void)self;
    (void)force;
    return HAL_OK;
}

static void look(void *self, const struct view *view,
                 const struct display_settings *display_settings, bool scoops)
{
    (void)self;
    (void)view;
    (void)display_settings;
    (void)scoops;
}

static int set_switch(void *self, enum hal_switch which, bool active)
{
    (void)self;
    rig.locked = which == HAL_COIN_LOCKOUT ? (uint32_t)active : rig.locked;
    return HAL_OK;
}

static int pulse_switch(void *self, enum hal_switch which, uint32_t count)
{
    (void)self;
    (void)which;
    (void)count;
    return HAL_OK;
}

/* Reports that all tickets have been dispensed. */
static uint32_t pending(void *self, enum hal_switch which)
{
    (void)self;
    (void)which;
    return 0;
}

/* Starts the kiosk with the state that the store contains, as after a reboot. */
static void begin(void)
{
    static const struct hal_buttons_ops buttons = { poll_buttons, describe };
    static const struct hal_switches_ops switches = { set_switch, pulse_switch, describe, pending };
    static const struct hal_poi_ops hand = { .open = open_hand,
                                             .poll = poll_pose,
                                             .set_force = feel,
                                             .set_view = look,
                                             .describe = describe };
    static struct kiosk_config config;
    config = (struct kiosk_config){
        .core = { .seed = 5, .fish_count = 4, .round_s = 10, .credit_coins = PRICE }
    };
    memset(&rig, 0, sizeof rig);
    rig.locked = 1; /* The coin slot is locked until the kiosk opens it. */
    rig.clock.now_ns = FRAME_NS;
    rig.storage = (struct storage){ .dir = dir, .without_thread = true };
    rig.hal = null_hal(NULL);
    rig.hal.clock = sim_clock_device(&rig.clock);
    rig.hal.storage = storage_device(&rig.storage);
    rig.hal.buttons = (struct hal_buttons){ .ops = &buttons };
    rig.hal.switches = (struct hal_switches){ .ops = &switches };
    rig.hal.poi[0] = (struct hal_poi){ .ops = &hand };
    rig.hal.storage.ledger.ops->open(rig.hal.storage.ledger.self);
    rig.hal.storage.ledger.ops->load(rig.hal.storage.ledger.self, &config.core.persistent);
    config.core.credit_coins = PRICE;
    assert_int_equal(kiosk_init(&rig.kiosk, &rig.hal, &config), CORE_OK);
}

static enum kiosk_end frames(uint32_t count)
{
    enum kiosk_end end = KIOSK_RUNS;
    for (uint32_t i = 0; i < count && end == KIOSK_RUNS; i++) {
        rig.clock.now_ns += FRAME_NS;
        end = kiosk_frame(&rig.kiosk, &rig.hal);
        storage_work(&rig.storage);
    }
    return end;
}

static void drop_coins(uint32_t line, uint32_t count)
{
    rig.buttons.coin_count[line] = count;
    assert_int_equal(frames(2), KIOSK_RUNS);
}

static void end(void)
{
    assert_int_equal(kiosk_close_store(&rig.kiosk, &rig.hal), 0);
}

static uint32_t audit(enum audit_id id)
{
    return rig.kiosk.core.game.accounts.audits.count[id];
}

static const struct balance *balance(void)
{
    return &rig.kiosk.core.game.accounts.ledger.balance;
}

/* Inserts one coin, which is half a credit, and ends the kiosk. Replaces the data folder by an
 * empty folder, as if the memory card was removed. */
static int set_up(void **state)
{
    (void)state;
    strcpy(dir, "/tmp/kingyo-late-XXXXXX");
    if (!mkdtemp(dir)) {
        return -1;
    }
    snprintf(file, sizeof file, "%s/" STORAGE_FILE, dir);
    snprintf(away, sizeof away, "%s-away", dir);
    begin();
    drop_coins(0, 1);
    frames(5);
    assert_int_equal(audit(AUDIT_COINS_1), 1);
    end();
    if (rename(dir, away) != 0 || mkdir(dir, 0755) != 0) {
        return -1;
    }
    /* Creates a link to a file that does not exist, so that the database cannot be opened. */
    return symlink("/tmp/kingyo-no-such-card/kingyo.db", file);
}

static void put_card_back(void)
{
    assert_int_equal(unlink(file), 0);
    assert_int_equal(rmdir(dir), 0);
    assert_int_equal(rename(away, dir), 0);
}

static int tear_down(void **state)
{
    (void)state;
    char command[192];
    rig.hal.storage.ledger.ops->close(rig.hal.storage.ledger.self);
    snprintf(command, sizeof command, "rm -rf %s %s", dir, away);
    return system(command);
}

static void test_a_coin_inserted_without_a_store_is_recorded_later_and_the_slot_opens(void **state)
{
    (void)state;
    begin();
    assert_int_equal(frames(10), KIOSK_RUNS);
    assert_int_equal(rig.locked, 1);
    drop_coins(0, 1);
    assert_int_equal(frames(60), KIOSK_RUNS);
    assert_int_equal(balance()->units, 1);
    put_card_back();
    assert_int_equal(frames(200), KIOSK_RESTART);
    end();
    begin();
    assert_int_equal(frames(60), KIOSK_RUNS);
    assert_int_equal(audit(AUDIT_COINS_1), 2);
    assert_int_equal(audit(AUDIT_UNITS), 2);
    assert_int_equal(audit(AUDIT_BOOTS), 2); /* The kiosk was started three times, and only the two
                                                starts with a store are counted. */
    /* The coin from before the removal of the card and the coin from the time without the card are
     * together one credit. */
    assert_int_equal(balance()->paid, 1);
    assert_int_equal(ledger_committed_credits(&rig.kiosk.core.game.accounts.ledger).paid, 1);
    assert_int_equal(rig.locked, 0);
}

static void test_offline_credits_and_entries_are_merged_exactly_once(void **state)
{
    (void)state;
    begin();
    frames(10);
    drop_coins(0, 2 * PRICE);
    drop_coins(1, 3);
    rig.buttons.pressed = INPUT_SERVICE;
    frames(2);
    const uint32_t units = audit(AUDIT_UNITS), paid = balance()->paid;
    assert_int_equal(balance()->service, 1);
    put_card_back();
    assert_int_equal(frames(200), KIOSK_RESTART);
    end();
    for (uint32_t start = 0; start < 2u; start++) {
        begin();
        frames(60);
        assert_int_equal(audit(AUDIT_COINS_1), 1 + 2 * PRICE);
        assert_int_equal(audit(AUDIT_COINS_2), 3);
        assert_int_equal(audit(AUDIT_UNITS), 1 + units);
        assert_int_equal(audit(AUDIT_CREDITS_SERVICE), 1);
        assert_int_equal(balance()->service, 1);
        assert_int_equal(PRICE * balance()->paid + balance()->units, 1 + units);
        assert_true(balance()->paid >= paid);
        end();
    }
}

/* The memory card is back, but another program locks the database. The kiosk must keep the coins
 * until it can write them. */
static void test_offline_credits_are_kept_until_the_card_is_writable(void **state)
{
    (void)state;
    sqlite3 *other;
    begin();
    drop_coins(0, 1);
    put_card_back();
    assert_int_equal(sqlite3_open(file, &other), SQLITE_OK);
    assert_int_equal(sqlite3_exec(other, "BEGIN IMMEDIATE", NULL, NULL, NULL), SQLITE_OK);
    assert_int_equal(frames(3), KIOSK_RUNS);
    assert_int_equal(rig.hal.storage.ledger.ops->offline_merged(rig.hal.storage.ledger.self),
                     HAL_ERR_BUSY);
    drop_coins(0, 1); /* The second coin is inserted while the first one cannot be written yet. */
    assert_int_equal(sqlite3_exec(other, "ROLLBACK", NULL, NULL, NULL), SQLITE_OK);
    sqlite3_close(other);
    enum kiosk_end how = KIOSK_RUNS;
    for (uint32_t i = 0; i < 300u && how == KIOSK_RUNS; i++) {
        rig.storage.retry_due_ms = 0; /* Makes the next retry of the store due at once. */
        how = frames(1);
    }
    assert_int_equal(how, KIOSK_RESTART);
    end();
    begin();
    frames(60);
    assert_int_equal(audit(AUDIT_COINS_1), 3);
    /* set_up() inserted one coin, and this test inserted two. */
    assert_int_equal(PRICE * balance()->paid + balance()->units, 3);
}

/* Makes an empty data folder, as on a new memory card. */
static void put_new_card(void)
{
    assert_int_equal(unlink(file), 0);
}

static void test_coins_from_before_a_new_card_enter_the_audits_of_the_new_card(void **state)
{
    (void)state;
    begin();
    frames(10);
    drop_coins(0, PRICE);
    drop_coins(1, 1);
    frames(60);
    put_new_card();
    assert_int_equal(frames(200), KIOSK_RESTART);
    end();
    for (uint32_t start = 0; start < 2u; start++) {
        begin();
        frames(60);
        assert_int_equal(rig.locked, 0);
        assert_int_equal(audit(AUDIT_COINS_1), PRICE);
        assert_int_equal(audit(AUDIT_COINS_2), 1);
        assert_int_equal(audit(AUDIT_UNITS), PRICE * balance()->paid + balance()->units);
        assert_int_equal(audit(AUDIT_CREDITS_PAID), balance()->paid);
        end();
    }
}

static void test_coins_that_no_store_accepted_are_reported_at_the_end(void **state)
{
    (void)state;
    begin();
    frames(60);
    /* Without coins, a kiosk without a store loses no takings. */
    assert_int_equal(kiosk_close_store(&rig.kiosk, &rig.hal), 0);
    begin();
    frames(10);
    drop_coins(0, PRICE);
    drop_coins(1, 1);
    frames(60);
    /* One entry for each of the two coin lines, and one for the credits. */
    assert_int_equal(kiosk_close_store(&rig.kiosk, &rig.hal), 3);
}

/* The kiosk ends after the memory card is back, but before the kiosk is idle or the store has
 * written the coins. */
static void test_coins_are_transferred_when_the_kiosk_ends_before_it_restarts(void **state)
{
    (void)state;
    begin();
    frames(10);
    drop_coins(0, 1);
    put_card_back();
    end();
    begin();
    frames(60);
    assert_int_equal(audit(AUDIT_COINS_1), 2);
    assert_int_equal(balance()->paid, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(
            test_a_coin_inserted_without_a_store_is_recorded_later_and_the_slot_opens, set_up,
            tear_down),
        cmocka_unit_test_setup_teardown(test_offline_credits_and_entries_are_merged_exactly_once,
                                        set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_offline_credits_are_kept_until_the_card_is_writable,
                                        set_up, tear_down),
        cmocka_unit_test_setup_teardown(
            test_coins_from_before_a_new_card_enter_the_audits_of_the_new_card, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_coins_that_no_store_accepted_are_reported_at_the_end,
                                        set_up, tear_down),
        cmocka_unit_test_setup_teardown(
            test_coins_are_transferred_when_the_kiosk_ends_before_it_restarts, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
