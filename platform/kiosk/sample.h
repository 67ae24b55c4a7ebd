/* sample.h -- the first part of a frame: all reads from devices. */
#ifndef KINGYO_PLATFORM_KIOSK_SAMPLE_H
#define KINGYO_PLATFORM_KIOSK_SAMPLE_H

#include "platform/kiosk/kiosk.h"

/* Assigns a controller to every slot and opens it. Call before the first frame. */
void sample_open(struct kiosk *kiosk, const struct hal *hal);

/* Fills kiosk->input with the current device values, except the poses, which are set for each tick.
 * Counts faults, and sets kiosk->end if the user quits or the display is lost for good. */
void sample_devices(struct kiosk *kiosk, const struct hal *hal);

#endif
