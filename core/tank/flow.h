/* flow.h -- the flow of water around a moving poi (the paper scoop), which is modelled as a disc.
 * The flow carries fish along and stimulates their lateral line.
 *
 * For motion along the disc's normal, the flow is the potential flow of a thin disc, which is
 * known exactly in oblate spheroidal coordinates. On the disc's axis, the water has the speed of
 * the disc at the disc and 0.18 of that speed at a distance of one radius. Far from the disc,
 * the flow is the flow of a dipole and decays with the cube of the distance. The strength of the
 * dipole follows from the disc's added mass, (8 / 3) * rho * a^3, where rho is the density of
 * water and a is the radius of the disc. For motion along the disc's plane, only the water near
 * the disc's ring moves. */
#ifndef KINGYO_CORE_TANK_FLOW_H
#define KINGYO_CORE_TANK_FLOW_H

#include "core/tank/collision/obstacle.h"

/* Returns the velocity of the water at a point in world coordinates, m/s. The water is never faster
 * than the disc. Returns zero if `disc` is a bowl, if the point is above the surface, or if the
 * point is farther than six disc radii from the disc's centre. The velocity is proportional to the
 * submerged fraction of the disc. Torn paper moves less water: the flow that motion along the
 * normal causes is proportional to the fraction of the paper that remains. */
vec3 flow_at(const struct obstacle *disc, vec3 point_m);

/* Returns the pressure of the flow at a point divided by the water density, m^2/s^2. The result is
 * the speed of the disc times the speed of the water at the point. The pressure grows with the
 * square of the disc's speed, so fish hardly feel a slow disc. */
float flow_push_m2_s2(const struct obstacle *disc, vec3 point_m);

#endif
