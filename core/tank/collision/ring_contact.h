/* ring_contact.h -- contact between a poi (the paper scoop) and a fish in one tick. The functions
 * compute the penetration of the fish into the poi's ring and paper, and decide whether the fish or
 * the poi moves.
 *
 * A poi moves before the fish do, and pushes fish out of its way. If a fish cannot move because of
 * other fish, a wall or the floor, the poi gives up as much of its step as needed. Giving up the
 * whole step always suffices, because poi and fish did not touch in the previous tick. */
#ifndef KINGYO_CORE_TANK_COLLISION_RING_CONTACT_H
#define KINGYO_CORE_TANK_COLLISION_RING_CONTACT_H

#include "core/tank/collision/body.h"
#include "core/tank/collision/obstacle.h"

/* Largest sag of the paper under a body. */
#define RING_SAG_M 0.004f

/* Returns a copy of the obstacle with its position and orientation before its step. */
struct obstacle ring_before(const struct obstacle *obstacle);

/* Returns the penetration of a fish into ring, hull or paper minus the allowed penetration, m. A
 * result > 0 is too deep. `out` receives the direction in which the fish must move. `before` is the
 * body in the previous tick. The allowed penetration is `free_m`, or the penetration of `before` if
 * that is larger. Paper keeps a fish on the side on which `before` is. */
float ring_excess_m(const struct obstacle *obstacle, const struct body *now,
                    const struct body *before, float free_m, vec3 *out);

/* Returns the shortest translation that moves the body off the ring or hull, or zero if the body
 * does not touch the obstacle. At a ring a small move along the ring's normal is added, because a
 * fish is round where its box has corners. */
vec3 ring_hard_push(const struct obstacle *obstacle, const struct body *now);

/* Returns the move that the paper requires of the fish in this tick, or zero if the fish does not
 * touch the paper. The fish moves off the paper by a limited distance. If the flow presses the fish
 * onto the paper, the fish also moves along with the paper. */
vec3 ring_paper_push(const struct obstacle *disc, const struct body *now, vec3 before_m);

/* Returns the shortest translation that keeps the fish's centre on its side of the paper, or zero
 * if the centre is already there. */
vec3 ring_paper_hold(const struct obstacle *disc, const struct body *now, vec3 before_m);

/* Returns the position of a point that was at `before_m` after it moved along with the obstacle. */
vec3 ring_carry_m(const struct obstacle *obstacle, vec3 before_m);

/* Reduces the obstacle's step by `excess_m` in the direction opposite to `out`. If that is
 * impossible, undoes the obstacle's rotation or, as the last possibility, the whole step. Returns 1
 * if the obstacle changed, or 0 if the obstacle has no motion left to give up. */
int ring_apply_reaction(struct obstacle *obstacle, vec3 out, float excess_m);

#endif
