/* poi_mouse.h -- the mouse, or fingers on a touch screen, as a poi, and with F held as a fan,
 * through SDL's event queue.
 *
 * Needs an initialised SDL video subsystem and a window; whoever owns the window pumps the queue
 * (display poll) before this is polled. Takes mouse and finger events from the queue and no others;
 * F it sees go by, whoever takes it. Where both are heeded the one that moved last leads, and the
 * other's buttons count. Fingers that are not heeded are a mouse's, as SDL makes it of them: one
 * that touches dips. The poi is polled before the fan and the buttons. */
#ifndef KINGYO_DRIVERS_POI_MOUSE_H
#define KINGYO_DRIVERS_POI_MOUSE_H

#include "drivers/pointer_fan.h"
#include "drivers/pointer_poi.h"
#include "drivers/touch_fingers.h"
#include "platform/hal.h"

enum pointer_heed {
    POINTER_HEEDS_MOUSE = 1u << 0,
    POINTER_HEEDS_FINGERS = 1u << 1,
};

struct poi_mouse {
    struct hal_clock clock;
    struct pointer_poi pointer;
    struct pointer_fan fan;
    uint8_t fan_key;              /* Whether F is down. */
    uint8_t heeds;                /* enum pointer_heed */
    uint32_t mouse_buttons;       /* enum pointer_button */
    struct touch_fingers fingers;
    uint64_t used_ns;             /* When it last said what only a hand says; 0: never. */
    float crept_px;               /* Moved since then. */
    struct showing showing;       /* As told last; zero: it fills the window. */
    struct pointer_report report; /* The pointer as last known; wheel apart. */
    uint64_t last_poll_ns;
    char text[HAL_TEXT_SIZE];
};

/* `width`, `height`: the window's size until the first event tells the true one. `heeds`: a set of
 * enum pointer_heed. */
void poi_mouse_init(struct poi_mouse *mouse, struct hal_clock clock, const struct view *view,
                    uint32_t width, uint32_t height, uint32_t heeds);

struct hal_poi poi_mouse_device(struct poi_mouse *mouse);

/* The fan that the same mouse leads while F is held. */
struct hal_shade poi_mouse_fan(struct poi_mouse *mouse);

/* Whether somebody has it in hand: it was moved on, pressed or touched within POINTER_USED_NS. That
 * a window opened under it is no sign of that. `mouse`: a struct poi_mouse. */
#define POINTER_USED_NS 120000000000ull
int poi_mouse_is_used(void *mouse);

/* START by three fingers. */
struct hal_buttons poi_mouse_buttons(struct poi_mouse *mouse);

#endif
