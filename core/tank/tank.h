/* tank.h -- the tank: the water, the fish that swim in it, and the obstacles.
 *
 * The origin is the centre of the still water surface; +x is to the right, +y up and +z toward the
 * player. A poi is the paper scoop of a player. A tick is 1/120 s. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

#include "core/scene.h"
#include "core/tank/behavior_params.h"
#include "core/tank/collision/broad_phase.h"
#include "core/tank/collision/contact_solver.h"
#include "core/tank/collision/obstacle.h"
#include "core/tank/fish.h"
#include "core/tank/oxygen.h"
#include "core/tank/preset.h"
#include "core/tank/shade.h"
#include "core/tank/water.h"

_Static_assert(TANK_OBSTACLE_MAX == 2u * POI_MAX, "a poi and a bowl of each player");
/* Largest number of shades on the water: SHADE_MAX shades of fans and human hands, followed by
 * POI_MAX shades of dry pois (paper scoops). */
#define TANK_SHADE_MAX (SHADE_MAX + POI_MAX)

struct tank {
    uint32_t seed;
    uint8_t preset; /* Preset of the tank (enum tank_preset_id). */
    /* Number of SIMD lanes (`lanes`) and algorithm of the pair search (`search`), copied from
     * struct tank_config. Both members affect only speed, so no state hash includes them. */
    uint8_t lanes, search;
    vec3 size_m;
    float wall_height_m;
    float wall_follow;    /* Strength [0, 1] with which walls attract fish. */
    bool ball_spaces;     /* True if the personal space around each fish is a ball instead of a
                             box. */
    struct temper temper; /* How much calmer the fish are in this round than living fish. */
    uint32_t fish_count;
    struct fish fish[TANK_FISH_MAX];
    /* Width of the personal space around the body of each fish, in body lengths. The value is
     * computed when the tank is opened. */
    float space;
    struct water water;
    struct shade shade[TANK_SHADE_MAX];
    struct oxygen oxygen;
    /* Upper bound of the number of fish in reentry: fish that came back into the water and still
     * overlap other fish. reentry_tick() sets the exact number. */
    uint32_t reentry_count;
    /* Results of the last search for pairs of nearby fish (broad-phase query). Later ticks use the
     * results, so the state hash includes them. */
    struct broad_phase broad_phase;
    /* Scratch memory of the contact solver for one tick, which no state hash includes. The solver
     * is a member of struct tank because the stack of an embedded board is too small for it. */
    struct contact_solver solver;
};

/* Parameters of a tank to be opened. */
struct tank_config {
    uint8_t preset;      /* Preset of the tank (enum tank_preset_id). */
    uint32_t fish_count; /* Number of fish, 1 .. tank_config_fish_max(). */
    uint32_t seed;       /* Seed of all random numbers; any value is valid. */
    /* Factor on the area of the floor, TANK_AREA_SCALE_MIN .. TANK_AREA_SCALE_MAX. */
    float area_scale;
    /* Inner size within TANK_SIDE_*_M and TANK_DEPTH_*_M. A component of 0 selects the preset's
     * value. */
    vec3 size_m;
    /* Strength [0, 1] with which walls attract fish; 0 in every preset. */
    float wall_follow;
    /* True if the personal space around each fish is a ball instead of a box. Balls serve only for
     * comparison with section 3.4 of the 2013 thesis on goldfish behavior. With balls, the time of
     * a query grows with the square of the number of fish. */
    bool ball_spaces;
    /* Range of the stamina at the start, within [0, 1]. The random stamina has a uniform
     * distribution. */
    float stamina_min, stamina_max;
    /* Temperature of the water, OXYGEN_TEMPERATURE_MIN_C .. OXYGEN_TEMPERATURE_MAX_C. */
    float temperature_c;
    /* Pressure of the air, OXYGEN_PRESSURE_MIN_HPA .. OXYGEN_PRESSURE_MAX_HPA. */
    float pressure_hpa;
    /* Dissolved oxygen at the start: 0 .. OXYGEN_MAX_MG_L, or TANK_OXYGEN_SATURATED. */
    float oxygen_mg_l;
    /* Factor by which oxygen changes faster than in reality, 0 .. OXYGEN_TIME_COMPRESSION_MAX
     * (oxygen.h). */
    float time_compression;
    bool pump; /* True if the air pump runs, so that the air stone bubbles. */
    /* Number of bowls, 0 .. POI_MAX. No fish starts under a bowl. */
    uint8_t bowls;
    /* Number of SIMD lanes (core/base/simd.h): 4, 8, or 0 for the default (4). The number affects
     * only speed. */
    uint8_t lanes;
    /* Algorithm of the pair search (enum pair_search), which affects only speed. */
    uint8_t search;
};

#define TANK_OXYGEN_SATURATED (-1.0f) /* Value of `oxygen_mg_l` for water saturated with oxygen. */

#define TANK_SIDE_MIN_M 0.30f
#define TANK_SIDE_MAX_M 2.00f
#define TANK_DEPTH_MIN_M 0.05f
#define TANK_DEPTH_MAX_M 0.50f

#define TANK_AREA_SCALE_MIN 0.05f
#define TANK_AREA_SCALE_MAX 250.0f

/* Returns the configuration with the values of a preset, seed 1 and one bowl. */
struct tank_config tank_config_of(uint8_t preset);

/* Returns the largest number of fish in a tank with this configuration. The function ignores
 * config->fish_count. Returns 0 if the size or the area scale is out of range. */
uint32_t tank_config_fish_max(const struct tank_config *config);

/* Opens a tank: fills `tank` with still water and with fish that do not overlap. Returns true on
 * success. Returns false and leaves `tank` unchanged if a value of `config` is out of range.
 * Also returns false if the function finds no places at which the fish do not overlap, which
 * happens only in tanks shorter than a fish. In that case `tank` must not be used. */
bool tank_open(struct tank *tank, const struct tank_config *config);

/* Pose and state that tank_stage_all() gives to a fish, for example to set up an encounter of two
 * fish. */
struct tank_stage {
    vec3 position_m;
    struct angles angles;
    float length_m;  /* Length of the fish. 0 keeps the length that the tank gave the fish. */
    float speed_m_s; /* Speed along the fish's forward axis, >= 0. */
    float stamina;   /* Stamina, [0, 1]. */
    /* Gait of the fish: GAIT_REST, GAIT_SWIM, GAIT_BURST or GAIT_SURFACE. The gait lasts for its
     * longest duration. */
    uint8_t gait;
};

/* Gives the first `count` fish of a tank that was just opened the poses and states in `stages`.
 * `count` must not exceed the number of fish. The caller guarantees that the bodies are in the
 * water and do not overlap. */
void tank_stage_all(struct tank *tank, const struct tank_stage *stages, uint32_t count);

/* Returns the behavior parameters of the tank's fish. */
const struct behavior_params *tank_behavior_params(const struct tank *tank);

/* Sets the shades of the next tick; the caller calls tank_tick() afterwards. A tank for which the
 * function is never called has no shades. Asserts that all values are finite. */
void tank_cast(struct tank *tank, const struct shade_cast casts[TANK_SHADE_MAX]);

/* Returns the number of swimming fish whose centre lies in the shade of `cast`. Returns 0 if the
 * shade is not present. */
uint32_t tank_shade_count(const struct tank *tank, const struct shade_cast *cast);

/* Advances the water's oxygen and every swimming or falling fish by one tick. core/poi moves the
 * fish on pois and in bowls. `obstacle_count` must not exceed TANK_OBSTACLE_MAX. */
void tank_tick(struct tank *tank, uint32_t tick, struct obstacle *obstacles,
               uint32_t obstacle_count);

/* Returns the position of the pump's air stone, which stands on the floor in the far left
 * corner. */
vec3 tank_stone_m(vec3 size_m);

/* Returns the inner faces of the tank, within which the contact solver keeps the fish. */
struct tank_bounds tank_bounds(const struct tank *tank);

/* Returns the options of a broad-phase query in this tank. */
struct broad_phase_search tank_search(const struct tank *tank);

/* Returns the surroundings on which a fish bases its decision in tick `tick`. The result points
 * into the tank and at `obstacles`, which may be null if `obstacle_count` is 0. */
struct perception tank_perception(const struct tank *tank, uint32_t tick,
                                  const struct obstacle *obstacles, uint32_t obstacle_count);

/* ---- Reentry of fish into the water ---------------------------------------------------------- */

/* Begins the reentry of a fish at its present place. Reentry is the state of a fish that came back
 * into the water, until the fish overlaps no other fish. A fish that dropped or floated off a poi,
 * or was poured from a bowl, may overlap other fish.
 *
 * During reentry the gait of the fish is GAIT_HELD and its holder FISH_HOLDER_WATER. The fish
 * drifts, is pushed out of other fish and pushes the other fish aside. The fish swims as soon as it
 * overlaps no other fish.
 *
 * After 0.13 s of overlap the fish moves toward the nearest gap, and after 0.4 s the fish is placed
 * into the gap. Therefore reentry ends within half a second unless no place within 5 cm is free.
 *
 * The function sets the fish's pitch and roll to 0, keeps the fish within the walls, and sets its
 * velocity to `velocity_m_s`, limited to 0.5 m/s. At the end of reentry the fish bursts away if its
 * alarm is high; otherwise the fish swims. */
void reentry_begin(struct tank *tank, struct fish *fish, vec3 velocity_m_s);

/* Advances all fish in reentry (reentry_begin()) by one tick; called after the contact solver. */
void reentry_tick(struct tank *tank, const struct obstacle *obstacles, uint32_t obstacle_count);
