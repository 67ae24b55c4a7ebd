/* carried_fish.h -- the fish on a poi (paper scoop), their loads on the paper, and the water that
 * the poi carries.
 *
 * A carried fish lies on its side, slaps, slides and calms down. The position of the fish is stored
 * in the plane of the poi, so that the fish moves with the poi. Carried fish lie side by side.
 *
 * A fish falls only through a hole under its body. A pinhole under the body or a hole beside the
 * body does not drop the fish. A hole as wide as the girth of the fish drops the fish. A hole that
 * leaves only a narrow strip of paper under the fish also drops the fish.
 *
 * The carried water is a film on both faces of the paper and a pool in the sag of the paper. On an
 * upside-down poi, the pool lies in the ring, which is 3 mm high. Only the tank supplies water.
 * Therefore the mass of the carried water never increases in air. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/base/vec.h"
#include "core/input.h"
#include "core/poi/paper/sheet.h"
#include "core/tank/fish.h"

/* Number of ticks (50 ms) for which the whole ring must be above the water with the fish on it
 * before the catch is valid. A catch without this time is a foul. */
#define CARRIED_CLEAR_TICKS (CORE_TICK_HZ / 20u)

enum carried_fish_state {
    CARRIED_LYING = 0,
    CARRIED_FALLING = 1, /* The fish is in the air and falls after it left the paper. */
    /* The fish falls, and the poi that dropped it no longer exists. A new poi of the player does
     * not catch the fish. */
    CARRIED_RELEASED = 2,
};

struct poi;

struct carried_fish {
    uint16_t fish; /* Index of the fish in the tank. */
    uint8_t state; /* State of the carried fish (enum carried_fish_state). */
    /* Side on which the fish lies. The value is +1 if the back of the fish is to the left of the
     * direction of its nose, and -1 if the back is to the right. */
    int8_t side;
    /* True if the ring pressed the fish against a tank wall when the fish was captured, which is a
     * foul. */
    bool walled;
    /* Number of consecutive ticks in which the whole ring was above the water with the fish on it;
     * at most CARRIED_CLEAR_TICKS. */
    uint8_t clear_ticks;
    float x_m, z_m; /* Centre of the fish, in the plane of the poi. */
    float height_m; /* Height of the fish's centre above the plane of the poi. */
    float slide_x_m_s, slide_z_m_s;
    /* Direction of the fish's nose in the plane of the poi. 0 is along the poi's -z axis, and
     * positive angles turn to the left, like yaw. */
    float heading_rad;
    /* Progress of the fish's roll onto its side: 0 is upright in water, 1 is flat on its side. */
    float lie;
    /* Strength [0, 1] of the fish's slaps, which decreases as the fish calms down. */
    float vigour;
    float rest_s; /* Time in seconds until the next slap. */
    /* Remaining time of the current slap; 0 means that the fish does not slap. */
    float slap_s;
    float slap_n;   /* Force of the current slap on the paper. */
    float slap_d_m; /* Diameter of the patch of paper that the tail hits. */
    /* Remaining time of the hop after a slap. During a hop, there is hardly any friction. */
    float hop_s;
    vec3 fall_m_s; /* Velocity of a falling fish in world axes. */
};

/* State of the poi and its paper that affects a carried fish, in the poi's axes. */
struct paper_surface {
    /* Gravity minus the poi's own acceleration. A negative y component presses the fish onto the
     * paper. */
    vec3 pull_m_s2;
    /* x and z components, in the poi's axes, of the world's up direction. Each is in [-1, 1], and
     * both are 0 if the poi is level. */
    float uphill_x, uphill_z;
    float radius_m; /* Radius of the paper. */
    /* Depth of the sag at the centre of the paper; negative if the paper bulges up. */
    float belly_m;
    /* Compliance of the paper under a single body: 1 / (2 * pi * tension). 0 means rigid paper. */
    float give_per_n;
};

/* Returns half the thickness of the fish's ellipsoid along `direction`, which is a unit vector in
 * the fish's own axes. */
float carried_fish_half_extent_m(const struct fish *fish, vec3 direction);

/* Advances a lying fish by one tick (1/120 s). The fish slides down a slope or into the sag of the
 * paper. A slap reduces the friction for a moment. A fish in enough water swims off the paper in
 * the direction of its nose, more slowly if the fish is calm.
 *
 * `dry` in [0, 1] is the fraction of the fish's weight that water does not support. `seed` and
 * `key_tick` are the random seed and the tick number that determine the slaps.
 *
 * Returns the force in N of a slap that starts in this tick, or 0 if no slap starts. */
float carried_fish_tick(struct carried_fish *carried, const struct fish *fish,
                        const struct paper_surface *ride, float dry, uint32_t seed,
                        uint32_t key_tick);

/* Writes the position of the fish's tail in the plane of the poi. */
void carried_fish_tail(const struct carried_fish *carried, float length_m, float *x_m, float *z_m);

/* Writes the position, the angles and the tail motion of `fish`. The inputs are the carried fish,
 * the sag of the paper, and the position and axes of the poi. */
void carried_fish_pose(const struct carried_fish *carried, const struct paper_surface *ride,
                       vec3 poi_m, const struct basis *poi_axes, struct fish *fish);

/* Separates overlapping carried fish for one tick; the lighter fish moves more. The ring stops a
 * fish that is pushed outward. A fish without enough room is pushed over the ring. Fish in the air
 * are ignored. `fish` is the tank's array of fish. */
void carried_separation_tick(struct poi *poi, const struct fish *fish);

/* Returns true if paper or ring supports the middle of a lying fish, and also its front half or its
 * rear half. A fish whose centre is beyond the ring is not supported. */
bool carried_support_holds(const struct sheet *sheet, const struct carried_fish *carried,
                           const struct fish *fish);

/* Returns the fraction [0, 1] of a carried fish's weight that water does not support. */
float carried_load_dryness(const struct poi *poi, const struct basis *axes,
                           const struct carried_fish *carried, const struct fish *fish);

/* Writes `loads`, `load_count`, `slap_count` and `carried_kg` of the poi for the next tick of the
 * paper.
 *
 * The body of a fish acts on a patch 20 mm in diameter. A slap acts at the tail on a patch 2 to
 * 5 mm in diameter if there is paper under the tail. Otherwise the force of the slap acts at the
 * body, on a patch whose area is 16 to 100 times larger.
 *
 * `pull_m_s2` is gravity minus the poi's own acceleration, along the poi's up axis. `fish` is the
 * tank's array of fish. */
void carried_load_gather(struct poi *poi, const struct basis *axes, float pull_m_s2,
                         const struct fish *fish);

/* Updates the water that the poi carries for one tick (1/120 s): the film on the paper, the pool in
 * its sag, and the falling drops. Under water, the film and the pool fill up. In air, water drains
 * in three ways. Over the rim, the time constant is 0.15 s divided by the sine of the tilt. Water
 * also drains through holes, and slowly through wet paper.
 *
 * `up_y` is the vertical component of the poi's unit normal. */
void carried_water_tick(struct poi *poi, float up_y);
