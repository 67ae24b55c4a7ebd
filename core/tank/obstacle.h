/* obstacle.h -- what the poi and the bowls are to a fish: hulls to keep out of. */
#ifndef KINGYO_CORE_TANK_OBSTACLE_H
#define KINGYO_CORE_TANK_OBSTACLE_H

#include <stdint.h>

#include "core/tank/fish.h"

enum obstacle_kind {
    OBSTACLE_DISC, /* A poi: a rigid ring with a sheet across. */
    OBSTACLE_BOWL, /* A floating bowl's hull: half an ellipsoid hanging below the surface. */
};

/* What fish must swim round this tick. The poi and the bowls describe themselves this way. */
struct obstacle {
    uint8_t kind; /* enum obstacle_kind */
    vec3 centre_m;
    vec3 normal; /* Unit; a disc's up. */
    vec3 velocity_m_s;
    float radius_m; /* Outer. */
    float depth_m;  /* Of a bowl's hull below its mouth. */
};

/* A disc's ring is a torus of this thickness; the sheet inside it is the poi's own business. */
#define RING_TUBE_PER_RADIUS 0.07f

/* The least move that takes the fish's box off the ring or the hull; zero when it is clear. */
vec3 obstacle_clear(const struct obstacle *obstacle, const struct box *box);

/* Whether a body so near could touch it before the tick is over. */
int obstacle_in_reach(const struct obstacle *obstacle, const struct box *box);

/* How near the fish is to the whole disc, sheet included. */
float obstacle_disc_distance_m(const struct obstacle *disc, vec3 point_m);

/* Wanted sidestep, m/s, horizontal: fish beside a slowly moving disc drift out of its way, those
 * over or under its sheet do not. */
vec3 obstacle_sidestep_m_s(const struct obstacle *disc, vec3 position_m);

#endif
