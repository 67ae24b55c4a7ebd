/* health_log.c -- entries for starts, crashes and uptime. */
#include "core/game/health_log.h"

#include "core/base/hash.h"
#include "core/core.h"
#include "core/game/accounting/coins.h"
#include "core/game/accounting/round_standing.h"
#include "core/game/pause.h"

static void tell_boot(struct core *core, struct output *output)
{
    struct ledger *ledger = &core->game.accounts.ledger;
    const struct ledger_entry entry = { .kind = LEDGER_BOOT,
                                        .count = ledger->boot,
                                        .value = (int32_t)ledger->balance.unlogged };
    coins_convert_pending(core);
    ledger_write(core, &entry, output);
    const int counts = (ledger->balance.open & PAYMENT_SPENT) && stand_finish(core, output);
    if (!counts && ledger->balance.open != PAYMENT_NONE) {
        credit_refund(core, REFUND_RESTART, output);
        core->game.accounts.credit.came_back =
            0; /* The refunded round is from an earlier run, so no message
                                            is shown. */
    }
}

static struct ledger_entry health_of(const struct core *core, const struct input *input)
{
    const struct health_log *health_log = &core->game.health_log;
    const uint32_t shakes = core->game.accounts.credit.shakes;
    return (struct ledger_entry){
        .kind = LEDGER_HEALTH,
        .count = shakes - health_log->told_shakes,
        .value = (int32_t)((core->game.tick - health_log->told_tick) / CORE_TICK_HZ),
        .health = {
            .up_s = core->game.tick / CORE_TICK_HZ,
            .dropped_ticks = input->dropped_ticks - health_log->dropped_ticks,
            .device_faults = input->device_faults - health_log->device_faults,
        },
    };
}

void health_log_write(struct core *core, const struct input *input, struct output *output)
{
    struct health_log *health_log = &core->game.health_log;
    const struct ledger_entry entry = health_of(core, input);
    if (ledger_write(core, &entry, output) != 0) {
        health_log->told_tick += (uint32_t)entry.value * CORE_TICK_HZ;
        health_log->dropped_ticks = input->dropped_ticks;
        health_log->device_faults = input->device_faults;
        health_log->told_shakes = core->game.accounts.credit.shakes;
    }
}

int health_log_final(const struct core *core, const struct input *input, struct ledger_entry *out)
{
    const struct ledger *ledger = &core->game.accounts.ledger;
    *out = health_of(core, input);
    out->id = ledger->last_id + 1u;
    out->boot = ledger->boot;
    out->tick = core->game.tick;
    out->day = ledger->day;
    out->minute = ledger->minute;
    out->balance = ledger->balance;
    return ledger->boot > 0;
}

/* An entry without room is logged as soon as the ledger has room. */
void health_log_tick(struct core *core, const struct input *input, struct output *output)
{
    struct health_log *health_log = &core->game.health_log;
    if (!health_log->is_told) {
        health_log->is_told = 1;
        if (core->game.accounts.ledger.boot > 0) { /* Without a store, starts are not counted. */
            tell_boot(core, output);
        }
    }
    const int is_due = core->game.tick - health_log->told_tick >= HEALTH_LOG_TICKS;
    if ((is_due || ledger_needs_sync(&core->game.accounts.ledger)) &&
        ledger_may_write(&core->game.accounts.ledger, LEDGER_HEALTH)) {
        health_log_write(core, input, output);
    }
}

/* ---- Controllers ---------------------------------------------------------------------------- */

static void note_loss(struct core *core, uint32_t seat, struct output *output)
{
    uint32_t *last_tick = &core->game.health_log.loss_tick[seat];
    const struct ledger_entry entry = { .kind = LEDGER_LOSS, .detail = (uint8_t)seat, .count = 1 };
    if (*last_tick != 0 && core->game.tick - *last_tick < HEALTH_LOG_LOSS_AGAIN_TICKS) {
        ledger_write(core, &entry, output);
    }
    *last_tick = core->game.tick;
}

void health_log_note_losses(struct core *core, struct output *output)
{
    struct health_log *health_log = &core->game.health_log;
    for (uint32_t i = 0; i < POI_MAX && !core->config.rules_7; i++) {
        const struct player *player = &core->game.player[i];
        const int is_away = player->plays && !player->out && !pause_holds(core, i);
        health_log->away_ticks[i] = is_away ? health_log->away_ticks[i] + 1u : 0u;
        if (health_log->away_ticks[i] == HEALTH_LOG_LOSS_TICKS) {
            note_loss(core, i, output);
        }
    }
}

uint64_t health_log_hash(uint64_t hash, const struct health_log *health_log)
{
    const uint32_t words[] = { health_log->is_told, health_log->told_tick,
                               health_log->dropped_ticks, health_log->device_faults,
                               health_log->told_shakes };
    for (uint32_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        hash = hash_u32(hash, words[i]);
    }
    for (uint32_t i = 0; i < POI_MAX; i++) {
        hash = hash_later(hash, 2u * i + 1u, health_log->away_ticks[i]);
        hash = hash_later(hash, 2u * i + 2u, health_log->loss_tick[i]);
    }
    return hash;
}
