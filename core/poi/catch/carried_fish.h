/* carried_fish.h -- one carried fish, which lies on its side, slaps, slides and calms down.
 *
 * The position is stored in the plane of the poi, so the fish moves with the poi. */
#ifndef KINGYO_CORE_POI_CATCH_CARRIED_FISH_H
#define KINGYO_CORE_POI_CATCH_CARRIED_FISH_H

#include <stdint.h>

#include "core/base/vec.h"
#include "core/input.h"
#include "core/poi/paper/sheet.h"
#include "core/tank/fish.h"

/* Time in which an umpire sees that a ring is clear of the water: 50 ms. */
#define CARRIED_CLEAR_TICKS (CORE_TICK_HZ / 20u)

enum carried_fish_state {
    CARRIED_LYING = 0,
    CARRIED_FALLING = 1,  /* In the air, off the poi, moving at its world velocity. */
    CARRIED_RELEASED = 2, /* In the air, and its poi is gone; a new poi in its place does not
                             catch it. */
};

struct carried_fish {
    uint16_t fish;       /* Index of the fish in the tank. */
    uint8_t state;       /* enum carried_fish_state */
    int8_t side;         /* +1 if the back is to the left of the nose, -1 if to the right. */
    uint8_t walled;      /* 1 if captured where the ring pressed the fish against a wall. */
    uint8_t clear_ticks; /* Consecutive ticks in which the whole ring was above the water with the
                            fish; at most CARRIED_CLEAR_TICKS. */
    float x_m, z_m;      /* Centre, in the plane of the poi. */
    float height_m;      /* Height of the centre above that plane. */
    float slide_x_m_s, slide_z_m_s;
    float heading_rad; /* Direction of the nose in that plane; 0 along -z, positive left, as yaw. */
    float lie;         /* 0 upright in water .. 1 flat on its side. */
    float vigour;      /* [0, 1] strength of its slaps; decays. */
    float rest_s;      /* Time until the next slap. */
    float slap_s;      /* Time left of the present slap. */
    float slap_n;      /* Force of the slap on the paper. */
    float slap_d_m;    /* Diameter of the slap's footprint. */
    float hop_s;       /* Time left of the hop after a slap, with hardly any friction. */
    vec3 fall_m_s;     /* World velocity while falling. */
};

/* The state of the paper for what lies on it, in the poi's axes. */
struct paper_surface {
    vec3 pull_m_s2; /* Gravity minus the poi's own acceleration, in body axes; -y presses. */
    float uphill_x, uphill_z; /* World up along the plane: [-1, 1], 0 if level. */
    float radius_m;           /* Radius of the paper. */
    float belly_m;            /* Depth of the sag at the centre; < 0: the paper bulges up. */
    float give_per_n;         /* 1 / (2 pi tension): compliance under one body; 0: rigid. */
};

/* Returns half the thickness of a fish's ellipsoid along a unit vector in the fish's axes. */
float carried_fish_half_extent_m(const struct fish *fish, vec3 direction);

/* Advances a lying fish by one tick. The fish slides down a slope and into the sag, and each slap
 * loosens it. With water to swim in it swims off along its nose, harder if it is less calm. `dry`
 * in [0, 1] is the share of its weight that water does not support. `key_tick` and `seed` select
 * its slaps. Returns the force of a slap that begins now, otherwise 0. */
float carried_fish_tick(struct carried_fish *carried, const struct fish *fish,
                        const struct paper_surface *ride, float dry, uint32_t seed,
                        uint32_t key_tick);

/* Writes the position of the tail in the plane of the poi. */
void carried_fish_tail(const struct carried_fish *carried, float length_m, float *x_m, float *z_m);

/* Writes the pose of the fish, which lies in the sag of the paper, from its own state and the
 * poi's. */
void carried_fish_pose(const struct carried_fish *carried, const struct paper_surface *ride,
                       vec3 poi_m, const struct basis *poi_axes, struct fish *fish);

uint64_t carried_fish_hash(uint64_t hash, const struct carried_fish *carried);

#endif
