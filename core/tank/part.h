/* part.h -- moves bodies until none overlaps another, an obstacle, a wall, the floor or the
 * surface. */
#ifndef KINGYO_CORE_TANK_PART_H
#define KINGYO_CORE_TANK_PART_H

#include "core/tank/crowd.h"
#include "core/tank/obstacle.h"

/* Inner faces that bodies keep within. */
struct tank_bounds {
    vec3 low_m, high_m;
};

/* What parting knows of a tank. */
struct part_place {
    struct tank_bounds bounds;
    const struct obstacle *obstacles;
    uint32_t obstacle_count;
    const vec3 *before_m; /* Where each fish was when the tick began: what others shove it by is
                             bounded, so that nobody jumps. Null binds nobody. */
};

/* Scratch of one tick. */
struct part {
    float step_max_m[TANK_FISH_MAX]; /* How far from where it was a body may end. */
};

/* First of all moves bodies out of obstacles and within bounds, so that the look sees where they
 * really are. */
void part_clear(struct part *part, struct crowd *crowd, const struct part_place *place);

/* Moves bodies until they overlap neither each other nor obstacles, as far as some rounds can.
 * Walls, floor and surface have the last word and always hold. */
void part_bodies(struct part *part, struct crowd *crowd, const struct part_place *place);

#endif
