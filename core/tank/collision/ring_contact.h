/* ring_contact.h -- contact between a poi and a fish in one tick: penetration of ring and paper,
 * and which of the two moves.
 *
 * A poi moves before the fish do, and pushes fish out of its way. If a fish cannot move (other
 * fish, a wall or the floor behind it), the poi gives back as much of its step as needed. Both were
 * clear of each other in the previous tick, so the whole step always suffices. */
#ifndef KINGYO_CORE_TANK_COLLISION_RING_CONTACT_H
#define KINGYO_CORE_TANK_COLLISION_RING_CONTACT_H

#include "core/tank/collision/body.h"
#include "core/tank/collision/obstacle.h"

/* Largest sag of the paper under a body. */
#define RING_SAG_M 0.004f

/* Returns the obstacle as it was at the start of the tick. */
struct obstacle ring_before(const struct obstacle *obstacle);

/* Returns the penetration of a fish into ring, hull or paper, minus the allowed depth; > 0 is too
 * deep. `out` becomes the direction out. `before` is the pose of the previous tick: a deeper
 * penetration there is allowed to stay, and paper holds a fish on its previous side. */
float ring_excess_m(const struct obstacle *obstacle, const struct body *now,
                    const struct body *before, float free_m, vec3 *out);

/* Returns the shortest move that takes the body off the ring or hull, and a little more above or
 * below a ring, because bodies are round where their boxes have corners. Zero: the body is
 * clear. */
vec3 ring_hard_push(const struct obstacle *obstacle, const struct body *now);

/* Returns the move that the paper requires of the fish in this tick: off the paper by the fish's
 * ellipsoid, a little more each tick, and along with the paper if the flow presses the fish on.
 * Zero: no contact. */
vec3 ring_paper_push(const struct obstacle *disc, const struct body *now, vec3 before_m);

/* Returns the shortest move that keeps the fish's centre on its side of the paper. Zero: the centre
 * is there. */
vec3 ring_paper_hold(const struct obstacle *disc, const struct body *now, vec3 before_m);

/* Returns the position of a point at `before_m` after it moves along with the obstacle. */
vec3 ring_carry_m(const struct obstacle *obstacle, vec3 before_m);

/* Removes `excess_m` of the obstacle's step against `out`, or its rotation into the fish, or
 * finally the whole step. Returns 0 if nothing is left to remove. */
int ring_apply_reaction(struct obstacle *obstacle, vec3 out, float excess_m);

#endif
