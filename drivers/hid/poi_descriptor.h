/* poi_descriptor.h -- the HID report descriptor of our own poi.
 *
 * The only definition of these bytes. The kiosk recognizes our poi by them, independent of
 * vendor and product id. kingyo-poi passes them to the kernel of the poi's board
 * (board/poi-gadget/), whose README lists them. A test compares them with poi_report.h field by
 * field. After any change, pois built before are no longer recognized. */
#ifndef KINGYO_DRIVERS_HID_POI_DESCRIPTOR_H
#define KINGYO_DRIVERS_HID_POI_DESCRIPTOR_H

#include <stdint.h>

#define POI_DESCRIPTOR_SIZE 184u

/* Vendor-defined usage page; the HID Usage Tables reserve FF00 .. FFFF for vendors. Other
 * vendors may use the same page, so only the whole descriptor identifies our poi. */
#define POI_PAGE 0xff4bu

enum poi_usage { /* Usages of POI_PAGE. */
                 POI_USAGE_SEQUENCE = 0x01,
                 POI_USAGE_FEEL = 0x02,     /* Collection of the force feedback report. */
                 POI_USAGE_FORCE_X = 0x10,  /* 0x10 .. 0x12: X, Y, Z. */
                 POI_USAGE_TORQUE_X = 0x13, /* 0x13 .. 0x15: X, Y, Z. */
                 POI_USAGE_DRAG = 0x16,     /* 0x16 .. 0x18: drag, slap, tear. */
};

extern const uint8_t poi_descriptor[POI_DESCRIPTOR_SIZE];

/* Returns 1 if the bytes are exactly our descriptor. */
int poi_descriptor_is(const uint8_t *bytes, uint32_t size);

#endif
