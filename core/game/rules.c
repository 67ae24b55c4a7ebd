/* rules.c -- the table with the rules of each mode. */
#include "core/game/rules.h"

#include "core/base/panic.h"
#include "core/poi/poi.h"
#include "core/tank/preset.h"

static const struct rules table[MODE_COUNT] = {
    [MODE_FESTIVAL] = {
        .name = "festival",
        .tank = RULES_STALLS_TANK,
        .round_s = 60,
        .ready_s = RULES_READY_S,
        .shows_hints = true,
        .has_levels = true,
        .keeps_score = true,
    },
    [MODE_CHAMPIONSHIP] = {
        .name = "championship",
        .tank = TANK_PRESET_OFFICIAL,
        .grade = 5,
        .round_s = 180,
        .ready_s = 5,
        .counts_fouls = true,
        .announces_time = true,
        .keeps_score = true,
    },
    [MODE_PRACTICE] = {
        .name = "practice",
        .tank = RULES_STALLS_TANK,
        .round_s = 180,
        .ready_s = RULES_READY_S,
        .renews_paper = true,
        .shows_hints = true,
        .shows_stress = true,
        .has_levels = true,
    },
};

/* The values of the easier levels come from `make bench-players`. At these values, simulated
 * visitors who do not know the technique catch fish, and skill still pays at every level.
 *
 * - A much larger ring does not help, because the larger sheet pushes more water and more fish
 *   away.
 * - Strong smoothing does not help, because the ring then arrives late below the fish.
 * - At LEVEL_NORMAL the fish react almost as fast as living fish. A longer latency of the reaction
 *   helps a player who chases fish, but not a player who waits below the fish. A higher threshold
 *   of the reaction helps both. */
static const struct level_rules levels[LEVEL_COUNT] = {
    [LEVEL_MASTER] = { .name = "master", .ring_radius_m = POI_RADIUS_M },
    [LEVEL_NORMAL] = {
        .name = "normal",
        .ring_radius_m = 0.041f,
        .grade_step = 1,
        .temper = {
            .threshold_gain = 0.5f,
            .latency_gain = 0.05f,
            .reach_loss = 0.2f,
            .calm_share = 0.2f,
        },
    },
    [LEVEL_EASY] = {
        .name = "easy",
        .ring_radius_m = 0.042f,
        .grade_step = 2,
        .stroke_s = 0.004f,
        .stroke_m_s = 0.8f,
        .temper = {
            .threshold_gain = 0.6f,
            .latency_gain = 0.6f,
            .reach_loss = 0.3f,
            .calm_share = 0.5f,
        },
    },
};

const struct level_rules *rules_of_level(uint8_t level)
{
    CORE_ASSERT(level < LEVEL_COUNT);
    return &levels[level];
}

uint8_t rules_grade_at_level(uint8_t grade, uint8_t level)
{
    const uint8_t step = rules_of_level(level)->grade_step;
    return grade > SHEET_GRADE_MIN + step ? (uint8_t)(grade - step) : SHEET_GRADE_MIN;
}

const struct rules *rules_of(uint8_t mode)
{
    CORE_ASSERT(mode < MODE_COUNT);
    return &table[mode];
}
