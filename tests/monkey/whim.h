/* whim.h -- draws one random step of the monkey test as a pure function of the seed and the step.
 *
 * In two thirds of the time, the keys are drawn with the frequencies of a player. In the other
 * third they are drawn with the frequencies of an operator, with many presses of TEST, SERVICE and
 * Esc. */
#ifndef KINGYO_TESTS_MONKEY_WHIM_H
#define KINGYO_TESTS_MONKEY_WHIM_H

#include <stdint.h>

enum whim_key {
    WHIM_KEY_START,
    WHIM_KEY_LEFT,
    WHIM_KEY_RIGHT,
    WHIM_KEY_UP,
    WHIM_KEY_DOWN,
    WHIM_KEY_ENTER,
    WHIM_KEY_COIN,
    WHIM_KEY_COIN_2,
    WHIM_KEY_LANGUAGE,
    WHIM_KEY_FULL_SCREEN,
    WHIM_KEY_TILT,
    /* A key that has no function in the kiosk. */
    WHIM_KEY_UNUSED,
    WHIM_KEY_TEST,
    WHIM_KEY_SERVICE,
    WHIM_KEY_ESCAPE,
    WHIM_KEY_COUNT,
};

enum whim_press {
    WHIM_PRESS_NONE,
    WHIM_PRESS_LEFT,  /* Presses or releases the left mouse button. */
    WHIM_PRESS_RIGHT, /* Presses or releases the right mouse button. */
};

struct whim {
    int key; /* Pressed key (enum whim_key); -1 means that no key is pressed. */
    /* 1 if the pointer moves to x_mille, y_mille; otherwise 0. */
    int moves;
    int x_mille; /* Pointer x in thousandths of the window's width, -50 to 1049. */
    int y_mille; /* Pointer y in thousandths of the window's height, -50 to 1049. */
    int press;   /* Mouse button action (enum whim_press). */
    int wheel;   /* Steps of the mouse wheel, -1 to 1. */
    /* New size of the window in pixels. If 0, the window keeps its size. */
    int width, height;
    /* 1 if a device is plugged in or unplugged; otherwise 0. */
    int plugs;
    uint32_t chance; /* Random number from which the caller draws further details. */
};

/* Returns the random input of step number `step` of the run with `seed`. */
struct whim whim_at(uint32_t seed, uint32_t step);

#endif
