/* late.c -- collects and transfers offline credits; see late.h. */
#include "platform/kiosk/late.h"

#define BATCH_MAX 16u /* Limit of hand_over(); further entries follow in the next transaction. */

struct batch {
    const struct core *core;
    struct ledger_entry entries[BATCH_MAX];
    uint32_t count;
};

static uint32_t less(uint32_t from, uint32_t what)
{
    return from > what ? from - what : 0u;
}

static uint32_t untold(const struct late *late, const struct core *core, uint32_t audit)
{
    return less(core->game.audits.count[audit], late->told.count[audit]);
}

static void add(struct batch *batch, uint8_t kind, uint32_t detail, uint32_t count, uint32_t value)
{
    const struct ledger *ledger = &batch->core->game.ledger;
    if (batch->count < BATCH_MAX) {
        batch->entries[batch->count++] = (struct ledger_entry){
            .tick = batch->core->tick,
            .day = ledger->day,
            .minute = ledger->minute,
            .kind = kind,
            .detail = (uint8_t)detail,
            .count = count,
            .value = (int32_t)value,
        };
    }
}

/* Adds the coins. The audits contain only the total value of all lines, which is assigned to the
 * first line with coins. */
static void add_coins(struct batch *batch, const struct late *late)
{
    uint32_t units = untold(late, batch->core, AUDIT_UNITS);
    for (uint32_t line = 0; line < COIN_LINE_COUNT; line++) {
        const uint32_t pulses = untold(late, batch->core, AUDIT_COINS_1 + line);
        if (pulses > 0) {
            add(batch, LEDGER_COINS, line, pulses, units);
            units = 0;
        }
    }
}

static void add_counted(struct batch *batch, const struct late *late, uint8_t kind, uint32_t audit)
{
    const uint32_t count = untold(late, batch->core, audit);
    if (count > 0) {
        add(batch, kind, 0, count, 0);
    }
}

static void add_credits(struct batch *batch, const struct late *late)
{
    const uint32_t credits = untold(late, batch->core, AUDIT_CREDITS_PAID);
    if (credits > 0) {
        add(batch, LEDGER_CREDITS, 0, credits, untold(late, batch->core, AUDIT_CREDITS_BONUS));
    }
    add_counted(batch, late, LEDGER_EXPIRED, AUDIT_EXPIRED);
    add_counted(batch, late, LEDGER_TEST_COIN, AUDIT_TEST_COINS);
    for (uint32_t i = untold(late, batch->core, AUDIT_CREDITS_SERVICE);
         i > 0 && batch->count < BATCH_MAX; i--) {
        add(batch, LEDGER_SERVICE, 0, 1, 0);
    }
}

/* Adds the tickets as a round without players: the balance contains the tickets, and the audits
 * must count them. */
static void add_tickets(struct batch *batch, const struct late *late)
{
    const uint32_t count = untold(late, batch->core, AUDIT_TICKETS);
    if (count > 0 && batch->count < BATCH_MAX) {
        add(batch, LEDGER_ROUND, 0, 0, count);
        batch->entries[batch->count - 1u].round.unscored = 1;
    }
}

static int is_same(const struct purse *a, const struct purse *b)
{
    return a->units == b->units && a->bonus_units == b->bonus_units && a->paid == b->paid &&
           a->service == b->service && a->untold == b->untold && a->tickets == b->tickets;
}

/* Returns 1 if the store has written what was transferred, or if nothing was transferred. */
static int is_written(struct late *late, const struct hal_storage *storage)
{
    if (late->is_asked && storage->ops->handed_over(storage->self) == HAL_OK) {
        late->told = late->asked;
        late->told_purse = late->asked_purse;
        late->is_asked = 0;
    }
    return !late->is_asked;
}

int late_is_told(struct late *late, const struct hal_storage *storage, const struct core *core)
{
    struct batch batch = { .core = core };
    if (!is_written(late, storage)) {
        return 0;
    }
    const struct purse_step step = { late->told_purse, core->game.ledger.purse };
    add_coins(&batch, late);
    add_credits(&batch, late);
    add_tickets(&batch, late);
    if (batch.count == 0 && is_same(&step.from, &step.to)) {
        return 1;
    }
    if (batch.count == 0) {
        add(&batch, LEDGER_HEALTH, 0, 0, 0); /* An entry that only carries the balance. */
    }
    if (storage->ops->hand_over(storage->self, &step, batch.entries, batch.count) == HAL_OK) {
        late->asked = late->told;
        for (uint32_t i = 0; i < batch.count; i++) {
            audits_note(&late->asked, &batch.entries[i]);
        }
        late->asked_purse = step.to;
        late->is_asked = 1;
    }
    return 0;
}
