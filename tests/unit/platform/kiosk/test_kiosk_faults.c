/* test_kiosk_faults.c -- Tests controllers that fail during a scoop, in the real frame loop.
 *
 * No fault of a controller may tear the paper, and a recording of the faults must replay exactly.
 * The paper is wet, of the weakest grade, and 6 cm below the water surface. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "core/game/control/controller.h"
#include "core/game/phases.h"
#include "drivers/null.h"
#include "drivers/sim/hal_sim.h"
#include "drivers/sim/pointer_sim.h"
#include "drivers/sim/sensor_sim.h"
#include "platform/kiosk/kiosk.h"
#include "platform/kiosk/recorder/replayer.h"

#define MS 1000000ull
#define FRAME_NS 16666667ull

static struct rig {
    struct clock_sim clock;
    struct sensor_sim sensor;
    struct pointer_sim pointer;
    struct pointer_report report; /* The only pointer report of the next frame. */
    struct hal hal;
    struct kiosk kiosk;
    uint32_t lost_frames, age_max;
} rig;

static const struct kiosk_config config = {
    .core = { .seed = 4, .fish_count = 20, .round_s = 60, .grade = 7 },
};

static struct poi_input *seen(void)
{
    return &rig.kiosk.input.poi[0];
}

static void frame(void)
{
    rig.clock.now_ns += FRAME_NS;
    rig.report.time_ns = rig.clock.now_ns;
    rig.pointer.feed.next = 0;
    assert_int_equal(kiosk_frame(&rig.kiosk, &rig.hal), KIOSK_RUNS);
    rig.lost_frames += (uint32_t)controller_is_lost(&rig.kiosk.core.world, 0);
    rig.age_max = seen()->age_ticks > rig.age_max ? seen()->age_ticks : rig.age_max;
}

static void frames(uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        frame();
    }
}

static void open_kiosk(const struct kiosk_config *with)
{
    memset(&rig, 0, sizeof rig);
    rig.clock.now_ns = 1000 * MS;
    rig.hal = null_hal(NULL);
    rig.hal.clock = sim_clock_device(&rig.clock);
    sensor_sim_init(&rig.sensor, rig.hal.clock, 250);
    rig.sensor.pose.position_m = v3(0.05f, 0.06f, 0.02f);
    rig.hal.poi[0] = sensor_sim_device(&rig.sensor);
    assert_int_equal(kiosk_init(&rig.kiosk, &rig.hal, with), CORE_OK);
}

static void start_round(void)
{
    frames(5);
    rig.kiosk.input.pressed = INPUT_START;
    while (rig.kiosk.core.game.phase != PHASE_ROUND) {
        frame();
    }
    frames(100);
}

static void wet_all(void)
{
    struct sheet *sheet = &rig.kiosk.core.world.poi[0].sheet;
    for (uint32_t cell = 0; cell < SHEET_CELL_COUNT; cell++) {
        sheet->wetness[cell] = 1.0f;
    }
    sheet->touched = sheet->soaked = 1;
}

static void dip(void)
{
    while (rig.sensor.pose.position_m.y > -0.06f) {
        rig.sensor.pose.position_m.y -= 0.1f * 1.0f / 60.0f;
        frame();
    }
    frames(60);
    wet_all();
}

static void sway(uint32_t count)
{
    for (uint32_t i = 0; i < count; i++) {
        rig.sensor.pose.position_m.x += i / 60u % 2u ? -0.0008f : 0.0008f;
        frame();
    }
}

static void break_for(enum sensor_fault fault, uint64_t ms)
{
    rig.sensor.fault = (uint8_t)fault;
    rig.sensor.from_ns = rig.clock.now_ns + 1u;
    rig.sensor.to_ns = rig.sensor.from_ns + ms * MS;
    rig.lost_frames = rig.age_max = 0;
}

/* ---- Tests with a six-axis sensor ----------------------------------------------------------- */

static void test_a_sensor_fault_pauses_the_round_and_tears_no_paper(void **state)
{
    static const struct {
        enum sensor_fault fault;
        uint32_t ms, lost_min, lost_max; /* Duration of the fault in ms, and limits for the number
                                            of frames without valid input. */
    } cases[] = {
        /* The kiosk tries to reopen a missing device once a second, so the input is lost for up to
         * one second longer than the device. */
        { SENSOR_GONE, 700, 40, 160 },
        { SENSOR_SILENT, 1200, 50, 70 }, /* The input counts as lost from 0.5 s after the last
                                            report until 0.25 s after the fault. */
        { SENSOR_SILENT, 300, 0, 0 },
        { SENSOR_HELD_BACK, 300, 0, 0 },
        { SENSOR_HELD_BACK, 1200, 50, 70 },
        { SENSOR_STUCK, 2000, 70, 85 },  /* The input counts as lost after 1 s with the same
                                            pose. */
        { SENSOR_JUMPED, 8, 14, 20 },    /* The input counts as lost for 0.25 s after a jump. */
        { SENSOR_JUMPED, 1500, 14, 40 }, /* The input is lost twice: at the jump, and when the pose
                                            jumps back. */
        { SENSOR_FLIPPED, 100, 18, 30 },
        { SENSOR_NOT_A_NUMBER, 100, 18, 30 },
        { SENSOR_GARBAGE, 500, 40, 50 },
        { SENSOR_TWICE, 1000, 0, 0 },
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        open_kiosk(&config);
        start_round();
        dip();
        const struct poi *poi = &rig.kiosk.core.world.poi[0];
        const uint32_t cells = poi->sheet.paper_cells;
        const uint32_t begin_tick = rig.kiosk.core.game.tick;
        const float left_s = game_seconds_left(&rig.kiosk.core.game, begin_tick);
        break_for(cases[i].fault, cases[i].ms);
        sway(400);
        print_message("fault %d: lost for %u frames, age %u\n", (int)cases[i].fault,
                      rig.lost_frames, rig.age_max);
        assert_in_range(rig.lost_frames, cases[i].lost_min, cases[i].lost_max);
        assert_int_equal(poi->sheet.paper_cells, cells);
        assert_false(controller_is_lost(&rig.kiosk.core.world, 0));
        assert_true(v3_length(v3_sub(poi->position_m, rig.sensor.pose.position_m)) < 0.02f);
        const float passed_s =
            left_s - game_seconds_left(&rig.kiosk.core.game, rig.kiosk.core.game.tick);
        const float played_s = (float)(800u - 2u * rig.lost_frames) * CORE_TICK_S;
        assert_float_equal(passed_s, played_s, 0.02f);
    }
}

static void test_the_pose_age_is_that_of_the_newest_report(void **state)
{
    (void)state;
    open_kiosk(&config);
    frames(30);
    assert_int_equal(seen()->trembles, 1);
    assert_int_equal(seen()->has_wrist, 1);
    assert_int_equal(rig.age_max, 0);
    break_for(SENSOR_SILENT, 400);
    frames(24);
    assert_in_range(rig.age_max, 46, 48);
    frames(10);
    assert_int_equal(seen()->age_ticks, 0);
}

static void test_non_finite_poses_are_counted_as_faults_and_passed_to_the_core(void **state)
{
    (void)state;
    uint32_t none = 0;
    open_kiosk(&config);
    frames(30);
    assert_int_equal(rig.kiosk.faults.poi, 0);
    break_for(SENSOR_NOT_A_NUMBER, 200);
    for (uint32_t i = 0; i < 12; i++) {
        frame();
        const struct poi_target *target = &seen()->target;
        none += !v3_is_finite(target->position_m) ||
                !f_is_finite(target->angles.yaw_rad + target->angles.pitch_rad +
                             target->angles.roll_rad);
    }
    assert_in_range(none, 11, 12);
    assert_in_range(rig.kiosk.faults.poi, 48, 52);
}

/* ---- Tests with a pointer (mouse) ----------------------------------------------------------- */

static void open_with_pointer(void)
{
    open_kiosk(&config);
    pointer_sim_init(&rig.pointer, rig.hal.clock, &rig.kiosk.scene.view);
    rig.pointer.reports = &rig.report;
    rig.pointer.feed.count = 1;
    rig.report =
        (struct pointer_report){ .x_px = 640, .y_px = 400, .width_px = 1280, .height_px = 720 };
    rig.hal.poi[0] = pointer_sim_devices(&rig.pointer).poi;
    assert_int_equal(kiosk_init(&rig.kiosk, &rig.hal, &config), CORE_OK);
}

static void test_a_pointer_jump_under_water_tears_no_paper(void **state)
{
    (void)state;
    open_with_pointer();
    start_round();
    rig.report.x_px = 250.0f;
    frames(40);
    rig.report.buttons = POINTER_DIP;
    frames(60);
    wet_all();
    const uint32_t cells = rig.kiosk.core.world.poi[0].sheet.paper_cells;
    rig.lost_frames = 0;
    rig.report.x_px = 1030.0f;
    frames(240);
    assert_int_equal(rig.lost_frames, 0); /* The poi moves to the new position at a limited speed,
                                             so the jump of the pointer is not an input loss. */
    assert_int_equal(rig.kiosk.core.world.poi[0].sheet.paper_cells, cells);
    assert_float_equal(rig.kiosk.core.world.poi[0].position_m.x, seen()->target.position_m.x,
                       0.01f);
}

/* Moves the pointer across the screen 14 times, to the right and to the left in turn, as a player
 * does who shakes the mouse. The first movement takes 6 frames and the last one 19. */
static void test_a_fast_mouse_movement_is_not_an_input_loss(void **state)
{
    (void)state;
    open_with_pointer();
    start_round();
    rig.lost_frames = 0;
    for (uint32_t frame_count = 6; frame_count < 20; frame_count++) {
        for (uint32_t i = 1; i <= frame_count; i++) {
            const float t = (float)i / (float)frame_count;
            const float share = f_smoothstep(0.0f, 1.0f, frame_count % 2u ? 1.0f - t : t);
            rig.report.x_px = f_floor(40.0f + 1200.0f * share);
            frame();
        }
        frames(20);
    }
    assert_int_equal(rig.lost_frames, 0);
}

static void test_random_pointer_reports_are_tolerated(void **state)
{
    (void)state;
    open_with_pointer();
    start_round();
    rig.pointer.feed.random_to = UINT32_MAX;
    rig.report.width_px = 1280;
    for (uint32_t i = 0; i < 600; i++) {
        rig.pointer.feed.random_from = i % 7u ? 0 : UINT32_MAX;
        frame();
        assert_true(v3_is_finite(seen()->target.position_m));
    }
    assert_true(rig.pointer.random_count > 500);
}

/* A mouse may rest for any time, here for 10 s, so an unchanged position must not count as a stuck
 * sensor. */
static void test_a_pointer_at_rest_never_times_out(void **state)
{
    (void)state;
    open_with_pointer();
    start_round();
    rig.lost_frames = rig.age_max = 0;
    frames(600);
    assert_int_equal(rig.lost_frames, 0);
    assert_int_equal(rig.age_max, 0);
    assert_int_equal(seen()->trembles, 0);
}

/* ---- Test with four players at one tank ----------------------------------------------------- */

static void test_one_faulty_sensor_pauses_all_four_players(void **state)
{
    static struct sensor_sim others[POI_MAX];
    struct kiosk_config four = config;
    (void)state;
    four.core.players = POI_MAX;
    open_kiosk(&four);
    const struct core *core = &rig.kiosk.core;
    for (uint32_t i = 1; i < POI_MAX; i++) {
        sensor_sim_init(&others[i], rig.hal.clock, 250);
        others[i].pose.position_m = v3(0.12f * (float)i - 0.3f, 0.06f, -0.08f);
        rig.hal.poi[i] = sensor_sim_device(&others[i]);
    }
    assert_int_equal(kiosk_init(&rig.kiosk, &rig.hal, &four), CORE_OK);
    start_round();
    for (uint32_t i = 1; i < POI_MAX; i++) {
        assert_true(v3_length(v3_sub(core->world.poi[i].position_m, others[i].pose.position_m)) <
                    0.01f);
    }
    for (uint32_t step = 0; step < 60; step++) {
        for (uint32_t i = 1; i < POI_MAX; i++) {
            others[i].pose.position_m.y -= 0.0015f;
        }
        frame();
    }
    break_for(SENSOR_NOT_A_NUMBER, 500);
    frames(15);
    const float left_s = game_seconds_left(&core->game, core->game.tick);
    frames(15);
    assert_float_equal(game_seconds_left(&core->game, core->game.tick), left_s, 0.001f);
    frames(240);
    assert_true(game_seconds_left(&core->game, core->game.tick) < left_s - 2.0f);
    for (uint32_t i = 1; i < POI_MAX; i++) {
        const struct sheet *sheet = &core->world.poi[i].sheet;
        assert_int_equal(sheet->paper_cells, sheet->paper_cells_new);
        assert_true(v3_length(v3_sub(core->world.poi[i].position_m, others[i].pose.position_m)) <
                    0.01f);
        assert_true(others[i].felt.force_n.y != 0.0f); /* The other three controllers still get
                                                          force feedback. */
    }
}

/* ---- Tests of view changes and replays ------------------------------------------------------ */

static void test_a_pointer_is_notified_when_the_view_changes(void **state)
{
    struct kiosk_config championship = config;
    (void)state;
    championship.core.modes = 1u << MODE_CHAMPIONSHIP;
    open_kiosk(&championship);
    assert_memory_equal(&rig.sensor.view, &rig.kiosk.scene.view, sizeof(struct view));
    const struct view before = rig.sensor.view;
    rig.kiosk.input.pressed = INPUT_START;
    frames(30);
    assert_int_equal(rig.kiosk.core.world.tank.preset, TANK_PRESET_OFFICIAL);
    assert_memory_equal(&rig.sensor.view, &rig.kiosk.scene.view, sizeof(struct view));
    assert_memory_not_equal(&rig.sensor.view, &before, sizeof(struct view));
}

static struct recorder recorder;
static struct replayer replayer;
static char path[] = "/tmp/kingyo-faults-XXXXXX";

/* Plays a round in which every kind of fault occurs, one after the other. */
static uint64_t play_them_all(void)
{
    start_round();
    dip();
    for (uint32_t fault = 1; fault < SENSOR_FAULT_COUNT; fault++) {
        break_for((enum sensor_fault)fault, 700);
        sway(90);
    }
    return core_hash(&rig.kiosk.core);
}

static void test_a_session_with_every_fault_replays_bit_for_bit(void **state)
{
    struct kiosk_config recorded = config;
    struct core_config from_file;
    struct input input;
    static struct core core;
    static struct output output;
    (void)state;
    const int fd = mkstemp(path);
    assert_true(fd >= 0 && close(fd) == 0);
    recorded.tap = recorder_tap(&recorder);
    open_kiosk(&recorded);
    assert_int_equal(recorder_begin(&recorder, path, &rig.kiosk.core), 0);
    start_round();
    for (uint32_t fault = 1; fault < SENSOR_FAULT_COUNT; fault++) {
        break_for((enum sensor_fault)fault, 700);
        sway(90);
    }
    const uint64_t hash = core_hash(&rig.kiosk.core);
    assert_int_equal(recorder_end(&recorder), 0);
    assert_int_equal(replayer_begin(&replayer, path, &from_file), 0);
    assert_int_equal(core_init(&core, &from_file), CORE_OK);
    const struct kiosk_source source = replayer_source(&replayer);
    const struct kiosk_tap tap = replayer_tap(&replayer);
    while (source.next(source.self, &input)) {
        core_tick(&core, &input, &output);
        tap.tick(tap.self, &input, &core);
    }
    replayer_end(&replayer);
    unlink(path);
    assert_int_equal(replayer.difference.found, 0);
    assert_true(core_hash(&core) == hash);
}

static void test_equal_faults_give_equal_sessions(void **state)
{
    (void)state;
    open_kiosk(&config);
    const uint64_t first = play_them_all();
    open_kiosk(&config);
    assert_true(play_them_all() == first);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_sensor_fault_pauses_the_round_and_tears_no_paper),
        cmocka_unit_test(test_the_pose_age_is_that_of_the_newest_report),
        cmocka_unit_test(test_non_finite_poses_are_counted_as_faults_and_passed_to_the_core),
        cmocka_unit_test(test_a_pointer_jump_under_water_tears_no_paper),
        cmocka_unit_test(test_a_fast_mouse_movement_is_not_an_input_loss),
        cmocka_unit_test(test_random_pointer_reports_are_tolerated),
        cmocka_unit_test(test_a_pointer_at_rest_never_times_out),
        cmocka_unit_test(test_one_faulty_sensor_pauses_all_four_players),
        cmocka_unit_test(test_a_pointer_is_notified_when_the_view_changes),
        cmocka_unit_test(test_a_session_with_every_fault_replays_bit_for_bit),
        cmocka_unit_test(test_equal_faults_give_equal_sessions),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
