/* show.h -- how single things of the state look: the scene shows them so, and a bot's eye sees them
 * so (core/game/sight.h). */
#ifndef KINGYO_CORE_SHOW_H
#define KINGYO_CORE_SHOW_H

#include "core/base/fmath.h"
#include "core/poi/sheet.h"
#include "core/scene.h"
#include "core/tank/fish.h"

/* enum scene_place of a fish in enum fish_gait `gait`. */
static inline uint8_t show_place(uint8_t gait)
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

/* [0, 1] along the colour keys: keepers see the first red at 50 to 60 days, and clear red within
 * three to four months. */
static inline float show_maturity(float age_days)
{
    return f_smoothstep(50.0f, 120.0f, age_days);
}

/* The pictures of a cell < SHEET_CELL_COUNT: 255 whole .. 1 nearly torn, 0 where there is no paper;
 * and 0 dry .. 255 wet, 0 beyond the ring. */
static inline uint8_t show_integrity(const struct sheet *sheet, uint32_t cell)
{
    const float whole = f_clamp(1.0f - sheet->damage[cell], 0.0f, 1.0f);
    return sheet->state[cell] == CELL_PAPER ? (uint8_t)(1 + (int32_t)(whole * 254.0f)) : 0;
}

static inline uint8_t show_wetness(const struct sheet *sheet, uint32_t cell)
{
    const float wet = f_clamp(sheet->wetness[cell], 0.0f, 1.0f);
    return sheet->state[cell] == CELL_OUTSIDE ? 0 : (uint8_t)(int32_t)(wet * 255.0f);
}

#endif
