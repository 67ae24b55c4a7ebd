/* config.c -- copies settings to the configuration of a session. */
#include "core/config.h"

#include "core/base/panic.h"
#include "core/tank/preset.h"

/* Limits the fish count to the capacity of the tank. A larger count comes from an SD card or a
 * configuration file that was used with a larger tank. */
static uint32_t fish_that_fit(uint32_t wanted, const struct core_config *config)
{
    CORE_ASSERT(config->preset < TANK_PRESET_COUNT);
    const uint32_t most = tank_preset_fish_max(tank_preset(config->preset), 1.0f);
    return wanted < most ? wanted : most;
}

void config_apply_settings(struct core_config *config, const struct settings *settings)
{
    const int32_t *value = settings->value;
    CORE_ASSERT(config && settings);
    CORE_ASSERT(value[SET_LANGUAGE] >= 0 && value[SET_LANGUAGE] < LANGUAGE_COUNT);
    CORE_ASSERT(value[SET_PLAYERS] >= 0 && value[SET_PLAYERS] <= (int32_t)POI_MAX);
    config->credit_coins = value[SET_PLAY] == PLAY_PAID ? (uint8_t)value[SET_PRICE] : 0u;
    config->ticket_fish = (uint8_t)value[SET_TICKET_FISH];
    config->modes = (uint8_t)value[SET_MODES];
    config->grade = (uint8_t)value[SET_GRADE];
    config->round_s = (uint32_t)value[SET_ROUND_S];
    config->fish_count = fish_that_fit((uint32_t)value[SET_FISH], config);
    config->players = (uint8_t)value[SET_PLAYERS];
    config->language = (uint8_t)value[SET_LANGUAGE];
}
