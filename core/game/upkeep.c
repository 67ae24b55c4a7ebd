/* upkeep.c -- entries for starts, crashes and uptime. */
#include "core/game/upkeep.h"

#include "core/base/hash.h"
#include "core/core.h"
#include "core/game/coins.h"
#include "core/game/pause.h"
#include "core/game/stand.h"

static void tell_boot(struct core *core, struct output *output)
{
    struct ledger *ledger = &core->game.ledger;
    const struct ledger_entry entry = { .kind = LEDGER_BOOT,
                                        .count = ledger->boot,
                                        .value = (int32_t)ledger->purse.untold };
    coins_fold_untold(core);
    ledger_write(core, &entry, output);
    const int counts = (ledger->purse.open & OPEN_SPENT) && stand_finish(core, output);
    if (!counts && ledger->purse.open != OPEN_NONE) {
        credit_give_back(core, REFUND_RESTART, output);
        core->game.credit.came_back = 0; /* The refunded round is from an earlier run, so no message
                                            is shown. */
    }
}

static struct ledger_entry health_of(const struct core *core, const struct input *input)
{
    const struct upkeep *upkeep = &core->game.upkeep;
    const uint32_t shakes = core->game.credit.shakes;
    return (struct ledger_entry){
        .kind = LEDGER_HEALTH,
        .count = shakes - upkeep->told_shakes,
        .value = (int32_t)((core->tick - upkeep->told_tick) / CORE_TICK_HZ),
        .health = {
            .up_s = core->tick / CORE_TICK_HZ,
            .dropped_ticks = input->dropped_ticks - upkeep->dropped_ticks,
            .device_faults = input->device_faults - upkeep->device_faults,
        },
    };
}

void upkeep_tell(struct core *core, const struct input *input, struct output *output)
{
    struct upkeep *upkeep = &core->game.upkeep;
    const struct ledger_entry entry = health_of(core, input);
    if (ledger_write(core, &entry, output) != 0) {
        upkeep->told_tick += (uint32_t)entry.value * CORE_TICK_HZ;
        upkeep->dropped_ticks = input->dropped_ticks;
        upkeep->device_faults = input->device_faults;
        upkeep->told_shakes = core->game.credit.shakes;
    }
}

int upkeep_last_word(const struct core *core, const struct input *input, struct ledger_entry *out)
{
    const struct ledger *ledger = &core->game.ledger;
    *out = health_of(core, input);
    out->id = ledger->last_id + 1u;
    out->boot = ledger->boot;
    out->tick = core->tick;
    out->day = ledger->day;
    out->minute = ledger->minute;
    out->purse = ledger->purse;
    return ledger->boot > 0;
}

/* An entry without room is logged as soon as the ledger has room. */
void upkeep_tick(struct core *core, const struct input *input, struct output *output)
{
    struct upkeep *upkeep = &core->game.upkeep;
    if (!upkeep->is_told) {
        upkeep->is_told = 1;
        if (core->game.ledger.boot > 0) { /* Without a store, starts are not counted. */
            tell_boot(core, output);
        }
    }
    const int is_due = core->tick - upkeep->told_tick >= UPKEEP_TICKS;
    if ((is_due || ledger_owes_purse(&core->game.ledger)) &&
        ledger_may_write(&core->game.ledger, LEDGER_HEALTH)) {
        upkeep_tell(core, input, output);
    }
}

/* ---- Controllers ---------------------------------------------------------------------------- */

static void note_loss(struct core *core, uint32_t seat, struct output *output)
{
    uint32_t *last_tick = &core->game.upkeep.loss_tick[seat];
    const struct ledger_entry entry = { .kind = LEDGER_LOSS, .detail = (uint8_t)seat, .count = 1 };
    if (*last_tick != 0 && core->tick - *last_tick < UPKEEP_LOSS_AGAIN_TICKS) {
        ledger_write(core, &entry, output);
    }
    *last_tick = core->tick;
}

void upkeep_note_losses(struct core *core, struct output *output)
{
    struct upkeep *upkeep = &core->game.upkeep;
    for (uint32_t i = 0; i < POI_MAX && !core->config.rules_7; i++) {
        const struct player *player = &core->game.player[i];
        const int is_away = player->plays && !player->out && !pause_holds(core, i);
        upkeep->away_ticks[i] = is_away ? upkeep->away_ticks[i] + 1u : 0u;
        if (upkeep->away_ticks[i] == UPKEEP_LOSS_TICKS) {
            note_loss(core, i, output);
        }
    }
}

uint64_t upkeep_hash(uint64_t hash, const struct upkeep *upkeep)
{
    const uint32_t words[] = { upkeep->is_told, upkeep->told_tick, upkeep->dropped_ticks,
                               upkeep->device_faults, upkeep->told_shakes };
    for (uint32_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        hash = hash_u32(hash, words[i]);
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        hash = hash_later(hash, 2u * i + 1u, upkeep->away_ticks[i]);
        hash = hash_later(hash, 2u * i + 2u, upkeep->loss_tick[i]);
    }
    return hash;
}
