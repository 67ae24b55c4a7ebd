/* water.h -- the water surface: a height field of small waves, stirred by pois and used for
 * refraction. */
#ifndef KINGYO_CORE_TANK_WATER_H
#define KINGYO_CORE_TANK_WATER_H

#include <stdint.h>

#include "core/base/vec.h"
#include "core/scene.h"

struct water {
    uint8_t newest; /* Index of the current layer; the other layer is one step older. */
    float height_m[2][RIPPLE_Z][RIPPLE_X];
};

void water_init(struct water *water);

/* Pushes the surface down smoothly by `depth_m` (may be negative) within `radius_m` of a point.
 * Points outside the tank are ignored. */
void water_press(struct water *water, vec3 size_m, vec3 point_m, float radius_m, float depth_m);

/* Returns the height of the surface at a point, interpolated between cell centres; beyond the
 * walls, the height at the wall. */
float water_height_m(const struct water *water, vec3 size_m, float x_m, float z_m);

/* Advances the damped wave equation by one step; called every second tick. */
void water_step(struct water *water, vec3 size_m);

/* Writes the slopes in the scale of the scene. */
void water_slopes(const struct water *water, vec3 size_m, int8_t slope[RIPPLE_Z][RIPPLE_X][2]);

uint64_t water_hash(uint64_t hash, const struct water *water);

#endif
