/* poi_board.c -- fuzz target: arbitrary bits as sensor values of a poi's board. If the report that
 * the board makes of them contains a position, the kiosk's decoder must accept the report;
 * otherwise the decoder must reject it. The motor value must stay within its range. */
#include <string.h>

#include "board/poi-gadget/attitude.h"
#include "board/poi-gadget/motor.h"
#include "board/poi-gadget/sensor_twin.h"
#include "tests/fuzz/trap.h"

struct moment {
    float wire[3], turn[4], gyro[3], accel[3];
    float drag, slap, tear;
    uint8_t fuses, buttons;
};

static void hold_report(const struct poi_report *report)
{
    const struct angles turn = report->target.angles;
    uint8_t bytes[POI_REPORT_SIZE];
    struct poi_report read;
    HOLD(f_is_finite(turn.yaw_rad) && f_is_finite(turn.pitch_rad) && f_is_finite(turn.roll_rad));
    HOLD(f_abs(turn.yaw_rad) < 3.15f && f_abs(turn.pitch_rad) < 1.58f);
    poi_report_encode(report, bytes);
    HOLD(poi_report_decode(bytes, sizeof bytes, &read) == v3_is_finite(report->target.position_m));
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    struct poi_config config;
    struct board_pose pose;
    struct motor_mix mix = { 0 };
    struct moment now;
    poi_config_init(&config);
    sensor_twin_calibrate(&config);
    board_pose_init(&pose, &config);
    for (; size >= sizeof now; bytes += sizeof now, size -= sizeof now) {
        struct readings readings = { 0 };
        struct poi_report report = { 0 };
        memcpy(&now, bytes, sizeof now);
        memcpy(readings.wire, now.wire, sizeof now.wire);
        readings.fuses = now.fuses & 1u;
        readings.turn = (struct quaternion){ now.turn[0], now.turn[1], now.turn[2], now.turn[3] };
        readings.gyro_rad_s = v3(now.gyro[0], now.gyro[1], now.gyro[2]);
        readings.accel_m_s2 = v3(now.accel[0], now.accel[1], now.accel[2]);
        readings.buttons = now.buttons;
        board_pose_step(&pose, &readings, 0.004f, &report);
        hold_report(&report);
        const struct poi_force force = { .drag = now.drag, .slap = now.slap, .tear = now.tear };
        const struct feel_levels levels = motor_mix_step(&mix, &force, 0.004f);
        HOLD(levels.motor >= 0.0f && levels.motor <= 1.0f);
        HOLD(levels.light >= 0.0f && levels.light <= 1.0f);
    }
    return 0;
}
