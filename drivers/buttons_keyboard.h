/* buttons_keyboard.h -- a desktop's keys as the cabinet's buttons, through SDL's event queue.
 *
 * Space, Enter: START. Left, Right, Down: LEFT, RIGHT, OK. L: LANGUAGE. F11: full screen.
 * Esc, Q: quit. Whoever owns the window pumps the queue first; this takes key events and no
 * others. */
#ifndef KINGYO_DRIVERS_BUTTONS_KEYBOARD_H
#define KINGYO_DRIVERS_BUTTONS_KEYBOARD_H

#include "platform/hal.h"

struct buttons_keyboard {
    uint32_t held; /* enum input_button levels. */
};

struct hal_buttons buttons_keyboard_device(struct buttons_keyboard *keyboard);

#endif
