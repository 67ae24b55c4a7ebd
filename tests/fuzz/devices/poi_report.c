/* poi_report.c -- fuzz target: arbitrary bytes as an input report of the Kingyo poi, and as a force
 * feedback report to the poi. Every accepted value must be within its range, and must not change
 * when it is encoded and decoded again. */
#include <math.h>
#include <string.h>

#include "drivers/hid/poi_report.h"
#include "tests/fuzz/trap.h"

static void hold_pose(const uint8_t *bytes, uint32_t size)
{
    struct poi_report report, again;
    uint8_t written[POI_REPORT_SIZE];
    if (!poi_report_decode(bytes, size, &report)) {
        return;
    }
    const vec3 at = report.target.position_m;
    HOLD(size == POI_REPORT_SIZE && fabsf(at.x) <= POI_REPORT_REACH_M);
    HOLD(fabsf(at.y) <= POI_REPORT_REACH_M && fabsf(at.z) <= POI_REPORT_REACH_M);
    poi_report_encode(&report, written);
    HOLD(memcmp(written, bytes, sizeof written) == 0);
    HOLD(poi_report_decode(written, sizeof written, &again));
    HOLD(again.sequence == report.sequence && again.buttons == report.buttons);
}

static void hold_feel(const uint8_t *bytes, uint32_t size)
{
    struct poi_force force;
    uint8_t written[POI_FORCE_SIZE], sequence = 0;
    if (!poi_force_decode(bytes, size, &force, &sequence)) {
        return;
    }
    HOLD(size == POI_FORCE_SIZE && sequence == bytes[1]);
    poi_force_encode(&force, sequence, written);
    HOLD(memcmp(written, bytes, sizeof written) == 0);
}

/* Encodes arbitrary floats. Checks that the encoder limits them to their range and that they can be
 * decoded again. */
static void hold_wild(const uint8_t *bytes, size_t size)
{
    struct poi_force force = { 0 }, again;
    uint8_t written[POI_FORCE_SIZE];
    memcpy(&force, bytes, size < sizeof force ? size : sizeof force);
    poi_force_encode(&force, 7u, written);
    HOLD(poi_force_decode(written, sizeof written, &again, NULL));
    HOLD(fabsf(again.force_n.x) <= POI_FORCE_N_MAX);
    HOLD(fabsf(again.torque_n_m.z) <= POI_TORQUE_N_M_MAX);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    hold_pose(bytes, (uint32_t)size);
    hold_feel(bytes, (uint32_t)size);
    hold_wild(bytes, size);
    return 0;
}
