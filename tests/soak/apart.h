/* apart.h -- what a soak looks at after every tick: is anything inside anything else, and do fish
 * still move as fish do?
 *
 * Nothing here is the core's own search or its own test of ring and hull: pairs come from cells of
 * this file's own, boxes are judged by all fifteen axes, the ring by points all along it. */
#ifndef KINGYO_TESTS_SOAK_APART_H
#define KINGYO_TESTS_SOAK_APART_H

#include "core/poi/bowl.h"
#include "core/poi/poi.h"
#include "core/tank/tank.h"

/* Deeper than this is an overlap; the kiosk's promise. */
#define APART_DEEP_M 0.0005f

/* A swimming fish that stays within STUCK_M for longer than this is stuck. */
#define APART_STUCK_M 0.003f

struct apart {
    /* How deep anything was in anything else, at worst. */
    float pair_m, wall_m, floor_m, surface_m, ring_m, hull_m;
    uint32_t pair_count, other_count; /* Pair-ticks and fish-ticks deeper than APART_DEEP_M. */
    uint64_t ticks, fish_ticks;

    /* How they move: calm is what a fish does that no fright drives. */
    double speed_sum, free_sum; /* Of swimming fish, m/s, true and by the gait alone. */
    float yaw_rate_max_rad_s;   /* Of calm fish. */
    uint64_t reversals;         /* Calm turns of over REVERSAL_RAD_S that change sides. */
    uint64_t by_wall;           /* Fish-ticks within 3 cm of a wall. */
    float stuck_s;              /* The longest that a swimming fish stayed on one spot. */
    float loose_s;              /* The longest that one was in the water and not yet clear. */

    /* Of each fish: where it is being watched from, for how long, and how it turned. */
    vec3 spot_m[TANK_FISH_MAX];
    uint32_t spot_tick[TANK_FISH_MAX], loose_ticks[TANK_FISH_MAX];
    float yaw_rad[TANK_FISH_MAX];
    int8_t turned[TANK_FISH_MAX];
    uint8_t known[TANK_FISH_MAX];
};

void apart_init(struct apart *apart);

/* Looks at the tank after a tick. `pois` and `bowls` may be 0. */
void apart_look(struct apart *apart, const struct tank *tank, const struct poi *pois,
                uint32_t poi_count, const struct bowl *bowls, uint32_t bowl_count);

/* The same pairs without cells, each fish with each; for the test of the cells. Returns the deepest
 * overlap. */
float apart_all_pairs_m(const struct tank *tank);

float apart_deepest_m(const struct apart *apart);

/* Mean true speed of swimming fish, in shares of what the gait alone would give. */
float apart_pace(const struct apart *apart);

/* Calm reversals per fish and second. */
float apart_reversals_per_s(const struct apart *apart);

/* Share of fish within 3 cm of walls, in shares of what an even spread would have there. */
float apart_wall_crowding(const struct apart *apart, const struct tank *tank);

#endif
