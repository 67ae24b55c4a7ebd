/* poi.h -- the paper scoop: a rigid ring on a spring from the hand, with a sheet of paper across.
 */
#ifndef KINGYO_CORE_POI_POI_H
#define KINGYO_CORE_POI_POI_H

#include <stdint.h>

#include "core/input.h"
#include "core/output.h"
#include "core/poi/bowl.h"
#include "core/poi/rider.h"
#include "core/poi/sheet.h"
#include "core/scene.h"
#include "core/tank/tank.h"

#define POI_RADIUS_M 0.040f /* Inner: the federation's 80 mm. */
#define POI_OUTER_RADIUS_M 0.0465f
#define POI_THICKNESS_M 0.003f
#define POI_MASS_KG 0.007f
#define POI_PAPER_DARK 0.34f /* Of the light: what thin paper over the water takes. */
#define POI_RIDER_MAX 16u /* 4 cm fish, side by side, cover it; more spill over the ring. */
_Static_assert(SHEET_LOAD_MAX == 2u * POI_RIDER_MAX, "a body and a slap of each");

/* Half the ring's extent along a world axis on which its unit normal has the part `n`. */
static inline float poi_half_extent_m(float n)
{
    return POI_OUTER_RADIUS_M * f_sqrt(f_max(0.0f, 1.0f - n * n)) +
           0.5f * POI_THICKNESS_M * f_abs(n);
}

/* How a hand holds it. */
struct poi_grip {
    struct poi_target target;
    int has_wrist; /* 0: the poi empties itself over its bowl. */
};

struct poi {
    uint8_t link;                  /* enum poi_link of the last input. */
    uint8_t spared;                /* Nobody leads it: what happens to it tears no paper. */
    uint32_t seed;                 /* Of this specimen; its fish slap by it. */
    vec3 position_m, velocity_m_s; /* Ring centre. */
    struct angles angles;
    vec3 before_m, before_m_s;   /* Where, how fast and how turned it was when the tick began: */
    struct angles before_angles; /* what it may give back. */
    vec3 hand_m;                 /* Where the hand draws it in this tick, ... */
    float pace_m_s;              /* ... and how fast that goes, or went of late. */
    uint8_t gave;    /* Bits of enum obstacle_gave: how fish held it up in the last tick. */
    uint8_t stopped; /* Walls, floor or bowl held it up in this one. */
    uint8_t jam_ticks; /* So long fish have held it against a hand that pulls up; <= 255. */
    uint8_t clings;  /* It was in the water, which has not let go of its edge yet. */
    vec3 angular_velocity_rad_s; /* Of yaw, pitch, roll, in that order. */
    vec3 spin_rad_s;             /* World; the part that turns its normal. */
    vec3 acceleration_m_s2;      /* Over the last few ticks; what water and fish on it feel ... */
    vec3 jolt_m_s2;              /* ... and the first of the two filters that make it. */
    float drag_n_s_m, slam_n;    /* Of water on the paper in this tick: for each m/s, and once; */
    float edge_n_s_m;            /* friction along its plane, for each m/s; */
    float added_kg;              /* what of it moves along; */
    float meniscus_n;            /* and what clings to the edge: pulls down. */
    float immersed;              /* [0, 1] fraction of the disc below the surface. */
    float splash_m_s;            /* This tick the ring went in (> 0) or came out (< 0), so fast. */
    float water_kg;              /* On the paper; a load only out of the tank: ... */
    float film_kg, pool_kg;      /* ... what clings to it, and what lies in it; ... */
    float drip_kg;               /* ... and what hangs below it until it is a drop. */
    uint8_t drops;               /* Fell in the last tick. */
    uint8_t laden_ticks;         /* Until it forgets that fish lay on it, and tips back. */
    float tip;         /* [0, 1] how far the wrist has turned to empty into the bowl ... */
    vec3 tip_toward;   /* ... and which way: horizontal, unit, chosen when it begins. */
    float pressure_pa; /* On the paper in the last tick, positive toward +up. */
    uint32_t dips;     /* Times a hand put it in: scoops. */
    uint8_t is_in;     /* It is in for such a one. */
    uint32_t slap_tick, tear_tick; /* When each was last heard. */
    struct sheet sheet;
    struct sheet_events strain; /* What the last tick did to the paper. */

    float riders_kg;      /* Weight of fish that the paper bears in air. */
    uint32_t rider_count; /* <= POI_RIDER_MAX */
    struct rider riders[POI_RIDER_MAX];
    uint32_t load_count; /* <= SHEET_LOAD_MAX; gathered by the last catch_tick. */
    uint32_t slap_count; /* The first so many of them are blows of tails, the others weights. */
    struct sheet_load loads[SHEET_LOAD_MAX];
};

/* A fresh poi of `grade` 4 .. 7 at rest; `position_m` above the water keeps it dry. */
void poi_init(struct poi *poi, uint8_t grade, vec3 position_m, uint32_t seed);

/* One tick of the ring: pulled by the hand, held back by water, floor, walls and its own bowl.
 * Without a wrist it rises and turns toward the bowl when it is over its mouth with fish on it. A
 * ring that was held back does not shoot off when it comes free: it is never faster than the hand
 * goes, or went a moment ago, by more than 1 m/s. A target that is not finite is a bug and asserts.
 * What the hand feels of it: haptics.h; what the surface does: wake.h. */
void poi_tick(struct poi *poi, const struct poi_grip *grip, const struct tank *tank,
              const struct bowl *bowl);

/* How the fish see it, and how it came there in this tick. The paper is borrowed. */
struct obstacle poi_obstacle(const struct poi *poi);

/* After the fish's tick: where one could not get out of its way, it gives way as `ring` tells. Then
 * the way that was truly made wets, strains and tears the paper, with the loads of the fish on it
 * that the last catch_tick gathered. */
void poi_give_way(struct poi *poi, const struct obstacle *ring);

/* Of what the water pushes, so much is left: a torn poi is a ring. */
static inline float poi_whole(const struct poi *poi)
{
    return 0.15f + 0.85f * sheet_left(&poi->sheet);
}

/* Mean depth over the whole paper of the water that it carries out of the tank. */
float poi_water_m(const struct poi *poi);

/* What it casts on the water below it: none once it dips. */
struct shade_cast poi_shade(const struct poi *poi);

uint64_t poi_hash(uint64_t hash, const struct poi *poi);
uint64_t poi_hash_quick(uint64_t hash, const struct poi *poi);

#endif
