/* whim.h -- what the monkey does at one step: a pure function of the seed and the step.
 *
 * Two thirds of the time the keys are a player's. In the other third the keys are an operator's,
 * with many presses of TEST, SERVICE and Esc. */
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
    WHIM_KEY_UNUSED, /* A key without a meaning. */
    WHIM_KEY_TEST,
    WHIM_KEY_SERVICE,
    WHIM_KEY_ESCAPE,
    WHIM_KEY_COUNT,
};

enum whim_press {
    WHIM_PRESS_NONE,
    WHIM_PRESS_LEFT,  /* Changes the left button: down, or up again. */
    WHIM_PRESS_RIGHT, /* Likewise the right button. */
};

struct whim {
    int key;            /* enum whim_key, or -1: no key is pressed. */
    int moves;          /* 1: the pointer goes to x_mille, y_mille. */
    int x_mille;        /* Thousandths of the window's width, -50 to 1049. */
    int y_mille;        /* Thousandths of the window's height, -50 to 1049. */
    int press;          /* enum whim_press. */
    int wheel;          /* Steps of the wheel, -1 to 1. */
    int width, height;  /* The window's new size in pixels; 0: the size stays. */
    int plugs;          /* 1: a device is plugged in or unplugged. */
    uint32_t chance;    /* For what the caller draws besides. */
};

/* Returns what the monkey that `seed` names does at `step`. */
struct whim whim_at(uint32_t seed, uint32_t step);

#endif
