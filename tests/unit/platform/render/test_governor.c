/* test_governor.c -- Tests the governor, which lowers the render quality if frames are late or the
 * machine is hot. The quality must settle, and the game speed must not change. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "platform/render/quality.h"

#define S 1000000000ull
#define MS 1000000ull

/* A simulated machine. `best_ns` is the duration of a frame at the best quality, and `hz` is the
 * refresh rate of the screen. */
static struct machine {
    struct governor governor;
    uint64_t now_ns, best_ns;
    uint32_t hz, step, changes;
} machine;

static void begin(uint64_t best_ns, uint32_t hz)
{
    machine = (struct machine){ .now_ns = 7 * S, .best_ns = best_ns, .hz = hz };
    quality_governor_begin(&machine.governor, hz);
}

/* Returns the duration of a frame at a quality step. 15 % of the duration do not depend on the
 * quality. */
static uint64_t cost_ns(uint32_t step)
{
    const struct quality best = { .scene_scale = 1.0f,
                                  .floor_scale = 1.0f,
                                  .mirror_scale = 1.0f,
                                  .screen_scale = 1.0f,
                                  .samples = 1,
                                  .lod_near_px = 100.0f };
    const struct quality now = quality_lower(&best, step);
    return (uint64_t)((float)machine.best_ns *
                      (0.15f + 15.0f / now.lod_near_px + 0.10f * now.floor_scale * now.floor_scale +
                       0.10f * now.mirror_scale * now.mirror_scale +
                       0.35f * now.screen_scale * now.screen_scale +
                       0.15f * now.scene_scale * now.scene_scale));
}

/* Runs frames with vsync, so each frame ends at a refresh of the screen. Returns the number of late
 * frames. */
static uint32_t run(uint32_t seconds, bool may_refine)
{
    const uint64_t turn_ns = S / machine.hz, end_ns = machine.now_ns + seconds * S;
    uint32_t late = 0;
    while (machine.now_ns < end_ns) {
        const uint64_t turns = (cost_ns(machine.step) + turn_ns - 1u) / turn_ns;
        machine.now_ns += turns * turn_ns;
        late += turns > 1;
        const uint32_t step = quality_governor_frame(&machine.governor, machine.now_ns, may_refine);
        machine.changes += step != machine.step;
        machine.step = step;
    }
    return late;
}

static void test_a_fast_machine_keeps_the_best_quality(void **state)
{
    (void)state;
    begin(14 * MS, 60);
    run(600, true);
    assert_int_equal(machine.step, 0);
    assert_int_equal(machine.changes, 0);
}

static void test_a_slow_machine_reaches_its_frame_rate_within_ten_seconds(void **state)
{
    (void)state;
    begin(30 * MS, 60);
    run(10, false);
    assert_true(machine.step > 0);
    assert_int_equal(run(600, false), 0);
    print_message("30 ms a frame at best: %u steps\n", machine.step);
}

static void test_the_quality_never_falls_below_the_last_step(void **state)
{
    (void)state;
    begin(200 * MS, 60);
    run(600, true);
    assert_int_equal(machine.step, QUALITY_STEP_MAX);
    begin(900 * MS, 60); /* No quality step makes a frame of 900 ms fast enough. */
    run(60, true);
    assert_int_equal(machine.step, QUALITY_STEP_MAX);
}

static void
test_a_machine_that_misses_each_frame_shows_every_second_at_the_best_quality(void **state)
{
    (void)state;
    begin(50 * MS, 60); /* 26 ms at the last step, and 31 ms at the fifth. */
    run(60, false);
    assert_int_equal(machine.step, 5);
    machine.changes = 0;
    assert_in_range(run(600, false), 600 * 30 - 1, 600 * 30 + 1);
    assert_int_equal(machine.changes, 0);
    /* A trial of the full frame rate fails, and the same step returns. */
    run(600, true);
    run(4, false);
    assert_int_equal(machine.step, 5);
    assert_in_range(machine.changes, 2, 10);
    machine.best_ns = 12 * MS;
    run(3u * GOVERNOR_PATIENCE_MAX_S, true);
    assert_int_equal(machine.step, 0);
    assert_int_equal(run(60, true), 0);
}

static void test_a_higher_quality_is_tried_between_games_with_increasing_delays(void **state)
{
    (void)state;
    begin(22 * MS, 60);
    run(20, false);
    const uint32_t settled = machine.step;
    assert_true(settled > 0);
    machine.changes = 0;
    run(3600, false); /* During a game (`may_refine` is false), the governor must not try a higher
                         quality. */
    assert_int_equal(machine.changes, 0);
    const uint32_t late = run(3600, true);
    print_message("an hour: %u changes, %u frames late\n", machine.changes, late);
    assert_in_range(machine.changes, 2, 16);
    assert_true(late < 600u);
    machine.best_ns = 12 * MS; /* From now on the machine is fast enough for the best quality. */
    run(2u * GOVERNOR_PATIENCE_MAX_S, true);
    assert_int_equal(machine.step, 0);
}

#define PATIENCE (GOVERNOR_PATIENCE_S / GOVERNOR_PERIOD_S)

/* Shows frames of the same duration, in per cent of the refresh period, for `periods` complete
 * measurement intervals of the governor. Returns the number of quality changes. */
static uint32_t show(uint32_t percent, uint32_t periods, bool may_refine)
{
    machine.changes = 0;
    for (uint32_t done = 0; done < periods;) {
        machine.now_ns += machine.governor.turn_ns * percent / 100u;
        const uint32_t step = quality_governor_frame(&machine.governor, machine.now_ns, may_refine);
        done += machine.governor.count == 0 && machine.governor.last_ns > 0;
        machine.changes += step != machine.step;
        machine.step = step;
    }
    return machine.changes;
}

/* Begins with a quality that late frames have lowered by two steps. */
static void begin_at_step_two(void)
{
    begin(16 * MS, 60);
    quality_governor_frame(&machine.governor, machine.now_ns, false);
    show(140, 2, true);
    assert_int_equal(machine.step, 2);
}

/* Shows frames until the quality changes. Returns the number of measurement intervals. */
static uint32_t wait_for_change(uint32_t percent)
{
    uint32_t periods = 1;
    while (periods < 2u * GOVERNOR_PATIENCE_MAX_S && show(percent, 1, true) == 0) {
        periods++;
    }
    return periods;
}

static void test_late_frames_lower_the_quality_by_one_step_and_very_late_ones_by_two(void **state)
{
    (void)state;
    begin_at_step_two();
    assert_int_equal(show(112, 1, true), 1);
    assert_int_equal(machine.step, 3);
    assert_int_equal(show(149, 1, true), 1);
    assert_int_equal(machine.step, 4);
    assert_int_equal(show(160, 1, true), 1);
    assert_int_equal(machine.step, 6);
    assert_int_equal(show(160, 1, true), 1);
    assert_int_equal(machine.step, QUALITY_STEP_MAX);
}

static void test_frames_between_the_limits_change_nothing(void **state)
{
    (void)state;
    begin_at_step_two();
    for (uint32_t percent = 104; percent <= 110; percent++) {
        assert_int_equal(show(percent, 3600, true), 0);
    }
    /* The time without late frames begins again after frames that were almost late. */
    assert_int_equal(show(100, PATIENCE - 1u, true), 0);
    assert_int_equal(show(108, 1, true), 0);
    assert_int_equal(show(100, PATIENCE - 1u, true), 0);
    assert_int_equal(show(100, 1, true), 1);
    assert_int_equal(machine.step, 1);
    assert_int_equal(show(102, PATIENCE, true), 1); /* Frames that are hardly late count. */
    assert_int_equal(machine.step, 0);
}

static void test_the_quality_rises_again_without_oscillation(void **state)
{
    (void)state;
    begin(26 * MS, 60);
    run(60, false);
    const uint32_t lowest = machine.step;
    assert_true(lowest >= 4);
    machine.best_ns = 15 * MS;
    machine.changes = 0;
    assert_int_equal(run((lowest + 1u) * GOVERNOR_PATIENCE_S * 2u, true), 0);
    assert_int_equal(machine.step, 0);
    assert_int_equal(machine.changes, lowest); /* Each change was one step up. */
    run(3600, true);
    assert_int_equal(machine.changes, lowest);
}

static void test_each_failed_trial_doubles_the_delay_and_a_success_resets_it(void **state)
{
    (void)state;
    begin_at_step_two();
    uint32_t delay = PATIENCE;
    for (uint32_t i = 0; i < 9; i++) {
        assert_int_equal(wait_for_change(100), delay);
        assert_int_equal(machine.step, 1);
        assert_int_equal(show(140, 1, true), 1); /* The trial fails, and the step returns. */
        assert_int_equal(machine.step, 2);
        delay = delay < GOVERNOR_PATIENCE_MAX_S / GOVERNOR_PERIOD_S ? 2u * delay : delay;
    }
    assert_int_equal(delay, GOVERNOR_PATIENCE_MAX_S / GOVERNOR_PERIOD_S);
    assert_int_equal(wait_for_change(100), delay);
    assert_int_equal(show(100, 30, false), 0);
    assert_int_equal(show(140, 1, true), 1);
    assert_int_equal(wait_for_change(100), PATIENCE);
    assert_int_equal(machine.step, 1);
}

static void test_a_trial_succeeds_only_after_a_minute(void **state)
{
    (void)state;
    begin_at_step_two();
    assert_int_equal(wait_for_change(100), PATIENCE);
    assert_int_equal(show(100, 60u / GOVERNOR_PERIOD_S - 1u, false), 0);
    assert_int_equal(show(140, 1, true), 1);
    assert_int_equal(wait_for_change(100), 2u * PATIENCE);
}

static void test_a_failed_trial_lowers_the_quality_by_one_step_only(void **state)
{
    (void)state;
    begin_at_step_two();
    wait_for_change(100);
    assert_int_equal(machine.step, 1);
    show(300, 1, true);
    assert_int_equal(machine.step, 2);
}

static void test_a_late_last_step_returns_to_the_best_step_of_half_the_frame_rate(void **state)
{
    (void)state;
    begin_at_step_two();
    show(160, 3, false);
    assert_int_equal(machine.step, QUALITY_STEP_MAX);
    assert_int_equal(show(160, 1, false), 1);
    assert_int_equal(machine.step, 0); /* Every second refresh is 200 %. The best step holds it. */
    assert_int_equal(show(200, 3600, false), 0);
    assert_int_equal(show(240, 1, false), 1);
    assert_int_equal(machine.step, 1);
    assert_int_equal(show(210, 3600, true), 0);
    /* A trial of the full frame rate begins at the last step, and returns to the same step. */
    wait_for_change(200);
    assert_int_equal(machine.step, QUALITY_STEP_MAX);
    assert_int_equal(show(160, 1, false), 1);
    assert_int_equal(machine.step, 1);
    assert_int_equal(show(200, 3600, false), 0);
    /* A trial that succeeds keeps the full frame rate, and the quality rises from the last step. */
    wait_for_change(200);
    assert_int_equal(show(100, 30, false), 0);
    assert_int_equal(wait_for_change(100), 1);
    assert_int_equal(machine.step, QUALITY_STEP_MAX - 1u);
}

static void test_a_low_refresh_rate_does_not_reduce_the_quality(void **state)
{
    (void)state;
    begin(14 * MS, 50);
    run(600, true);
    assert_int_equal(machine.step, 0);
    begin(14 * MS, 30);
    run(600, true);
    assert_int_equal(machine.step, 0);
    begin(6 * MS, 144); /* A frame of 10 ms takes two refresh intervals of a 144 Hz screen. This is
                           fast enough, because the game needs only 60 frames a second. */
    machine.best_ns = 10 * MS;
    run(600, true);
    assert_int_equal(machine.step, 0);
}

static void test_a_delayed_frame_does_not_reduce_the_quality(void **state)
{
    (void)state;
    begin(14 * MS, 60);
    for (uint32_t i = 0; i < 100; i++) {
        run(3, true);
        machine.now_ns += 2 * S;
    }
    assert_int_equal(machine.step, 0);
}

static void test_heat_reduces_the_quality_immediately_and_cooling_restores_it(void **state)
{
    (void)state;
    begin(14 * MS, 60);
    quality_governor_set_temperature(&machine.governor, GOVERNOR_HOT_MDEG - 1);
    run(1, false);
    assert_int_equal(machine.step, 1);
    for (uint32_t i = 0; i < 10; i++) {
        quality_governor_set_temperature(&machine.governor, -5000);
    }
    run(1, false);
    assert_int_equal(machine.step, QUALITY_STEP_MAX);
    /* Values exactly at the limits count neither as hot nor as cool, so they change nothing. */
    quality_governor_set_temperature(&machine.governor, GOVERNOR_HOT_MDEG);
    quality_governor_set_temperature(&machine.governor, GOVERNOR_COOL_MDEG);
    run(1, false);
    assert_int_equal(machine.step, QUALITY_STEP_MAX);
    for (uint32_t i = 0; i < QUALITY_STEP_MAX; i++) {
        quality_governor_set_temperature(&machine.governor, GOVERNOR_COOL_MDEG + 1);
    }
    run(1, false);
    assert_int_equal(machine.step, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_fast_machine_keeps_the_best_quality),
        cmocka_unit_test(test_a_slow_machine_reaches_its_frame_rate_within_ten_seconds),
        cmocka_unit_test(test_the_quality_never_falls_below_the_last_step),
        cmocka_unit_test(
            test_a_machine_that_misses_each_frame_shows_every_second_at_the_best_quality),
        cmocka_unit_test(test_a_higher_quality_is_tried_between_games_with_increasing_delays),
        cmocka_unit_test(test_late_frames_lower_the_quality_by_one_step_and_very_late_ones_by_two),
        cmocka_unit_test(test_frames_between_the_limits_change_nothing),
        cmocka_unit_test(test_the_quality_rises_again_without_oscillation),
        cmocka_unit_test(test_each_failed_trial_doubles_the_delay_and_a_success_resets_it),
        cmocka_unit_test(test_a_trial_succeeds_only_after_a_minute),
        cmocka_unit_test(test_a_failed_trial_lowers_the_quality_by_one_step_only),
        cmocka_unit_test(test_a_late_last_step_returns_to_the_best_step_of_half_the_frame_rate),
        cmocka_unit_test(test_a_low_refresh_rate_does_not_reduce_the_quality),
        cmocka_unit_test(test_a_delayed_frame_does_not_reduce_the_quality),
        cmocka_unit_test(test_heat_reduces_the_quality_immediately_and_cooling_restores_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
