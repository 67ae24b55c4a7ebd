/* scene_helpers.h -- conversions of state values to scene values, shared by the scene and by the
 * vision of the bot (core/game/bot/vision.h). */
#pragma once

#include "core/base/fmath.h"
#include "core/poi/paper/sheet.h"
#include "core/scene.h"
#include "core/tank/fish.h"

/* Returns the enum scene_place of a fish in enum fish_gait `gait`. */
static inline uint8_t scene_place_of(uint8_t gait)
{
    switch (gait) {
    case GAIT_HELD:
        return SCENE_ON_POI;
    case GAIT_BOWL:
        return SCENE_IN_BOWL;
    default:
        return SCENE_IN_TANK;
    }
}

/* Returns the colour maturity of a goldfish, [0, 1]: the position between the species' first and
 * last colour key. Fish keepers report the first red at 50 to 60 days and clear red within three to
 * four months. */
static inline float scene_maturity(float age_days)
{
    return f_smoothstep(50.0f, 120.0f, age_days);
}

/* Return the scene values of paper cell `cell` < SHEET_CELL_COUNT. Integrity runs from 255 (whole)
 * to 1 (nearly torn); 0 means no paper. Wetness runs from 0 (dry) to 255 (wet), and is 0 outside
 * the ring. */
static inline uint8_t scene_integrity(const struct sheet *sheet, uint32_t cell)
{
    const float whole = f_clamp(1.0f - sheet->damage[cell], 0.0f, 1.0f);
    return sheet->state[cell] == CELL_PAPER ? (uint8_t)(1 + (int32_t)(whole * 254.0f)) : 0;
}

static inline uint8_t scene_wetness(const struct sheet *sheet, uint32_t cell)
{
    const float wet = f_clamp(sheet->wetness[cell], 0.0f, 1.0f);
    return sheet->state[cell] == CELL_OUTSIDE ? 0 : (uint8_t)(int32_t)(wet * 255.0f);
}
