/* obstacle.h -- pois (paper scoops) and bowls as obstacles that fish must not penetrate. */
#ifndef KINGYO_CORE_TANK_COLLISION_OBSTACLE_H
#define KINGYO_CORE_TANK_COLLISION_OBSTACLE_H

#include <stdint.h>

#include "core/tank/collision/shape_tests.h"
#include "core/tank/fish.h"

enum obstacle_kind {
    OBSTACLE_DISC, /* A poi: a rigid ring with a sheet of paper across it. */
    OBSTACLE_BOWL, /* The hull of a floating bowl: half of an ellipsoid that hangs below the
                      surface. */
};

/* Number of rows and of columns of `paper`. The number must equal SHEET_SIDE. */
#define OBSTACLE_PAPER_SIDE 32u
/* Value of a cell of `paper` that is not torn. The value must equal CELL_PAPER. */
#define OBSTACLE_PAPER_HOLDS 1u

enum obstacle_reaction {
    REACTION_POSITION = 1, /* The contact solver changed the position of the obstacle. */
    REACTION_ROTATION = 2, /* The contact solver changed the orientation of the obstacle. */
};

/* State of an obstacle in one tick. The code of the poi or of the bowl sets the state. The contact
 * solver may undo a part of the obstacle's motion if a fish cannot move out of the way. */
struct obstacle {
    uint8_t kind; /* Kind of the obstacle (enum obstacle_kind). */
    vec3 centre_m;
    vec3 normal;       /* Unit normal of a disc's plane, pointing to the disc's upper side. */
    vec3 velocity_m_s; /* Velocity of the obstacle if no fish blocks it. */
    float stalled;     /* Fraction [0, 1] of the intended motion that fish blocked when the obstacle
                          last tried to move. */
    float radius_m;    /* Outer radius of the ring or of the bowl's mouth. */
    float depth_m;     /* Depth of a bowl's hull below its mouth. */

    /* Motion in this tick; zero if the obstacle did not move. */
    vec3 step_m;
    struct basis axes, axes_before; /* Axes of a disc now (`axes`) and before the step
                                       (`axes_before`). `axes.up` equals `normal`. */
    uint8_t turned;                 /* 1 if `axes_before` differs from `axes`, otherwise 0. */

    /* Paper of a disc: OBSTACLE_PAPER_SIDE rows of OBSTACLE_PAPER_SIDE cells, beginning at the far
     * left corner. A cell supports a fish if its value is OBSTACLE_PAPER_HOLDS. The memory is
     * borrowed for the tick. Null means that there is no paper. */
    const uint8_t *paper;
    float paper_radius_m;
    float open; /* Fraction [0, 1] of a disc through which water flows because its paper is torn. */

    /* The contact solver writes `reaction` and `reaction_count`. */
    uint8_t reaction; /* Motion that the obstacle gave up: bits of enum obstacle_reaction. */
    uint8_t reaction_count;
};

/* Radius of the tube of a disc's ring, divided by the ring's outer radius. The ring is a torus. */
#define RING_TUBE_PER_RADIUS 0.07f

/* Returns the velocity with which the obstacle pushes water and approaches fish. The velocity is
 * zero for an obstacle that fish block completely, even if the player continues to move the poi. */
static inline vec3 obstacle_goes_m_s(const struct obstacle *obstacle)
{
    return v3_scale(obstacle->velocity_m_s, 1.0f - obstacle->stalled);
}

/* Returns the gap between the box of a fish and the ring or hull, and the direction in which the
 * box must move. */
struct touch obstacle_touch(const struct obstacle *obstacle, const struct box *box);

/* Returns the shortest translation that moves the box of a fish off the ring or hull, or zero if
 * the box does not touch the obstacle. */
vec3 obstacle_clear(const struct obstacle *obstacle, const struct box *box);

/* Margin of obstacle_in_reach(). The margin covers the motion in one tick of a poi at 1.5 m/s, and
 * of an escaping fish with its pushes. */
#define OBSTACLE_REACH_M 0.03f

/* Returns 1 if the box could touch the obstacle before the tick ends, otherwise 0. */
int obstacle_in_reach(const struct obstacle *obstacle, const struct box *box);

/* Returns the distance of a point from a disc, which includes the ring and its paper, m. */
float obstacle_disc_distance_m(const struct obstacle *disc, vec3 point_m);

/* Returns the horizontal velocity at which a fish at `position_m` steps aside, m/s. Fish beside a
 * moving disc drift away from the disc. Returns zero for fish over or under the disc's paper. */
vec3 obstacle_sidestep_m_s(const struct obstacle *disc, vec3 position_m);

#endif
