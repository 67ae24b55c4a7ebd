/* drag.h -- a tank of a given density, and a hand that drags a real poi through it without mercy:
 * 0.1 to 1.5 m/s, level, slanted and on edge, plunging, along walls and into corners. */
#ifndef KINGYO_TESTS_SOAK_DRAG_H
#define KINGYO_TESTS_SOAK_DRAG_H

#include "core/core.h"
#include "tests/soak/apart.h"

struct drag {
    struct core core;
    struct input input;
    struct output output;
    vec3 to_m;       /* Where the hand goes ... */
    float speed_m_s; /* ... how fast ... */
    struct angles angles;
    uint32_t stroke; /* ... in the how manieth stroke. */
    double lag_sum_m, hand_m; /* Ring behind hand, summed over ticks; the hand's way. */
    uint32_t ticks;
};

/* A stall with `fish_count` fish; 0: the preset's own. In attract, until drag_begin(). */
void drag_init(struct drag *drag, uint8_t preset, uint32_t fish_count, uint32_t seed);

/* Starts a round, with the poi over the middle of the tank. */
void drag_begin(struct drag *drag);

/* One tick of the round with the hand on its way; the paper never wears out, and a bowl that fills
 * is poured back. */
void drag_tick(struct drag *drag);

/* One tick of the same tank, bowl included, that no poi disturbs. */
void drag_calm_tick(struct drag *drag);

#endif
