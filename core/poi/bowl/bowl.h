/* bowl.h -- the bowl that floats beside a player and holds the caught fish.
 *
 * The bowl is a thin half ellipsoid filled with water. A soft spring (the mooring) connects the
 * bowl to its home position. y points up, and the still water surface of the tank is at y = 0.
 *
 * A bowl sinks by a tenth of a millimetre with each fish and rocks when a fish falls into it. A
 * bowl tilts with the slope of the water surface, and its mooring returns the bowl after a push.
 * The rules of the goldfish-scooping federation forbid players to touch a bowl with the free hand.
 * Therefore only the ring of a poi (paper scoop) can push a bowl, and the ring of any player can
 * push any bowl. Tank walls and other bowls stop a bowl.
 *
 * Each fish in a bowl circles at its own depth, radius and angular speed, and the fish do not
 * overlap. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/base/rng.h"
#include "core/scene.h"
#include "core/tank/tank.h"

/* Radius of the mouth. The rules of the goldfish-scooping federation allow a diameter of at most
 * 160 mm. */
#define BOWL_RADIUS_M 0.080f
#define BOWL_DEPTH_M 0.059f
#define BOWL_HULL_KG 0.030f
/* Number of 4 cm fish that fit into the bowl without overlap. The largest catch on record is 107
 * fish. */
#define BOWL_FISH_MAX 112u
/* Mass of 112 fish that are 4 cm long. This mass limits the number of larger fish in the bowl. */
#define BOWL_FISH_KG_MAX 0.172f

struct bowl {
    bool present;
    /* Home position, to which the mooring returns the bowl, in the same axes as `position_m`. Only
     * x and z have an effect. */
    vec3 home_m;
    vec3 position_m; /* Centre of the bowl's mouth, slightly above the water. */
    vec3 before_m;   /* `position_m` at the start of the tick. */
    vec3 velocity_m_s;
    /* Tilt of the bowl: the x and z components of the mouth's unit normal in world axes. */
    float heel_x, heel_z;
    float heel_x_rad_s, heel_z_rad_s;
    float water_kg; /* Mass of the water in the bowl. */
    /* Mass of the fish in the bowl, updated once per tick and with each caught fish. */
    float fish_kg;
    uint32_t fish_count; /* Number of fish in the bowl, at most BOWL_FISH_MAX. */
};

/* The tank and the bowls of all players. bowls[i] belongs to player i. Functions use the pointers
 * only during a call. */
struct stall {
    struct tank *tank;
    struct bowl *bowls;
    uint32_t bowl_count; /* Number of entries in `bowls`, at most POI_MAX. */
    /* True if the players look at the tank from its short side (core/view.h), which determines the
     * stereo positions of sounds only. */
    bool is_turned;
};

/* Initializes an empty bowl that is moored at `position_m`. The height of the mouth is clamped to
 * the range from 2 mm to BOWL_DEPTH_M / 2 above the tank's water. The bowl gets the mass of water
 * with which it floats at rest at this height. */
void bowl_init(struct bowl *bowl, vec3 position_m);

/* Returns true if the bowl has reached its largest number or mass of fish. */
bool bowl_is_full(const struct bowl *bowl);

/* Adds a fish of the tank that falls into the bowl with the world velocity `velocity_m_s`. The
 * impact rocks the bowl. `bowl_index` is the index of the bowl in struct stall.
 *
 * If the bowl is already full, its fish first return to the tank, as if an umpire had emptied the
 * bowl.
 *
 * The caller counts the score. Asserts that the bowl is present. */
void bowl_take(struct bowl *bowl, uint32_t bowl_index, struct tank *tank, struct fish *fish,
               vec3 velocity_m_s);

/* Returns every fish of the bowl to the tank, at random places beside the bowl. */
void bowl_empty(struct bowl *bowl, uint32_t bowl_index, struct tank *tank);

/* Returns the radius of the hull at the depth `below_m` below the bowl's mouth. */
float bowl_hull_radius_m(float below_m);

/* Returns the volume of the hull below the depth `below_m`, which is measured from the bowl's
 * mouth. `below_m` is clamped to the hull. */
float bowl_room_m3(float below_m);

/* Returns the distance from the bowl's mouth down to the water surface in the bowl. The fish in the
 * bowl raise this surface. */
float bowl_level_m(const struct bowl *bowl);

/* Returns the bowl as an obstacle for the fish of the tank. The obstacle includes the motion of the
 * bowl in this tick. */
struct obstacle bowl_obstacle(const struct bowl *bowl);

/* Applies the contact with fish to the bowl. `hull` is the result of bowl_obstacle(), which the
 * contact solver changed in the tick of the fish. If `hull.reaction` shows that a fish blocked the
 * bowl, the bowl gets the position and velocity of `hull`. The caller must call this function after
 * the tick of the fish. */
void bowl_apply_reaction(struct bowl *bowl, const struct obstacle *hull);

/* Returns the tilt of the bowl as angles for the renderer's scene. */
struct angles bowl_angles(const struct bowl *bowl);

/* Returns a random number in [0, 1) for the fish with the index `fish`. `which` distinguishes the
 * random numbers that a fish needs for one `purpose`. */
static inline float bowl_draw(enum rng_purpose purpose, uint32_t seed, uint32_t fish,
                              uint32_t which)
{
    return rng_unit((struct rng_key){ seed, which, fish, purpose });
}

struct poi;

/* Advances every bowl of the stall by one tick (1/120 s). The caller must call this function after
 * the tick of the pois and before the tick of the fish. If live[i] is 1 (`i` < `poi_count`),
 * pois[i] pushes the bowls that its ring touches. A bowl above its largest mass loses water. */
void bowl_buoyancy_tick(const struct stall *stall, const struct poi *pois, const uint8_t *live,
                        uint32_t poi_count);

/* Advances the fish of one bowl by one tick (1/120 s). The fish move along with the bowl, swim, and
 * keep clear of each other and of the hull. Updates `fish_kg` of the bowl. Does nothing if the bowl
 * is absent or empty. */
void bowl_fish_tick(struct bowl *bowl, uint32_t bowl_index, struct tank *tank);
