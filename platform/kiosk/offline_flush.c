/* offline_flush.c -- computes the offline credits that are not yet on disk and transfers them to
 * the store; see offline_flush.h. */
#include "platform/kiosk/offline_flush.h"

#include "core/base/panic.h"

/* Maximum number of entries in one call of merge_offline(). Additional entries follow in the next
 * transaction. */
#define BATCH_MAX 16u

struct batch {
    struct core_status status;
    const struct audits *audits; /* Audit counts of the core. */
    const struct audits *stored; /* Audit counts that the store has already written to disk. */
    struct ledger_entry entries[BATCH_MAX];
    uint32_t count;
};

/* Returns the part of the counter `audit` that is not yet on disk. */
static uint32_t unflushed_count(const struct batch *batch, uint32_t audit)
{
    CORE_ASSERT(audit < AUDIT_COUNT);
    const uint32_t count = batch->audits->count[audit];
    const uint32_t stored = batch->stored->count[audit];
    return count > stored ? count - stored : 0u;
}

static void add_entry(struct batch *batch, uint8_t kind, uint32_t detail, uint32_t count,
                      uint32_t value)
{
    CORE_ASSERT(batch->count <= BATCH_MAX);
    if (batch->count < BATCH_MAX) {
        batch->entries[batch->count++] = (struct ledger_entry){
            .tick = batch->status.tick,
            .day = batch->status.day,
            .minute = batch->status.minute,
            .kind = kind,
            .detail = (uint8_t)detail,
            .count = count,
            .value = (int32_t)value,
        };
    }
}

/* Adds an entry for each kind of credit that was counted since the last transfer. */
static void add_credits(struct batch *batch)
{
    static const struct {
        uint8_t kind, audit;
    } counts[] = {
        { LEDGER_CREDITS, AUDIT_CREDITS_PAID },
        { LEDGER_EXPIRED, AUDIT_EXPIRED },
        { LEDGER_TEST_COIN, AUDIT_TEST_COINS },
    };
    for (uint32_t i = 0; i < sizeof counts / sizeof counts[0]; i++) {
        const uint32_t count = unflushed_count(batch, counts[i].audit);
        const uint32_t bonus =
            counts[i].kind == LEDGER_CREDITS ? unflushed_count(batch, AUDIT_CREDITS_BONUS) : 0u;
        if (count > 0) {
            add_entry(batch, counts[i].kind, 0, count, bonus);
        }
    }
    for (uint32_t i = unflushed_count(batch, AUDIT_CREDITS_SERVICE);
         i > 0 && batch->count < BATCH_MAX; i--) {
        add_entry(batch, LEDGER_SERVICE, 0, 1, 0);
    }
}

/* Marks the last transfer as stored if the store has written it. */
static void note_stored(struct offline_flush *flush, const struct hal_ledger *store)
{
    if (flush->is_sending && store->ops->offline_merged(store->self) == HAL_OK) {
        flush->stored = flush->sent;
        flush->stored_balance = flush->sent_balance;
        flush->is_sending = false;
    }
}

/* Returns entries with the amounts that are not yet on disk. */
static struct batch unflushed_batch(const struct offline_flush *flush, const struct core *core)
{
    struct batch batch = { .status = core_status(core),
                           .audits = core_audits(core),
                           .stored = &flush->stored };
    /* Adds one entry for each coin line that received coins. The audits contain only the total
     * value of all coins, not the value for each coin line. Therefore the first entry gets the
     * total value, and the other entries get 0. */
    uint32_t units = unflushed_count(&batch, AUDIT_UNITS);
    for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
        const uint32_t pulses = unflushed_count(&batch, AUDIT_COINS_1 + line);
        if (pulses > 0) {
            add_entry(&batch, LEDGER_COINS, line, pulses, units);
            units = 0;
        }
    }
    add_credits(&batch);
    /* Adds the offline tickets as an entry for a round (LEDGER_ROUND) without players. The balance
     * already contains the tickets, so the entry changes only the ticket count of the audits. */
    const uint32_t count = unflushed_count(&batch, AUDIT_TICKETS);
    if (count > 0 && batch.count < BATCH_MAX) {
        add_entry(&batch, LEDGER_ROUND, 0, 0, count);
        batch.entries[batch.count - 1u].round.unscored = 1;
    }
    return batch;
}

uint32_t offline_flush_missing(struct offline_flush *flush, const struct hal_ledger *store,
                               const struct core *core)
{
    CORE_ASSERT(flush && store->ops);
    note_stored(flush, store);
    return unflushed_batch(flush, core).count;
}

bool offline_flush_step(struct offline_flush *flush, const struct hal_ledger *store,
                        const struct core *core)
{
    note_stored(flush, store);
    if (flush->is_sending) {
        return false;
    }
    struct batch batch = unflushed_batch(flush, core);
    const struct balance_change step = { flush->stored_balance, batch.status.balance };
    if (batch.count == 0 && step.from.units == step.to.units &&
        step.from.bonus_units == step.to.bonus_units && step.from.paid == step.to.paid &&
        step.from.service == step.to.service && step.from.unlogged == step.to.unlogged &&
        step.from.tickets == step.to.tickets) {
        return true;
    }
    if (batch.count == 0) {
        add_entry(&batch, LEDGER_HEALTH, 0, 0,
                  /* The store writes a balance only as a part of an entry. A health entry whose
                   * counts are all 0 changes nothing except the balance. */
                  0);
    }
    if (store->ops->merge_offline(store->self, &step, batch.entries, batch.count) == HAL_OK) {
        flush->sent = flush->stored;
        for (uint32_t i = 0; i < batch.count; i++) {
            audits_note(&flush->sent, &batch.entries[i]);
        }
        flush->sent_balance = step.to;
        flush->is_sending = true;
    }
    return false;
}
