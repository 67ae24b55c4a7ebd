/* present.h -- runs the last part of a frame, which sends the results of the ticks to the
 * devices. */
#ifndef KINGYO_PLATFORM_KIOSK_PRESENT_H
#define KINGYO_PLATFORM_KIOSK_PRESENT_H

#include "platform/kiosk/kiosk.h"

/* Sends the camera view and the display settings to the display and to the pointer devices if one
 * of them has changed. */
void present_view(struct kiosk *kiosk, const struct hal *hal);

/* Presents the picture. If the frame had ticks, also plays sounds, sets outputs, executes commands,
 * sends forces and stores data. Counts faults. Sets kiosk->end if the kiosk must restart. */
void present_frame(struct kiosk *kiosk, const struct hal *hal, uint32_t tick_count);

#endif
