/* hid_axis_decoder.h -- decodes the bits of a HID report into a value for each binding of a
 * mapping. A private part of hid_pose_decoder. */
#ifndef KINGYO_DRIVERS_HID_HID_AXIS_DECODER_H
#define KINGYO_DRIVERS_HID_HID_AXIS_DECODER_H

#include "drivers/hid/hid_pose_decoder.h"

/* Finds the array fields that the mapping binds. Must be called once, after hand->map was set. */
void hid_axis_decoder_find_arrays(struct hid_pose_decoder *hand);

/* Decodes a complete report with the id `report_id` into hand->value. Returns 1, or 0 if the
 * mapping uses no field of the report. The value of a HID_BINDING_STEP binding is valid for one
 * report. A report with a different id sets the value to 0. */
int hid_axis_decoder_read(struct hid_pose_decoder *hand, uint8_t report_id,
                          struct hid_report report);

#endif
