/* sample.h -- the frame's first part: the only reads from devices. */
#ifndef KINGYO_PLATFORM_KIOSK_SAMPLE_H
#define KINGYO_PLATFORM_KIOSK_SAMPLE_H

#include "platform/kiosk/kiosk.h"

/* Before the first frame: every seat gets its controller, and is opened. */
void sample_open(struct kiosk *kiosk, const struct hal *hal);

/* Fills kiosk->input with what devices say by now; what each tick has for itself, the poses, comes
 * with the tick. Counts the faults that it meets, and sets kiosk->end when somebody quits or the
 * display is lost for good. */
void sample_devices(struct kiosk *kiosk, const struct hal *hal);

#endif
