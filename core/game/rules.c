/* rules.c -- the table with the rules of each mode. */
#include "core/game/rules.h"

#include "core/base/panic.h"
#include "core/tank/preset.h"

static const struct rules table[MODE_COUNT] = {
    [MODE_FESTIVAL] = {
        .name = "festival",
        .tank = RULES_STALLS_TANK,
        .round_s = 60,
        .ready_s = RULES_READY_S,
        .coaches = 1,
        .keeps_score = 1,
    },
    [MODE_CHAMPIONSHIP] = {
        .name = "championship",
        .tank = TANK_PRESET_OFFICIAL,
        .grade = 5,
        .round_s = 180,
        .ready_s = 5,
        .judges = 1,
        .calls = 1,
        .keeps_score = 1,
    },
    [MODE_PRACTICE] = {
        .name = "practice",
        .tank = RULES_STALLS_TANK,
        .round_s = 180,
        .ready_s = RULES_READY_S,
        .renews_paper = 1,
        .coaches = 1,
        .shows_stress = 1,
    },
};

const struct rules *rules_of(uint8_t mode)
{
    CORE_ASSERT(mode < MODE_COUNT);
    return &table[mode];
}
