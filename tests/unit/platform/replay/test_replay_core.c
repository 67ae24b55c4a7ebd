/* test_replay_core.c -- Tests recordings of a running core. A replay must reproduce every tick,
 * even if a signal or a panic ended the recording, and must report the first difference. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/hash.h"
#include "core/base/rng.h"
#include "platform/replay/replay.h"
#include "tests/unit/support/replay_fixture.h"

static struct core core;
static struct recorder recorder;
static struct replayer replayer;

/* Returns the input of a fan. The fan appears after two seconds, moves over the water, moves aside
 * and disappears. */
static struct shade_input fan_at(uint32_t tick)
{
    const float t = (float)tick / (float)CORE_TICK_HZ;
    return (struct shade_input){
        .present = t > 2.0f && t < 7.0f,
        .x_m = 0.1f * f_smoothstep(5.0f, 6.0f, t),
        .z_m = 0.6f - 0.6f * f_smoothstep(2.0f, 2.5f, t),
        .radius_m = 0.1f,
    };
}

/* Records `seconds` in which the bot plays, with a press of START after one second. From tick
 * `lie_at` on, the recorded digests are wrong. */
static void play_and_record(uint32_t seconds, uint32_t lie_at)
{
    static struct output output;
    struct input input = { .poi[0].link = POI_SOURCE_BOT };
    assert_int_equal(core_init(&core, &config), CORE_OK);
    empty_path();
    assert_int_equal(recorder_begin(&recorder, path, &core), 0);
    const struct kiosk_tap tap = recorder_tap(&recorder);
    for (uint32_t tick = 0; tick < seconds * CORE_TICK_HZ; tick++) {
        static struct core altered;
        input.pressed = tick == CORE_TICK_HZ ? INPUT_START : 0;
        input.shade[0] = fan_at(tick);
        output.sound_count = 0;
        core_tick(&core, &input, &output);
        altered = core;
        altered.game.tick += tick >= lie_at;
        tap.tick(tap.self, &input, &altered);
    }
    assert_int_equal(recorder_end(&recorder), 0);
}

static void replay_all_as(uint8_t as_is)
{
    static struct output output;
    struct input input;
    struct core_config from_file;
    assert_int_equal(replayer_begin(&replayer, path, &from_file), 0);
    replayer.reader.as_is = as_is;
    assert_int_equal(core_init(&core, &from_file), CORE_OK);
    const struct kiosk_source source = replayer_source(&replayer);
    const struct kiosk_tap tap = replayer_tap(&replayer);
    while (source.next(source.self, &input)) {
        output.sound_count = 0;
        core_tick(&core, &input, &output);
        tap.tick(tap.self, &input, &core);
    }
    replayer_end(&replayer);
}

static void replay_all(void)
{
    replay_all_as(0);
}

static void test_a_correct_recording_verifies(void **state)
{
    (void)state;
    play_and_record(3, UINT32_MAX);
    const uint64_t hash = core_hash(&core);
    replay_all();
    assert_int_equal(replayer.damaged, 0);
    assert_int_equal(replayer.difference.found, 0);
    assert_int_equal(replayer.totals.ticks, 3 * CORE_TICK_HZ);
    assert_true(core_hash(&core) == hash);
}

/* The dip that begins the game chooses the side of the bowl. The side is not in the recording's
 * configuration: the replay must compute the same side from the input. */
static void test_a_recording_with_the_bowl_on_the_left_side_verifies(void **state)
{
    (void)state;
    static struct output output;
    struct input input = { .poi[0].link = POI_SOURCE_LIVE };
    struct core_config left = config;
    left.modes = 1u << MODE_FESTIVAL;
    settings_reset(&left.persistent.settings);
    left.persistent.settings.value[SET_SIDE] = BOWL_BY_FIRST_DIP;
    assert_int_equal(core_init(&core, &left), CORE_OK);
    empty_path();
    assert_int_equal(recorder_begin(&recorder, path, &core), 0);
    const struct kiosk_tap tap = recorder_tap(&recorder);
    for (uint32_t tick = 0; tick < 8u * CORE_TICK_HZ; tick++) {
        const bool is_down = tick > CORE_TICK_HZ && tick < 3u * CORE_TICK_HZ / 2u;
        input.poi[0].target.position_m = v3(-0.3f, is_down ? -0.03f : 0.08f, 0.0f);
        output.sound_count = 0;
        core_tick(&core, &input, &output);
        tap.tick(tap.self, &input, &core);
    }
    assert_int_equal(recorder_end(&recorder), 0);
    const float bowl_x_m = core.world.bowl[0].position_m.x;
    assert_int_equal(core.game.phase, PHASE_ROUND);
    assert_true(bowl_x_m < -0.1f);
    const uint64_t hash = core_hash(&core);
    replay_all();
    assert_int_equal(replayer.damaged, 0);
    assert_int_equal(replayer.difference.found, 0);
    assert_true(core_hash(&core) == hash);
    assert_float_equal(core.world.bowl[0].position_m.x, bowl_x_m, 0.0f);
}

/* The recording contains coins and a visit to the operator's menu. In the menu, controllers are
 * plugged in, unplugged and learned. */
static void test_a_recording_of_the_operator_menu_verifies(void **state)
{
    static struct output output;
    static const uint32_t presses[] = { INPUT_TEST, INPUT_TEST,    INPUT_TEST,  INPUT_TEST,
                                        INPUT_LEFT, INPUT_SERVICE, INPUT_RIGHT, INPUT_TEST,
                                        INPUT_OK,   INPUT_SERVICE, INPUT_START, INPUT_SERVICE };
    struct core_config paid = config;
    struct input input = { .poi[0].link = POI_SOURCE_BOT };
    (void)state;
    paid.credit_coins = 2;
    paid.ticket_fish = 3;
    assert_int_equal(core_init(&core, &paid), CORE_OK);
    empty_path();
    assert_int_equal(recorder_begin(&recorder, path, &core), 0);
    const struct kiosk_tap tap = recorder_tap(&recorder);
    uint32_t menu_ticks = 0;
    for (uint32_t tick = 0; tick < 6u * CORE_TICK_HZ; tick++) {
        input.coin_count[0] = tick % 50u == 7u;
        input.pressed = tick % 30u == 29u ? presses[tick / 30u % 12u] : 0u;
        input.held = tick / 100u % 2u ? INPUT_DOOR : 0u;
        input.controllers.state[0] = CONTROLLER_FREE;
        input.controllers.state[1u + tick / 77u % 7u] =
            (uint8_t)(tick / 31u % CONTROLLER_STATE_COUNT);
        input.controllers.learn_step = (uint8_t)(tick / 120u);
        input.controllers.learn_progress = (uint8_t)tick;
        input.controllers.file_count = (uint8_t)(tick / 9u);
        output.sound_count = 0;
        core_tick(&core, &input, &output);
        menu_ticks += core.game.phase == PHASE_MENU;
        tap.tick(tap.self, &input, &core);
    }
    assert_int_equal(recorder_end(&recorder), 0);
    const uint64_t hash = core_hash(&core);
    assert_true(menu_ticks > CORE_TICK_HZ && output.command_count > 0 && output.coins_counted > 0);
    replay_all();
    assert_int_equal(replayer.damaged, 0);
    assert_int_equal(replayer.difference.found, 0);
    assert_true(core_hash(&core) == hash);
}

/* START is pressed in the first second. After 3 s the countdown of the round still runs: the round
 * is counted, but the recording has no mode and no player yet. After 5 s, the first player plays a
 * festival round. */
static void test_a_recording_contains_its_modes_and_players(void **state)
{
    (void)state;
    play_and_record(3, UINT32_MAX);
    assert_int_equal(recorder.totals.rounds, 1);
    assert_int_equal(recorder.totals.modes, 0);
    assert_int_equal(recorder.totals.players, 0);
    play_and_record(5, UINT32_MAX);
    replay_all();
    assert_int_equal(replayer.difference.found, 0);
    assert_int_equal(replayer.reader.totals.modes, 1u << MODE_FESTIVAL);
    assert_int_equal(replayer.reader.totals.players, 1);
}

/* The totals of a recording are sums over all its rounds. The counts of a player restart at 0 in
 * each round, so a smaller count means that a new round has begun. */
static void test_counts_rise_with_the_scores_and_restart_with_a_round(void **state)
{
    static const uint32_t caught[] = { 0, 2, 2, 0, 1 }, fouls[] = { 1, 1, 3, 0, 1 };
    struct replay_totals totals = { 0 };
    struct recorder_tally tally = { 0 };
    (void)state;
    memset(&core, 0, sizeof core);
    for (size_t i = 0; i < sizeof caught / sizeof caught[0]; i++) {
        core.game.player[2].caught = caught[i];
        core.game.player[2].fouls = (uint8_t)fouls[i];
        recorder_count(&totals, &tally, &core);
    }
    assert_int_equal(totals.ticks, 5);
    assert_int_equal(totals.caught, 3);
    assert_int_equal(totals.fouls, 4);
}

static void test_the_first_different_tick_is_reported(void **state)
{
    (void)state;
    play_and_record(3, 200);
    replay_all();
    assert_int_equal(replayer.difference.found, 1);
    assert_int_equal(replayer.difference.tick, 200);
    assert_true(replayer.difference.recorded != replayer.difference.computed);
}

/* After a panic in the middle of a tick, the recording must contain the input of this tick. The
 * tick has no digest, because the state is incomplete. */
static void test_a_recording_ended_by_a_panic_reproduces_the_panic(void **state)
{
    static struct output output;
    struct replay_totals totals;
    struct input input = { .poi[0].link = POI_SOURCE_BOT };
    (void)state;
    assert_int_equal(core_init(&core, &config), CORE_OK);
    empty_path();
    assert_int_equal(recorder_begin(&recorder, path, &core), 0);
    const struct kiosk_tap tap = recorder_tap(&recorder);
    for (uint32_t tick = 0; tick < 150; tick++) {
        tap.before(tap.self, &input);
        core_tick(&core, &input, &output);
        tap.tick(tap.self, &input, &core);
    }
    input.pressed = INPUT_LANGUAGE;
    tap.before(tap.self, &input);
    /* Overwrites the state, as a panic in the middle of a tick leaves it incomplete. */
    memset(&core.game, 0xff, sizeof core.game);
    assert_int_equal(recorder_end_in_panic(&recorder), 0);
    assert_int_equal(scan(&totals), 0);
    assert_int_equal(totals.ticks, 151);
    assert_int_equal(totals.rounds, 0);
    replay_all();
    assert_int_equal(core.game.tick, 151);
    assert_int_equal(core.game.language, LANGUAGE_EN);
    /* The replay completes the tick, so its state differs from the recorded one. */
    assert_int_equal(replayer.difference.found, 1);
    assert_int_equal(replayer.difference.tick, 150);
}

/* Records `count` complete ticks, and the input of one more tick that is not completed. */
static void record_into_a_tick(uint32_t count)
{
    static struct output output;
    const struct input input = { .poi[0].link = POI_SOURCE_BOT };
    assert_int_equal(core_init(&core, &config), CORE_OK);
    empty_path();
    assert_int_equal(recorder_begin(&recorder, path, &core), 0);
    const struct kiosk_tap tap = recorder_tap(&recorder);
    for (uint32_t tick = 0; tick < count; tick++) {
        tap.before(tap.self, &input);
        core_tick(&core, &input, &output);
        tap.tick(tap.self, &input, &core);
    }
    tap.before(tap.self, &input);
}

static void test_a_recording_ended_by_a_signal_within_a_tick_verifies(void **state)
{
    static const uint32_t counts[] = { 0, 150, 2u * CORE_TICK_HZ - 1u, 2u * CORE_TICK_HZ };
    (void)state;
    for (uint32_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        record_into_a_tick(counts[i]);
        assert_int_equal(recorder_end_in_panic(&recorder), 0);
        replay_all_as(1);
        assert_int_equal(core.game.tick, counts[i] + 1u);
        assert_int_equal(replayer.damaged, 0);
        assert_int_equal(replayer.difference.found, 0);
        assert_true(replayer_is_interrupted(&replayer));
    }
}

static void test_a_signal_during_a_write_leaves_a_recording_of_whole_seconds(void **state)
{
    struct replay_totals totals;
    (void)state;
    record_into_a_tick(150);
    recorder.is_in_tick = 0;
    /* Simulates a panic while the recorder writes a tick. */
    recorder.is_adding = 1;
    assert_int_equal(recorder_end_in_panic(&recorder), -EINTR);
    assert_int_equal(scan(&totals), 0);
    assert_int_equal(totals.ticks, CORE_TICK_HZ);
    recorder.is_adding = 0;
    recorder_end(&recorder);
}

static void test_a_panic_between_ticks_adds_no_tick(void **state)
{
    struct replay_totals totals;
    (void)state;
    assert_int_equal(core_init(&core, &config), CORE_OK);
    empty_path();
    assert_int_equal(recorder_begin(&recorder, path, &core), 0);
    assert_int_equal(recorder_end_in_panic(&recorder), 0);
    assert_int_equal(scan(&totals), 0);
    assert_int_equal(totals.ticks, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_correct_recording_verifies),
        cmocka_unit_test(test_a_recording_with_the_bowl_on_the_left_side_verifies),
        cmocka_unit_test(test_a_recording_of_the_operator_menu_verifies),
        cmocka_unit_test(test_a_recording_contains_its_modes_and_players),
        cmocka_unit_test(test_counts_rise_with_the_scores_and_restart_with_a_round),
        cmocka_unit_test(test_the_first_different_tick_is_reported),
        cmocka_unit_test(test_a_recording_ended_by_a_panic_reproduces_the_panic),
        cmocka_unit_test(test_a_recording_ended_by_a_signal_within_a_tick_verifies),
        cmocka_unit_test(test_a_signal_during_a_write_leaves_a_recording_of_whole_seconds),
        cmocka_unit_test(test_a_panic_between_ticks_adds_no_tick),
    };
    return cmocka_run_group_tests(tests, make_path, remove_path);
}
