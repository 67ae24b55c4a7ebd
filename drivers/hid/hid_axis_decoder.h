/* hid_axis_decoder.h -- decodes the bits of a report for each binding of a mapping. A part of
 * hid_pose_decoder. */
#ifndef KINGYO_DRIVERS_HID_HID_AXIS_DECODER_H
#define KINGYO_DRIVERS_HID_HID_AXIS_DECODER_H

#include "drivers/hid/hid_pose_decoder.h"

/* Finds the arrays that the mapping binds. Must be called once, after the mapping was set. */
void hid_axis_decoder_find_arrays(struct hid_pose_decoder *hand);

/* Decodes a complete report of id `report_id` into hand->value. Returns 1, or 0 if the mapping
 * uses no field of this report. STEP values apply to one report only and are cleared by other
 * reports. */
int hid_axis_decoder_read(struct hid_pose_decoder *hand, uint8_t report_id,
                          struct hid_report report);

#endif
