/* test_demo.c -- Tests the demo mode, which plays a recording or lets a bot play, without a window.
 * In a recording, the digest of each tick is compared with the recorded one. A demo with a bot must
 * start within a round. */
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "platform/kiosk/demo.h"

static struct run_common session;
static struct core core;
static volatile sig_atomic_t stop;
static char folder[] = "/tmp/kingyo-demo-XXXXXX";
static char recording[64];

static int make_folder(void **state)
{
    (void)state;
    session.recorder.writer.fd = -1;
    return mkdtemp(folder) ? 0 : -1;
}

static int remove_folder(void **state)
{
    char command[64];
    (void)state;
    snprintf(command, sizeof command, "rm -rf %s", folder);
    return system(command);
}

/* Records `count` ticks without player input. Each tick has a digest of the core's state, and the
 * digest of tick `wrong` is set to a false value. */
static void record(const char *name, uint32_t count, uint32_t wrong)
{
    static struct recorder recorder;
    static struct output output;
    const struct core_config config = { .seed = 3, .fish_count = 5 };
    const struct input input = { 0 };
    snprintf(recording, sizeof recording, "%s/%s", folder, name);
    assert_int_equal(core_init(&core, &config), CORE_OK);
    assert_int_equal(recorder_begin(&recorder, recording, &core), 0);
    for (uint32_t tick = 0; tick < count; tick++) {
        core_tick(&core, &input, &output);
        recorder_count(&recorder.totals, &recorder.tally, &core);
        recorder.totals.hash = core_hash(&core);
        const uint32_t digest = (uint32_t)core_hash_quick(&core) ^ (uint32_t)(tick == wrong);
        replay_add(&recorder.writer, &input, digest, &recorder.totals);
    }
    assert_int_equal(recorder_end(&recorder), 0);
}

static enum exit_code show(void)
{
    session.options = (struct options){ .width = 320, .height = 240 };
    snprintf(session.options.replay, sizeof session.options.replay, "%s", recording);
    snprintf(session.options.shots, sizeof session.options.shots, "%s", folder);
    session.stop = &stop;
    assert_int_equal(run_common_check(&session), EXIT_OK);
    return demo_run(&session);
}

static void test_every_tick_of_a_recording_is_played(void **state)
{
    (void)state;
    record("true.kgr", 100, UINT32_MAX);
    assert_int_equal(show(), EXIT_OK);
    assert_int_equal(session.kiosk.core.game.tick, 100);
}

static void test_a_mismatch_in_the_last_tick_of_a_recording_is_detected(void **state)
{
    (void)state;
    record("wrong.kgr", 100, 99);
    assert_int_equal(show(), EXIT_NOT_SO);
    assert_int_equal(session.replayer.difference.tick, 99);
}

static void test_an_empty_recording_gives_one_picture(void **state)
{
    (void)state;
    record("empty.kgr", 0, UINT32_MAX);
    assert_int_equal(show(), EXIT_OK);
    assert_int_equal(session.kiosk.frames, 1);
}

static void test_the_demo_starts_in_the_round_and_catches_a_fish(void **state)
{
    (void)state;
    session.options = (struct options){ .width = 320, .height = 240, .demo = 1, .demo_s = 15 };
    snprintf(session.options.shots, sizeof session.options.shots, "%s", folder);
    assert_int_equal(demo_run(&session), EXIT_OK);
    const struct core *played = &session.kiosk.core;
    assert_int_equal(played->game.phase, PHASE_ROUND);
    /* The demo lasts 15 s and begins 0.75 s after the start of the round, when the poi has moved
     * over the water. The range allows 15.5 to 16 s. */
    assert_in_range(played->game.tick - played->game.round_tick, 31u * CORE_TICK_HZ / 2u,
                    16u * CORE_TICK_HZ);
    assert_true(played->game.player[0].caught > 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_tick_of_a_recording_is_played),
        cmocka_unit_test(test_a_mismatch_in_the_last_tick_of_a_recording_is_detected),
        cmocka_unit_test(test_an_empty_recording_gives_one_picture),
        cmocka_unit_test(test_the_demo_starts_in_the_round_and_catches_a_fish),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
