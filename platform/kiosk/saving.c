/* saving.c -- passes ledger entries and edits to the store and handles the store's errors; see
 * saving.h. */
#include "platform/kiosk/saving.h"

#include "core/base/panic.h"

/* Interval between two attempts to pass data to the store after a failure. */
#define RETRY_NS 1000000000ull

/* Returns 1 if the store accepted the data or no store exists, otherwise 0. After a failure, delays
 * the next attempt. */
static int is_settled(struct saving *saving, int result, uint64_t now_ns)
{
    if (hal_is_fault(result)) {
        saving->retry_ns = now_ns + RETRY_NS;
    }
    return result == HAL_OK || result == HAL_ERR_ABSENT;
}

uint32_t saving_put_entries(struct saving *saving, const struct hal_ledger *store,
                            const struct output *output, uint64_t now_ns)
{
    CORE_ASSERT(store->ops);
    while (!saving_is_done(saving, output) && now_ns >= saving->retry_ns) {
        const uint32_t behind = output->entry_id - saving->accepted_id;
        saving->accepted_id += behind > LEDGER_RING ? behind - LEDGER_RING : 0u;
        const uint32_t place = (saving->accepted_id + 1u) % LEDGER_RING;
        const int result = store->ops->append(store->self, &output->entries[place]);
        if (!is_settled(saving, result, now_ns)) {
            return (uint32_t)hal_is_fault(result);
        }
        saving->accepted_id++;
    }
    return 0;
}

uint32_t saving_put_edit(struct saving *saving, const struct hal_edit_store *edits,
                         const struct output *output, uint64_t now_ns)
{
    CORE_ASSERT(edits->ops);
    if (output->edit.id == saving->accepted_edit_id || now_ns < saving->retry_ns) {
        return 0;
    }
    const int result = edits->ops->store(edits->self, &output->edit);
    if (is_settled(saving, result, now_ns)) {
        saving->accepted_edit_id = output->edit.id;
    }
    return (uint32_t)hal_is_fault(result);
}

uint32_t saving_refused(struct saving *saving, const struct hal_ledger *store)
{
    const uint32_t refused = store->ops->failed_count(store->self);
    const uint32_t fresh = refused - saving->refused_seen;
    saving->refused_seen = refused;
    return fresh;
}

/* ---- Offline credits ----------------------------------------------------------------------- */

/* Maximum number of entries in one call of merge_offline(). Additional entries follow in the next
 * transaction. */
#define BATCH_MAX 16u

struct batch {
    const struct core *core;
    struct ledger_entry entries[BATCH_MAX];
    uint32_t count;
};

static uint32_t untold(const struct offline_flush *flush, const struct core *core, uint32_t audit)
{
    CORE_ASSERT(audit < AUDIT_COUNT);
    return core->game.accounts.audits.count[audit] > flush->told.count[audit]
               ? core->game.accounts.audits.count[audit] - flush->told.count[audit]
               : 0u;
}

static void offline_flush_add_entry(struct batch *batch, uint8_t kind, uint32_t detail,
                                    uint32_t count, uint32_t value)
{
    CORE_ASSERT(batch->count <= BATCH_MAX);
    const struct ledger *ledger = &batch->core->game.accounts.ledger;
    if (batch->count < BATCH_MAX) {
        batch->entries[batch->count++] = (struct ledger_entry){
            .tick = batch->core->game.tick,
            .day = ledger->day,
            .minute = ledger->minute,
            .kind = kind,
            .detail = (uint8_t)detail,
            .count = count,
            .value = (int32_t)value,
        };
    }
}

static void add_counted(struct batch *batch, const struct offline_flush *flush, uint8_t kind,
                        uint32_t audit)
{
    const uint32_t count = untold(flush, batch->core, audit);
    if (count > 0) {
        offline_flush_add_entry(batch, kind, 0, count, 0);
    }
}

static void add_credits(struct batch *batch, const struct offline_flush *flush)
{
    const uint32_t credits = untold(flush, batch->core, AUDIT_CREDITS_PAID);
    if (credits > 0) {
        offline_flush_add_entry(batch, LEDGER_CREDITS, 0, credits,
                                untold(flush, batch->core, AUDIT_CREDITS_BONUS));
    }
    add_counted(batch, flush, LEDGER_EXPIRED, AUDIT_EXPIRED);
    add_counted(batch, flush, LEDGER_TEST_COIN, AUDIT_TEST_COINS);
    for (uint32_t i = untold(flush, batch->core, AUDIT_CREDITS_SERVICE);
         i > 0 && batch->count < BATCH_MAX; i--) {
        offline_flush_add_entry(batch, LEDGER_SERVICE, 0, 1, 0);
    }
}

int saving_flush_offline(struct offline_flush *flush, const struct hal_ledger *store,
                         const struct core *core)
{
    struct batch batch = { .core = core };
    /* Record the amounts of a transfer as transferred after the store has written the transfer. */
    if (flush->is_asked && store->ops->offline_merged(store->self) == HAL_OK) {
        flush->told = flush->asked;
        flush->told_balance = flush->asked_balance;
        flush->is_asked = 0;
    }
    if (flush->is_asked) {
        return 0;
    }
    const struct balance_change step = { flush->told_balance, core->game.accounts.ledger.balance };
    /* Add one entry for each coin line that received coins. The audits contain only the total value
     * of all coins, not the value of each coin line. Therefore the first entry gets the total
     * value, and the other entries get 0. */
    uint32_t units = untold(flush, batch.core, AUDIT_UNITS);
    for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
        const uint32_t pulses = untold(flush, batch.core, AUDIT_COINS_1 + line);
        if (pulses > 0) {
            offline_flush_add_entry(&batch, LEDGER_COINS, line, pulses, units);
            units = 0;
        }
    }
    add_credits(&batch, flush);
    /* Add the offline tickets as an entry for a round (LEDGER_ROUND) without players. The
     * balance already contains the tickets. The entry only makes the audits count the tickets. */
    const uint32_t count = untold(flush, batch.core, AUDIT_TICKETS);
    if (count > 0 && batch.count < BATCH_MAX) {
        offline_flush_add_entry(&batch, LEDGER_ROUND, 0, 0, count);
        batch.entries[batch.count - 1u].round.unscored = 1;
    }
    if (batch.count == 0 && step.from.units == step.to.units &&
        step.from.bonus_units == step.to.bonus_units && step.from.paid == step.to.paid &&
        step.from.service == step.to.service && step.from.unlogged == step.to.unlogged &&
        step.from.tickets == step.to.tickets) {
        return 1;
    }
    if (batch.count == 0) {
        offline_flush_add_entry(&batch, LEDGER_HEALTH, 0, 0,
                                0); /* A health entry whose counts are all 0 only stores the changed
                                       balance. */
    }
    if (store->ops->merge_offline(store->self, &step, batch.entries, batch.count) == HAL_OK) {
        flush->asked = flush->told;
        for (uint32_t i = 0; i < batch.count; i++) {
            audits_note(&flush->asked, &batch.entries[i]);
        }
        flush->asked_balance = step.to;
        flush->is_asked = 1;
    }
    return 0;
}
