/* bowl.h -- the bowl that floats beside a player and holds the caught fish.
 *
 * The bowl is a thin half ellipsoid filled with water. A soft spring moors the bowl to its home
 * position. bowl_buoyancy.h moves the bowl, and bowl_fish.h moves the fish in it. y points up, and
 * the still water surface is at y = 0. */
#ifndef KINGYO_CORE_POI_BOWL_BOWL_H
#define KINGYO_CORE_POI_BOWL_BOWL_H

#include <stdint.h>

#include "core/scene.h"
#include "core/tank/tank.h"

/* Radius of the mouth. The rules of the goldfish-scooping federation allow a diameter of at most
 * 160 mm. */
#define BOWL_RADIUS_M 0.080f
#define BOWL_DEPTH_M 0.059f
#define BOWL_HULL_KG 0.030f
/* Number of 4 cm fish that fit into the bowl without overlap; the record catch is 107 fish. */
#define BOWL_FISH_MAX 112u
/* Mass of 112 fish of 4 cm, which limits the number of larger fish. */
#define BOWL_FISH_KG_MAX 0.172f

struct bowl {
    uint8_t present;
    vec3 home_m;     /* Mooring position, in the axes of `position_m`; only x and z have an
                        effect. */
    vec3 position_m; /* Centre of the bowl's mouth, slightly above the water. */
    vec3 before_m;   /* `position_m` at the start of the tick. */
    vec3 velocity_m_s;
    float heel_x, heel_z; /* Tilt of the bowl: x and z components of the mouth's unit normal in
                             world axes. */
    float heel_x_rad_s, heel_z_rad_s;
    float water_kg;      /* Mass of the water in the bowl. */
    float fish_kg;       /* Mass of the fish in the bowl, computed in the last tick. */
    uint32_t fish_count; /* Number of fish in the bowl, at most BOWL_FISH_MAX. */
};

/* The tank and the bowls with which pois and fish interact. bowls[i] belongs to player i. Functions
 * borrow the struct for the duration of a call. */
struct stall {
    struct tank *tank;
    struct bowl *bowls;
    uint32_t bowl_count; /* Number of entries in `bowls`, at most POI_MAX. */
};

/* Initializes an empty bowl that is moored at `position_m`. The height is clamped so that the mouth
 * is 2 mm to BOWL_DEPTH_M / 2 above the water. The amount of water in the bowl is chosen so that
 * the bowl floats at rest there. */
void bowl_init(struct bowl *bowl, vec3 position_m);

/* Returns 1 if the bowl has reached its largest number or mass of fish, otherwise 0. */
int bowl_is_full(const struct bowl *bowl);

/* Adds a fish of the tank that falls into the bowl at a world velocity, which rocks the bowl.
 * `bowl_index` is the index of the bowl in its stall. A full bowl is first poured back into the
 * tank, as an umpire would do. The caller keeps the score. Asserts that the bowl is present. */
void bowl_take(struct bowl *bowl, uint32_t bowl_index, struct tank *tank, struct fish *fish,
               vec3 velocity_m_s);

/* Puts every fish of the bowl back into the tank, beside the bowl and below it. */
void bowl_empty(struct bowl *bowl, uint32_t bowl_index, struct tank *tank);

/* Returns the radius of the half-ellipsoid hull at the depth `below_m` under the mouth. */
float bowl_hull_radius_m(float below_m);

/* Returns the volume of the hull below the level that is `below_m` under the mouth. The level is
 * clamped to the hull. */
float bowl_room_m3(float below_m);

/* Returns the distance from the bowl's mouth down to the water level in the bowl. The fish in the
 * bowl raise the level. */
float bowl_level_m(const struct bowl *bowl);

/* Returns the bowl as an obstacle for the fish of the tank, with its motion in this tick. */
struct obstacle bowl_obstacle(const struct bowl *bowl);

/* Applies `hull.reaction` to the bowl after the tick of the fish: the bowl stays back where a fish
 * could not give way. */
void bowl_apply_reaction(struct bowl *bowl, const struct obstacle *hull);

/* Returns the tilt of the bowl as angles for the renderer's scene. */
struct angles bowl_angles(const struct bowl *bowl);

uint64_t bowl_hash(uint64_t hash, const struct bowl *bowl);

#endif
