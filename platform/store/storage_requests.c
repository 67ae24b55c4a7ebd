/* storage_requests.c -- writes and reads replays of ranked rounds, and writes offline credits. At
 * most one request of each kind is pending at a time. */
#include <string.h>

#include <sqlite3.h>

#include "core/base/panic.h"
#include "platform/store/storage_internal.h"

/* ---- Functions for the frame loop ---------------------------------------------------------- */

int storage_store_replay(void *self, uint32_t round_id, const uint8_t *bytes, size_t size)
{
    CORE_ASSERT(bytes);
    struct storage *storage = self;
    if (!atomic_load(&storage->has_file)) {
        return HAL_ERR_ABSENT;
    }
    if (atomic_load(&storage->put.state) != STORAGE_REPLAY_IDLE) {
        return HAL_ERR_BUSY;
    }
    storage->put.round_id = round_id;
    storage->put.bytes = bytes;
    storage->put.size = size;
    atomic_store(&storage->put.state, STORAGE_REPLAY_WAITS);
    sem_post(&storage->wake);
    return HAL_OK;
}

uint32_t storage_stored_replay_id(void *self)
{
    struct storage *storage = self;
    return atomic_load(&storage->put_id);
}

int storage_fetch_replay(void *self, uint32_t round_id, uint8_t *bytes, size_t size,
                         struct ledger_entry *round)
{
    CORE_ASSERT(bytes && round);
    struct storage *storage = self;
    if (!atomic_load(&storage->has_file)) {
        return HAL_ERR_ABSENT;
    }
    if (atomic_load(&storage->get.state) != STORAGE_REPLAY_IDLE) {
        return HAL_ERR_BUSY;
    }
    storage->get.round_id = round_id;
    storage->get.room = bytes;
    storage->get.size = size;
    storage->get.round = round;
    atomic_store(&storage->get.state, STORAGE_REPLAY_WAITS);
    sem_post(&storage->wake);
    return HAL_OK;
}

int storage_replay_fetched(void *self)
{
    struct storage *storage = self;
    return atomic_load(&storage->get.state) != STORAGE_REPLAY_IDLE ? HAL_ERR_BUSY
                                                                   : atomic_load(&storage->got);
}

bool storage_has_replay(void *self, uint32_t round_id)
{
    struct storage *storage = self;
    for (uint32_t i = 0; i < LEDGER_RANKS && round_id != 0; i++) {
        if (atomic_load_explicit(&storage->sealed[i], memory_order_relaxed) == round_id) {
            return true;
        }
    }
    return false;
}

/* ---- Functions for the store's thread ------------------------------------------------------ */

/* Returns true if the round is on disk and has a place in the ranking. */
static bool is_ranked(const struct storage *storage, uint32_t round_id)
{
    const struct rank_row *rows = &storage->file.content.memory.ranking.row[0][0][0];
    for (uint32_t i = 0; i < LEDGER_RANKS; i++) {
        if (rows[i].caught > 0 && rows[i].round_id == round_id) {
            return true;
        }
    }
    return false;
}

void storage_update_sealed(struct storage *storage)
{
    if (!storage->file.db) {
        return; /* A failed write has closed the database, so no replay can be looked up. */
    }
    const struct rank_row *rows = &storage->file.content.memory.ranking.row[0][0][0];
    for (uint32_t i = 0; i < LEDGER_RANKS; i++) {
        const uint32_t id = rows[i].caught > 0 ? rows[i].round_id : 0u;
        const bool has = id != 0 && ledger_file_has_replay(&storage->file, id);
        atomic_store_explicit(&storage->sealed[i], has ? id : 0u, memory_order_relaxed);
    }
}

/* Writes the requested replay after the ledger entry of its round. Abandons a replay that the
 * memory card has rejected for STORAGE_REPLAY_MS. */
void storage_put_replay(struct storage *storage)
{
    CORE_ASSERT(storage_unwritten(storage) <= STORAGE_QUEUE_MAX);
    const struct storage_replay *put = &storage->put;
    if (atomic_load(&put->state) != STORAGE_REPLAY_WAITS) {
        return;
    }
    int code = SQLITE_BUSY;
    if (storage->file.db && !storage->moved && storage_unwritten(storage) == 0) {
        code = is_ranked(storage, put->round_id)
                   ? ledger_file_put_replay(&storage->file, put->round_id, put->bytes, put->size)
                   : SQLITE_OK;
        storage_note_write(storage, code);
        storage_update_sealed(storage);
    }
    const int64_t now_ms = storage_now_ms();
    storage->put_since_ms = storage->put_since_ms > 0 ? storage->put_since_ms : now_ms;
    if (code == SQLITE_OK || now_ms - storage->put_since_ms >= STORAGE_REPLAY_MS) {
        storage->put_since_ms = 0;
        atomic_store(&storage->put_id, storage->put.round_id);
        atomic_store(&storage->put.state, STORAGE_REPLAY_IDLE);
    }
}

void storage_get_replay(struct storage *storage)
{
    struct storage_replay *get = &storage->get;
    if (atomic_load(&get->state) != STORAGE_REPLAY_WAITS) {
        return;
    }
    size_t size = 0;
    const int code = storage->file.db ? ledger_file_get_replay(&storage->file, get->round_id,
                                                               get->room, get->size, &size)
                                      : SQLITE_NOTFOUND;
    *get->round = (struct ledger_entry){ 0 };
    if (code == SQLITE_OK) {
        ledger_file_round(&storage->file, get->round_id, get->round);
    }
    atomic_store(&storage->got, code == SQLITE_OK ? (int)size : HAL_ERR_ABSENT);
    atomic_store(&get->state, STORAGE_REPLAY_IDLE);
}

/* ---- Offline credits ----------------------------------------------------------------------- */

/* Writes offline credits to a database that appears after program start. Offline credits are coins
 * and credits that the kiosk received before a database was available.
 *
 * The database already has its own ledger. The offline entries are appended to this ledger in one
 * transaction. Their boot number follows the last boot number of the database. */

int storage_merge_offline(void *self, const struct balance_change *step,
                          const struct ledger_entry *entries, uint32_t count)
{
    CORE_ASSERT(entries && count > 0);
    struct storage *storage = self;
    struct offline_credits *late = &storage->late;
    if (!storage->running || atomic_load(&late->state) != OFFLINE_CREDITS_NONE) {
        return storage->running ? HAL_ERR_BUSY : HAL_ERR_ABSENT;
    }
    late->count = count < OFFLINE_CREDITS_MAX ? count : OFFLINE_CREDITS_MAX;
    memcpy(late->entries, entries, late->count * sizeof *entries);
    /* The id 0 means that the entries have not yet got their ids in the database. */
    late->entries[0].id = 0;
    late->step = *step;
    atomic_store(&late->state, OFFLINE_CREDITS_NEW);
    sem_post(&storage->wake);
    return HAL_OK;
}

int storage_offline_merged(void *self)
{
    struct storage *storage = self;
    return atomic_load(&storage->late.state) == OFFLINE_CREDITS_NONE ? HAL_OK : HAL_ERR_BUSY;
}

static void change(uint32_t *count, uint32_t from, uint32_t to)
{
    const int64_t sum = (int64_t)*count + to - from;
    *count = sum < 0 ? 0u : sum < BALANCE_MAX ? (uint32_t)sum : BALANCE_MAX;
}

/* Returns the database's balance `balance` after the change `step`. The member `open`, the kind of
 * credit of an open round, keeps its value from the database. The next start can therefore refund a
 * round that is open in the database. */
static struct balance balance_after_change(struct balance balance,
                                           const struct balance_change *step)
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

void storage_apply_offline(struct storage *storage)
{
    CORE_ASSERT(storage->late.count <= OFFLINE_CREDITS_MAX);
    struct offline_credits *late = &storage->late;
    if (atomic_load(&late->state) == OFFLINE_CREDITS_NONE || storage->start.has_read) {
        return;
    }
    atomic_store(&late->state, OFFLINE_CREDITS_PENDING);
    const struct ledger_start *list = &storage->file.content.memory.ledger;
    const bool has_ids = list->last_id <= LEDGER_ID_MAX - OFFLINE_CREDITS_MAX;
    int code = storage->file.refusal ? storage->file.refusal : has_ids ? SQLITE_OK : SQLITE_FULL;
    /* Searches the database for the offline entries, because an earlier commit may have succeeded
     * although it reported an error. Entries that are found are on disk, because opening the
     * database made its content durable. */
    const struct ledger_entry *first = &storage->late.entries[0];
    struct ledger_entry there;
    if (code == SQLITE_OK &&
        !(first->id > 0 && ledger_file_entry(&storage->file, first->id, &there) == SQLITE_OK &&
          there.boot == first->boot && there.tick == first->tick && there.kind == first->kind)) {
        const struct balance balance = balance_after_change(list->balance, &late->step);
        const uint32_t next = list->boots + (list->boots < LEDGER_BOOTS_MAX);
        late->boot =
            late->boot > 0 ? late->boot : next; /* All transfers of this kiosk share one boot
                                                   number. */
        for (uint32_t i = 0; i < late->count; i++) {
            late->entries[i].id = list->last_id + 1u + i;
            late->entries[i].boot = late->boot;
            late->entries[i].balance = balance;
        }
        code = ledger_file_write(&storage->file, late->entries, late->count);
    }
    if (code != SQLITE_OK) {
        atomic_fetch_add(&storage->refused, 1);
    } else if (storage_mirror_write(storage, late->entries, late->count) == 0) {
        atomic_store(&late->state, OFFLINE_CREDITS_NONE);
    }
}
