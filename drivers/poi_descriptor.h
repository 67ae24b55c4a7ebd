/* poi_descriptor.h -- the HID report descriptor of our own poi: what its reports mean, in bytes.
 *
 * The one source of it. The kiosk knows a poi of ours by these bytes, whatever its vendor and
 * product; kingyo-poi gives them to the kernel of the poi's board (board/poi-gadget/); its README
 * lists them, and a test holds all of it against poi_report.h, field by field. A change makes
 * another device: pois that were built before are then none of ours any more. */
#ifndef KINGYO_DRIVERS_POI_DESCRIPTOR_H
#define KINGYO_DRIVERS_POI_DESCRIPTOR_H

#include <stdint.h>

#define POI_DESCRIPTOR_SIZE 184u

/* HID Usage Tables leave pages FF00 .. FFFF to vendors. Only the whole descriptor is a name: the
 * page alone may be anybody's. */
#define POI_PAGE 0xff4bu

enum poi_usage { /* On POI_PAGE. */
    POI_USAGE_SEQUENCE = 0x01,
    POI_USAGE_FEEL = 0x02,     /* The collection of what the hand is made to feel. */
    POI_USAGE_FORCE_X = 0x10,  /* .. 0x12: X, Y, Z. */
    POI_USAGE_TORQUE_X = 0x13, /* .. 0x15. */
    POI_USAGE_DRAG = 0x16,     /* .. 0x18: drag, slap, tear. */
};

extern const uint8_t poi_descriptor[POI_DESCRIPTOR_SIZE];

/* Whether these are the bytes of our own poi. */
int poi_descriptor_is(const uint8_t *bytes, uint32_t size);

#endif
