/* rim.h -- a poi and a fish in one tick: who is in the ring or in the paper, and which of the two
 * gives way.
 *
 * A poi has moved before the fish do. Fish are pushed out of its way; where one cannot go (others,
 * a wall, the floor behind it), it wins, and the poi gives back as much of its step as it takes.
 * Both were clear of each other a tick before, so that never needs more than the whole step. */
#ifndef KINGYO_CORE_TANK_RIM_H
#define KINGYO_CORE_TANK_RIM_H

#include "core/tank/body.h"
#include "core/tank/obstacle.h"

/* Paper sags under a body by so much; deeper it does not go in. */
#define RIM_SAG_M 0.004f

/* The obstacle as it was when the tick began. */
struct obstacle rim_before(const struct obstacle *obstacle);

/* How deep the fish is in the ring, the hull or the paper, at most a little more than it may be:
 * > 0 is too deep; `out` becomes its way out. `before` is where fish and obstacle were: who was
 * deeper may stay so, and paper holds a fish on the side on which it was. */
float rim_excess_m(const struct obstacle *obstacle, const struct body *now,
                   const struct body *before, float free_m, vec3 *out);

/* The least move that takes the body off the ring or the hull, and over or under a ring a little
 * more: bodies are round where their boxes have corners, and glide off a rim. Zero: it is clear. */
vec3 rim_hard_push(const struct obstacle *obstacle, const struct body *now);

/* Where paper wants the fish in this tick: off itself by its ellipsoid, a little more each tick,
 * and along with itself where the stream presses it on. Zero: it does not touch it. */
vec3 rim_paper_push(const struct obstacle *disc, const struct body *now, vec3 before_m);

/* The least move that keeps the fish's middle on its side of the paper. Zero: it is there. */
vec3 rim_paper_hold(const struct obstacle *disc, const struct body *now, vec3 before_m);

/* Where a point that was at `before_m` is when it goes along with the obstacle. */
vec3 rim_carry_m(const struct obstacle *obstacle, vec3 before_m);

/* Takes `excess_m` off the obstacle's step, against `out`, or what turned it into the fish, or in
 * the end the whole step. Returns 0 when it has nothing more to give. */
int rim_give_way(struct obstacle *obstacle, vec3 out, float excess_m);

#endif
