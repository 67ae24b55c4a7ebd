/* buttons_keyboard.h -- the keyboard as cabinet buttons, through SDL's event queue.
 *
 * Space, Enter: START. Left, Right: LEFT, RIGHT. Down, Up: OK. L: LANGUAGE. F2: TEST. F3:
 * SERVICE. F4: TILT. 5, 6, 7: coins. F11: full screen. Esc, Q: quit. The owner of the window
 * pumps the queue first. This driver removes key and text events and no others. */
#ifndef KINGYO_DRIVERS_POINTER_BUTTONS_KEYBOARD_H
#define KINGYO_DRIVERS_POINTER_BUTTONS_KEYBOARD_H

#include "platform/hal.h"

struct buttons_keyboard {
    uint32_t held; /* Buttons that are down, enum input_button. */
};

struct hal_buttons buttons_keyboard_device(struct buttons_keyboard *keyboard);

#endif
