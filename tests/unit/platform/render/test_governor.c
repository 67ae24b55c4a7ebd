/* test_governor.c -- a picture that comes late or makes the machine hot gets coarser, never the
 * game slower; and it settles. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "platform/render/quality.h"

#define S 1000000000ull
#define MS 1000000ull

/* A machine that needs so long for the best picture, on a screen of so many turns a second. */
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

/* What a step leaves of the cost: a third of it is not the scene's. */
static uint64_t cost_ns(uint32_t step)
{
    const struct quality best = { .scene_scale = 1.0f, .floor_scale = 1.0f, .samples = 1 };
    const float scale = quality_lower(&best, step).scene_scale;
    return (uint64_t)((float)machine.best_ns * (0.33f + 0.67f * scale * scale));
}

/* Shown at the screen's next turn. Returns how many of the frames were late. */
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

static void test_a_machine_that_is_fast_enough_keeps_the_best_picture(void **state)
{
    (void)state;
    begin(14 * MS, 60);
    run(600, true);
    assert_int_equal(machine.step, 0);
    assert_int_equal(machine.changes, 0);
}

static void test_a_slow_one_is_on_time_within_ten_seconds(void **state)
{
    (void)state;
    begin(30 * MS, 60);
    run(10, false);
    assert_true(machine.step > 0);
    assert_int_equal(run(600, false), 0);
    print_message("30 ms a frame at best: %u steps\n", machine.step);
}

static void test_no_machine_is_drawn_for_less_than_the_last_step(void **state)
{
    (void)state;
    begin(200 * MS, 60);
    run(600, true);
    assert_int_equal(machine.step, QUALITY_STEP_MAX);
    begin(900 * MS, 60); /* Each frame as long as a stall. */
    run(60, true);
    assert_int_equal(machine.step, QUALITY_STEP_MAX);
}

static void test_a_finer_picture_is_tried_between_games_and_ever_more_rarely(void **state)
{
    (void)state;
    begin(22 * MS, 60);
    run(20, false);
    const uint32_t settled = machine.step;
    assert_true(settled > 0);
    machine.changes = 0;
    run(3600, false); /* In a game nothing is tried. */
    assert_int_equal(machine.changes, 0);
    const uint32_t late = run(3600, true);
    print_message("an hour: %u changes, %u frames late\n", machine.changes, late);
    assert_in_range(machine.changes, 2, 16);
    assert_true(late < 600u);
    machine.best_ns = 12 * MS; /* What made it slow went. */
    run(2u * GOVERNOR_PATIENCE_MAX_S, true);
    assert_int_equal(machine.step, 0);
}

static void test_a_slow_screen_is_no_slow_machine(void **state)
{
    (void)state;
    begin(14 * MS, 50);
    run(600, true);
    assert_int_equal(machine.step, 0);
    begin(14 * MS, 30);
    run(600, true);
    assert_int_equal(machine.step, 0);
    begin(6 * MS, 144); /* The game has 60; a frame may take two of its turns. */
    machine.best_ns = 10 * MS;
    run(600, true);
    assert_int_equal(machine.step, 0);
}

static void test_a_stall_says_nothing_of_drawing(void **state)
{
    (void)state;
    begin(14 * MS, 60);
    for (uint32_t i = 0; i < 100; i++) {
        run(3, true);
        machine.now_ns += 2 * S;
    }
    assert_int_equal(machine.step, 0);
}

static void test_heat_is_answered_at_once_and_forgiven_when_it_is_cool(void **state)
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
    quality_governor_set_temperature(&machine.governor,
                                     GOVERNOR_HOT_MDEG); /* Neither hot nor cool: as it is. */
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
        cmocka_unit_test(test_a_machine_that_is_fast_enough_keeps_the_best_picture),
        cmocka_unit_test(test_a_slow_one_is_on_time_within_ten_seconds),
        cmocka_unit_test(test_no_machine_is_drawn_for_less_than_the_last_step),
        cmocka_unit_test(test_a_finer_picture_is_tried_between_games_and_ever_more_rarely),
        cmocka_unit_test(test_a_slow_screen_is_no_slow_machine),
        cmocka_unit_test(test_a_stall_says_nothing_of_drawing),
        cmocka_unit_test(test_heat_is_answered_at_once_and_forgiven_when_it_is_cool),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
