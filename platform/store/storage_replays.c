/* storage_replays.c -- writes and reads replays of ranked rounds. At most one write and one read
 * are pending at a time. */
#include <sqlite3.h>

#include "platform/store/storage_internal.h"

/* ---- Functions for the frame loop ---------------------------------------------------------- */

int storage_store_replay(void *self, uint32_t round_id, const uint8_t *bytes, size_t size)
{
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

int storage_has_replay(void *self, uint32_t round_id)
{
    struct storage *storage = self;
    for (uint32_t i = 0; i < STORAGE_RANKS && round_id != 0; i++) {
        if (atomic_load_explicit(&storage->sealed[i], memory_order_relaxed) == round_id) {
            return 1;
        }
    }
    return 0;
}

/* ---- Functions for the store's thread ------------------------------------------------------ */

/* Returns true if the round is on disk and has a place in the ranking. */
static bool is_ranked(const struct storage *storage, uint32_t round_id)
{
    const struct ranking *ranking = &storage->file.content.memory.ranking;
    for (uint32_t i = 0; i < MODE_COUNT * RANK_PERIOD_COUNT * RANK_ROWS; i++) {
        const struct rank_row *row =
            &ranking->row[i / RANK_ROWS / RANK_PERIOD_COUNT][i / RANK_ROWS % RANK_PERIOD_COUNT]
                         [i % RANK_ROWS];
        if (row->caught > 0 && row->round_id == round_id) {
            return true;
        }
    }
    return false;
}

static void end_put(struct storage *storage)
{
    storage->put_since_ms = 0;
    atomic_store(&storage->put_id, storage->put.round_id);
    atomic_store(&storage->put.state, STORAGE_REPLAY_IDLE);
}

/* Returns true if the card has rejected the replay for STORAGE_REPLAY_MS. */
static bool gives_up(struct storage *storage)
{
    const int64_t now_ms = storage_now_ms();
    storage->put_since_ms = storage->put_since_ms > 0 ? storage->put_since_ms : now_ms;
    return now_ms - storage->put_since_ms >= STORAGE_REPLAY_MS;
}

void storage_update_sealed(struct storage *storage)
{
    if (!storage->file.db) {
        return; /* A failed write has closed the database. Therefore no replay can be looked up. */
    }
    const struct rank_row *rows = &storage->file.content.memory.ranking.row[0][0][0];
    for (uint32_t i = 0; i < STORAGE_RANKS; i++) {
        const uint32_t id = rows[i].caught > 0 ? rows[i].round_id : 0u;
        const int has = id != 0 && ledger_file_has_replay(&storage->file, id);
        atomic_store_explicit(&storage->sealed[i], has ? id : 0u, memory_order_relaxed);
    }
}

/* Writes the requested replay after the ledger entry of its round. Abandons a replay that the card
 * has rejected for STORAGE_REPLAY_MS. */
void storage_put_replay(struct storage *storage)
{
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
    if (code == SQLITE_OK || gives_up(storage)) {
        end_put(storage);
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
