/* drag.h -- drags a simulated poi through a tank as fast as a player can. The poi moves at 0.1 to
 * 1.5 m/s, level, tilted or on edge. It plunges into the water and moves along walls and into
 * corners. */
#ifndef KINGYO_TESTS_SOAK_DRAG_H
#define KINGYO_TESTS_SOAK_DRAG_H

#include "core/core.h"
#include "tests/soak/apart.h"

struct drag {
    struct core core;
    struct input input;
    struct output output;
    vec3 to_m;       /* Target of the current stroke. */
    float speed_m_s; /* Speed of the current stroke. */
    struct angles angles;
    uint32_t stroke; /* Number of the current stroke. */
    /* Two sums over the ticks, in m: the distance between the requested and the simulated position
     * of the poi (`lag_sum_m`), and the length of the requested path (`hand_m`). */
    double lag_sum_m, hand_m;
    uint32_t ticks;
};

/* Starts a game with `fish_count` fish; 0 means the preset's number. The game stays in attract mode
 * until drag_begin(). */
void drag_init(struct drag *drag, uint8_t preset, uint32_t fish_count, uint32_t seed);

/* Starts a round with the poi above the middle of the tank. */
void drag_begin(struct drag *drag);

/* Runs one tick of the round and moves the poi along the current stroke. Replaces torn paper, and
 * empties a full bowl into the tank, so that the round can continue for ever. */
void drag_tick(struct drag *drag);

/* Runs one tick of the same tank and bowl without a poi. */
void drag_calm_tick(struct drag *drag);

#endif
