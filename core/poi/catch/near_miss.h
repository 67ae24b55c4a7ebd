/* near_miss.h -- detects that a player almost caught a fish.
 *
 * Two events are near misses: a fish falls into the water from a poi (paper scoop) that was
 * completely above the water, or a fish that swam over the paper escapes just before the lift and
 * is still near the rim. The state is used for announcements only: the simulation never reads the
 * state, and no hash contains it. */
#pragma once

#include <stdbool.h>

#include "core/poi/poi.h"

/* Shortest time between two announcements for one poi. Most dips of a beginner fail, and an
 * announcement after each of these dips would disturb the player. */
#define NEAR_MISS_APART_TICKS (25u * CORE_TICK_HZ)
/* Largest horizontal distance from the outer edge of the ring at which an escaped fish is a near
 * miss. */
#define NEAR_MISS_RIM_M 0.02f
/* Longest time from the last tick in which the fish was over the paper to the lift of the poi.
 * After this time, the escape of the fish is no near miss. */
#define NEAR_MISS_LIFT_TICKS (2u * CORE_TICK_HZ / 5u)

struct near_miss {
    uint32_t tick; /* Tick of the latest announced near miss; 0 means none. */
    /* Last tick in which `fish` swam over the paper of the immersed poi; 0 means never. */
    uint32_t over_tick;
    uint16_t fish; /* Index of the fish that swam over the paper last. */
};

/* Advances one tick of `poi`, and returns true if a near miss must be announced. `slipped` is the
 * number of fish that fell from the lifted poi into the water in this tick (catch.h). `tick` is
 * the number of the tick, > 0. Must be called after catch_tick(). */
bool near_miss_tick(struct near_miss *miss, const struct poi *poi, const struct tank *tank,
                    uint32_t slipped, uint32_t tick);
