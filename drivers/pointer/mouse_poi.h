/* mouse_poi.h -- the mouse or a touch screen as a poi, and with F held as a fan, through SDL.
 *
 * Needs SDL's video subsystem and a window. The owner of the window pumps the queue (display
 * poll) before this device is polled. Mouse and finger events are removed from the queue, no
 * others; F is observed by an event watch. If both mouse and fingers are enabled, the device
 * that moved last sets the position, and the buttons of both count. Fingers that are not enabled
 * act as a mouse, because SDL converts them, and a touch then dips. The poi must be polled
 * before the fan and the buttons. */
#ifndef KINGYO_DRIVERS_POINTER_MOUSE_POI_H
#define KINGYO_DRIVERS_POINTER_MOUSE_POI_H

#include "drivers/pointer/pointer_fan.h"
#include "drivers/pointer/pointer_poi.h"
#include "drivers/pointer/touch_fingers.h"
#include "platform/hal.h"

enum pointer_filter {
    POINTER_FILTER_MOUSE = 1u << 0,
    POINTER_FILTER_TOUCH = 1u << 1,
};

struct mouse_poi {
    struct hal_clock clock;
    struct pointer_poi pointer;
    struct pointer_fan fan;
    uint8_t fan_key;        /* 1 while the key F is down. */
    uint8_t heeds;          /* enum pointer_filter, the enabled devices. */
    uint32_t mouse_buttons; /* enum pointer_button bits that are down. */
    struct touch_fingers fingers;
    uint64_t used_ns; /* Time of the last use by a person; 0: never. */
    float crept_px;   /* Motion in pixels since `used_ns`. */
    struct display_settings
        display_settings; /* Image geometry set by look(); zero: the image fills the window. */
    struct pointer_report report; /* Last pointer state; the wheel is reset for each event. */
    uint64_t last_poll_ns;
    char text[HAL_TEXT_SIZE];
};

/* Initializes the device. `width` and `height` are the window's size until the first event gives
 * the true size. `heeds` is a set of enum pointer_filter. */
void mouse_poi_init(struct mouse_poi *mouse, struct hal_clock clock, const struct view *view,
                    uint32_t width, uint32_t height, uint32_t heeds);

struct hal_poi mouse_poi_device(struct mouse_poi *mouse);

/* Returns the fan that the same mouse controls while F is held. */
struct hal_fan mouse_poi_fan(struct mouse_poi *mouse);

/* Returns 1 if a person moved, pressed or touched the device within POINTER_USED_NS. The motion
 * event of a window that opens under the pointer does not count. `mouse` is a struct mouse_poi. */
#define POINTER_USED_NS 120000000000ull
int mouse_poi_is_used(void *mouse);

/* Returns a button device that reports START for three fingers. */
struct hal_buttons mouse_poi_buttons(struct mouse_poi *mouse);

#endif
