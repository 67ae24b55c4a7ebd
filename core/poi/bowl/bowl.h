/* bowl.h -- the bowl that floats beside a player and holds the caught fish.
 *
 * A thin half ellipsoid filled with water, softly moored. Motion of the bowl: bowl_buoyancy.h;
 * motion of its fish: bowl_fish.h. */
#ifndef KINGYO_CORE_POI_BOWL_BOWL_H
#define KINGYO_CORE_POI_BOWL_BOWL_H

#include <stdint.h>

#include "core/scene.h"
#include "core/tank/tank.h"

#define BOWL_RADIUS_M 0.080f /* The federation's standard: diameter at most 160 mm. */
#define BOWL_DEPTH_M 0.059f
#define BOWL_HULL_KG 0.030f
#define BOWL_FISH_MAX 112u      /* Fish of 4 cm that fit without overlap; the record is 107. */
#define BOWL_FISH_KG_MAX 0.172f /* Weight of that many fish; the limit for larger fish. */

struct bowl {
    uint8_t present;
    vec3 home_m;     /* Mooring position, as position_m; only x and z count. */
    vec3 position_m; /* Centre of the mouth, slightly above the water. */
    vec3 before_m;   /* `position_m` at the start of the tick. */
    vec3 velocity_m_s;
    float heel_x, heel_z; /* Components of the mouth's normal along world x and z, rad. */
    float heel_x_rad_s, heel_z_rad_s;
    float water_kg;      /* Water in the bowl. */
    float fish_kg;       /* Weight of the fish at the last tick. */
    uint32_t fish_count; /* Fish in the bowl; <= BOWL_FISH_MAX. */
};

/* The tank and the bowls that pois and fish interact with; bowls by player. Borrowed for a call. */
struct stall {
    struct tank *tank;
    struct bowl *bowls;
    uint32_t bowl_count; /* <= POI_MAX */
};

/* Initialises an empty bowl moored at a place. The bowl holds as much water as lets it float there
 * at rest, with its mouth 2 mm to BOWL_DEPTH_M / 2 above the water. */
void bowl_init(struct bowl *bowl, vec3 position_m);

/* Returns 1 if the bowl is full, by number or weight of fish. */
int bowl_is_full(const struct bowl *bowl);

/* Adds a fish of the tank that falls in at a world velocity, which rocks the bowl. A full bowl is
 * first poured back into the tank, as by an umpire; the score is kept elsewhere. */
void bowl_take(struct bowl *bowl, uint32_t bowl_index, struct tank *tank, struct fish *fish,
               vec3 velocity_m_s);

/* Pours every fish back into the tank, beside and under the bowl. */
void bowl_empty(struct bowl *bowl, uint32_t bowl_index, struct tank *tank);

/* Returns the radius of the hull `below_m` under the mouth: half an ellipsoid. */
float bowl_hull_radius_m(float below_m);

/* Returns the volume of the hull below a level `below_m` under the mouth, clamped to the hull. */
float bowl_room_m3(float below_m);

/* Returns the depth of the bowl's own water level, with the fish in it, under the mouth. */
float bowl_level_m(const struct bowl *bowl);

/* Returns the bowl as an obstacle for fish, with its motion in this tick. */
struct obstacle bowl_obstacle(const struct bowl *bowl);

/* Applies the reaction in `hull` after the tick of the fish: the bowl stays back where a fish could
 * not move out of its way. */
void bowl_apply_reaction(struct bowl *bowl, const struct obstacle *hull);

/* Returns the heel as angles for the scene. */
struct angles bowl_angles(const struct bowl *bowl);

uint64_t bowl_hash(uint64_t hash, const struct bowl *bowl);

#endif
