/* flow.h -- the water that moves round a moving disc: what carries fish along, and what their
 * lateral line feels.
 *
 * Potential flow of a thin disc that goes along its normal, exact in oblate spheroidal coordinates:
 * at the speed of the disc on its axis, 0.18 of it a radius away, and as a dipole of the disc's
 * added mass, (8/3) rho a^3, beyond: with the cube of nearness. A disc that goes along its plane
 * draws little but the skin of water at its ring. */
#ifndef KINGYO_CORE_TANK_FLOW_H
#define KINGYO_CORE_TANK_FLOW_H

#include "core/tank/obstacle.h"

/* Velocity of the water at a point, world; never faster than the disc. Zero round a disc in air,
 * above the surface, and farther than six radii off; near the surface by as much as is under water,
 * and of a torn disc by what is left of it. Of a hull: zero. */
vec3 flow_at(const struct obstacle *disc, vec3 point_m);

/* The pressure that this brings, over rho: the disc's speed times the flow's there (m^2/s^2). Of
 * its square, then: a slow disc is hardly felt. */
float flow_push_m2_s2(const struct obstacle *disc, vec3 point_m);

#endif
