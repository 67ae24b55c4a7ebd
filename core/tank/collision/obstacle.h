/* obstacle.h -- pois and bowls as obstacles for fish: hulls that fish must stay outside. */
#ifndef KINGYO_CORE_TANK_COLLISION_OBSTACLE_H
#define KINGYO_CORE_TANK_COLLISION_OBSTACLE_H

#include <stdint.h>

#include "core/tank/collision/shape_tests.h"
#include "core/tank/fish.h"

enum obstacle_kind {
    OBSTACLE_DISC, /* A poi: a rigid ring with a sheet across it. */
    OBSTACLE_BOWL, /* The hull of a floating bowl: half an ellipsoid hanging below the surface. */
};

#define OBSTACLE_PAPER_SIDE 32u /* Must equal SHEET_SIDE. */
#define OBSTACLE_PAPER_HOLDS 1u /* Must equal CELL_PAPER. */

enum obstacle_reaction {
    REACTION_POSITION = 1, /* The obstacle is not at its intended position. */
    REACTION_ROTATION = 2, /* The obstacle does not have its intended orientation. */
};

/* An obstacle of this tick. Pois and bowls fill it in. A tick of the tank may revert a part of the
 * step that led here if a fish cannot move out of the way. */
struct obstacle {
    uint8_t kind; /* enum obstacle_kind */
    vec3 centre_m;
    vec3 normal;       /* Unit vector; the up direction of a disc. */
    vec3 velocity_m_s; /* Intended velocity. */
    float stalled;     /* [0, 1] share of the intended motion that failed at the last attempt. */
    float radius_m;    /* Outer radius. */
    float depth_m;     /* Depth of a bowl's hull below its mouth. */

    /* Motion in this tick; zero if the obstacle did not move. */
    vec3 step_m;
    struct basis axes, axes_before; /* Axes of a disc now and before the step; `axes.up` is
                                       `normal`. */
    uint8_t turned;                 /* 1 if `axes_before` differs from `axes`. */

    /* Paper of a disc: OBSTACLE_PAPER_SIDE rows of as many cells from its far left corner. A cell
     * holds a fish if it is OBSTACLE_PAPER_HOLDS. The memory is borrowed for the tick. Null: no
     * paper. */
    const uint8_t *paper;
    float paper_radius_m;
    float open; /* [0, 1] share of a disc that lets water through because its paper is torn. */

    /* Output: the reaction of the obstacle. */
    uint8_t reaction; /* Bits of enum obstacle_reaction. */
    uint8_t reaction_count;
};

/* The ring of a disc is a torus of this thickness. */
#define RING_TUBE_PER_RADIUS 0.07f

/* Returns the apparent velocity, which moves water and looms. An obstacle stalled by fish does
 * neither, however hard the hand pulls. */
static inline vec3 obstacle_goes_m_s(const struct obstacle *obstacle)
{
    return v3_scale(obstacle->velocity_m_s, 1.0f - obstacle->stalled);
}

/* Returns the gap between the box of a fish and the ring or hull, and the direction out. */
struct touch obstacle_touch(const struct obstacle *obstacle, const struct box *box);

/* Returns the shortest move that takes the box of a fish off the ring or hull; zero if it is
 * clear. */
vec3 obstacle_clear(const struct obstacle *obstacle, const struct box *box);

/* Margin of obstacle_in_reach(): the motion in one tick of a poi at 1.5 m/s, and of a flying fish
 * with its pushes. */
#define OBSTACLE_REACH_M 0.03f

/* Returns 1 if the body could touch the obstacle before the tick ends. */
int obstacle_in_reach(const struct obstacle *obstacle, const struct box *box);

/* Returns the distance of a point from the whole disc, sheet included. */
float obstacle_disc_distance_m(const struct obstacle *disc, vec3 point_m);

/* Returns the wished sidestep, m/s, horizontal. Fish beside a slowly moving disc drift out of its
 * way; fish over or under its sheet do not. */
vec3 obstacle_sidestep_m_s(const struct obstacle *disc, vec3 position_m);

#endif
