/* mouse_poi.h -- a mouse or a touch screen as a poi (the paper scoop), and as a fan while key F is
 * pressed, through SDL.
 *
 * Needs SDL's video subsystem and a window. The owner of the window pumps SDL's queue (display
 * poll) before this device is polled. Mouse and finger events are removed from the queue, and all
 * other events stay. Key F is observed by an event watch.
 *
 * If mouse and fingers are enabled, the device that moved last sets the position, and the buttons
 * of mouse and fingers are combined. If fingers are disabled, SDL converts them to mouse events, so
 * a touch dips the poi. The poi must be polled before the fan and the buttons. */
#ifndef KINGYO_DRIVERS_POINTER_MOUSE_POI_H
#define KINGYO_DRIVERS_POINTER_MOUSE_POI_H

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
    uint8_t fan_key;        /* 1 while the F key is pressed, otherwise 0. */
    uint8_t heeds;          /* Enabled devices, as bits of enum pointer_filter. */
    uint32_t mouse_buttons; /* Pressed mouse buttons, as bits of enum pointer_button. */
    struct touch_fingers fingers;
    uint64_t used_ns; /* Time of the last use by a person; 0 means never. */
    float crept_px;   /* Distance that the mouse has moved after `used_ns`, in pixels. */
    /* Image geometry from set_view(). If all fields are 0, the image fills the window. */
    struct display_settings display_settings;
    /* Last state of the pointer. The wheel motion is reset to 0 for each event. */
    struct pointer_report report;
    uint64_t last_poll_ns; /* Time of the last poll. */
    char text[HAL_TEXT_SIZE];
};

/* Initializes the device. `width` and `height` are the assumed size of the window in pixels until
 * the first event reports the real size. `heeds` has bits of enum pointer_filter. */
void mouse_poi_init(struct mouse_poi *mouse, struct hal_clock clock, const struct view *view,
                    uint32_t width, uint32_t height, uint32_t heeds);

/* Returns the poi device of the mouse or touch screen. */
struct hal_poi mouse_poi_device(struct mouse_poi *mouse);

/* Returns the fan that the same mouse controls while key F is pressed. */
struct hal_fan mouse_poi_fan(struct mouse_poi *mouse);

/* Time without use after which mouse_poi_is_used() returns 0. */
#define POINTER_USED_NS 120000000000ull
/* Returns 1 if a person moved, pressed or touched the device within POINTER_USED_NS, otherwise 0.
 * The motion event of a window that opens under the pointer does not count. `mouse` is a struct
 * mouse_poi. */
int mouse_poi_is_used(void *mouse);

/* Returns a button device that reports START while three fingers touch the screen. */
struct hal_buttons mouse_poi_buttons(struct mouse_poi *mouse);

#endif
