/* random_step.h -- draws one random step of the monkey test as a pure function of the seed and the
 * step.
 *
 * In two thirds of the time, the keys are drawn with the frequencies of a player. In the other
 * third they are drawn with the frequencies of an operator, with many presses of TEST, SERVICE and
 * Esc. */
#ifndef KINGYO_TESTS_MONKEY_RANDOM_STEP_H
#define KINGYO_TESTS_MONKEY_RANDOM_STEP_H

#include <stdint.h>

enum step_key {
    STEP_KEY_START,
    STEP_KEY_LEFT,
    STEP_KEY_RIGHT,
    STEP_KEY_UP,
    STEP_KEY_DOWN,
    STEP_KEY_ENTER,
    STEP_KEY_COIN,
    STEP_KEY_COIN_2,
    STEP_KEY_LANGUAGE,
    STEP_KEY_FULL_SCREEN,
    STEP_KEY_TILT,
    /* A key that has no function in the kiosk. */
    STEP_KEY_UNUSED,
    STEP_KEY_TEST,
    STEP_KEY_SERVICE,
    STEP_KEY_ESCAPE,
    STEP_KEY_COUNT,
};

enum step_press {
    STEP_PRESS_NONE,
    STEP_PRESS_LEFT,  /* Presses or releases the left mouse button. */
    STEP_PRESS_RIGHT, /* Presses or releases the right mouse button. */
};

struct random_step {
    int key; /* Pressed key (enum step_key); -1 means that no key is pressed. */
    /* 1 if the pointer moves to x_mille, y_mille; otherwise 0. */
    int moves;
    int x_mille; /* Pointer x in thousandths of the window's width, -50 to 1049. */
    int y_mille; /* Pointer y in thousandths of the window's height, -50 to 1049. */
    int press;   /* Mouse button action (enum step_press). */
    int wheel;   /* Steps of the mouse wheel, -1 to 1. */
    /* New size of the window in pixels. If 0, the window keeps its size. */
    int width, height;
    /* 1 if a device is plugged in or unplugged; otherwise 0. */
    int plugs;
    uint32_t chance; /* Random number from which the caller draws further details. */
};

/* Returns the random input of step number `step` of the run with `seed`. */
struct random_step random_step_at(uint32_t seed, uint32_t step);

#endif
