/* poi_report.h -- the two reports of our own poi, byte by byte: where it is, and what its hand is
 * made to feel.
 *
 * Pure: no device, no clock. Numbers are two's complement, low byte first. A field of 16 bits goes
 * from -32767 to 32767, so that both ends are as far from 0; -32768 says that there is no value.
 *
 *   input, id 1, 15 bytes                     output, id 2, 17 bytes
 *    0      id                                 0      id
 *    1      sequence, 0 .. 255 and round       1      sequence
 *    2.. 7  X Y Z: +-1 m of world               2.. 7  force X Y Z: +-POI_FORCE_N_MAX
 *    8..13  Rx Ry Rz: +-pi, pitch yaw roll       8..13  torque X Y Z: +-POI_TORQUE_N_M_MAX
 *   14      buttons, enum poi_button           14..16  drag, slap, tear: 0 .. 255 is 0 .. 1
 *
 * What the bytes mean is declared to the host by poi_descriptor.h. */
#ifndef KINGYO_DRIVERS_POI_REPORT_H
#define KINGYO_DRIVERS_POI_REPORT_H

#include <stdint.h>

#include "core/output.h"

#define POI_REPORT_ID 1u
#define POI_REPORT_SIZE 15u
#define POI_REPORT_REACH_M 1.0f /* A step is 31 um. */
#define POI_FEEL_ID 2u
#define POI_FEEL_SIZE 17u

/* Keys on a poi's handle; HID's Button 1 is bit 0. The other bits are a maker's own. */
enum poi_button {
    POI_BUTTON_OK = 1u << 0, /* Under the thumb, where any other program looks for a trigger. */
    POI_BUTTON_START = 1u << 1,
    POI_BUTTON_LEFT = 1u << 2,
    POI_BUTTON_RIGHT = 1u << 3,
    POI_BUTTON_FAN = 1u << 4, /* While it is down the hand holds a fan instead. */
};

/* What an input report says. Angles as struct angles has them, within +-pi. */
struct poi_report {
    struct poi_target target;
    uint8_t buttons;  /* enum poi_button levels. */
    uint8_t sequence; /* One more than the last's; a gap is reports that were lost. */
};

/* Reads `size` bytes. 0 and `out` as it was where they are no such report: another id, another
 * length, or a coordinate that says that there is none (the sensor has lost its mark). */
int poi_report_decode(const uint8_t *bytes, uint32_t size, struct poi_report *out);

/* Writes a report. What is beyond the range is its end; a number that is none is no value. */
void poi_report_encode(const struct poi_report *report, uint8_t bytes[POI_REPORT_SIZE]);

/* Writes what the hand is to feel. Beyond the range it is the end; what is no number is 0, for a
 * motor must not run away by it. Half a step is rounded away from 0 both ways. */
void poi_feel_encode(const struct poi_force *force, uint8_t sequence, uint8_t bytes[POI_FEEL_SIZE]);

/* The way back, for the device and for its twin; refuses as poi_report_decode(). `sequence` may be
 * null. */
int poi_feel_decode(const uint8_t *bytes, uint32_t size, struct poi_force *out, uint8_t *sequence);

#endif
