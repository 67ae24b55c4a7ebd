/* water.h -- the surface: a height field of small waves that the poi stirs and the eye refracts. */
#ifndef KINGYO_CORE_TANK_WATER_H
#define KINGYO_CORE_TANK_WATER_H

#include <stdint.h>

#include "core/base/vec.h"
#include "core/scene.h"

struct water {
    uint8_t newest; /* Which of the two layers is now; the other is one step before. */
    float height_m[2][RIPPLE_Z][RIPPLE_X];
};

void water_init(struct water *water);

/* Pushes the surface down by `depth_m` (may be negative) within `radius_m` of a point, smoothly.
 * Points outside the tank are ignored. */
void water_press(struct water *water, vec3 size_m, vec3 point_m, float radius_m, float depth_m);

/* How high the surface stands at a point, between the middles of cells; beyond the walls as at
 * them. */
float water_height_m(const struct water *water, vec3 size_m, float x_m, float z_m);

/* One step of the wave equation with damping; called every second tick. */
void water_step(struct water *water, vec3 size_m);

/* Slopes as the scene wants them. */
void water_slopes(const struct water *water, vec3 size_m, int8_t slope[RIPPLE_Z][RIPPLE_X][2]);

uint64_t water_hash(uint64_t hash, const struct water *water);

#endif
