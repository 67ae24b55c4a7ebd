/* pond.h -- single fish of the festival's tank and what they perceive, for tests that need no
 * complete tank. */
#ifndef KINGYO_TESTS_UNIT_SUPPORT_POND_H
#define KINGYO_TESTS_UNIT_SUPPORT_POND_H

#include "core/input.h"
#include "core/tank/behavior_params.h"
#include "core/tank/fish.h"
#include "core/tank/preset.h"

#define POND_WATER_M 0.12f

/* Initializers of the length, height and width of a wakin (goldfish) with the length `size_m`. */
#define WAKIN(size_m)                                                                              \
    .length_m = (size_m), .height_m = 0.36f * (size_m), .width_m = 0.20f * (size_m)

/* Returns the behavior parameters of the festival tank's fish. */
static inline const struct behavior_params *pond_params(void)
{
    return &tank_preset(TANK_PRESET_FESTIVAL)->params;
}

/* Returns what a fish of the festival's tank perceives in tick `tick`. The result is valid until
 * the next call. */
static inline const struct perception *pond_at(uint32_t seed, uint32_t tick)
{
    static struct perception around;
    around = (struct perception){
        .params = pond_params(),
        .size_m = { 0.85f, POND_WATER_M, 0.55f },
        .seed = seed,
        .tick = tick,
        .dt_s = CORE_TICK_S,
        .oxygen_mg_l = 8.0f,
    };
    return &around;
}

/* Returns a level fish at half the depth, with the given length and gait. A test sets further
 * members itself. */
static inline struct fish pond_fish(float length_m, uint8_t gait)
{
    return (struct fish){ WAKIN(length_m),
                          .stamina = 1.0f,
                          .brake = 1.0f,
                          .room = 1.0f,
                          .haste = 1.0f,
                          .gait = gait,
                          .position_m = { 0.0f, -0.5f * POND_WATER_M, 0.0f },
                          .depth_goal_m = -0.5f * POND_WATER_M };
}

#endif
