/* test_core_status.c -- checks that the status, the audits and the record of a round agree with the
 * state of the core and with its output. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/core.h"
#include "core/game/bot/vision.h"
#include "core/pin.h"

static struct core core;
static struct input input;
static struct output output;

static void open_with(const struct core_config *config)
{
    assert_int_equal(core_init(&core, config), CORE_OK);
    input = (struct input){ .store_well = 1 };
    output = (struct output){ 0 };
}

static void ticks(uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        output.sound_count = 0;
        assert_int_equal(core_tick(&core, &input, &output), CORE_OK);
        input.pressed = 0;
        memset(input.coin_count, 0, sizeof input.coin_count);
        if (output.entry_id > 0) {
            input.record_saved_id = output.entry_id;
        }
    }
}

static void test_status_of_a_fresh_kiosk_comes_from_its_configuration(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 3,
                                        .fish_count = 12,
                                        .persistent.ledger = { .boots = 2, .last_id = 40 } };
    open_with(&config);
    const struct core_status status = core_status(&core);
    assert_int_equal(status.tick, 0);
    assert_int_equal(status.entry_id, 40);
    assert_int_equal(status.fish_count, 12);
    assert_int_equal(status.phase, PHASE_ATTRACT);
    assert_int_equal(status.round_count, 0);
}

static void test_a_coin_shows_in_balance_audits_and_newest_entry(void **state)
{
    (void)state;
    struct core_config config = { .seed = 3,
                                  .fish_count = 12,
                                  .persistent.ledger = { .boots = 2, .last_id = 40 } };
    settings_reset(&config.persistent.settings);
    config.credit_coins = 3;
    open_with(&config);
    input.poi[0].link = POI_SOURCE_LIVE;
    input.poi[0].target.position_m = v3(0.05f, 0.06f, 0.02f);
    input.day = 9000;
    input.minute = 610;
    ticks(10);
    input.coin_count[0] = 2;
    ticks(1);
    const struct core_status status = core_status(&core);
    assert_int_equal(status.tick, 11);
    assert_int_equal(status.tick, output.tick);
    assert_true(status.entry_id > 40);
    assert_int_equal(status.entry_id, output.entry_id);
    assert_int_equal(status.balance.units, 2);
    assert_int_equal(status.day, 9000);
    assert_int_equal(status.minute, 610);
    assert_int_equal(core_audits(&core)->count[AUDIT_COINS_1], 2);
}

static void test_a_round_shows_its_phase_its_length_and_its_players(void **state)
{
    (void)state;
    const struct core_config config = { .seed = 3, .fish_count = 12, .round_s = 20 };
    open_with(&config);
    input.poi[0].link = POI_SOURCE_LIVE;
    input.poi[0].target.position_m = v3(0.05f, 0.06f, 0.02f);
    ticks(2);
    input.pressed = INPUT_START;
    ticks(GAME_READY_TICKS + 2u);
    const struct core_status status = core_status(&core);
    assert_int_equal(status.phase, PHASE_ROUND);
    assert_int_equal(status.phase, output.phase);
    assert_int_equal(status.mode, MODE_FESTIVAL);
    assert_int_equal(status.round_count, 1);
    assert_int_equal(status.round_s, 20);
    assert_int_equal(status.player[0].plays, 1);
    assert_int_equal(status.player[1].plays, 0);
    assert_true(v3_length(status.player[0].target_pose.position_m) > 0.0f);
    const struct round_record record = core_round_record(&core);
    assert_int_equal(record.players, 1);
    assert_int_equal(record.round_s, 20);
    assert_int_equal(record.start_tick, output.round_tick);
    const struct vision vision = core_vision(&core, 0);
    assert_int_equal(vision_game(&vision).phase, PHASE_ROUND);
    assert_int_equal(vision_game(&vision).fish_count, status.fish_count);
}

/* If a PIN is set, the menu opens on a page where SERVICE selects a digit and TEST enters the
 * digit. */
static void test_a_page_for_a_pin_shows_until_the_pin_is_complete(void **state)
{
    (void)state;
    struct core_config config = { .seed = 3, .fish_count = 12 };
    settings_reset(&config.persistent.settings);
    config.persistent.settings.value[SET_PIN] = pin_hide(1111, 5);
    open_with(&config);
    assert_false(core_status(&core).takes_pin);
    input.pressed = INPUT_TEST;
    ticks(1);
    assert_int_equal(core_status(&core).phase, PHASE_MENU);
    assert_true(core_status(&core).takes_pin);
    for (uint32_t digit = 0; digit < 4; digit++) {
        ticks(CORE_TICK_HZ / 2u);
        input.pressed = INPUT_TEST;
        ticks(1);
        assert_int_equal(core_status(&core).takes_pin, digit < 3);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_status_of_a_fresh_kiosk_comes_from_its_configuration),
        cmocka_unit_test(test_a_coin_shows_in_balance_audits_and_newest_entry),
        cmocka_unit_test(test_a_round_shows_its_phase_its_length_and_its_players),
        cmocka_unit_test(test_a_page_for_a_pin_shows_until_the_pin_is_complete),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
