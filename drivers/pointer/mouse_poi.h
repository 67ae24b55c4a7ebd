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
#pragma once

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
    /* Adaptation of the pointer to the player. Its options come from set_view(). */
    struct pointer_aid aid;
    bool fan_key;           /* True while the F key is pressed. */
    uint8_t enabled;        /* Enabled devices, as bits of enum pointer_filter. */
    uint32_t mouse_buttons; /* Pressed mouse buttons, as bits of enum pointer_button. */
    struct touch_fingers fingers;
    /* Time at which a person last used the mouse or touch screen. 0 means never. */
    uint64_t used_ns;
    float crept_px; /* Distance that the mouse has moved after `used_ns`, in pixels. */
    /* Image geometry from set_view(). If all fields are 0, the image fills the window. */
    struct display_settings display_settings;
    /* Newest state of the pointer. `wheel_notches` contains only the motion of the newest event. */
    struct pointer_report report;
    uint64_t last_poll_ns; /* Time of the last poll. */
    char text[HAL_TEXT_SIZE];
};

/* Initializes the device. `width` and `height` are the assumed size of the window in pixels until
 * the first event reports the real size. `enabled` has bits of enum pointer_filter. */
void mouse_poi_init(struct mouse_poi *mouse, struct hal_clock clock, const struct view *view,
                    uint32_t width, uint32_t height, uint32_t enabled);

/* Returns the devices of the mouse or touch screen. The mouse controls the fan while key F is
 * pressed. The button device reports START while three fingers touch the screen. */
struct hal_controller_devices mouse_poi_devices(struct mouse_poi *mouse);

/* If no person uses the mouse for this time, mouse_poi_is_used() returns false. */
#define POINTER_USED_NS 120000000000ull
/* Returns true if a person moved, pressed or touched the device within POINTER_USED_NS. The motion
 * event of a window that opens under the pointer does not count. `mouse` is a struct mouse_poi. */
bool mouse_poi_is_used(void *mouse);
