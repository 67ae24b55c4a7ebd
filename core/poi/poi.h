/* poi.h -- the poi: a paper scoop that consists of a rigid ring and a sheet of paper.
 *
 * A spring (ring.h) pulls the ring toward the hand of the player. y points up, and the still water
 * surface is at y = 0. One tick is 1/120 s. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/input.h"
#include "core/output.h"
#include "core/poi/bowl/bowl.h"
#include "core/poi/catch/carried_fish.h"
#include "core/poi/paper/sheet.h"
#include "core/scene.h"
#include "core/tank/tank.h"

/* Inner radius of a standard ring. The rules of the goldfish-scooping federation prescribe a
 * diameter of 80 mm. Easier levels have a larger ring (core/game/rules.h). */
#define POI_RADIUS_M 0.040f
#define POI_OUTER_RADIUS_M 0.0465f
#define POI_RADIUS_MAX_M 0.060f /* Largest inner radius of a ring. */
#define POI_THICKNESS_M 0.003f
#define POI_MASS_KG 0.007f
#define POI_PAPER_DARK 0.34f /* Fraction of the light that thin paper absorbs above the water. */
/* Largest number of fish that a poi carries. 16 fish of 4 cm cover the paper side by side, and
 * additional fish slip off over the ring. */
#define POI_CARRIED_MAX 16u
_Static_assert(SHEET_LOAD_MAX == 2u * POI_CARRIED_MAX, "a body and a slap of each");

/* Input for one tick: the target pose, and whether the input device controls the angles of the
 * poi. */
struct poi_grip {
    struct poi_target target;
    /* True if the input controls the angles. False means that the input has no angles, and
     * therefore the poi tips over its bowl automatically. */
    bool has_wrist;
};

struct poi {
    uint8_t link; /* Source of the last input (enum poi_source). */
    /* True if the paper takes no damage, because no player controls the poi. */
    bool damage_immune;
    /* Random seed of the poi, which determines its paper and the slaps of its fish. */
    uint32_t seed;
    vec3 position_m, velocity_m_s; /* Position and velocity of the ring's centre, in world axes. */
    struct angles angles;
    vec3 before_m, before_m_s; /* `position_m` and `velocity_m_s` at the start of the tick. */
    /* `angles` at the start of the tick. The poi returns to these angles if fish block the
     * rotation. */
    struct angles before_angles;
    /* Target position of the ring in this tick, which is the position of the player's hand. */
    vec3 hand_m;
    /* Highest recent speed of the hand in m/s. The stored value decreases with time. */
    float pace_m_s;
    /* Motions of the ring that fish blocked in the last tick: bits of enum obstacle_reaction
     * (position, rotation). */
    uint8_t reaction;
    /* True if walls, floor, a bowl or another ring blocked the ring in this tick. */
    bool stopped;
    /* Number of consecutive ticks in which fish block the ring while the hand pulls the ring up; at
     * most 255. */
    uint8_t jam_ticks;
    /* True if the ring was in the water and the meniscus may still cling to its edge. */
    bool clings;
    /* Angular velocity: the rates of change of yaw, pitch and roll are stored as x, y and z. */
    vec3 angular_velocity_rad_s;
    /* Angular velocity of the poi's normal, as a vector in world axes. The rotation about the
     * normal itself is not included. */
    vec3 spin_rad_s;
    /* Low-pass filtered acceleration of the ring, which acts on the carried water and fish. */
    vec3 acceleration_m_s2;
    /* First stage of the low-pass filter, whose second stage gives `acceleration_m_s2`. */
    vec3 jolt_m_s2;
    /* Forces of the water along the normal in this tick: the drag coefficient `drag_n_s_m` and the
     * slam force `slam_n`. */
    float drag_n_s_m, slam_n;
    /* Coefficient of the water's friction for motion along the plane of the ring. */
    float edge_n_s_m;
    float added_kg;   /* Added mass of water for motion along the ring's normal. */
    float meniscus_n; /* Downward pull of the meniscus at the edge of the ring. */
    float immersed;   /* Share [0, 1] of the disc that is below the water surface. */
    /* Speed at which the ring entered the water (> 0) or left the water (< 0) in this tick. 0 means
     * that the ring neither entered nor left the water. */
    float splash_m_s;
    /* Mass of the water on the paper. The weight of this water counts only for the fraction of the
     * disc that is in air. */
    float water_kg;
    /* The two parts of `water_kg`: the film on both faces of the paper (`film_kg`), and the pool in
     * its sag (`pool_kg`). */
    float film_kg, pool_kg;
    /* Mass of drained water that hangs below the paper until the water forms a drop. */
    float drip_kg;
    uint8_t drops; /* Number of drops that fell in the last tick. */
    /* Number of ticks for which the poi stays tipped after its last fish left. */
    uint8_t laden_ticks;
    /* Progress of the automatic tip toward the bowl: 0 is not tipped, 1 is fully tipped. */
    float tip;
    /* Direction of the tip: a horizontal unit vector that is chosen when the tip starts. */
    vec3 tip_toward;
    /* Pressure on the paper in the last tick, positive toward the poi's up axis. */
    float pressure_pa;
    /* Number of scoops. A scoop is an entry of the poi into the water while a player controls the
     * poi. */
    uint32_t dips;
    /* True if the poi is in the water and was immersed deeply enough to count as a scoop. */
    bool is_in;
    /* Tick numbers of the last slap sound and the last tear sound; 0 means that there was no sound
     * yet. */
    uint32_t slap_tick, tear_tick;
    float tear_gain; /* Gain of the last tear sound. The gain affects sounds only. */
    struct sheet sheet;
    /* Effect of the last tick on the paper: number of torn cells and highest tension. */
    struct sheet_events strain;

    /* Mass of the carried fish that the paper supports. The mass that water supports is not
     * included. */
    float carried_kg;
    uint32_t carried_count; /* Number of entries in `carried_fish`, at most POI_CARRIED_MAX. */
    struct carried_fish carried_fish[POI_CARRIED_MAX];
    /* Number of entries in `loads`, written by the last catch_tick(); at most SHEET_LOAD_MAX. */
    uint32_t load_count;
    /* Number of slaps in `loads`. Slaps are the first entries of `loads`, and the other entries are
     * weights. */
    uint32_t slap_count;
    struct sheet_load loads[SHEET_LOAD_MAX];
};

/* Returns the outer radius of a ring with the inner radius `radius_m`. The rim of a larger ring is
 * wider in proportion. */
static inline float ring_outer_radius_m(float radius_m)
{
    return radius_m * (POI_OUTER_RADIUS_M / POI_RADIUS_M);
}

static inline float poi_radius_m(const struct poi *poi)
{
    return poi->sheet.radius_m;
}

static inline float poi_outer_radius_m(const struct poi *poi)
{
    return ring_outer_radius_m(poi->sheet.radius_m);
}

/* Returns the half extent of the ring along a world axis. `n` is the component of the ring's unit
 * normal along that axis. */
static inline float poi_half_extent_m(const struct poi *poi, float n)
{
    return poi_outer_radius_m(poi) * f_sqrt(f_max(0.0f, 1.0f - n * n)) +
           0.5f * POI_THICKNESS_M * f_abs(n);
}

/* Initializes a poi at rest with dry paper. `grade` is the paper grade, from 4 (strong) to 7
 * (weak). `seed` determines the random properties of the paper. */
void poi_init(struct poi *poi, uint8_t grade, vec3 position_m, uint32_t seed);

/* Initializes a poi like poi_init(), with a ring of the inner radius `radius_m`, POI_RADIUS_M ..
 * POI_RADIUS_MAX_M. */
void poi_init_sized(struct poi *poi, uint8_t grade, float radius_m, vec3 position_m, uint32_t seed);

/* Advances the ring by one tick. The hand spring pulls the ring. Water, floor, walls and the
 * player's own bowl act against the spring.
 *
 * If the input has no angles, a poi that carries fish rises over the bowl's mouth and tips toward
 * the bowl. When a blocked ring becomes free, its speed exceeds the recent speed of the hand by at
 * most 1 m/s.
 *
 * Asserts that the target is finite. poi_haptics() computes the force feedback, and
 * surface_disturbance_tick() computes the effect on the water surface. */
void poi_tick(struct poi *poi, const struct poi_grip *grip, const struct tank *tank,
              const struct bowl *bowl);

/* Returns the poi as an obstacle for fish, including its motion in this tick. The result points to
 * the paper cells of `poi` and is valid only as long as `poi`. */
struct obstacle poi_obstacle(const struct poi *poi);

/* Ends the tick of a poi. `ring` is the result of poi_obstacle(), in which the contact solver has
 * undone the motion that fish blocked. The function undoes the same motion of the poi. The
 * remaining motion then wets, strains and tears the paper, together with the fish loads that the
 * last catch_tick() wrote. The caller must call this function after the tick of the fish. */
void poi_apply_reaction(struct poi *poi, const struct obstacle *ring);

/* Returns the fraction of the normal water force that still acts on a poi with torn paper. A poi
 * without paper keeps 15 %, which is the force on the bare ring. */
static inline float poi_whole(const struct poi *poi)
{
    return 0.15f + 0.85f * sheet_left(&poi->sheet);
}

/* Returns the volume of the carried water divided by the area of the paper. The function excludes
 * water on the immersed part of the poi. */
float carried_water_m(const struct poi *poi);

/* Returns the shade that the poi casts on the water. The poi casts no shade while it touches the
 * water. */
struct shade_cast poi_shade(const struct poi *poi);

/* Moves the ring out of the floor, the walls and the player's own bowl, and back into the reach
 * of the arm. Removes the part of the ring's velocity that points beyond these limits.
 * poi_tick() calls this function. Another caller needs the function if it moved the ring after
 * poi_tick(). */
void poi_constrain(struct poi *poi, const struct tank *tank, const struct bowl *bowl);

/* Moves the ring out of another player's bowl `bowl`. The caller must have called poi_tick() in
 * this tick. */
void poi_constrain_to_bowl(struct poi *poi, const struct bowl *bowl);

/* Separates two rings that overlap, or that passed through each other in this tick. Each ring moves
 * by half of the overlap. The caller must have called poi_tick() for both pois.
 *
 * Rings that press against each other slide apart at 0.6 m/s each, so that no player can block
 * another player's ring for long. The order of `a` and `b` has no effect.
 *
 * Returns true if the rings touched. The caller must then apply the constraints of walls and bowls
 * again. */
bool ring_pairs_separate(struct poi *a, struct poi *b);

/* Applies the disturbances that `poi` causes in one tick (1/120 s) to `water`. The ring disturbs
 * the surface when it moves up or down, when its edge cuts through the surface, and when water
 * drips from the ring. */
void surface_disturbance_tick(const struct poi *poi, struct water *water, vec3 tank_size_m);

#define POI_GRIP_M 0.130f /* Distance from the ring's centre to the grip, along the handle. */
/* Slap force at which the slap feedback has its full strength. The value is the force of the
 * strongest slap of a 5 cm fish in air. */
#define POI_SLAP_N_FULL 0.15f
#define POI_TEAR_CELLS_FULL 10.0f

/* Writes the force feedback of this tick to `force`: the force and the torque on the hand that
 * holds the poi. The force comes from the same physics that moves the ring. A freely moving ring
 * pulls at the hand with its drag, added mass, weight, meniscus force and fish. If walls, floor, a
 * bowl or fish block the ring, the stretched hand spring pulls at the hand.
 *
 * The torque about the grip depends on the point at which each force acts. catch_tick() collects
 * the slaps of the fish in one tick. In the next tick, each slap loads the paper, moves the ring
 * and acts on the hand.
 *
 * The values of `force` are limited to the ranges in output.h. The caller must have called
 * poi_apply_reaction() in this tick. */
void poi_haptics(const struct poi *poi, struct poi_force *force);
