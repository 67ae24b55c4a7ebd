/* poi.h -- the paper scoop: a rigid ring with a sheet of paper, pulled by the hand spring. */
#ifndef KINGYO_CORE_POI_POI_H
#define KINGYO_CORE_POI_POI_H

#include <stdint.h>

#include "core/input.h"
#include "core/output.h"
#include "core/poi/bowl/bowl.h"
#include "core/poi/catch/carried_fish.h"
#include "core/poi/paper/sheet.h"
#include "core/scene.h"
#include "core/tank/tank.h"

#define POI_RADIUS_M 0.040f /* Inner radius: the federation's 80 mm. */
#define POI_OUTER_RADIUS_M 0.0465f
#define POI_THICKNESS_M 0.003f
#define POI_MASS_KG 0.007f
#define POI_PAPER_DARK 0.34f /* Share of the light that thin paper over the water takes. */
/* 16 fish of 4 cm cover the paper side by side; more slip off over the ring. */
#define POI_CARRIED_MAX 16u
_Static_assert(SHEET_LOAD_MAX == 2u * POI_CARRIED_MAX, "a body and a slap of each");

/* Returns half the extent of the ring along a world axis; `n` is the component of its unit normal
 * along that axis. */
static inline float poi_half_extent_m(float n)
{
    return POI_OUTER_RADIUS_M * f_sqrt(f_max(0.0f, 1.0f - n * n)) +
           0.5f * POI_THICKNESS_M * f_abs(n);
}

/* The grip of the hand: the target, and whether the hand controls the angles. */
struct poi_grip {
    struct poi_target target;
    int has_wrist; /* 0: no wrist input, so the poi tips over its bowl automatically. */
};

struct poi {
    uint8_t link;                  /* enum poi_source of the last input. */
    uint8_t damage_immune;         /* 1 if no player controls the poi: damage of the paper is
                                      disabled. */
    uint32_t seed;                 /* Seed of this specimen, also for the slaps of its fish. */
    vec3 position_m, velocity_m_s; /* Position and velocity of the ring's centre. */
    struct angles angles;
    vec3 before_m, before_m_s;   /* Position and velocity at the start of the tick. */
    struct angles before_angles; /* Angles at the start of the tick; the reaction may restore
                                    them. */
    vec3 hand_m;                 /* Target position of the hand in this tick. */
    float pace_m_s;              /* Recent highest speed of the hand. */
    uint8_t
        reaction; /* Bits of enum obstacle_reaction: how fish blocked the ring in the last tick. */
    uint8_t stopped;   /* 1 if walls, floor or a bowl blocked the ring in this tick. */
    uint8_t jam_ticks; /* Ticks since fish block the ring against a hand that pulls up; <= 255. */
    uint8_t clings; /* 1 if the ring was in the water and the meniscus still clings to its edge. */
    vec3 angular_velocity_rad_s; /* Rates of yaw, pitch and roll, in that order. */
    vec3 spin_rad_s;             /* World rotation; only the part that turns the normal. */
    vec3 acceleration_m_s2;      /* Filtered acceleration of the last few ticks, which acts on water
                                    and fish. */
    vec3 jolt_m_s2;              /* State of the first of the two filters of `acceleration_m_s2`. */
    float drag_n_s_m, slam_n;    /* Water forces on the paper in this tick: drag per m/s, and
                                    slam. */
    float edge_n_s_m;            /* Friction along the plane, per m/s. */
    float added_kg;              /* Added mass of water along the normal. */
    float meniscus_n;            /* Pull of the meniscus at the edge, downward. */
    float immersed;              /* [0, 1] fraction of the disc below the surface. */
    float splash_m_s;            /* Speed at which the ring entered (> 0) or left (< 0) the water in
                                    this tick. */
    float water_kg;              /* Water on the paper; a load only out of the tank. */
    float film_kg, pool_kg;      /* Parts of the water: the clinging film and the pool. */
    float drip_kg;               /* Water that hangs below the paper until it forms a drop. */
    uint8_t drops;               /* Drops that fell in the last tick. */
    uint8_t laden_ticks;         /* Ticks until the poi tips back after the last fish left it. */
    float tip;                   /* [0, 1] progress of the tip toward the bowl. */
    vec3 tip_toward;             /* Direction of the tip: horizontal, unit, chosen at its start. */
    float pressure_pa;           /* Pressure on the paper in the last tick, positive toward +up. */
    uint32_t dips;               /* Scoops: times a player put the poi into the water. */
    uint8_t is_in;               /* 1 during such a scoop. */
    uint32_t slap_tick, tear_tick; /* Ticks of the last slap sound and the last tear sound. */
    struct sheet sheet;
    struct sheet_events strain; /* Effect of the last tick on the paper. */

    float carried_kg;       /* Weight of the fish that the paper supports in air. */
    uint32_t carried_count; /* <= POI_CARRIED_MAX */
    struct carried_fish carried_fish[POI_CARRIED_MAX];
    uint32_t load_count; /* <= SHEET_LOAD_MAX; gathered by the last catch_tick(). */
    uint32_t slap_count; /* The first `slap_count` loads are slaps, the others are weights. */
    struct sheet_load loads[SHEET_LOAD_MAX];
};

/* Initialises a new poi of `grade` 4 .. 7 at rest; a `position_m` above the water keeps it dry. */
void poi_init(struct poi *poi, uint8_t grade, vec3 position_m, uint32_t seed);

/* Advances the ring by one tick: the hand spring pulls the ring; water, floor, walls and its own
 * bowl hold it back. Without wrist input the ring rises and turns toward the bowl when it is over
 * the bowl's mouth with fish on it. A blocked ring does not shoot off when it comes free: the ring
 * exceeds the recent speed of the hand by at most 1 m/s. Asserts that the target is finite. Force
 * on the hand: haptics.h; effect on the surface: surface_disturbance.h. */
void poi_tick(struct poi *poi, const struct poi_grip *grip, const struct tank *tank,
              const struct bowl *bowl);

/* Returns the poi as an obstacle for fish, with its motion in this tick. The paper is borrowed. */
struct obstacle poi_obstacle(const struct poi *poi);

/* Applies the reaction in `ring` after the tick of the fish, where a fish could not move out of the
 * way. The remaining true motion then wets, strains and tears the paper, with the fish loads that
 * the last catch_tick() gathered. */
void poi_apply_reaction(struct poi *poi, const struct obstacle *ring);

/* Returns the share of the water force that remains: a torn poi is only a ring. */
static inline float poi_whole(const struct poi *poi)
{
    return 0.15f + 0.85f * sheet_left(&poi->sheet);
}

/* Returns the mean depth over the whole paper of the water carried out of the tank. */
float carried_water_m(const struct poi *poi);

/* Returns the shade on the water below the poi, or no shade once the poi dips in. */
struct shade_cast poi_shade(const struct poi *poi);

uint64_t poi_hash(uint64_t hash, const struct poi *poi);
uint64_t poi_hash_quick(uint64_t hash, const struct poi *poi);

#endif
