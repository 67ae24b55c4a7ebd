/* pond.h -- a stall's fish and surroundings for tests that need no whole tank. */
#ifndef KINGYO_TESTS_POND_H
#define KINGYO_TESTS_POND_H

#include "core/input.h"
#include "core/tank/fish.h"
#include "core/tank/preset.h"
#include "core/tank/surroundings.h"

#define POND_WATER_M 0.12f

/* The members that make a wakin so long. */
#define WAKIN(size_m)                                                                              \
    .length_m = (size_m), .height_m = 0.36f * (size_m), .width_m = 0.20f * (size_m)

static inline const struct law *pond_law(void)
{
    return &tank_preset(TANK_PRESET_FESTIVAL)->law;
}

/* What a fish of the stall knows in a tick; good until the next call. */
static inline const struct surroundings *pond_at(uint32_t seed, uint32_t tick)
{
    static struct surroundings around;
    around = (struct surroundings){
        .law = pond_law(),
        .size_m = { 0.85f, POND_WATER_M, 0.55f },
        .seed = seed,
        .tick = tick,
        .dt_s = CORE_TICK_S,
        .oxygen_mg_l = 8.0f,
    };
    return &around;
}

/* On a level course at mid depth, as one who has thought; for more, set its members. */
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
