/* poi_mouse.h -- the mouse (or a touch screen) as a poi, through SDL's event queue.
 *
 * Needs an initialised SDL video subsystem and a window; whoever owns the window pumps the queue
 * (display poll) before this is polled. Takes mouse events from the queue and no others. */
#ifndef KINGYO_DRIVERS_POI_MOUSE_H
#define KINGYO_DRIVERS_POI_MOUSE_H

#include "drivers/pointer_poi.h"
#include "platform/hal.h"

struct poi_mouse {
    struct hal_clock clock;
    struct pointer_poi pointer;
    struct pointer_report report; /* The pointer as last known; wheel apart. */
    uint64_t last_poll_ns;
    char text[HAL_TEXT_SIZE];
};

/* `width`, `height`: the window's size until the first event tells the true one. */
void poi_mouse_init(struct poi_mouse *mouse, struct hal_clock clock, const struct view *view,
                    uint32_t width, uint32_t height);

struct hal_poi poi_mouse_device(struct poi_mouse *mouse);

#endif
