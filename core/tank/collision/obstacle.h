/* obstacle.h -- pois (paper scoops) and bowls as obstacles that fish must not penetrate, and the
 * contact between an obstacle and a fish in one tick.
 *
 * A poi moves before the fish do, and pushes fish out of its way. If a fish cannot move because of
 * other fish, a wall or the floor, the contact solver undoes as much of the poi's motion in this
 * tick as needed. Undoing the whole motion always suffices, because poi and fish did not touch in
 * the previous tick. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/tank/collision/box.h"
#include "core/tank/fish.h"

enum obstacle_kind {
    OBSTACLE_DISC, /* A poi: a rigid ring with a sheet of paper across it. */
    /* The hull of a floating bowl: half of an ellipsoid that hangs below the surface. */
    OBSTACLE_BOWL,
};

/* Number of rows, and of columns, of the grid of cells `paper` in struct obstacle. The number must
 * equal SHEET_SIDE. */
#define OBSTACLE_PAPER_SIDE 32u
/* Value of a cell of the grid `paper` (struct obstacle) in which the paper is not torn. The value
 * must equal CELL_PAPER. */
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
    /* Unit normal of the plane of a disc (poi). The normal points to the upper side of the disc. */
    vec3 normal;
    vec3 velocity_m_s; /* Velocity that the obstacle would have if no fish blocked its motion. */
    /* Fraction [0, 1] of the intended motion that fish prevented when the obstacle moved last. */
    float stalled;
    float radius_m; /* Outer radius of the ring or of the bowl's mouth. */
    float depth_m;  /* Depth of a bowl's hull below its mouth. */

    /* Motion of the obstacle in this tick, or in the present substep while the contact solver runs.
     * Zero if the obstacle did not move. */
    vec3 step_m;
    /* Axes of a poi now (`axes`) and before its motion in this tick (`axes_before`). `axes.up`
     * equals `normal`. */
    struct basis axes, axes_before;
    bool turned; /* True if `axes_before` differs from `axes`. */

    /* Paper of a poi (paper scoop): OBSTACLE_PAPER_SIDE rows of OBSTACLE_PAPER_SIDE cells,
     * beginning at the far left corner. A cell supports a fish if its value is
     * OBSTACLE_PAPER_HOLDS. The memory is borrowed for the tick. Null means that there is no
     * paper. */
    const uint8_t *paper;
    float paper_radius_m;
    /* Fraction [0, 1] of the area of a poi that is open, so that water flows through it, because
     * the paper is torn. */
    float open;

    /* Results of the contact solver: `reaction` and `reaction_count`. */
    uint8_t reaction; /* Kinds of motion that the contact solver has undone: bits of enum
                         obstacle_reaction. */
    uint8_t reaction_count;
};

/* Radius of the tube of a poi's ring, divided by the outer radius of the ring. The ring is a
 * torus. */
#define RING_TUBE_PER_RADIUS 0.07f

/* Returns the velocity with which the obstacle pushes water and approaches fish. The velocity is
 * zero if fish block the obstacle completely, even if the player continues to move the poi. */
static inline vec3 obstacle_goes_m_s(const struct obstacle *obstacle)
{
    return v3_scale(obstacle->velocity_m_s, 1.0f - obstacle->stalled);
}

/* Returns the gap between the box of a fish and the obstacle (the ring of a poi or the hull of a
 * bowl). Also returns the direction in which the box leaves the obstacle soonest. */
struct touch obstacle_touch(const struct obstacle *obstacle, const struct box *box);

/* Returns the shortest translation that moves the box of a fish off the ring or hull, or zero if
 * the box does not touch the obstacle. */
vec3 obstacle_clear(const struct obstacle *obstacle, const struct box *box);

/* Distance between a fish and an obstacle within which the fish could touch the obstacle in this
 * tick. The distance covers the motion in one tick of a poi at 1.5 m/s and of an escaping fish. */
#define OBSTACLE_REACH_M 0.03f

/* Returns true if the box of a fish could touch the obstacle before the tick ends. */
bool obstacle_in_reach(const struct obstacle *obstacle, const struct box *box);

/* Returns the horizontal velocity at which a fish at `position_m` steps aside, m/s. A fish beside a
 * moving disc (a poi, the paper scoop) drifts away from the disc. Returns zero for a fish over or
 * under the paper of the disc. */
vec3 obstacle_sidestep_m_s(const struct obstacle *disc, vec3 position_m);

/* Largest depth to which the paper of a poi sags under a fish. */
#define RING_SAG_M 0.004f

/* Returns a copy of the obstacle with the position and orientation that the obstacle had before its
 * motion in this tick. */
struct obstacle obstacle_before(const struct obstacle *obstacle);

/* Returns by how much a fish penetrates a ring, a hull or paper more deeply than allowed, m. A
 * result <= 0 means that the penetration is allowed. The allowed depth is `free_m`, or the depth in
 * the previous tick if that was larger. `before` is the body of the fish in the previous tick. A
 * fish must stay on the side of the paper on which `before` is. `out` receives the direction in
 * which the fish must move. */
float obstacle_excess_m(const struct obstacle *obstacle, const struct body *now,
                        const struct body *before, float free_m, vec3 *out);

/* Returns the translation that moves the body off the ring or hull, or zero if the body does not
 * touch the obstacle. At a hull the translation is the shortest one. At a ring the function adds a
 * move along the ring's normal to the shortest translation. Without that move, the corners of the
 * box would catch on the ring, while a real fish is round and slides over the ring. */
vec3 obstacle_hard_push(const struct obstacle *obstacle, const struct body *now);

/* Returns the translation by which the paper of a poi moves a fish in this tick, or zero if the
 * fish does not touch the paper. The fish moves off the paper by a limited distance. If the flow
 * presses the fish onto the paper, the fish also moves along with the paper. */
vec3 obstacle_paper_push(const struct obstacle *disc, const struct body *now, vec3 before_m);

/* Returns the shortest translation that moves the fish's centre back to the side of the paper on
 * which the centre was before. Returns zero if the centre is on that side. */
vec3 obstacle_paper_hold(const struct obstacle *disc, const struct body *now, vec3 before_m);

/* Returns the position of a point after the point moved along with the obstacle in this tick.
 * `before_m` is the position of the point before that motion. */
vec3 obstacle_carry_m(const struct obstacle *obstacle, vec3 before_m);

/* Undoes a part of the obstacle's motion in this substep, because a fish in its way cannot move.
 * `excess_m` and `out` are the results of obstacle_excess_m() for this fish. The first of these
 * rules that applies is used:
 *
 * - From the ninth call for the obstacle in a substep on, the whole motion is undone.
 * - If the obstacle moved along `out`, the obstacle moves back by `excess_m`, but not farther along
 *   `out` than it moved.
 * - If the obstacle rotated, the rotation is undone.
 * - Otherwise the whole motion is undone.
 *
 * Returns true if any motion was undone, or false if no motion was left to undo. */
bool obstacle_apply_reaction(struct obstacle *obstacle, vec3 out, float excess_m);
