/* obstacle.h -- pois (paper scoops) and bowls as obstacles that fish must not penetrate, and the
 * contact between an obstacle and a fish in one tick.
 *
 * A poi moves before the fish do, and pushes fish out of its way. If a fish cannot move because of
 * other fish, a wall or the floor, the poi gives up as much of its step as needed. Giving up the
 * whole step always suffices, because poi and fish did not touch in the previous tick. */
#ifndef KINGYO_CORE_TANK_COLLISION_OBSTACLE_H
#define KINGYO_CORE_TANK_COLLISION_OBSTACLE_H

#include <stdint.h>

#include "core/tank/collision/box.h"
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

/* Largest sag of the paper under a body. */
#define RING_SAG_M 0.004f

/* Returns a copy of the obstacle with its position and orientation before its step. */
struct obstacle obstacle_before(const struct obstacle *obstacle);

/* Returns the penetration of a fish into ring, hull or paper minus the allowed penetration, m. A
 * result > 0 is too deep. `out` receives the direction in which the fish must move. `before` is the
 * body in the previous tick. The allowed penetration is `free_m`, or the penetration of `before` if
 * that is larger. Paper keeps a fish on the side on which `before` is. */
float obstacle_excess_m(const struct obstacle *obstacle, const struct body *now,
                        const struct body *before, float free_m, vec3 *out);

/* Returns the shortest translation that moves the body off the ring or hull, or zero if the body
 * does not touch the obstacle. At a ring a small move along the ring's normal is added, because a
 * fish is round where its box has corners. */
vec3 obstacle_hard_push(const struct obstacle *obstacle, const struct body *now);

/* Returns the move that the paper requires of the fish in this tick, or zero if the fish does not
 * touch the paper. The fish moves off the paper by a limited distance. If the flow presses the fish
 * onto the paper, the fish also moves along with the paper. */
vec3 obstacle_paper_push(const struct obstacle *disc, const struct body *now, vec3 before_m);

/* Returns the shortest translation that keeps the fish's centre on its side of the paper, or zero
 * if the centre is already there. */
vec3 obstacle_paper_hold(const struct obstacle *disc, const struct body *now, vec3 before_m);

/* Returns the position of a point that was at `before_m` after it moved along with the obstacle. */
vec3 obstacle_carry_m(const struct obstacle *obstacle, vec3 before_m);

/* Reduces the obstacle's step by `excess_m` in the direction opposite to `out`. If that is
 * impossible, undoes the obstacle's rotation or, as the last possibility, the whole step. Returns 1
 * if the obstacle changed, or 0 if the obstacle has no motion left to give up. */
int obstacle_apply_reaction(struct obstacle *obstacle, vec3 out, float excess_m);

#endif
