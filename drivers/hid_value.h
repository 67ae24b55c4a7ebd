/* hid_value.h -- what the bits of a report say of each binding of a map. A part of hid_hand. */
#ifndef KINGYO_DRIVERS_HID_VALUE_H
#define KINGYO_DRIVERS_HID_VALUE_H

#include "drivers/hid_hand.h"

/* Once, when the map is there: which arrays of the descriptor it binds. */
void hid_hand_find_arrays(struct hid_hand *hand);

/* Reads a whole report of id `report_id` into hand->value. 0: the map knows no such report. Steps
 * are of one report only. */
int hid_hand_read(struct hid_hand *hand, uint8_t report_id, struct hid_report report);

#endif
