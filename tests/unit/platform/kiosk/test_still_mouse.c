/* test_still_mouse.c -- Tests that a mouse at rest does not count as moved when the view changes to
 * another tank.
 *
 * After this change, the same pixel shows another point of the water. The decoder and the frame
 * loop are real. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "core/tank/preset.h"
#include "drivers/null.h"
#include "drivers/sim/hal_sim.h"
#include "drivers/sim/pointer_sim.h"
#include "platform/kiosk/kiosk.h"

static struct {
    struct clock_sim clock;
    struct pointer_sim poi;
    struct hal hal;
    struct kiosk kiosk;
    struct pointer_report report;
} rig;

static void frame(uint64_t frame_ns)
{
    rig.clock.now_ns += frame_ns;
    rig.report.time_ns = rig.clock.now_ns;
    rig.poi.reports = &rig.report;
    rig.poi.feed.count = 1;
    rig.poi.feed.next = 0;
    kiosk_frame(&rig.kiosk, &rig.hal);
}

/* Starts a kiosk in attract mode with the pointer a little below the middle of the window. */
static void start_attract(void)
{
    const struct kiosk_config config = { .core = { .seed = 5, .modes = 1u << MODE_CHAMPIONSHIP } };
    memset(&rig, 0, sizeof rig);
    rig.report = (struct pointer_report){
        .x_px = 640.0f, .y_px = 400.0f, .width_px = 1280, .height_px = 720
    };
    rig.hal = null_hal(NULL);
    rig.hal.clock = sim_clock_device(&rig.clock);
    pointer_sim_init(&rig.poi, rig.hal.clock, &tank_preset(TANK_PRESET_FESTIVAL)->view);
    rig.hal.poi[0] = pointer_sim_devices(&rig.poi).poi;
    assert_int_equal(kiosk_init(&rig.kiosk, &rig.hal, &config), CORE_OK);
    for (uint32_t i = 0; i < 10; i++) {
        frame(16666667ull);
    }
}

static vec3 hand_m(void)
{
    return rig.kiosk.core.game.control[0].validation.newest.position_m;
}

static void lie_still(uint64_t frame_ns)
{
    start_attract();
    rig.kiosk.input.pressed = INPUT_START;
    frame(frame_ns);
    const vec3 before_m = hand_m();
    assert_int_equal(rig.kiosk.core.game.phase, PHASE_READY);
    while (rig.kiosk.core.game.phase == PHASE_READY) {
        frame(frame_ns);
        assert_int_equal(rig.kiosk.core.game.player[0].fouls, 0);
    }
    /* The new view changes the position on the water as much as a movement of the mouse would. */
    assert_true(v3_length(v3_sub(hand_m(), before_m)) > PLAYER_STIR_M);
}

static void test_a_mouse_at_rest_commits_no_foul(void **state)
{
    (void)state;
    lie_still(16666667ull);
}

static void test_a_mouse_at_rest_commits_no_foul_at_a_low_frame_rate(void **state)
{
    (void)state;
    lie_still(130000000ull);
    lie_still(900000000ull);
}

static void test_a_mouse_moved_and_held_over_fish_commits_a_foul(void **state)
{
    (void)state;
    start_attract();
    rig.kiosk.input.pressed = INPUT_START;
    for (uint32_t i = 0; i < 90; i++) {
        frame(16666667ull);
    }
    rig.report.x_px = 700.0f;
    while (rig.kiosk.core.game.phase != PHASE_ROUND) {
        frame(16666667ull);
    }
    assert_int_equal(rig.kiosk.core.game.player[0].fouls, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_mouse_at_rest_commits_no_foul),
        cmocka_unit_test(test_a_mouse_at_rest_commits_no_foul_at_a_low_frame_rate),
        cmocka_unit_test(test_a_mouse_moved_and_held_over_fish_commits_a_foul),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
