/* water.h -- the water surface as a field of wave heights. Pois and fish make waves, and the
 * renderer uses the slopes for refraction. */
#ifndef KINGYO_CORE_TANK_WATER_H
#define KINGYO_CORE_TANK_WATER_H

#include <stdint.h>

#include "core/base/vec.h"
#include "core/scene.h"

struct water {
    uint8_t newest; /* Index of the current layer of `height_m`. The other layer holds the heights
                       of the previous step. */
    float height_m[2][RIPPLE_Z][RIPPLE_X];
};

void water_init(struct water *water);

/* Pushes the surface smoothly down by `depth_m` within `radius_m` of a point. A negative `depth_m`
 * lifts the surface. Points outside the tank are ignored. */
void water_press(struct water *water, vec3 size_m, vec3 point_m, float radius_m, float depth_m);

/* Returns the height of the surface at (x_m, z_m), interpolated between cell centres. Outside the
 * tank, returns the height at the nearest wall. */
float water_height_m(const struct water *water, vec3 size_m, float x_m, float z_m);

/* Advances the wave equation by one step of 1/60 s; called every second tick. */
void water_step(struct water *water, vec3 size_m);

/* Writes the slopes of the surface along x to slope[..][..][0] and along z to slope[..][..][1]. The
 * values +127 and -127 mean slopes of +0.25 and -0.25, as in scene.h. */
void water_slopes(const struct water *water, vec3 size_m, int8_t slope[RIPPLE_Z][RIPPLE_X][2]);

uint64_t water_hash(uint64_t hash, const struct water *water);

#endif
