/* offline_flush.c -- collects offline credits and transfers them to the store; see
 * offline_flush.h. */
#include "platform/kiosk/offline_flush.h"

/* Maximum number of entries in one call of merge_offline(). Additional entries follow in the next
 * transaction. */
#define BATCH_MAX 16u

struct batch {
    const struct core *core;
    struct ledger_entry entries[BATCH_MAX];
    uint32_t count;
};

static uint32_t less(uint32_t from, uint32_t what)
{
    return from > what ? from - what : 0u;
}

static uint32_t untold(const struct offline_flush *flush, const struct core *core, uint32_t audit)
{
    return less(core->game.accounts.audits.count[audit], flush->told.count[audit]);
}

static void offline_flush_add_entry(struct batch *batch, uint8_t kind, uint32_t detail,
                                    uint32_t count, uint32_t value)
{
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

/* Adds one entry for each coin line that received coins. The audits have only the total value of
 * all coin lines. Therefore the first entry gets the total value, and the other entries get 0. */
static void add_coins(struct batch *batch, const struct offline_flush *flush)
{
    uint32_t units = untold(flush, batch->core, AUDIT_UNITS);
    for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
        const uint32_t pulses = untold(flush, batch->core, AUDIT_COINS_1 + line);
        if (pulses > 0) {
            offline_flush_add_entry(batch, LEDGER_COINS, line, pulses, units);
            units = 0;
        }
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

/* Adds the offline tickets as an entry for a round (LEDGER_ROUND) without players. The balance
 * already contains the tickets. The entry only makes the audits count the tickets. */
static void add_tickets(struct batch *batch, const struct offline_flush *flush)
{
    const uint32_t count = untold(flush, batch->core, AUDIT_TICKETS);
    if (count > 0 && batch->count < BATCH_MAX) {
        offline_flush_add_entry(batch, LEDGER_ROUND, 0, 0, count);
        batch->entries[batch->count - 1u].round.unscored = 1;
    }
}

static int offline_flush_is_same(const struct balance *a, const struct balance *b)
{
    return a->units == b->units && a->bonus_units == b->bonus_units && a->paid == b->paid &&
           a->service == b->service && a->unlogged == b->unlogged && a->tickets == b->tickets;
}

/* Returns 1 if no transfer is in progress, otherwise 0. When the store has written a transfer,
 * records its amounts as transferred. */
static int is_written(struct offline_flush *flush, const struct hal_ledger *store)
{
    if (flush->is_asked && store->ops->offline_merged(store->self) == HAL_OK) {
        flush->told = flush->asked;
        flush->told_balance = flush->asked_balance;
        flush->is_asked = 0;
    }
    return !flush->is_asked;
}

int offline_flush_step(struct offline_flush *flush, const struct hal_ledger *store,
                       const struct core *core)
{
    struct batch batch = { .core = core };
    if (!is_written(flush, store)) {
        return 0;
    }
    const struct balance_change step = { flush->told_balance, core->game.accounts.ledger.balance };
    add_coins(&batch, flush);
    add_credits(&batch, flush);
    add_tickets(&batch, flush);
    if (batch.count == 0 && offline_flush_is_same(&step.from, &step.to)) {
        return 1;
    }
    if (batch.count == 0) {
        offline_flush_add_entry(&batch, LEDGER_HEALTH, 0, 0,
                                0); /* A health entry without counts only stores the changed
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
