/* buttons_keyboard.h -- the keyboard as cabinet buttons, through SDL's event queue.
 *
 * Space and Enter press START. Left and Right press LEFT and RIGHT, Up and Down press OK. L is
 * LANGUAGE, F2 is TEST, F3 is SERVICE and F4 is TILT. 5, 6 and 7 insert coins, F11 toggles full
 * screen, Esc and Q quit. The owner of the window pumps SDL's queue before each poll. This driver
 * removes key and text events from the queue and leaves all other events. */
#pragma once

#include "platform/hal.h"

struct buttons_keyboard {
    uint32_t held; /* Pressed buttons, as bits of enum input_button. */
};

/* Returns the button device of the keyboard. */
struct hal_buttons buttons_keyboard_device(struct buttons_keyboard *keyboard);
