/* bowl.h -- the bowl that floats at the player's side and keeps what was caught.
 *
 * A thin half ellipsoid with water in it, moored softly. What moves it: afloat.h; what the fish in
 * it do: bowl_fish.h. */
#ifndef KINGYO_CORE_POI_BOWL_H
#define KINGYO_CORE_POI_BOWL_H

#include <stdint.h>

#include "core/scene.h"
#include "core/tank/tank.h"

#define BOWL_RADIUS_M 0.080f /* The federation's standard: 160 mm at most. */
#define BOWL_DEPTH_M 0.059f
#define BOWL_HULL_KG 0.030f
#define BOWL_FISH_MAX 112u      /* Of 4 cm, before they swim in one another; the record is 107. */
#define BOWL_FISH_KG_MAX 0.172f /* So much those weigh; of larger fish it holds fewer. */

struct bowl {
    uint8_t present;
    vec3 home_m;       /* Where it is moored, as position_m; of it x and z. */
    vec3 position_m;   /* Centre of the mouth, a little above the water. */
    vec3 before_m;     /* The same when the tick began. */
    vec3 velocity_m_s;
    float heel_x, heel_z; /* How far the mouth's normal leans along the world's x and z, rad. */
    float heel_x_rad_s, heel_z_rad_s;
    float water_kg;      /* In it. */
    float fish_kg;       /* Of its fish, at the last tick. */
    uint32_t fish_count; /* In it now; <= BOWL_FISH_MAX. */
};

/* What a poi and its fish meet: the water and every bowl at it, by player. Borrowed for a call. */
struct stall {
    struct tank *tank;
    struct bowl *bowls;
    uint32_t bowl_count; /* <= POI_MAX */
};

/* An empty bowl, moored at a place, with as much water in it as makes it float there at rest; its
 * mouth 2 mm to BOWL_DEPTH_M / 2 over the water. */
void bowl_init(struct bowl *bowl, vec3 position_m);

/* Whether it holds as many fish as it can, by number or weight. */
int bowl_is_full(const struct bowl *bowl);

/* A fish of the tank falls in at a world velocity: it is the bowl's, which it rocks. A bowl that is
 * full the umpire first pours back into the tank; who keeps the score counts on. */
void bowl_take(struct bowl *bowl, uint32_t bowl_index, struct tank *tank, struct fish *fish,
               vec3 velocity_m_s);

/* Pours every fish back into the tank, beside the bowl and under it. */
void bowl_pour_back(struct bowl *bowl, uint32_t bowl_index, struct tank *tank);

/* The hull's radius `below_m` under the mouth: half an ellipsoid. */
float bowl_hull_radius_m(float below_m);

/* The hull's room below a level so far under its mouth, clamped to the hull. */
float bowl_room_m3(float below_m);

/* How far its own water, with the fish in it, stands under its mouth. */
float bowl_level_m(const struct bowl *bowl);

/* How fish see it, and how it came there in this tick. */
struct obstacle bowl_obstacle(const struct bowl *bowl);

/* After the fish's tick: where one could not get out of its way, it stays back as `hull` tells. */
void bowl_give_way(struct bowl *bowl, const struct obstacle *hull);

/* How it heels, as the scene turns it. */
struct angles bowl_angles(const struct bowl *bowl);

uint64_t bowl_hash(uint64_t hash, const struct bowl *bowl);

#endif
