/* crowd.h -- all bodies of one tick at once: which are near, which touch, and how to part them.
 *
 * Scratch: rebuilt from the fish each tick, so nothing here is state and no hash covers it. */
#ifndef KINGYO_CORE_TANK_CROWD_H
#define KINGYO_CORE_TANK_CROWD_H

#include "core/tank/avoid.h"
#include "core/tank/fish.h"
#include "core/tank/grid.h"
#include "core/tank/obstacle.h"

#define CROWD_CONTACT_MAX                                                                          \
    (4u * GRID_FISH_MAX) /* 1.4 overlap a fish at the thesis' density. Further                     \
                            ones draw lots for a place, anew each tick. */

/* Inner faces that bodies keep within. */
struct tank_bounds {
    vec3 low_m, high_m;
};

struct crowd_body {
    vec3 centre_m;  /* First, so that the grid can stride over it. As box.centre_m at the start. */
    float reach_m;  /* Radius of the ball that holds the personal space. */
    float slab_m;   /* Half the height of the upright box that holds it. */
    float margin_m; /* Personal space beyond the body. */
    struct box box;
    vec3 extent_m; /* Half of the body's upright box. */
    vec3 forward;
    float speed_m_s;
    struct avoid_advice advice;
    float brake, room; /* As in struct fish. */
    vec3 push_m_s;
    uint32_t avoid_since; /* As in struct fish, with the two below. */
    uint16_t avoid_with;
    uint8_t avoiding;
    uint16_t fish;    /* Index in the tank. */
    uint8_t airborne; /* Above the surface: the surface does not hold it. */
    uint8_t beside;   /* An obstacle is in reach. */
    vec3 before_m;    /* Where it was when the tick began ... */
    float step_max_m; /* ... and how far from there it may end. */
};

/* What the pair search reads of a body, in the order of the cells. */
struct crowd_near {
    vec3 centre_m;
    float reach_m, slab_m;
};

struct crowd {
    uint32_t count;
    struct crowd_body body[GRID_FISH_MAX];
    struct crowd_near near[GRID_FISH_MAX]; /* near[k] is body[grid.item[k]]. */
    struct grid grid;
    uint32_t overlap_count; /* Pairs whose bodies crowd_meet() found overlapping. */
    uint32_t touch_count;   /* Pairs that touch or nearly do; the list has room for some of them. */
    uint32_t contact_count;
    uint16_t contact[CROWD_CONTACT_MAX][2];
};

/* Takes the bodies of all fish that swim. Personal spaces reach `space` body lengths beyond bodies.
 * `before_m` is where each fish was when the tick began: what others shove it by is bounded, so
 * that nobody jumps. Null binds nobody. */
void crowd_gather(struct crowd *crowd, const struct fish *fish, uint32_t fish_count, float space,
                  const vec3 *before_m);

/* First of all moves bodies out of obstacles and within bounds, so that the search sees where they
 * really are. */
void crowd_clear(struct crowd *crowd, const struct tank_bounds *bounds,
                 const struct obstacle *obstacles, uint32_t obstacle_count);

/* Finds every pair whose personal spaces overlap: advises those that meet, pushes those that are
 * near, lists those that touch. */
void crowd_meet(struct crowd *crowd, vec3 tank_size_m, const struct law *law, uint32_t seed,
                uint32_t tick);

/* Moves bodies until they overlap neither each other nor obstacles, as far as some rounds can.
 * Walls, floor and surface have the last word and always hold. */
void crowd_part(struct crowd *crowd, const struct tank_bounds *bounds,
                const struct obstacle *obstacles, uint32_t obstacle_count);

/* The personal space that a crowd leaves, in body lengths beyond the body: the law's own in sparse
 * tanks, a fifth of it at worst. */
float crowd_space(const struct fish *fish, uint32_t fish_count, vec3 tank_size_m,
                  const struct law *law);

#endif
