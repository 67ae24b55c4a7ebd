/* poi_report.h -- the two reports of Kingyo's poi controller, byte by byte (pose and force
 * feedback), and the HID report descriptor that declares them. Kingyo's poi controller is the paper
 * scoop with sensors that this project defines.
 *
 * Pure: uses no device and no clock. Numbers are two's complement in little-endian order. The
 * values of a 16-bit field range from -32767 to 32767, so that the range is symmetric. The number
 * -32768 means that there is no value.
 *
 *   input, id 1, 15 bytes                     output, id 2, 17 bytes
 *    0      id                                 0      id
 *    1      sequence, 0 .. 255, wraps           1      sequence, wraps
 *    2.. 7  X Y Z: +-1 m, world axes            2.. 7  force X Y Z: +-POI_FORCE_N_MAX
 *    8..13  Rx Ry Rz: +-pi, pitch yaw roll      8..13  torque X Y Z: +-POI_TORQUE_N_M_MAX
 *   14      buttons, enum poi_button           14..16  drag, slap, tear: 0 .. 255 is 0 .. 1
 *
 * The array `poi_descriptor` is the only definition of the descriptor's bytes, from which the host
 * reads this format. The kiosk recognizes Kingyo's poi controller by the descriptor, independent of
 * the vendor and product id. The program kingyo-poi passes the bytes to the kernel of the board
 * inside the controller (board/poi-gadget/, whose README explains the bytes). A test compares the
 * bytes with the reports field by field. After a change of the descriptor, controllers with the
 * previous descriptor are no longer recognized. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/base/fmath.h"
#include "core/output.h"

#define POI_REPORT_ID 1u
#define POI_REPORT_SIZE 15u
#define POI_REPORT_REACH_M 1.0f /* Range of a position: +-1 m, in steps of 31 um. */
#define POI_FORCE_ID 2u
#define POI_FORCE_SIZE 17u

/* Keys on the handle of Kingyo's poi controller. Bit 0 is HID Button 1. Bits 5 to 7 are free for
 * vendors. */
enum poi_button {
    /* OK key under the thumb. The key is HID Button 1, which other programs use as the main
     * button. */
    POI_BUTTON_OK = 1u << 0,
    POI_BUTTON_START = 1u << 1,
    POI_BUTTON_LEFT = 1u << 2,
    POI_BUTTON_RIGHT = 1u << 3,
    POI_BUTTON_FAN = 1u << 4, /* FAN key: while the key is pressed, the controller moves the fan. */
};

/* Content of an input report. Angles are within +-pi, as in struct angles. */
struct poi_report {
    struct poi_target target;
    uint8_t buttons; /* Pressed keys, as bits of enum poi_button. */
    /* Number that increases by 1 with each report and returns to 0 after 255. A gap means that
     * reports were lost. */
    uint8_t sequence;
};

/* Value of a full 16-bit field. */
#define POI_REPORT_FULL 32767.0f
/* Number in a 16-bit field that has no value. */
#define POI_REPORT_NONE (-32768)

/* Decodes three 16-bit fields with the range +-`most`. Returns false if a field has no value. */
static inline bool poi_report_get_vec3(const uint8_t bytes[6], float most, vec3 *out)
{
    float value[3];
    bool has_values = true;
    for (uint32_t i = 0; i < 3; i++) {
        const int32_t number = (int16_t)(bytes[2u * i] | bytes[2u * i + 1u] << 8);
        has_values = has_values && number != POI_REPORT_NONE;
        value[i] = (float)number * (most / POI_REPORT_FULL);
    }
    *out = v3(value[0], value[1], value[2]);
    return has_values;
}

/* Parses an input report of `size` bytes. Returns true. Returns false if the id or the length is
 * wrong, or if a coordinate has no value because the sensor lost its marker. After a failure `out`
 * is unchanged. */
static inline bool poi_report_decode(const uint8_t *bytes, uint32_t size, struct poi_report *out)
{
    vec3 position_m, angles_rad;
    if (size != POI_REPORT_SIZE || bytes[0] != POI_REPORT_ID ||
        !poi_report_get_vec3(bytes + 2, POI_REPORT_REACH_M, &position_m) ||
        !poi_report_get_vec3(bytes + 8, F_PI, &angles_rad)) {
        return false;
    }
    *out = (struct poi_report){
        .target = { .position_m = position_m,
                    .angles = { .yaw_rad = angles_rad.y,
                                .pitch_rad = angles_rad.x,
                                .roll_rad = angles_rad.z } },
        .buttons = bytes[14],
        .sequence = bytes[1],
    };
    return true;
}

/* Writes an input report. Values out of range are clamped. A value that is not finite is encoded as
 * "no value". */
void poi_report_encode(const struct poi_report *report, uint8_t bytes[POI_REPORT_SIZE]);

/* Writes a force feedback report. Values out of range are clamped. A value that is not finite is
 * encoded as 0, so that it drives no motor. Halves are rounded away from 0. */
void poi_force_encode(const struct poi_force *force, uint8_t sequence,
                      uint8_t bytes[POI_FORCE_SIZE]);

/* Parses a force feedback report. The device and its simulation call this function. Returns true.
 * Returns false if the id or the length is wrong or if a component has no value. After a failure
 * `out` is unchanged. `sequence` may be null. */
bool poi_force_decode(const uint8_t *bytes, uint32_t size, struct poi_force *out,
                      uint8_t *sequence);

/* ---- Report descriptor ----------------------------------------------------------------------- */

#define POI_DESCRIPTOR_SIZE 184u

/* Vendor-defined usage page. The HID Usage Tables reserve the pages FF00 to FFFF for vendors.
 * Another vendor may use the same page, so only the whole descriptor identifies Kingyo's poi
 * controller. */
#define POI_PAGE 0xff4bu

enum poi_usage { /* Usages of POI_PAGE. */
                 POI_USAGE_SEQUENCE = 0x01,
                 /* Usage of the collection that is the force feedback report. */
                 POI_USAGE_FEEL = 0x02,
                 /* First of three force usages, 0x10 to 0x12: X, Y, Z. */
                 POI_USAGE_FORCE_X = 0x10,
                 /* First of three torque usages, 0x13 to 0x15: X, Y, Z. */
                 POI_USAGE_TORQUE_X = 0x13,
                 /* First of three effect usages, 0x16 to 0x18: drag, slap, tear. */
                 POI_USAGE_DRAG = 0x16,
};

extern const uint8_t poi_descriptor[POI_DESCRIPTOR_SIZE];

/* Returns true if the bytes are exactly `poi_descriptor`. */
bool poi_descriptor_is(const uint8_t *bytes, uint32_t size);
