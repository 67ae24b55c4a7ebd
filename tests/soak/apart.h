/* apart.h -- checks after every tick of a soak test that nothing overlaps and that the fish move
 * naturally.
 *
 * This module does not use the core's own search or the core's own tests of ring and hull. Pairs
 * come from a grid of this file, boxes are tested by all fifteen axes, and the ring by points along
 * its circle. */
#ifndef KINGYO_TESTS_SOAK_APART_H
#define KINGYO_TESTS_SOAK_APART_H

#include "core/poi/bowl/bowl.h"
#include "core/poi/poi.h"
#include "core/tank/tank.h"

/* Depth from which a contact counts as an overlap. The kiosk must never exceed this depth. */
#define APART_DEEP_M 0.0005f

/* Radius of the stuck check. A swimming fish is stuck while it stays within this radius. */
#define APART_STUCK_M 0.003f

struct apart {
    /* Greatest depth of each kind of overlap in m. */
    float pair_m, wall_m, floor_m, surface_m, ring_m, hull_m;
    /* Number of pairs of fish (`pair_count`), and of fish in walls, floor, surface, rings or hulls
     * (`other_count`), that overlap by more than APART_DEEP_M. The numbers are summed over the
     * ticks. */
    uint32_t pair_count, other_count;
    uint64_t ticks, fish_ticks;

    /* The members below describe the motion of the fish. A calm fish is a fish that is not
     * startled. */
    double speed_sum, free_sum; /* Sums of the speeds of swimming fish in m/s: the true speed and
                                   the speed of the gait alone. */
    float yaw_rate_max_rad_s;   /* Greatest yaw rate of a calm fish. */
    uint64_t reversals;         /* Number of calm turns of more than REVERSAL_RAD_S that change
                                   their direction. */
    uint64_t by_wall;           /* Number of fish within 3 cm of a wall, summed over the ticks. */
    float stuck_s;              /* Longest time for which a swimming fish stayed in one place. */
    /* Longest time for which a fish in reentry was in the water and still overlapped others. */
    float loose_s;

    /* State of each fish: the place from which its motion is measured, the time of this place, and
     * its last turn. */
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

/* Returns the deepest overlap of all pairs without the grid, as a reference for the test of the
 * grid. */
float apart_all_pairs_m(const struct tank *tank);

/* Returns the deepest overlap of any kind in m. */
float apart_deepest_m(const struct apart *apart);

/* Returns the mean true speed of swimming fish as a fraction of the speed of the gait alone. */
float apart_pace(const struct apart *apart);

/* Returns the number of calm turn reversals for each fish and second. */
float apart_reversals_per_s(const struct apart *apart);

/* Returns the number of fish within 3 cm of the walls as a fraction of the number in an even
 * distribution. */
float apart_wall_crowding(const struct apart *apart, const struct tank *tank);

#endif
