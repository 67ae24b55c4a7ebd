/* test_replay_format_7.c -- Tests that a recording of the previous version replays with its
 * original results.
 *
 * tests/replay/format-7.replay was written by version 7. It starts after a power cut with an open
 * paid round and with units that no entry reported. A player then wins tickets in one round and
 * loses the controller a second before the end of the next, which refunds the credit. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "platform/kiosk/recorder/replayer.h"

#define OLD_FILE "tests/replay/format-7.replay"

static struct replayer replayer;
static struct core core;
static struct input input;
static struct output output;

static void begin(void)
{
    struct core_config config;
    memset(&output, 0, sizeof output);
    assert_int_equal(replayer_begin(&replayer, OLD_FILE, &config), 0);
    assert_int_equal(core_init(&core, &config), CORE_OK);
}

static void play(void)
{
    const struct kiosk_source source = replayer_source(&replayer);
    const struct kiosk_tap tap = replayer_tap(&replayer);
    while (!replayer.difference.found && source.next(source.self, &input)) {
        output.sound_count = 0;
        core_tick(&core, &input, &output);
        tap.tick(tap.self, &input, &core);
    }
    replayer_end(&replayer);
}

static void test_a_format_7_recording_reproduces_its_hashes(void **state)
{
    (void)state;
    begin();
    assert_int_equal(replayer.reader.header.version, 7);
    play();
    assert_false(replayer.damaged);
    assert_false(replayer.difference.found);
    assert_int_equal(replayer.totals.ticks, 17455);
    assert_int_equal(replayer.totals.rounds, 2);
    assert_int_equal(output.tickets, 2);
    assert_int_equal(core.game.accounts.audits.count[AUDIT_REFUNDS], 2);
}

/* The hashes depend on the rules, so that no other rules reproduce the recording. */
static void test_a_format_7_recording_differs_under_the_current_rules(void **state)
{
    (void)state;
    begin();
    core.config.rules_7 = 0;
    play();
    assert_false(replayer.damaged);
    assert_true(replayer.difference.found);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_format_7_recording_reproduces_its_hashes),
        cmocka_unit_test(test_a_format_7_recording_differs_under_the_current_rules),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
