/* test_poi_scoops.c -- tests that fish can be caught with the motion of `kingyo-poi run
 * --simulate`. The computed motion passes through the simulated wires, analog converter and
 * gyroscope, then through USB reports, and then through the kiosk's decoder and input
 * validation. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "board/poi-gadget/sensor_twin.h"
#include "core/game/control/controller.h"
#include "core/tank/preset.h"
#include "drivers/hid/poi_report.h"
#include "drivers/hid/poi_hid.h"
#include "drivers/null.h"
#include "platform/kiosk/kiosk.h"
#include "tests/unit/support/hid_wire.h"

/* Time between two reports in ns, for 250 reports per second. */
#define REPORT_NS 4000000ull
#define FRAME_NS 16666667ull

static struct {
    struct clock_sim clock;
    struct hid_wire wire;
    struct poi_hid poi;
    struct hal hal;
    struct kiosk kiosk;
    struct poi_config config;
    struct sensor_twin_source twin;
    struct pose_source source;
    uint64_t next_report_ns;
    uint8_t sequence;
} rig;

static void frame(void)
{
    rig.clock.now_ns += FRAME_NS;
    for (; rig.next_report_ns <= rig.clock.now_ns; rig.next_report_ns += REPORT_NS) {
        struct poi_report report;
        uint8_t bytes[POI_REPORT_SIZE];
        rig.source.step(rig.source.self, (float)REPORT_NS * 1e-9f, &report);
        report.sequence = rig.sequence++;
        poi_report_encode(&report, bytes);
        hid_port_sim_report(&rig.wire.port, bytes, sizeof bytes);
    }
    kiosk_frame(&rig.kiosk, &rig.hal);
}

static void begin(uint32_t seed)
{
    const struct kiosk_config config = { .core = { .seed = seed, .fish_count = 300 } };
    memset(&rig, 0, sizeof rig);
    wire_begin(&rig.wire, &rig.clock, poi_descriptor, POI_DESCRIPTOR_SIZE);
    poi_config_init(&rig.config);
    sensor_twin_calibrate(&rig.config);
    rig.source = sensor_twin_source(&rig.twin, &rig.config);
    rig.hal = null_hal(NULL);
    rig.hal.clock = sim_clock_device(&rig.clock);
    poi_hid_init(&rig.poi, &rig.wire.port.port, rig.hal.clock, (struct hid_mapper){ 0 },
                 &tank_preset(TANK_PRESET_FESTIVAL)->view);
    rig.hal.poi[0] = poi_hid_devices(&rig.poi).poi;
    rig.hal.buttons = poi_hid_devices(&rig.poi).buttons;
    assert_int_equal(kiosk_init(&rig.kiosk, &rig.hal, &config), CORE_OK);
}

static void test_a_simulated_poi_starts_a_round_and_catches_fish(void **state)
{
    (void)state;
    uint32_t landed = 0, dips = 0, lost_frames = 0, round_frames = 0, rounds = 0;
    for (uint32_t seed = 1; seed <= 2; seed++) {
        begin(seed);
        for (uint32_t n = 0; n < 90 * 60; n++) {
            const struct game *game = &rig.kiosk.core.game;
            const uint8_t before = game->phase;
            const uint32_t caught = game->player[0].caught;
            const float before_m = rig.kiosk.core.world.poi[0].position_m.y;
            frame();
            const int plays = game->phase == PHASE_ROUND;
            rounds += plays && before != PHASE_ROUND;
            round_frames += (uint32_t)plays;
            lost_frames += plays && controller_is_lost(&rig.kiosk.core.world, 0);
            landed += game->player[0].caught > caught ? game->player[0].caught - caught : 0;
            dips +=
                plays && before_m > -0.02f && rig.kiosk.core.world.poi[0].position_m.y <= -0.02f;
        }
    }
    print_message("# %u rounds, %u frames: %u fish in %u dips; %u frames not believed\n", rounds,
                  round_frames, landed, dips, lost_frames);
    assert_true(rounds >= 2);
    assert_int_equal(lost_frames, 0);
    assert_true(dips >= 10);
    /* The motion follows a script that does not aim at fish. The test therefore requires only half
     * of the fish that a player usually catches. */
    assert_true(landed >= 4);
    assert_int_equal(rig.poi.decoder.refused_count + rig.poi.decoder.gap_count, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_a_simulated_poi_starts_a_round_and_catches_fish),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
