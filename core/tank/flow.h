/* flow.h -- the flow of water around a moving poi, which carries fish along and stimulates their
 * lateral line.
 *
 * The flow is the potential flow of a thin disc that moves along its normal, which is exact in
 * oblate spheroidal coordinates. On the axis the water has the disc's own speed at the disc, and
 * 0.18 of that speed one radius away. Farther away the flow is that of a dipole with the disc's
 * added mass, (8/3) rho a^3, and decays with the cube of the distance. A disc that moves along its
 * plane moves only the water near its ring. */
#ifndef KINGYO_CORE_TANK_FLOW_H
#define KINGYO_CORE_TANK_FLOW_H

#include "core/tank/collision/obstacle.h"

/* Returns the velocity of the water at a point in world coordinates, m/s. The water is never faster
 * than the disc. Returns zero for a bowl, above the surface and beyond six disc radii. The flow is
 * proportional to the submerged share of the disc. If the paper is torn, the flow along the normal
 * is proportional to the share of paper that remains. */
vec3 flow_at(const struct obstacle *disc, vec3 point_m);

/* Returns the pressure of the flow divided by the water density, m^2/s^2: the speed of the disc
 * times the speed of the flow at the point. The pressure grows with the square of the disc's speed,
 * so fish hardly feel a slow disc. */
float flow_push_m2_s2(const struct obstacle *disc, vec3 point_m);

#endif
