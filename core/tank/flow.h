/* flow.h -- the water around a moving disc, which carries fish along and acts on their lateral
 * line.
 *
 * Potential flow of a thin disc that moves along its normal, exact in oblate spheroidal
 * coordinates. On the axis the water has the speed of the disc at the disc and 0.18 of it one
 * radius away. Farther out the flow is the dipole of the disc's added mass, (8/3) rho a^3, and
 * decays with the cube of the distance. A disc that moves along its plane moves little more than
 * the water at its ring. */
#ifndef KINGYO_CORE_TANK_FLOW_H
#define KINGYO_CORE_TANK_FLOW_H

#include "core/tank/collision/obstacle.h"

/* Returns the velocity of the water at a point, world, never faster than the disc. The flow is
 * zero around a disc in air, above the surface, beyond six radii and around a hull. Near the
 * surface the flow scales with the submerged share of the disc, and for torn paper with the
 * share that remains. */
vec3 flow_at(const struct obstacle *disc, vec3 point_m);

/* Returns the pressure of this flow divided by rho, m^2/s^2: the disc's speed times the flow speed
 * at the point. The value grows with the square of the speed, so a slow disc is hardly felt. */
float flow_push_m2_s2(const struct obstacle *disc, vec3 point_m);

#endif
