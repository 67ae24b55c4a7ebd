/* present.h -- the last part of a frame: all writes to devices. */
#ifndef KINGYO_PLATFORM_KIOSK_PRESENT_H
#define KINGYO_PLATFORM_KIOSK_PRESENT_H

#include "platform/kiosk/kiosk.h"

/* Sends a changed view or transform to the display and to the pointer devices. */
void present_view(struct kiosk *kiosk, const struct hal *hal);

/* Writes sounds, outputs, commands, forces and data to store if the frame had ticks, and always the
 * picture. Counts faults, and sets kiosk->end if the kiosk must restart. */
void present_frame(struct kiosk *kiosk, const struct hal *hal, uint32_t tick_count);

#endif
