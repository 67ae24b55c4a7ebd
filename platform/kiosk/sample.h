/* sample.h -- runs the first part of a frame, which reads all devices. */
#ifndef KINGYO_PLATFORM_KIOSK_SAMPLE_H
#define KINGYO_PLATFORM_KIOSK_SAMPLE_H

#include "platform/kiosk/kiosk.h"

/* Assigns controllers to all slots and opens them. Call before the first frame. */
void sample_open(struct kiosk *kiosk, const struct hal *hal);

/* Fills kiosk->input with the current device values, except the poses, which are set for each tick.
 * Counts faults. Sets kiosk->end if the user quits or the display is lost permanently. */
void sample_devices(struct kiosk *kiosk, const struct hal *hal);

#endif
