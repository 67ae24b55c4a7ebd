/* config.c -- copies settings to the core's configuration. */
#include "core/config.h"

#include "core/base/panic.h"
#include "core/scene.h"
#include "core/tank/preset.h"

/* Level (enum level) that each value of SET_LEVEL selects. */
static const uint8_t level_of_choice[LEVEL_CHOICE_COUNT] = {
    [LEVEL_CHOICE_NORMAL] = LEVEL_NORMAL,
    [LEVEL_CHOICE_EASY] = LEVEL_EASY,
    [LEVEL_CHOICE_MASTER] = LEVEL_MASTER,
};

void config_apply_settings(struct core_config *config, const struct settings *settings)
{
    const int32_t *value = settings->value;
    CORE_ASSERT(config && settings && config->preset < TANK_PRESET_COUNT);
    CORE_ASSERT(value[SET_LANGUAGE] >= 0 && value[SET_LANGUAGE] < LANGUAGE_COUNT);
    CORE_ASSERT(value[SET_PLAYERS] >= 0 && value[SET_PLAYERS] <= (int32_t)POI_MAX);
    config->credit_coins = value[SET_PLAY] == PLAY_PAID ? (uint8_t)value[SET_PRICE] : 0u;
    config->ticket_fish = (uint8_t)value[SET_TICKET_FISH];
    config->modes = (uint8_t)value[SET_MODES];
    config->grade = (uint8_t)value[SET_GRADE];
    config->round_s = (uint32_t)value[SET_ROUND_S];
    /* Limit the number of fish to the capacity of the tank. The setting may exceed the capacity if
     * the SD card or the configuration file was used with a larger tank. */
    const uint32_t fish_max = tank_preset_fish_max(tank_preset(config->preset), 1.0f);
    config->fish_count =
        (uint32_t)value[SET_FISH] < fish_max ? (uint32_t)value[SET_FISH] : fish_max;
    config->players = (uint8_t)value[SET_PLAYERS];
    config->level =
        config_has_rules(config, 9) ? level_of_choice[value[SET_LEVEL]] : (uint8_t)LEVEL_MASTER;
    config->language = (uint8_t)value[SET_LANGUAGE];
}
