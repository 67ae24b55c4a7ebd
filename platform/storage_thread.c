/* storage_thread.c -- what the store does while frames go on. */
#include <semaphore.h>
#include <time.h>

#include <sqlite3.h>

#include "platform/edit_file.h"
#include "platform/storage_parts.h"

#define RETRY_S 1 /* Between two tries at a card that refused. */

uint32_t storage_unwritten(const struct storage *storage)
{
    return atomic_load(&storage->pushed) - atomic_load(&storage->written);
}

uint32_t storage_unwritten_edits(const struct storage *storage)
{
    return atomic_load(&storage->edits_pushed) - atomic_load(&storage->edits_written);
}

void storage_close_file(struct storage *storage)
{
    ledger_backup_drop(&storage->backup);
    ledger_file_close(&storage->file);
}

int64_t storage_now_ms(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (int64_t)now.tv_sec * 1000 + now.tv_nsec / 1000000 + 1;
}

static void note_result(struct storage *storage, int code)
{
    atomic_store(&storage->error, code);
    if (code != SQLITE_OK) {
        atomic_fetch_add(&storage->refused, 1);
    }
}

/* ---- A card that went ----------------------------------------------------------------------- */

/* These say that the file as it was opened is of no use any more; others pass. */
static bool needs_reopening(int code)
{
    return code == SQLITE_IOERR || code == SQLITE_CANTOPEN || code == SQLITE_READONLY ||
           code == SQLITE_CORRUPT || code == SQLITE_NOTADB;
}

/* Whether the list in the file is not the one that was left there: somebody else's card, or the
 * kiosk began without this one. A fresh card has fewer entries, and so has a backup; and one more
 * batch may have come through than the kiosk was told. */
static bool is_anothers(struct storage *storage)
{
    const unsigned pushed = atomic_load(&storage->pushed);
    const uint32_t saved_id = atomic_load(&storage->saved_id);
    const uint32_t last_id = storage->file.content.memory.ledger.last_id;
    const uint32_t newest_id = storage_unwritten(storage) > 0
                                   ? storage->queue[(pushed - 1u) % STORAGE_QUEUE_MAX].id
                                   : saved_id;
    struct ledger_entry entry;
    if (last_id < saved_id || last_id == 0) {
        return false;
    }
    return last_id > newest_id ||
           (saved_id > 0 && (ledger_file_entry(&storage->file, saved_id, &entry) != SQLITE_OK ||
                             entry.boot != storage->saved_boot ||
                             entry.tick != storage->saved_tick));
}

static bool has_card(struct storage *storage)
{
    if (storage->file.db && !storage->file.is_read_only) {
        return true;
    }
    storage_close_file(storage);
    if (!storage->path[0]) {
        return false;
    }
    int code = storage_open_file(storage);
    if (code == SQLITE_OK && is_anothers(storage)) {
        storage_close_file(storage);
        code = LEDGER_FILE_ANOTHERS;
    }
    if (code == SQLITE_OK) {
        atomic_store(&storage->has_file, true);
        code = storage->file.is_read_only ? SQLITE_READONLY : SQLITE_OK;
    }
    note_result(storage, code);
    return code == SQLITE_OK;
}

/* ---- Entries -------------------------------------------------------------------------------- */

static void note_saved(struct storage *storage, const struct ledger_entry *newest)
{
    storage->saved_boot = newest->boot;
    storage->saved_tick = newest->tick;
    atomic_store(&storage->saved_id, newest->id);
}

/* All that lie side by side in the queue, in one transaction. 0 when it was refused. */
static int write_batch(struct storage *storage, unsigned written, unsigned pushed)
{
    const unsigned first = written % STORAGE_QUEUE_MAX;
    const unsigned waiting = pushed - written;
    const unsigned beside = STORAGE_QUEUE_MAX - first;
    const unsigned count = waiting < beside ? waiting : beside;
    const struct ledger_entry *entries = &storage->queue[first];
    atomic_store(&storage->busy_since_ms, storage_now_ms());
    const int code = ledger_file_write(&storage->file, entries, count);
    atomic_store(&storage->busy_since_ms, 0);
    note_result(storage, code);
    if (code != SQLITE_OK) {
        if (needs_reopening(code)) {
            storage_close_file(storage);
        }
        return 0;
    }
    for (unsigned i = 0; i < count; i++) {
        storage->prunes |= entries[i].kind == LEDGER_ROUND;
    }
    note_saved(storage, &entries[count - 1u]);
    atomic_store(&storage->written, written + count);
    return 1;
}

/* Writes what is queued, oldest first, and stops at the first refusal. */
static void drain(struct storage *storage)
{
    unsigned written = atomic_load(&storage->written);
    unsigned pushed = atomic_load(&storage->pushed);
    while (written != pushed && write_batch(storage, written, pushed)) {
        written = atomic_load(&storage->written);
        pushed = atomic_load(&storage->pushed);
    }
    if (storage->prunes && storage->file.db && written == pushed) {
        storage->prunes = ledger_file_prune(&storage->file) != SQLITE_OK;
        storage_note_seals(storage);
    }
}

/* ---- The backup ----------------------------------------------------------------------------- */

static int64_t now_s(void)
{
    return storage_now_ms() / 1000;
}

static bool may_back_up(const struct storage *storage)
{
    return storage->file.db && !storage->file.is_read_only && !storage->how.vfs &&
           atomic_load(&storage->error) == SQLITE_OK;
}

/* A piece at a time, and only while no entry waits; one that fails is made again in an hour. */
static void back_up(struct storage *storage)
{
    char path[LEDGER_PATH_SIZE];
    int code = SQLITE_OK;
    if (!may_back_up(storage)) {
        ledger_backup_drop(&storage->backup);
        return;
    }
    if (!storage->backup.copy && now_s() >= storage->backup_due_s) {
        storage->backup_due_s = now_s() + STORAGE_BACKUP_S;
        storage_backup_path(storage, path);
        code = storage_is_behind_backup(storage)
                   ? SQLITE_CORRUPT /* What has more is not written over with what has less. */
                   : ledger_backup_begin(&storage->backup, &storage->file, path);
    }
    while (code == SQLITE_OK && storage->backup.copy && storage_unwritten(storage) == 0 &&
           !atomic_load(&storage->stop)) {
        code = ledger_backup_step(&storage->backup);
    }
    if (code != SQLITE_OK && code != SQLITE_DONE && code != SQLITE_BUSY) {
        atomic_fetch_add(&storage->refused, 1);
    }
}

/* ---- Replays -------------------------------------------------------------------------------- */

/* Only of a round that is on disk and still among the best. */
static bool is_ranked(const struct storage *storage, uint32_t round_id)
{
    const struct ranking *ranking = &storage->file.content.memory.ranking;
    for (uint32_t i = 0; i < MODE_COUNT * RANK_PERIOD_COUNT * RANK_ROWS; i++) {
        const struct rank_row *row = &ranking->row[i / RANK_ROWS / RANK_PERIOD_COUNT]
                                                  [i / RANK_ROWS % RANK_PERIOD_COUNT]
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

/* Whether a refusal was the last straw. */
static bool gives_up(struct storage *storage)
{
    const int64_t now_ms = storage_now_ms();
    storage->put_since_ms = storage->put_since_ms > 0 ? storage->put_since_ms : now_ms;
    return now_ms - storage->put_since_ms >= STORAGE_REPLAY_MS;
}

void storage_note_seals(struct storage *storage)
{
    const struct rank_row *rows = &storage->file.content.memory.ranking.row[0][0][0];
    for (uint32_t i = 0; i < STORAGE_RANKS; i++) {
        const uint32_t id = rows[i].caught > 0 ? rows[i].round_id : 0u;
        const int has = id != 0 && ledger_file_has_replay(&storage->file, id);
        atomic_store_explicit(&storage->sealed[i], has ? id : 0u, memory_order_relaxed);
    }
}

/* Its round is written first; it is given up when the card goes on refusing. */
static void put_replay(struct storage *storage)
{
    const struct storage_replay *put = &storage->put;
    if (atomic_load(&put->state) != STORAGE_REPLAY_WAITS) {
        return;
    }
    int code = SQLITE_BUSY;
    if (storage->file.db && storage_unwritten(storage) == 0) {
        code = is_ranked(storage, put->round_id)
                   ? ledger_file_put_replay(&storage->file, put->round_id, put->bytes, put->size)
                   : SQLITE_OK;
        note_result(storage, code);
        storage_note_seals(storage);
    }
    if (code == SQLITE_OK || gives_up(storage)) {
        end_put(storage);
    }
}

static void get_replay(struct storage *storage)
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
    atomic_store(&storage->got, code == SQLITE_OK ? (int)size : HAL_ERR_NONE);
    atomic_store(&get->state, STORAGE_REPLAY_IDLE);
}

/* ---- Graphs, which need no database --------------------------------------------------------- */

static void drain_edits(struct storage *storage)
{
    unsigned written = atomic_load(&storage->edits_written);
    while (written != atomic_load(&storage->edits_pushed)) {
        const struct edit_record *edit = &storage->edits[written % STORAGE_EDITS_MAX];
        const int error = edit_file_keep(storage->dir, edit);
        atomic_store(&storage->edit_error, -error);
        if (error != 0) {
            atomic_fetch_add(&storage->refused, 1);
            return;
        }
        atomic_store(&storage->kept_edit_id, edit->id);
        atomic_store(&storage->edits_written, ++written);
    }
}

/* ---- The thread ----------------------------------------------------------------------------- */

void storage_work(struct storage *storage)
{
    if (has_card(storage)) {
        drain(storage);
    }
    put_replay(storage);
    get_replay(storage);
    drain_edits(storage);
    back_up(storage);
}

static bool has_work(const struct storage *storage)
{
    return storage_unwritten(storage) > 0 || storage_unwritten_edits(storage) > 0 ||
           (storage->path[0] && !storage->file.db) || storage->file.is_read_only ||
           atomic_load(&storage->put.state) == STORAGE_REPLAY_WAITS || storage->backup.copy;
}

/* Until something comes, or a card that refused may be asked again, or a backup is due. */
static void wait_for_work(struct storage *storage)
{
    const int64_t due_s = storage->backup_due_s - now_s();
    const int64_t idle_s = due_s > RETRY_S ? due_s : RETRY_S;
    struct timespec until;
    clock_gettime(CLOCK_MONOTONIC, &until);
    until.tv_sec += has_work(storage) ? RETRY_S : idle_s;
    sem_clockwait(&storage->wake, CLOCK_MONOTONIC, &until);
}

void *storage_thread(void *context)
{
    struct storage *storage = context;
    while (!atomic_load(&storage->stop)) {
        wait_for_work(storage);
        storage_work(storage);
    }
    return NULL;
}
