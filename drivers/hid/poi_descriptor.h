/* poi_descriptor.h -- the HID report descriptor of Kingyo's poi controller, the paper scoop with
 * sensors that this project defines.
 *
 * The array `poi_descriptor` is the only definition of the bytes. The kiosk recognizes Kingyo's poi
 * controller by the descriptor, independent of the vendor and product id. The program kingyo-poi
 * passes the bytes to the kernel of the board inside the controller (board/poi-gadget/, whose
 * README explains the bytes). A test compares the bytes with poi_report.h field by field. After a
 * change of the descriptor, controllers with the previous descriptor are no longer recognized. */
#ifndef KINGYO_DRIVERS_HID_POI_DESCRIPTOR_H
#define KINGYO_DRIVERS_HID_POI_DESCRIPTOR_H

#include <stdint.h>

#define POI_DESCRIPTOR_SIZE 184u

/* Vendor-defined usage page. The HID Usage Tables reserve the pages FF00 to FFFF for vendors.
 * Another vendor may use the same page, so only the whole descriptor identifies Kingyo's poi
 * controller. */
#define POI_PAGE 0xff4bu

enum poi_usage { /* Usages of POI_PAGE. */
                 POI_USAGE_SEQUENCE = 0x01,
                 POI_USAGE_FEEL = 0x02,     /* Usage of the collection that is the force feedback
                                               report. */
                 POI_USAGE_FORCE_X = 0x10,  /* First of three force usages, 0x10 to 0x12: X, Y,
                                               Z. */
                 POI_USAGE_TORQUE_X = 0x13, /* First of three torque usages, 0x13 to 0x15: X, Y,
                                               Z. */
                 POI_USAGE_DRAG = 0x16,     /* First of three effect usages, 0x16 to 0x18: drag,
                                               slap, tear. */
};

extern const uint8_t poi_descriptor[POI_DESCRIPTOR_SIZE];

/* Returns 1 if the bytes are exactly `poi_descriptor`, otherwise 0. */
int poi_descriptor_is(const uint8_t *bytes, uint32_t size);

#endif
