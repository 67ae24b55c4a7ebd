/* apart.h -- checks after every tick of a soak test that nothing overlaps and that the fish move
 * naturally.
 *
 * The checks do not use the core's collision code. Pairs of fish come from a separate grid, boxes
 * are tested on all fifteen separating axes, and the ring is tested by points along its circle. */
#ifndef KINGYO_TESTS_SOAK_APART_H
#define KINGYO_TESTS_SOAK_APART_H

#include "core/poi/bowl/bowl.h"
#include "core/poi/poi.h"
#include "core/tank/tank.h"

/* Depth in m above which a contact counts as an overlap. */
#define APART_DEEP_M 0.0005f

/* A swimming fish counts as stuck while it stays within a circle of this radius in m. */
#define APART_STUCK_M 0.003f

struct apart {
    /* Greatest depth of each kind of overlap in m. */
    float pair_m, wall_m, floor_m, surface_m, ring_m, hull_m;
    /* Number of overlaps deeper than APART_DEEP_M, summed over the ticks. `pair_count` counts pairs
     * of fish. `other_count` counts overlaps of a fish with a wall, the floor, the surface, a ring
     * or a bowl's hull. */
    uint32_t pair_count, other_count;
    uint64_t ticks, fish_ticks;

    /* The members below describe the motion of the fish. In their comments, a calm fish is a fish
     * that is not startled. */
    /* Two sums over all swimming fish in all ticks, in m/s: their true speed (`speed_sum`), and the
     * speed that their gait alone would give (`free_sum`). */
    double speed_sum, free_sum;
    float yaw_rate_max_rad_s; /* Greatest yaw rate of a calm fish. */
    /* Number of times that a calm fish turned to one side and then to the other, both at more than
     * REVERSAL_RAD_S. */
    uint64_t reversals;
    uint64_t by_wall; /* Number of fish within 3 cm of a wall, summed over the ticks. */
    /* Longest time for which a swimming fish was stuck. */
    float stuck_s;
    /* Longest time for which a fish still overlapped other fish after it was put back into the
     * water. */
    float loose_s;

    /* State of each fish for the checks of stuck fish and of reversals: a reference position, the
     * tick in which the fish was at this position, and the side of the fish's last turn. */
    vec3 spot_m[TANK_FISH_MAX];
    uint32_t spot_tick[TANK_FISH_MAX], loose_ticks[TANK_FISH_MAX];
    float yaw_rad[TANK_FISH_MAX];
    int8_t turned[TANK_FISH_MAX];
    uint8_t known[TANK_FISH_MAX];
};

/* Resets all measures. */
void apart_init(struct apart *apart);

/* Checks the tank after a tick. `pois` and `bowls` may be null. */
void apart_check(struct apart *apart, const struct tank *tank, const struct poi *pois,
                 uint32_t poi_count, const struct bowl *bowls, uint32_t bowl_count);

/* Returns the deepest overlap in m over all pairs of fish. This function does not use the grid, so
 * its result verifies the check with the grid. */
float apart_all_pairs_m(const struct tank *tank);

/* Returns the deepest overlap of any kind in m. */
float apart_deepest_m(const struct apart *apart);

/* Returns the mean true speed of the swimming fish as a fraction of the mean speed that their gait
 * alone would give. */
float apart_pace(const struct apart *apart);

/* Returns the number of reversals per fish and second. */
float apart_reversals_per_s(const struct apart *apart);

/* Returns the number of fish within 3 cm of the walls as a multiple of the number that an even
 * distribution would give. */
float apart_wall_crowding(const struct apart *apart, const struct tank *tank);

#endif
