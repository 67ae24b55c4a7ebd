/* settings_edit.c -- changes settings and logs the changes in the ledger. */
#include "core/game/menu/settings_edit.h"

#include "core/base/hash.h"
#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/game/game.h"
#include "core/config.h"
#include "core/tank/preset.h"

static struct settings *live_settings(struct settings *settings)
{
    return settings;
}

void settings_edit_init(struct settings_edit *settings_edit, const struct core_config *config)
{
    const uint32_t wrong = config->persistent.audits.count[AUDIT_WRONG_PINS];
    *settings_edit = (struct settings_edit){
        .told = config->persistent.settings,
        .pin_wrong = wrong < UINT8_MAX ? wrong : UINT8_MAX, /* The ticks of stored wrong PINs are
                                                               unknown, so the lockout time starts
                                                               at the kiosk's start. */
    };
    settings_sanitize(&settings_edit->told);
}

int32_t settings_edit_max(const struct core_config *config, uint32_t id)
{
    const struct setting *setting = settings_entry(id);
    if (id != SET_FISH) {
        return setting->max;
    }
    const int32_t room = (int32_t)tank_preset_fish_max(tank_preset(config->preset), 1.0f);
    return room < setting->max ? room : setting->max;
}

static void apply(struct settings_edit *settings_edit, struct core_config *config, uint32_t tick)
{
    config_apply_settings(config, live_settings(&config->persistent.settings));
    settings_edit->turn_tick = tick;
}

void settings_edit_set(struct game *game, struct core_config *config, uint32_t id, int32_t value)
{
    CORE_ASSERT(settings_allows(id, value));
    CORE_ASSERT(value <= settings_edit_max(config, id));
    live_settings(&config->persistent.settings)->value[id] = value;
    apply(&game->settings_edit, config, game->tick);
    if (id == SET_LANGUAGE) {
        game->language = (uint8_t)value;
    }
}

/* Returns the next allowed value of setting `id`. Paper grades 1 to 3 do not exist and are
 * skipped. */
static int32_t step_from(const struct core_config *config, uint32_t id, int32_t value, int is_down)
{
    const struct setting *setting = settings_entry(id);
    const int32_t max = settings_edit_max(config, id);
    do {
        value += is_down ? -setting->step : setting->step;
        value = value > max ? setting->min : value < setting->min ? max : value;
    } while (!settings_allows(id, value));
    return value;
}

static int is_end(const struct core_config *config, uint32_t id, int32_t value, int is_down)
{
    const int32_t next = step_from(config, id, value, is_down);
    return is_down ? next > value : next < value;
}

int settings_edit_step(struct game *game, struct core_config *config, uint32_t id, int is_down,
                       uint32_t step_count)
{
    int32_t value =
        step_from(config, id, live_settings(&config->persistent.settings)->value[id], is_down);
    for (uint32_t i = 1; i < step_count && !is_end(config, id, value, is_down); i++) {
        value = step_from(config, id, value, is_down);
    }
    settings_edit_set(game, config, id, value);
    return is_end(config, id, value, is_down);
}

int settings_edit_factory_reset(struct game *game, struct core_config *config,
                                struct output *output)
{
    struct ledger *ledger = &game->accounts.ledger;
    const struct balance balance = ledger->balance;
    const struct ledger_entry entry = { .kind = LEDGER_FACTORY,
                                        .count = balance.paid + balance.service,
                                        .value = balance.tickets };
    ledger->balance = (struct balance){ 0 };
    if (!ledger_write(&game->accounts, game->tick, &entry, output)) {
        ledger->balance = balance;
        return 0;
    }
    settings_reset(live_settings(&config->persistent.settings));
    game->settings_edit.told = *live_settings(&config->persistent.settings);
    game->settings_edit.entry_id = ledger->last_id;
    game->language = (uint8_t)live_settings(&config->persistent.settings)->value[SET_LANGUAGE];
    apply(&game->settings_edit, config, game->tick);
    return 1;
}

/* Logs setting `id` if it changed. Returns 1, or 0 if the ledger had no room. */
static int append_setting_entry(struct game *game, struct settings *settings, uint32_t id,
                                struct output *output)
{
    struct settings_edit *settings_edit = &game->settings_edit;
    const int32_t value = live_settings(settings)->value[id];
    if (value == settings_edit->told.value[id]) {
        return 1;
    }
    if (!ledger_may_write(&game->accounts.ledger, LEDGER_SETTING)) {
        return 0; /* The next tick tries again, because every change of a setting must be logged. */
    }
    const struct ledger_entry entry = {
        .kind = LEDGER_SETTING, .detail = (uint8_t)(id & 0xffu), .count = id >> 8, .value = value
    };
    settings_edit->entry_id = ledger_write(&game->accounts, game->tick, &entry, output);
    settings_edit->told.value[id] = value;
    return 1;
}

void settings_edit_tick(struct game *game, struct settings *settings, struct output *output)
{
    const struct settings_edit *settings_edit = &game->settings_edit;
    if (game->tick - settings_edit->turn_tick < SETTINGS_EDIT_REST_TICKS) {
        return;
    }
    uint32_t id = 0;
    while (id < SETTING_COUNT && append_setting_entry(game, settings, id, output)) {
        id++;
    }
}

int settings_edit_is_saved(const struct ledger *ledger, const struct settings_edit *settings_edit,
                           const struct settings *settings)
{
    const struct settings *now = settings;
    return memcmp(now, &settings_edit->told, sizeof *now) == 0 &&
           ledger_is_saved(ledger, settings_edit->entry_id);
}

uint64_t settings_edit_hash(uint64_t hash, const struct settings_edit *settings_edit, int rules_7)
{
    hash = settings_hash(hash, &settings_edit->told, rules_7);
    hash = hash_u32(hash_u32(hash, settings_edit->turn_tick), settings_edit->entry_id);
    return hash_u32(hash_u32(hash, settings_edit->pin_wrong), settings_edit->pin_tick);
}
