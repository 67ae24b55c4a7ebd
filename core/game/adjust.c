/* adjust.c -- changes settings and logs them in the ledger. */
#include "core/game/adjust.h"

#include "core/base/hash.h"
#include "core/base/mem.h"
#include "core/base/panic.h"
#include "core/core.h"
#include "core/tank/preset.h"

static struct settings *live(struct core *core)
{
    return &core->config.memory.settings;
}

void adjust_init(struct adjust *adjust, const struct core_config *config)
{
    const uint32_t wrong = config->memory.audits.count[AUDIT_WRONG_PINS];
    *adjust = (struct adjust){
        .told = config->memory.settings,
        .pin_wrong = wrong < UINT8_MAX ? wrong : UINT8_MAX, /* The times of stored wrong PINs are
                                                               unknown, so the lockout time starts
                                                               at boot. */
    };
    settings_mend(&adjust->told);
}

int32_t adjust_max(const struct core *core, uint32_t id)
{
    const struct setting *setting = setting_of(id);
    if (id != SET_FISH) {
        return setting->max;
    }
    const int32_t room =
        (int32_t)tank_preset_fish_max(tank_preset(core->config.preset), 1.0f);
    return room < setting->max ? room : setting->max;
}

static void apply(struct core *core)
{
    settings_apply(live(core), &core->config);
    core->game.adjust.turn_tick = core->tick;
}

void adjust_set(struct core *core, uint32_t id, int32_t value)
{
    CORE_ASSERT(setting_allows(id, value));
    CORE_ASSERT(value <= adjust_max(core, id));
    live(core)->value[id] = value;
    apply(core);
    if (id == SET_LANGUAGE) {
        core->game.language = (uint8_t)value;
    }
}

/* Returns the next allowed value; paper grades 1 to 3 do not exist and are skipped. */
static int32_t step_from(const struct core *core, uint32_t id, int32_t value, int is_down)
{
    const struct setting *setting = setting_of(id);
    const int32_t max = adjust_max(core, id);
    do {
        value += is_down ? -setting->step : setting->step;
        value = value > max ? setting->min : value < setting->min ? max : value;
    } while (!setting_allows(id, value));
    return value;
}

static int is_end(const struct core *core, uint32_t id, int32_t value, int is_down)
{
    const int32_t next = step_from(core, id, value, is_down);
    return is_down ? next > value : next < value;
}

int adjust_turn(struct core *core, uint32_t id, int is_down, uint32_t step_count)
{
    int32_t value = step_from(core, id, live(core)->value[id], is_down);
    for (uint32_t i = 1; i < step_count && !is_end(core, id, value, is_down); i++) {
        value = step_from(core, id, value, is_down);
    }
    adjust_set(core, id, value);
    return is_end(core, id, value, is_down);
}

int adjust_factory(struct core *core, struct output *output)
{
    struct ledger *ledger = &core->game.ledger;
    const struct purse purse = ledger->purse;
    const struct ledger_entry entry = { .kind = LEDGER_FACTORY,
                                        .count = purse.paid + purse.service,
                                        .value = purse.tickets };
    ledger->purse = (struct purse){ 0 };
    if (!ledger_write(core, &entry, output)) {
        ledger->purse = purse;
        return 0;
    }
    settings_reset(live(core));
    core->game.adjust.told = *live(core);
    core->game.adjust.entry_id = ledger->last_id;
    core->game.language = (uint8_t)live(core)->value[SET_LANGUAGE];
    apply(core);
    return 1;
}

/* Logs setting `id` if it changed. Returns 0 if the ledger had no room, else 1. */
static int tell(struct core *core, uint32_t id, struct output *output)
{
    struct adjust *adjust = &core->game.adjust;
    const int32_t value = live(core)->value[id];
    if (value == adjust->told.value[id]) {
        return 1;
    }
    if (!ledger_may_write(&core->game.ledger, LEDGER_SETTING)) {
        return 0; /* The next tick tries again, because no change of a setting may be lost. */
    }
    const struct ledger_entry entry = { .kind = LEDGER_SETTING, .detail = (uint8_t)(id & 0xffu),
                                        .count = id >> 8, .value = value };
    adjust->entry_id = ledger_write(core, &entry, output);
    adjust->told.value[id] = value;
    return 1;
}

void adjust_tick(struct core *core, struct output *output)
{
    const struct adjust *adjust = &core->game.adjust;
    if (core->tick - adjust->turn_tick < ADJUST_REST_TICKS) {
        return;
    }
    uint32_t id = 0;
    while (id < SETTING_COUNT && tell(core, id, output)) {
        id++;
    }
}

int adjust_is_saved(const struct core *core)
{
    const struct adjust *adjust = &core->game.adjust;
    const struct settings *now = &core->config.memory.settings;
    return memcmp(now, &adjust->told, sizeof *now) == 0 &&
           ledger_is_saved(&core->game.ledger, adjust->entry_id);
}

uint64_t adjust_hash(uint64_t hash, const struct adjust *adjust, int rules_7)
{
    hash = settings_hash(hash, &adjust->told, rules_7);
    hash = hash_u32(hash_u32(hash, adjust->turn_tick), adjust->entry_id);
    return hash_u32(hash_u32(hash, adjust->pin_wrong), adjust->pin_tick);
}
