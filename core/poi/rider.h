/* rider.h -- one fish on the paper: it lies on its side, slaps, slides, calms down.
 *
 * A rider's place is kept in the poi's own plane, so it goes where the poi goes. */
#ifndef KINGYO_CORE_POI_RIDER_H
#define KINGYO_CORE_POI_RIDER_H

#include <stdint.h>

#include "core/base/vec.h"
#include "core/input.h"
#include "core/poi/sheet.h"
#include "core/tank/fish.h"

/* What an umpire's eye takes to see that a ring is clear of the water: 50 ms. */
#define RIDER_CLEAR_TICKS (CORE_TICK_HZ / 20u)

enum rider_state {
    RIDER_LYING = 0,
    RIDER_FALLING = 1, /* In the air, off the poi: its world velocity carries it. */
    RIDER_LET_GO = 2,  /* The same, and its poi is gone: a fresh one in its place is not for it. */
};

struct rider {
    uint16_t fish;  /* Index in the tank. */
    uint8_t state;  /* enum rider_state */
    int8_t side;    /* +1 lies with its back to the left of its nose, -1 to the right. */
    uint8_t walled; /* Taken up where the ring pressed it against a wall. */
    uint8_t clear_ticks; /* So long, without a break, the whole ring has been over the water with
                            it; at most RIDER_CLEAR_TICKS. */
    float x_m, z_m; /* Centre, in the poi's plane ... */
    float height_m; /* ... and over it. */
    float slide_x_m_s, slide_z_m_s;
    float heading_rad; /* Of the nose in that plane; 0 along -z, positive left, as yaw. */
    float lie;         /* 0 upright in water .. 1 flat on its side. */
    float vigour;      /* [0, 1] how hard it slaps; tires. */
    float rest_s;      /* Until the next slap. */
    float slap_s;      /* Left of this one. */
    float slap_n;      /* Its force on the paper, ... */
    float slap_d_m;    /* ... its footprint. */
    float hop_s;       /* Left of what a slap lifts it for: so long hardly anything holds it. */
    vec3 fall_m_s;     /* World velocity while falling. */
};

/* What the paper does to what lies on it, in the poi's axes. */
struct ride {
    vec3 pull_m_s2; /* Gravity less the poi's own acceleration, in body axes; -y presses. */
    float uphill_x, uphill_z; /* The world's up, along the plane: [-1, 1], 0 when level. */
    float radius_m;           /* Of the paper. */
    float belly_m;            /* How deep it sags in its middle; < 0: it bulges up. */
    float give_per_n;         /* 1 / (2 pi tension): how it gives under one body; 0: a board. */
};

/* Half the thickness of a fish's ellipsoid along a unit direction given in the fish's axes. */
float fish_half_extent_m(const struct fish *fish, vec3 direction);

/* One tick of a lying rider. It slides down a slope and into the belly, each slap shakes it loose;
 * with water to swim in it makes off along its nose, the harder the less calm it is. `dry` in
 * [0, 1]: how much of its weight the water no longer bears. `key_tick` and `seed` choose its
 * slaps. Returns the force of a slap that begins now, else 0. */
float rider_tick(struct rider *rider, const struct fish *fish, const struct ride *ride, float dry,
                 uint32_t seed, uint32_t key_tick);

/* The tail's place in the poi's plane. */
void rider_tail(const struct rider *rider, float length_m, float *x_m, float *z_m);

/* Writes the fish's pose from the rider's and the poi's. It lies in the paper's belly. */
void rider_pose(const struct rider *rider, const struct ride *ride, vec3 poi_m,
                const struct basis *poi_axes, struct fish *fish);

uint64_t rider_hash(uint64_t hash, const struct rider *rider);

#endif
