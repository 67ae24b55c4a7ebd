/* test_replay_formats.c -- Tests that recordings of older formats replay with their original
 * results, and only under the rules of their format.
 *
 * Older versions of Kingyo wrote these recordings. tests/replay/format-7.replay starts with a paid
 * round that a power cut has interrupted. A player wins tickets, and the next round is refunded
 * because the controller is lost. tests/replay/format-8.replay starts without a store and with
 * tickets that are still due. A visitor chooses a language, pays and wins a ticket. The next round
 * is refunded because the controller is lost. tests/replay/format-9.replay visits the operator's
 * menu: LEFT and RIGHT move the highlight, and a poi changes values. Then a poi appears over a tag
 * of the mode selection and dips in the left half of the tank. tests/replay/format-10.replay and
 * tests/replay/format-11.replay visit the pages of the sound and of the picture in the operator's
 * menu. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "platform/kiosk/recorder/replayer.h"

#define FORMAT_7 "tests/replay/format-7.replay"
#define FORMAT_8 "tests/replay/format-8.replay"
#define FORMAT_9 "tests/replay/format-9.replay"
#define FORMAT_10 "tests/replay/format-10.replay"
#define FORMAT_11 "tests/replay/format-11.replay"

static struct replayer replayer;
static struct core core;
static struct input input;
static struct output output;

static void begin(const char *path)
{
    struct core_config config;
    memset(&output, 0, sizeof output);
    assert_int_equal(replayer_begin(&replayer, path, &config), 0);
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

/* Replays a recording of the format `version` to its end, under the rules of its format. All its
 * hashes must be reproduced, in `ticks` ticks. */
static void check_hashes(const char *path, uint32_t version, uint32_t ticks)
{
    begin(path);
    assert_int_equal(replayer.reader.header.version, version);
    play();
    assert_false(replayer.damaged);
    assert_false(replayer.difference.found);
    assert_int_equal(replayer.totals.ticks, ticks);
}

static void test_a_format_7_recording_reproduces_its_hashes(void **state)
{
    (void)state;
    check_hashes(FORMAT_7, 7, 17455);
    assert_int_equal(replayer.totals.rounds, 2);
    assert_int_equal(output.tickets, 2);
    assert_int_equal(core.game.accounts.audits.count[AUDIT_REFUNDS], 2);
}

static void test_a_format_8_recording_reproduces_its_hashes(void **state)
{
    (void)state;
    check_hashes(FORMAT_8, 8, 13843);
    assert_int_equal(replayer.totals.rounds, 2);
    assert_int_equal(core.game.accounts.audits.count[AUDIT_REFUNDS], 1);
}

static void test_a_format_9_recording_reproduces_its_hashes(void **state)
{
    (void)state;
    check_hashes(FORMAT_9, 9, 4073);
    assert_int_equal(core.config.persistent.settings.value[SET_ROUND_S], 150);
    assert_int_equal(core.config.persistent.settings.value[SET_LEVEL], LEVEL_CHOICE_EASY);
}

static void test_a_format_10_recording_reproduces_its_hashes(void **state)
{
    (void)state;
    check_hashes(FORMAT_10, 10, 1388);
    assert_int_equal(core.config.persistent.settings.value[SET_VOLUME], 90);
    assert_int_equal(core.config.persistent.settings.value[SET_ATTRACT_SOUND], 0);
    assert_int_equal(core.config.persistent.settings.value[SET_TEXT], 1);
}

static void test_a_format_11_recording_reproduces_its_hashes(void **state)
{
    (void)state;
    check_hashes(FORMAT_11, 11, 1344);
    assert_int_equal(core.config.persistent.settings.value[SET_MUSIC], 1);
    assert_int_equal(core.config.persistent.settings.value[SET_QUIET_FROM_MIN], 15);
    assert_int_equal(core.config.persistent.settings.value[SET_TIME], 1);
}

/* A recording that is replayed under the rules of another format must show a difference. */
static void test_an_older_recording_differs_under_the_rules_of_another_format(void **state)
{
    (void)state;
    static const struct {
        const char *path;
        uint8_t rules;
    } wrong[] = { { FORMAT_7, 0 }, { FORMAT_7, 8 },  { FORMAT_8, 0 }, { FORMAT_8, 7 },
                  { FORMAT_9, 0 }, { FORMAT_10, 0 }, { FORMAT_11, 0 } };
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        begin(wrong[i].path);
        core.config.rules = wrong[i].rules;
        play();
        assert_false(replayer.damaged);
        assert_true(replayer.difference.found);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_format_7_recording_reproduces_its_hashes),
        cmocka_unit_test(test_a_format_8_recording_reproduces_its_hashes),
        cmocka_unit_test(test_a_format_9_recording_reproduces_its_hashes),
        cmocka_unit_test(test_a_format_10_recording_reproduces_its_hashes),
        cmocka_unit_test(test_a_format_11_recording_reproduces_its_hashes),
        cmocka_unit_test(test_an_older_recording_differs_under_the_rules_of_another_format),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
