/* test_float_env.c -- checks that the state's hash stays the same if a library changes the
 * floating-point mode. The core refuses to run in a wrong mode, and the kiosk resets the mode
 * before each frame. */
#include <fenv.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/base/float_env.h"
#include "core/core.h"
#include "drivers/null.h"
#include "drivers/sim/hal_sim.h"
#include "platform/cpu.h"
#include "platform/kiosk/kiosk.h"

#define FRAME_NS 16666667ull

static const struct kiosk_config config = { .core = { .seed = 3, .fish_count = 20 } };

#ifdef __x86_64__
#define MODE_COUNT_HERE 5
#else
#define MODE_COUNT_HERE 3
#endif

/* Sets the wrong floating-point mode number `mode` in the calling thread. */
static void leave_mode(int mode)
{
    static const int directions[] = { FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO };
    cpu_set_float();
    if (mode < 3) {
        fesetround(directions[mode]);
    }
#ifdef __x86_64__
    static const uint32_t flush = 1u << 15, denormals_are_zero = 1u << 6;
    if (mode >= 3) {
        __builtin_ia32_ldmxcsr(0x1f80u | (mode == 3 ? flush : denormals_are_zero));
    }
#endif
}

static int restore(void **state)
{
    (void)state;
    fesetround(FE_TONEAREST);
    cpu_set_float();
    return 0;
}

static void test_the_check_finds_each_wrong_mode_and_the_platform_resets_it(void **state)
{
    (void)state;
    assert_int_equal(cpu_set_float(), 0);
    assert_true(float_env_is_standard());
    for (int mode = 0; mode < MODE_COUNT_HERE; mode++) {
        leave_mode(mode);
        const int is_standard = float_env_is_standard();
        const int was_other = cpu_set_float();
        assert_int_equal(is_standard, 0);
        assert_int_equal(was_other, 1);
        assert_true(float_env_is_standard());
    }
}

static void test_status_flags_are_no_wrong_mode(void **state)
{
    (void)state;
    feraiseexcept(FE_INEXACT | FE_UNDERFLOW | FE_OVERFLOW);
    assert_int_equal(cpu_set_float(), 0);
    assert_true(float_env_is_standard());
}

static void test_a_core_does_not_start_in_a_wrong_mode(void **state)
{
    (void)state;
    static struct core core, before;
    memset(&core, 0x5a, sizeof core);
    before = core;
    for (int mode = 0; mode < MODE_COUNT_HERE; mode++) {
        leave_mode(mode);
        const enum core_error error = core_init(&core, &config.core);
        cpu_set_float();
        assert_int_equal(error, CORE_ERR_FLOAT);
        assert_memory_equal(&core, &before, sizeof core);
    }
}

static void test_the_first_tick_of_a_second_is_rejected_in_a_wrong_mode(void **state)
{
    (void)state;
    static struct core core, before;
    static struct output output, output_before;
    const struct input input = { .poi[0].link = POI_SOURCE_BOT };
    assert_int_equal(core_init(&core, &config.core), CORE_OK);
    for (uint32_t i = 0; i < CORE_TICK_HZ; i++) {
        assert_int_equal(core_tick(&core, &input, &output), CORE_OK);
    }
    before = core;
    output_before = output;
    for (int mode = 0; mode < MODE_COUNT_HERE; mode++) {
        leave_mode(mode);
        const enum core_error error = core_tick(&core, &input, &output);
        cpu_set_float();
        assert_int_equal(error, CORE_ERR_FLOAT);
        assert_memory_equal(&core, &before, sizeof core);
        assert_memory_equal(&output, &output_before, sizeof output);
    }
    assert_int_equal(core_tick(&core, &input, &output), CORE_OK);
    assert_int_equal(core.game.tick, CORE_TICK_HZ + 1u);
}

/* ---- The frame loop ------------------------------------------------------------------------- */

/* Number of the wrong floating-point mode that the simulated display sets after each picture. -1
 * means that the display does not change the mode. */
static int mode_left = -1;

static int present(void *self, const struct scene *scene)
{
    (void)self;
    (void)scene;
    if (mode_left >= 0) {
        leave_mode(mode_left);
    }
    return HAL_OK;
}

/* Plays `frames` frames with a display that sets the wrong mode `mode` after each picture; -1 means
 * that it does not change the mode. Returns the state's hash, and writes how often the kiosk reset
 * the mode to `resets`. */
static uint64_t play(int mode, uint32_t frames, uint32_t *resets)
{
    static struct kiosk kiosk;
    struct clock_sim clock = { .now_ns = 1000000000ull };
    struct hal hal = null_hal(NULL);
    struct hal_display_ops ops = *hal.display.ops;
    struct kiosk_config with = config;
    with.bot[0] = 1;
    mode_left = mode;
    ops.present = present;
    hal.display.ops = &ops;
    hal.clock = sim_clock_device(&clock);
    assert_int_equal(kiosk_init(&kiosk, &hal, &with), CORE_OK);
    for (uint32_t i = 0; i < frames; i++) {
        clock.now_ns += FRAME_NS;
        kiosk.input.pressed = i == 30u ? INPUT_START : 0;
        assert_int_equal(kiosk_frame(&kiosk, &hal), KIOSK_RUNS);
    }
    cpu_set_float();
    *resets = kiosk.float_resets;
    return core_hash(&kiosk.core);
}

static void test_a_library_that_leaves_a_wrong_mode_in_each_frame_changes_no_hash(void **state)
{
    (void)state;
    uint32_t resets;
    const uint64_t hash = play(-1, 600, &resets);
    assert_int_equal(resets, 0);
    for (int mode = 0; mode < MODE_COUNT_HERE; mode++) {
        assert_true(play(mode, 600, &resets) == hash);
        /* The display sets a wrong mode after each of the 600 frames, so the kiosk must reset the
         * mode before each frame except the first. */
        assert_int_equal(resets, 599);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_the_check_finds_each_wrong_mode_and_the_platform_resets_it),
        cmocka_unit_test(test_status_flags_are_no_wrong_mode),
        cmocka_unit_test(test_a_core_does_not_start_in_a_wrong_mode),
        cmocka_unit_test(test_the_first_tick_of_a_second_is_rejected_in_a_wrong_mode),
        cmocka_unit_test(test_a_library_that_leaves_a_wrong_mode_in_each_frame_changes_no_hash),
    };
    return cmocka_run_group_tests(tests, NULL, restore);
}
