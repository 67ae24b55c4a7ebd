/* offline_credits.c -- writes offline credits to a database that appears after program start.
 * Offline credits are coins and credits that the kiosk received before a database was available.
 *
 * The database already has its own ledger. The offline entries are appended to this ledger in one
 * transaction. Their boot number follows the last boot number of the database. */
#include <string.h>

#include <sqlite3.h>

#include "platform/store/storage_internal.h"

int offline_credits_merge(void *self, const struct balance_change *step,
                          const struct ledger_entry *entries, uint32_t count)
{
    struct storage *storage = self;
    struct offline_credits *late = &storage->late;
    if (!storage->running || atomic_load(&late->state) != OFFLINE_CREDITS_NONE) {
        return storage->running ? HAL_ERR_BUSY : HAL_ERR_ABSENT;
    }
    late->count = count < OFFLINE_CREDITS_MAX ? count : OFFLINE_CREDITS_MAX;
    memcpy(late->entries, entries, late->count * sizeof *entries);
    late->entries[0].id = 0; /* An id of 0 means that the entries did not get ids in the database
                                yet. */
    late->step = *step;
    atomic_store(&late->state, OFFLINE_CREDITS_NEW);
    sem_post(&storage->wake);
    return HAL_OK;
}

int offline_credits_result(void *self)
{
    struct storage *storage = self;
    return atomic_load(&storage->late.state) == OFFLINE_CREDITS_NONE ? HAL_OK : HAL_ERR_BUSY;
}

static void change(uint32_t *count, uint32_t from, uint32_t to)
{
    const int64_t sum = (int64_t)*count + to - from;
    *count = sum < 0 ? 0u : sum < BALANCE_MAX ? (uint32_t)sum : BALANCE_MAX;
}

/* Returns the database's balance after the change. `open` stays unchanged, because a round that is
 * open in the database is refunded at the next start. */
static struct balance after(struct balance balance, const struct balance_change *step)
{
    change(&balance.units, step->from.units, step->to.units);
    change(&balance.bonus_units, step->from.bonus_units, step->to.bonus_units);
    change(&balance.paid, step->from.paid, step->to.paid);
    change(&balance.service, step->from.service, step->to.service);
    change(&balance.unlogged, step->from.unlogged, step->to.unlogged);
    uint32_t tickets = balance.tickets;
    change(&tickets, step->from.tickets, step->to.tickets);
    balance.tickets = (uint16_t)(tickets < BALANCE_TICKETS_MAX ? tickets : BALANCE_TICKETS_MAX);
    return balance;
}

static void put_behind(struct offline_credits *late, const struct ledger_start *list)
{
    const struct balance balance = after(list->balance, &late->step);
    const uint32_t next = list->boots + (list->boots < LEDGER_BOOTS_MAX);
    late->boot = late->boot > 0 ? late->boot : next; /* All transfers of this kiosk share one boot
                                                        number. */
    for (uint32_t i = 0; i < late->count; i++) {
        late->entries[i].id = list->last_id + 1u + i;
        late->entries[i].boot = late->boot;
        late->entries[i].balance = balance;
    }
}

/* Returns true if the database already contains the offline entries. An earlier commit of the
 * entries may have succeeded although it reported an error. Entries that are found here are on
 * disk, because opening the database made its content durable. */
static bool has_them(struct storage *storage)
{
    const struct ledger_entry *first = &storage->late.entries[0];
    struct ledger_entry there;
    return first->id > 0 && ledger_file_entry(&storage->file, first->id, &there) == SQLITE_OK &&
           there.boot == first->boot && there.tick == first->tick && there.kind == first->kind;
}

void offline_credits_apply(struct storage *storage)
{
    struct offline_credits *late = &storage->late;
    if (atomic_load(&late->state) == OFFLINE_CREDITS_NONE || storage->start.has_read) {
        return;
    }
    atomic_store(&late->state, OFFLINE_CREDITS_PENDING);
    const struct ledger_start *list = &storage->file.content.memory.ledger;
    const bool has_ids = list->last_id <= LEDGER_ID_MAX - OFFLINE_CREDITS_MAX;
    int code = storage->file.refusal ? storage->file.refusal : has_ids ? SQLITE_OK : SQLITE_FULL;
    if (code == SQLITE_OK && !has_them(storage)) {
        put_behind(late, list);
        code = ledger_file_write(&storage->file, late->entries, late->count);
    }
    if (code != SQLITE_OK) {
        atomic_fetch_add(&storage->refused, 1);
    } else if (storage_mirror_write(storage, late->entries, late->count) == 0) {
        atomic_store(&late->state, OFFLINE_CREDITS_NONE);
    }
}
