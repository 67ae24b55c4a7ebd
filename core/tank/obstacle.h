/* obstacle.h -- what the poi and the bowls are to a fish: hulls to keep out of. */
#ifndef KINGYO_CORE_TANK_OBSTACLE_H
#define KINGYO_CORE_TANK_OBSTACLE_H

#include <stdint.h>

#include "core/tank/fish.h"
#include "core/tank/touch.h"

enum obstacle_kind {
    OBSTACLE_DISC, /* A poi: a rigid ring with a sheet across. */
    OBSTACLE_BOWL, /* A floating bowl's hull: half an ellipsoid hanging below the surface. */
};

#define OBSTACLE_PAPER_SIDE 32u /* As SHEET_SIDE. */
#define OBSTACLE_PAPER_HOLDS 1u /* As CELL_PAPER. */

enum obstacle_gave {
    OBSTACLE_GAVE_PLACE = 1, /* It is not where it wanted to be ... */
    OBSTACLE_GAVE_TURN = 2,  /* ... or not turned as it wanted. */
};

/* What fish must swim round this tick. The poi and the bowls describe themselves this way; a tick
 * of the tank may take back some of the step that led here, where a fish cannot give way. */
struct obstacle {
    uint8_t kind; /* enum obstacle_kind */
    vec3 centre_m;
    vec3 normal; /* Unit; a disc's up. */
    vec3 velocity_m_s; /* As it wants to go; ... */
    float stalled;     /* ... [0, 1] of it it could not when it last tried. */
    float radius_m; /* Outer. */
    float depth_m;  /* Of a bowl's hull below its mouth. */

    /* How it came here in this tick; zero: it did not move. */
    vec3 step_m;
    struct basis axes, axes_before; /* A disc's; `axes.up` is `normal`. */
    uint8_t turned;                 /* `axes_before` is another way than `axes`. */

    /* A disc's paper: OBSTACLE_PAPER_SIDE rows of as many cells from its left far corner, that
     * hold a fish where they are OBSTACLE_PAPER_HOLDS; borrowed for the tick. Null: none. */
    const uint8_t *paper;
    float paper_radius_m;
    float open; /* [0, 1] of a disc that lets water through: its paper is torn. */

    /* Out: how it gave way. */
    uint8_t gave; /* Bits of enum obstacle_gave. */
    uint8_t give_count;
};

/* A disc's ring is a torus of this thickness. */
#define RING_TUBE_PER_RADIUS 0.07f

/* How fast it seems to go: what moves water, and looms. One that fish hold up does neither, however
 * hard a hand pulls at it. */
static inline vec3 obstacle_goes_m_s(const struct obstacle *obstacle)
{
    return v3_scale(obstacle->velocity_m_s, 1.0f - obstacle->stalled);
}

/* The gap between the fish's box and the ring or the hull, and the fish's way out. */
struct touch obstacle_touch(const struct obstacle *obstacle, const struct box *box);

/* The least move that takes the fish's box off the ring or the hull; zero when it is clear. */
vec3 obstacle_clear(const struct obstacle *obstacle, const struct box *box);

/* What obstacle_in_reach() adds to both: a poi at 1.5 m/s, a fish in flight and what shoves it, in
 * a tick. */
#define OBSTACLE_REACH_M 0.03f

/* Whether a body so near could touch it before the tick is over. */
int obstacle_in_reach(const struct obstacle *obstacle, const struct box *box);

/* How near the fish is to the whole disc, sheet included. */
float obstacle_disc_distance_m(const struct obstacle *disc, vec3 point_m);

/* Wanted sidestep, m/s, horizontal: fish beside a slowly moving disc drift out of its way, those
 * over or under its sheet do not. */
vec3 obstacle_sidestep_m_s(const struct obstacle *disc, vec3 position_m);

#endif
