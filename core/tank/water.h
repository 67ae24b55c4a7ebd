/* water.h -- the water: the surface as a field of wave heights, and the flow around a moving poi
 * (the paper scoop).
 *
 * Pois and fish make waves, and the renderer uses the slopes for refraction. The flow carries fish
 * along and stimulates their lateral line.
 *
 * The flow is that of a disc, because a poi is a thin round sheet. For motion along the normal of
 * the disc, the flow is the potential flow of a thin disc, which is known exactly in oblate
 * spheroidal coordinates.
 *
 * On the axis of the disc, the water has the speed of the disc at the disc and 0.18 of that speed
 * at a distance of one radius. Far from the disc, the flow is the flow of a dipole and decays with
 * the cube of the distance. The strength of the dipole follows from the added mass of the disc.
 * With the water density rho and the disc radius a, the added mass is (8/3) rho a^3.
 *
 * For motion along the plane of the disc, only the water near the ring of the disc moves. */
#pragma once

#include <stdint.h>

#include "core/base/vec.h"
#include "core/scene.h"
#include "core/tank/collision/obstacle.h"

struct water {
    /* Index of the layer of `height_m` that holds the current heights of the surface. The other
     * layer holds the heights of the previous step of the wave equation. */
    uint8_t newest;
    float height_m[2][RIPPLE_Z][RIPPLE_X];
};

/* Pushes the surface smoothly down by `depth_m` within `radius_m` of a point. A negative `depth_m`
 * lifts the surface. Points outside the tank are ignored. */
void water_press(struct water *water, vec3 size_m, vec3 point_m, float radius_m, float depth_m);

/* Returns the height of the surface at (x_m, z_m), interpolated between cell centres. Outside the
 * tank, returns the height at the nearest wall. */
float water_height_m(const struct water *water, vec3 size_m, float x_m, float z_m);

/* Advances the wave equation by one step of 1/60 s; called every second tick. */
void water_step(struct water *water, vec3 size_m);

/* Writes the slopes of the surface along x to slope[..][..][0] and along z to slope[..][..][1]. A
 * value of +127 means a slope of +0.25, and -127 means -0.25, as in scene.h. */
void water_slopes(const struct water *water, vec3 size_m, int8_t slope[RIPPLE_Z][RIPPLE_X][2]);

/* Returns the velocity, m/s, that a moving disc (a poi) gives to the water at a point in world
 * coordinates. The water is never faster than the disc. Returns zero if `disc` is a bowl, if the
 * point is above the surface, or if the point is farther than six disc radii from the disc's
 * centre. The velocity is proportional to the submerged fraction of the disc. Torn paper moves less
 * water: the flow that motion along the normal causes is proportional to the fraction of the paper
 * that remains. */
vec3 water_flow_m_s(const struct obstacle *disc, vec3 point_m);

/* Returns the pressure of the flow at a point divided by the water density, m^2/s^2. The result is
 * the speed of the disc times the speed of the water at the point. The pressure grows with the
 * square of the disc's speed, so fish hardly feel a slow disc. */
float water_push_m2_s2(const struct obstacle *disc, vec3 point_m);
