/* poi.h -- the paper scoop: a rigid ring on a spring from the hand, with a sheet of paper across. */
#ifndef KINGYO_CORE_POI_POI_H
#define KINGYO_CORE_POI_POI_H

#include <stdint.h>

#include "core/input.h"
#include "core/output.h"
#include "core/poi/sheet.h"
#include "core/scene.h"
#include "core/tank/tank.h"

#define POI_RADIUS_M 0.040f       /* Inner: the federation's 80 mm. */
#define POI_OUTER_RADIUS_M 0.0465f

struct poi {
    uint8_t link;                  /* enum poi_link of the last input. */
    vec3 position_m, velocity_m_s; /* Ring centre. */
    struct angles angles;
    vec3 angular_velocity_rad_s;   /* Of yaw, pitch, roll, in that order. */
    vec3 last_flow_m_s;            /* Velocity relative to water in the last tick, for added mass. */
    float immersed;                /* [0, 1] fraction of the disc below the surface. */
    float water_kg;                /* Carried on the paper, out of the tank. */
    float tip;                     /* [0, 1] how far the wrist has turned to empty into the bowl. */
    uint32_t dips;                 /* Times it went in: scoops. */
    struct sheet sheet;
};

/* A fresh poi of `grade` 4 .. 7 at rest above the tank. */
void poi_init(struct poi *poi, uint8_t grade, vec3 position_m, uint32_t seed);

/* One tick of the ring: pulled by the hand, held back by the water. `over_bowl` in [0, 1] turns a
 * wristless controller's poi. Loads of the fish on it were gathered by the last catch_tick. */
void poi_tick(struct poi *poi, const struct poi_target *target, const struct tank *tank,
              float over_bowl, struct poi_force *force);

/* Stirs the surface where the ring cuts or moves it. */
void poi_stir(const struct poi *poi, struct water *water, vec3 tank_size_m);

/* How the fish see it. */
struct obstacle poi_obstacle(const struct poi *poi);

uint64_t poi_hash(uint64_t hash, const struct poi *poi);
uint64_t poi_hash_quick(uint64_t hash, const struct poi *poi);

#endif
