/* poi_mouse.h -- the mouse (or a touch screen) as a poi, and with F held as a fan, through SDL's
 * event queue.
 *
 * Needs an initialised SDL video subsystem and a window; whoever owns the window pumps the queue
 * (display poll) before this is polled. Takes mouse events from the queue and no others; F it sees
 * go by, whoever takes it. The poi is polled before the fan. */
#ifndef KINGYO_DRIVERS_POI_MOUSE_H
#define KINGYO_DRIVERS_POI_MOUSE_H

#include "drivers/pointer_fan.h"
#include "drivers/pointer_poi.h"
#include "platform/hal.h"

struct poi_mouse {
    struct hal_clock clock;
    struct pointer_poi pointer;
    struct pointer_fan fan;
    uint8_t fan_key;              /* Whether F is down. */
    struct pointer_report report; /* The pointer as last known; wheel apart. */
    uint64_t last_poll_ns;
    char text[HAL_TEXT_SIZE];
};

/* `width`, `height`: the window's size until the first event tells the true one. */
void poi_mouse_init(struct poi_mouse *mouse, struct hal_clock clock, const struct view *view,
                    uint32_t width, uint32_t height);

struct hal_poi poi_mouse_device(struct poi_mouse *mouse);

/* The fan that the same mouse leads while F is held. */
struct hal_shade poi_mouse_fan(struct poi_mouse *mouse);

#endif
