/* test_kiosk_store.c -- Tests that the frame loop stores each round exactly once. Also tests that a
 * fault of the store or of the sound card does not stop the game. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "platform/kiosk/kiosk.h"
#include "tests/unit/support/kiosk_fixture.h"

static void play_another_round(void)
{
    rig.kiosk.input.pressed = INPUT_START;
    for (uint32_t i = 0; i < 2400 && newest_record(&rig.kiosk.output)->id == ENTRIES; i++) {
        frames(1);
        rig.kiosk.input.pressed |= i % 60 == 0 ? INPUT_START : 0;
    }
    assert_int_equal(newest_record(&rig.kiosk.output)->id, 2u * ENTRIES);
}

static void test_a_round_plays_its_sounds_and_is_stored_once(void **state)
{
    (void)state;
    play_a_round();
    frames(120);
    assert_int_equal(rig.storage.accepted_count, ENTRIES);
    assert_int_equal(rig.storage.record.id, ENTRIES);
    assert_int_equal(rig.kiosk.input.record_saved_id, ENTRIES);
    assert_true(rig.audio.played[SOUND_START] >= 1);
    assert_int_equal(rig.audio.played[SOUND_RESULT], 1);
}

static void test_a_busy_store_is_retried_each_frame(void **state)
{
    (void)state;
    rig.storage.busy_left = 30;
    play_a_round();
    frames(40);
    assert_int_equal(rig.storage.refused_count, 30);
    assert_int_equal(rig.storage.accepted_count, ENTRIES);
    assert_int_equal(rig.kiosk.faults.storage, 0);
}

static void test_a_failing_store_is_retried_each_second(void **state)
{
    (void)state;
    static const struct button_event events[] = {
        { .time_ns = 1100 * MS, .pressed = INPUT_START },
    };
    rig.storage.fail_left = 2;
    glide(1000, 20);
    script(events, 1);
    for (uint32_t i = 0; i < 60 && rig.storage.refused_count == 0; i++) {
        frames(1);
    }
    frames(30);
    assert_int_equal(rig.storage.refused_count, 1);
    frames(120);
    assert_int_equal(rig.storage.accepted_count, 1); /* The first entry, which records the start of
                                                        the round, was accepted after the
                                                        retries. */
    assert_int_equal(rig.kiosk.faults.storage, 2);
}

static void test_failed_writes_of_the_store_thread_are_counted_as_faults(void **state)
{
    (void)state;
    frames(10);
    rig.storage.write_refused_count = 2;
    frames(10);
    assert_int_equal(rig.kiosk.faults.storage, 2);
    rig.storage.write_refused_count = 3;
    assert_int_equal(kiosk_close_store(&rig.kiosk, &rig.hal), 0);
    assert_int_equal(rig.kiosk.faults.storage, 3);
}

static void test_the_core_input_reports_that_graphs_cannot_be_stored(void **state)
{
    (void)state;
    frames(10);
    assert_int_equal(rig.kiosk.input.edit_refused, 0);
    rig.storage.edit_failed = 1;
    frames(10);
    assert_int_equal(rig.kiosk.input.edit_refused, 1);
    rig.hal.storage = null_hal("no store").storage;
    rig.storage.edit_failed = 0;
    frames(10);
    assert_int_equal(rig.kiosk.input.edit_refused, 1);
}

static void test_a_round_that_the_store_never_accepted_is_counted_as_lost(void **state)
{
    (void)state;
    rig.storage.busy_left = 100000;
    play_a_round();
    frames(10);
    assert_int_equal(kiosk_close_store(&rig.kiosk, &rig.hal), ENTRIES);
}

/* Adds a restart command to the output of the core, as the operator's menu does. */
static void request_restart(void)
{
    struct output *output = &rig.kiosk.output;
    output->commands[output->command_count++ % CONTROLLER_COMMAND_MAX] =
        (struct controller_command){ .kind = COMMAND_RESTART };
}

static void test_a_restart_waits_for_the_store_up_to_its_timeout(void **state)
{
    (void)state;
    rig.storage.busy_left = 100000;
    play_a_round();
    request_restart();
    frames(5u * 60u - 2u); /* Two frames before the timeout of five seconds, the store is still
                              busy, and the restart still waits for it. */
    assert_true(rig.kiosk.saving.accepted_id < rig.kiosk.output.entry_id);
    enum kiosk_end end = KIOSK_RUNS;
    for (uint32_t i = 0; i < 6 && end == KIOSK_RUNS; i++) {
        end = frame_after(FRAME_NS);
    }
    assert_int_equal(end, KIOSK_RESTART);
    assert_int_equal(kiosk_close_store(&rig.kiosk, &rig.hal), ENTRIES);
}

static void test_a_restart_follows_as_soon_as_the_store_is_flushed(void **state)
{
    (void)state;
    rig.storage.busy_left = 100000;
    play_a_round();
    request_restart();
    frames(30);
    rig.storage.busy_left = 0;
    enum kiosk_end end = KIOSK_RUNS;
    for (uint32_t i = 0; i < 3 && end == KIOSK_RUNS; i++) {
        end = frame_after(FRAME_NS);
    }
    assert_int_equal(end, KIOSK_RESTART);
    assert_int_equal(rig.storage.accepted_count, ENTRIES);
}

static void test_the_saved_id_covers_only_entries_on_disk(void **state)
{
    (void)state;
    rig.storage.delay_polls = 20;
    play_a_round();
    frames(10);
    assert_int_equal(rig.storage.accepted_count, ENTRIES);
    assert_int_equal(rig.kiosk.input.record_saved_id, 0);
    frames(20);
    assert_int_equal(rig.kiosk.input.record_saved_id, ENTRIES);
}

static void test_a_failing_sound_card_is_counted_and_the_round_continues(void **state)
{
    (void)state;
    rig.audio.fails = 1;
    play_a_round();
    assert_true(rig.kiosk.faults.audio > 0);
}

static void test_a_removed_sound_card_is_one_fault_and_is_retried_each_second(void **state)
{
    (void)state;
    rig.audio.gone = 1;
    play_a_round();
    assert_int_equal(rig.kiosk.faults.audio, 1);
    /* The kiosk tries to open the sound card once a second. The test takes a little longer than the
     * round of ten seconds. */
    assert_in_range(rig.audio.open_count, 8, 20);
    rig.audio.gone = 0;
    frames(70);
    play_another_round();
    assert_true(rig.audio.played[SOUND_RESULT] >= 1);
    assert_int_equal(rig.kiosk.faults.audio, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        TEST(test_a_round_plays_its_sounds_and_is_stored_once),
        TEST(test_a_busy_store_is_retried_each_frame),
        TEST(test_a_failing_store_is_retried_each_second),
        TEST(test_failed_writes_of_the_store_thread_are_counted_as_faults),
        TEST(test_the_core_input_reports_that_graphs_cannot_be_stored),
        TEST(test_a_round_that_the_store_never_accepted_is_counted_as_lost),
        TEST(test_a_restart_waits_for_the_store_up_to_its_timeout),
        TEST(test_a_restart_follows_as_soon_as_the_store_is_flushed),
        TEST(test_the_saved_id_covers_only_entries_on_disk),
        TEST(test_a_failing_sound_card_is_counted_and_the_round_continues),
        TEST(test_a_removed_sound_card_is_one_fault_and_is_retried_each_second),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
