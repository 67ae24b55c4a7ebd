/* bowl.h -- the bowl that floats at the player's hand and keeps what was caught. */
#ifndef KINGYO_CORE_POI_BOWL_H
#define KINGYO_CORE_POI_BOWL_H

#include <stdint.h>

#include "core/scene.h"
#include "core/tank/tank.h"

#define BOWL_RADIUS_M 0.075f /* The federation allows a bowl of 160 mm at most. */
#define BOWL_DEPTH_M 0.055f

struct bowl {
    uint8_t present;
    vec3 position_m;     /* Centre of the mouth, a little above the water. */
    uint32_t fish_count; /* In it now. */
};

/* What a poi and its fish meet: the water and every bowl at it, by player. Borrowed for a call. */
struct stall {
    struct tank *tank;
    struct bowl *bowls;
    uint32_t bowl_count; /* <= POI_MAX */
};

void bowl_init(struct bowl *bowl, vec3 position_m);

/* Moves the fish that are in it: small circles under a small sky. */
void bowl_tick(const struct bowl *bowl, uint32_t bowl_index, struct tank *tank, uint32_t tick);

/* Pours every fish back into the tank, beside the bowl and under it. */
void bowl_pour_back(struct bowl *bowl, uint32_t bowl_index, struct tank *tank);

/* The hull's radius `below_m` under the mouth: half an ellipsoid. */
float bowl_hull_radius_m(float below_m);

struct obstacle bowl_obstacle(const struct bowl *bowl);

uint64_t bowl_hash(uint64_t hash, const struct bowl *bowl);

#endif
