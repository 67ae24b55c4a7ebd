/* present.h -- the frame's last part: the only writes to devices. */
#ifndef KINGYO_PLATFORM_KIOSK_PRESENT_H
#define KINGYO_PLATFORM_KIOSK_PRESENT_H

#include "platform/kiosk/kiosk.h"

/* The display, and whoever points at the picture, are told when it is another one. */
void present_view(struct kiosk *kiosk, const struct hal *hal);

/* Sounds, lamps, orders, forces and what is to be kept, when the frame had ticks; the picture
 * always. Counts the faults that it meets, and sets kiosk->end when the kiosk is to begin anew. */
void present_frame(struct kiosk *kiosk, const struct hal *hal, uint32_t tick_count);

#endif
