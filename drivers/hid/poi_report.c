/* poi_report.c -- encodes the pose reports of Kingyo's poi controller, encodes and decodes its
 * force feedback reports, and contains the bytes of its HID report descriptor. */
#include "drivers/hid/poi_report.h"

#include <string.h>

/* Writes `v` as three 16-bit fields with the range +-`most`. A component that is not finite is
 * written as `otherwise`. Halves are rounded away from 0, so that opposite forces have opposite
 * encodings. */
static void put_vec3(uint8_t *bytes, vec3 v, float most, int32_t otherwise)
{
    const float components[3] = { v.x, v.y, v.z };
    for (uint32_t i = 0; i < 3; i++) {
        const bool is_finite = f_is_finite(components[i]);
        const float steps =
            is_finite ? f_clamp(components[i] / most, -1.0f, 1.0f) * POI_REPORT_FULL : 0.0f;
        const int32_t rounded = (int32_t)(steps < 0.0f ? steps - 0.5f : steps + 0.5f);
        const uint32_t bits = (uint32_t)(is_finite ? rounded : otherwise);
        bytes[2u * i] = (uint8_t)(bits & 255u);
        bytes[2u * i + 1u] = (uint8_t)(bits >> 8 & 255u);
    }
}

void poi_report_encode(const struct poi_report *report, uint8_t bytes[POI_REPORT_SIZE])
{
    const struct angles angles = report->target.angles;
    bytes[0] = POI_REPORT_ID;
    bytes[1] = report->sequence;
    put_vec3(bytes + 2, report->target.position_m, POI_REPORT_REACH_M, POI_REPORT_NONE);
    put_vec3(bytes + 8, v3(angles.pitch_rad, angles.yaw_rad, angles.roll_rad), F_PI,
             POI_REPORT_NONE);
    bytes[14] = report->buttons;
}

static uint8_t level_of(float share)
{
    /* NOLINTNEXTLINE(bugprone-incorrect-roundings): the value is not negative. */
    return f_is_finite(share) ? (uint8_t)(int32_t)(f_clamp(share, 0.0f, 1.0f) * 255.0f + 0.5f) : 0;
}

void poi_force_encode(const struct poi_force *force, uint8_t sequence,
                      uint8_t bytes[POI_FORCE_SIZE])
{
    bytes[0] = POI_FORCE_ID;
    bytes[1] = sequence;
    put_vec3(bytes + 2, force->force_n, POI_FORCE_N_MAX, 0);
    put_vec3(bytes + 8, force->torque_n_m, POI_TORQUE_N_M_MAX, 0);
    bytes[14] = level_of(force->drag);
    bytes[15] = level_of(force->slap);
    bytes[16] = level_of(force->tear);
}

bool poi_force_decode(const uint8_t *bytes, uint32_t size, struct poi_force *out, uint8_t *sequence)
{
    vec3 force_n, torque_n_m;
    if (size != POI_FORCE_SIZE || bytes[0] != POI_FORCE_ID ||
        !poi_report_get_vec3(bytes + 2, POI_FORCE_N_MAX, &force_n) ||
        !poi_report_get_vec3(bytes + 8, POI_TORQUE_N_M_MAX, &torque_n_m)) {
        return false;
    }
    *out = (struct poi_force){
        .force_n = force_n,
        .torque_n_m = torque_n_m,
        .drag = (float)bytes[14] / 255.0f,
        .slap = (float)bytes[15] / 255.0f,
        .tear = (float)bytes[16] / 255.0f,
    };
    if (sequence) {
        *sequence = bytes[1];
    }
    return true;
}

/* ---- Report descriptor ----------------------------------------------------------------------- */

/* The bytes have one item in each line (HID 1.11, section 6.2.2).
 *
 * Units follow the specification. In unit system 1 (centimeter, gram, second) a newton is 10^5 g
 * cm/s^2, and a newton meter is 10^7 g cm^2/s^2. Degrees belong to unit system 4. The physical
 * limits correspond to the logical limits and are integers. */
const uint8_t poi_descriptor[POI_DESCRIPTOR_SIZE] = {
    0x05, 0x01, /* Usage Page (Generic Desktop) */
    0x09, 0x08, /* Usage (Multi-axis Controller) */
    0xa1, 0x01, /* Collection (Application) */

    0x85, 0x01,       /*   Report ID (1): pose */
    0x06, 0x4b, 0xff, /*   Usage Page (POI_PAGE) */
    0x09, 0x01,       /*   Usage (sequence) */
    0x15, 0x00,       /*   Logical Minimum (0) */
    0x26, 0xff, 0x00, /*   Logical Maximum (255) */
    0x75, 0x08,       /*   Report Size (8) */
    0x95, 0x01,       /*   Report Count (1) */
    0x81, 0x0a,       /*   Input (Data, Variable, Absolute, Wrap) */

    0x05, 0x01,       /*   Usage Page (Generic Desktop) */
    0x09, 0x01,       /*   Usage (Pointer) */
    0xa1, 0x00,       /*   Collection (Physical) */
    0x09, 0x30,       /*     Usage (X): the player's right */
    0x09, 0x31,       /*     Usage (Y): up, 0 at the still water */
    0x09, 0x32,       /*     Usage (Z): toward the player */
    0x16, 0x01, 0x80, /*     Logical Minimum (-32767) */
    0x26, 0xff, 0x7f, /*     Logical Maximum (32767) */
    0x36, 0x18, 0xfc, /*     Physical Minimum (-1000) */
    0x46, 0xe8, 0x03, /*     Physical Maximum (1000) */
    0x65, 0x11,       /*     Unit (cm) */
    0x55, 0x0f,       /*     Unit Exponent (-1): mm */
    0x75, 0x10,       /*     Report Size (16) */
    0x95, 0x03,       /*     Report Count (3) */
    0x81, 0x42,       /*     Input (Data, Variable, Absolute, Null State): -32768 means no value */
    0x09, 0x33,       /*     Usage (Rx): pitch */
    0x09, 0x34,       /*     Usage (Ry): yaw */
    0x09, 0x35,       /*     Usage (Rz): roll */
    0x36, 0x4c, 0xff, /*     Physical Minimum (-180) */
    0x46, 0xb4, 0x00, /*     Physical Maximum (180) */
    0x65, 0x14,       /*     Unit (degree) */
    0x55, 0x00,       /*     Unit Exponent (0) */
    0x81, 0x42,       /*     Input (Data, Variable, Absolute, Null State) */
    0xc0,             /*   End Collection */

    0x05, 0x09, /*   Usage Page (Button) */
    0x19, 0x01, /*   Usage Minimum (1) */
    0x29, 0x08, /*   Usage Maximum (8) */
    0x15, 0x00, /*   Logical Minimum (0) */
    0x25, 0x01, /*   Logical Maximum (1) */
    0x35, 0x00, /*   Physical Minimum (0) */
    0x45, 0x01, /*   Physical Maximum (1) */
    0x65, 0x00, /*   Unit (none) */
    0x75, 0x01, /*   Report Size (1) */
    0x95, 0x08, /*   Report Count (8) */
    0x81, 0x02, /*   Input (Data, Variable, Absolute) */

    0x85, 0x02,       /*   Report ID (2): force feedback */
    0x06, 0x4b, 0xff, /*   Usage Page (POI_PAGE) */
    0x09, 0x02,       /*   Usage (POI_USAGE_FEEL) */
    0xa1, 0x02,       /*   Collection (Logical) */
    0x09, 0x01,       /*     Usage (sequence) */
    0x26, 0xff, 0x00, /*     Logical Maximum (255) */
    0x45, 0x00,       /* Physical Maximum (0): not declared */
    0x75, 0x08,       /*     Report Size (8) */
    0x95, 0x01,       /*     Report Count (1) */
    0x91, 0x0a,       /*     Output (Data, Variable, Absolute, Wrap) */
    0x19, 0x10,       /*     Usage Minimum (force X) */
    0x29, 0x12,       /*     Usage Maximum (force Z) */
    0x16, 0x01, 0x80, /*     Logical Minimum (-32767) */
    0x26, 0xff, 0x7f, /*     Logical Maximum (32767) */
    0x35, 0xec,       /*     Physical Minimum (-20) */
    0x45, 0x14,       /*     Physical Maximum (20) */
    0x66, 0x11, 0xe1, /*     Unit (g cm/s^2) */
    0x55, 0x05,       /*     Unit Exponent (5): N */
    0x75, 0x10,       /*     Report Size (16) */
    0x95, 0x03,       /*     Report Count (3) */
    0x91, 0x02,       /*     Output (Data, Variable, Absolute) */
    0x19, 0x13,       /*     Usage Minimum (torque X) */
    0x29, 0x15,       /*     Usage Maximum (torque Z) */
    0x35, 0xfc,       /*     Physical Minimum (-4) */
    0x45, 0x04,       /*     Physical Maximum (4) */
    0x66, 0x21, 0xe1, /*     Unit (g cm^2/s^2) */
    0x55, 0x07,       /*     Unit Exponent (7): N m */
    0x91, 0x02,       /*     Output (Data, Variable, Absolute) */
    0x19, 0x16,       /*     Usage Minimum (drag) */
    0x29, 0x18,       /*     Usage Maximum (tear) */
    0x15, 0x00,       /*     Logical Minimum (0) */
    0x26, 0xff, 0x00, /*     Logical Maximum (255) */
    0x35, 0x00,       /*     Physical Minimum (0) */
    0x45, 0x01,       /*     Physical Maximum (1) */
    0x65, 0x00,       /*     Unit (none) */
    0x55, 0x00,       /*     Unit Exponent (0) */
    0x75, 0x08,       /*     Report Size (8) */
    0x91, 0x02,       /*     Output (Data, Variable, Absolute) */
    0xc0,             /*   End Collection */
    0xc0,             /* End Collection */
};

bool poi_descriptor_is(const uint8_t *bytes, uint32_t size)
{
    return size == POI_DESCRIPTOR_SIZE && memcmp(bytes, poi_descriptor, size) == 0;
}
