/* health_log.c -- writes the ledger entries for starts, crashes and uptime. */
#include "core/game/phases.h"

#include "core/base/panic.h"
#include "core/config.h"
#include "core/game/accounting/accounts.h"
#include "core/poi/world.h"

static struct ledger_entry health_of(const struct credit *credit,
                                     const struct health_log *health_log, uint32_t tick,
                                     const struct input *input)
{
    const uint32_t shakes = credit->shakes;
    return (struct ledger_entry){
        .kind = LEDGER_HEALTH,
        .count = shakes - health_log->written_shakes,
        .value = (int32_t)((tick - health_log->written_tick) / CORE_TICK_HZ),
        .health = {
            .up_s = tick / CORE_TICK_HZ,
            .dropped_ticks = input->dropped_ticks - health_log->dropped_ticks,
            .device_faults = input->device_faults - health_log->device_faults,
        },
    };
}

void health_log_write(struct accounts *accounts, struct health_log *health_log, uint32_t tick,
                      const struct input *input, struct output *output)
{
    const struct ledger_entry entry = health_of(&accounts->credit, health_log, tick, input);
    if (ledger_write(accounts, tick, &entry, output) != 0) {
        health_log->written_tick += (uint32_t)entry.value * CORE_TICK_HZ;
        health_log->dropped_ticks = input->dropped_ticks;
        health_log->device_faults = input->device_faults;
        health_log->written_shakes = accounts->credit.shakes;
    }
}

bool health_log_final(const struct accounts *accounts, const struct health_log *health_log,
                      uint32_t tick, const struct input *input, struct ledger_entry *out)
{
    const struct ledger *ledger = &accounts->ledger;
    *out = health_of(&accounts->credit, health_log, tick, input);
    out->id = ledger->last_id + 1u;
    out->boot = ledger->boot;
    out->tick = tick;
    out->day = ledger->day;
    out->minute = ledger->minute;
    out->balance = ledger->balance;
    return ledger->boot > 0 && ledger->last_id < LEDGER_ID_MAX;
}

/* Logs the entry about the kiosk's start and each due entry about uptime and faults. If the ledger
 * has no room, the function logs a due entry in the first tick in which the ledger has room. */
void health_log_tick(struct accounts *accounts, struct health_log *health_log,
                     const struct game *game, const struct core_config *config,
                     const struct input *input, struct output *output)
{
    struct ledger *ledger = &accounts->ledger;
    const bool is_first = !health_log->is_written;
    health_log->is_written = 1;
    /* Log the kiosk's start. Without a store (`boot` 0) starts are not counted and not logged. */
    if (is_first && ledger->boot > 0) {
        const struct ledger_entry entry = { .kind = LEDGER_BOOT,
                                            .count = ledger->boot,
                                            .value = (int32_t)ledger->balance.unlogged };
        coins_convert_pending(ledger, config);
        ledger_write(accounts, game->tick, &entry, output);
        const bool counts = (ledger->balance.open & PAYMENT_SPENT) &&
                            round_standing_finish(accounts, config, game->tick, output);
        if (!counts && ledger->balance.open != PAYMENT_NONE) {
            credit_refund(accounts, game, config, REFUND_RESTART, output);
            /* Show no message about the refund, because the refunded round is from an earlier run
             * of the kiosk. */
            accounts->credit.came_back = 0;
        }
    }
    const bool is_due = game->tick - health_log->written_tick >= HEALTH_LOG_TICKS;
    if ((is_due || ledger_needs_sync(ledger)) && ledger_may_write(ledger, LEDGER_HEALTH)) {
        health_log_write(accounts, health_log, game->tick, input, output);
    }
}

/* ---- Repeated losses of controllers --------------------------------------------------------- */

void health_log_note_losses(struct accounts *accounts, struct health_log *health_log,
                            const struct game *game, const struct world *world,
                            struct output *output)
{
    CORE_ASSERT(game->phase == PHASE_ROUND);
    for (uint32_t i = 0; i < POI_MAX; i++) {
        const struct player *player = &game->player[i];
        const uint32_t last_tick = health_log->loss_tick[i];
        const bool is_away = player->plays && !player->out && !player_has_poi(world, i);
        health_log->away_ticks[i] = is_away ? health_log->away_ticks[i] + 1u : 0u;
        if (health_log->away_ticks[i] != HEALTH_LOG_LOSS_TICKS) {
            continue;
        }
        health_log->loss_tick[i] = game->tick;
        if (last_tick != 0 && game->tick - last_tick < HEALTH_LOG_LOSS_AGAIN_TICKS) {
            const struct ledger_entry entry = { .kind = LEDGER_LOSS,
                                                .detail = (uint8_t)i,
                                                .count = 1 };
            ledger_write(accounts, game->tick, &entry, output);
        }
    }
}
