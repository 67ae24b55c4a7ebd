/* storage_thread.c -- implements the queues of entries and edits from the frame loop to the store's
 * thread, and the store's thread. The thread writes to the database and to the ledger mirror while
 * the frame loop draws. */
#include <errno.h>
#include <semaphore.h>
#include <sys/stat.h>
#include <time.h>

#include <sqlite3.h>

#include "core/base/panic.h"
#include "platform/store/graph_file.h"
#include "platform/store/storage_internal.h"

/* Interval between two attempts to write to a memory card after a failure, in milliseconds. */
#define RETRY_MS 1000
/* Interval in milliseconds between two checks that the open database is still at its path. With
 * this interval a loss is reported within one second, because the status file is written
 * immediately after a change of the status. */
#define CHECK_MS 200

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
    ledger_mirror_close(&storage->tail);
    ledger_file_close(&storage->file);
}

int64_t storage_now_ms(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (int64_t)now.tv_sec * 1000 + now.tv_nsec / 1000000 + 1;
}

/* ---- Queues, which the frame loop fills ---------------------------------------------------- */

int storage_append(void *self, const struct ledger_entry *entry)
{
    struct storage *storage = self;
    if (!atomic_load(&storage->has_file)) {
        return HAL_ERR_ABSENT;
    }
    if (entry->id <= storage->accepted_id) {
        return HAL_OK;
    }
    if (storage_unwritten(storage) == STORAGE_QUEUE_MAX) {
        return HAL_ERR_BUSY;
    }
    const unsigned pushed = atomic_load(&storage->pushed);
    storage->queue[pushed % STORAGE_QUEUE_MAX] = *entry;
    storage->accepted_id = entry->id;
    atomic_store(&storage->pushed, pushed + 1);
    sem_post(&storage->wake);
    return HAL_OK;
}

int storage_store_edit(void *self, const struct graph_edit_record *edit)
{
    struct storage *storage = self;
    if (!storage->running) {
        return HAL_ERR_ABSENT;
    }
    if (edit->id <= storage->accepted_edit_id) {
        return HAL_OK;
    }
    const unsigned pushed = atomic_load(&storage->edits_pushed);
    if (storage_unwritten_edits(storage) == STORAGE_EDITS_MAX) {
        return HAL_ERR_BUSY;
    }
    storage->edits[pushed % STORAGE_EDITS_MAX] = *edit;
    storage->accepted_edit_id = edit->id;
    atomic_store(&storage->edits_pushed, pushed + 1);
    sem_post(&storage->wake);
    return HAL_OK;
}

/* ---- Ledger mirror ------------------------------------------------------------------------- */

/* Writes each new entry to the ledger mirror before the entry is acknowledged. The ledger mirror
 * is a second copy of the newest entries.
 *
 * The mirror has no gap. After a failed write, the missing entries are copied from the database
 * before a newer entry is added. No entry is acknowledged until the mirror is complete. */

/* Maximum number of entries that are copied from the database between two syncs. */
#define BATCH 64u

static int open_tail(struct storage *storage)
{
    const struct storage_path path = storage_path(storage, STORAGE_MIRROR_SUFFIX, "");
    int result = ledger_mirror_open(&storage->tail, path.text);
    /* A mirror of a foreign ledger must not be used. Such a mirror exists if, for example, a user
     * copied files from another memory card. */
    struct ledger_entry entry;
    if (result == 0 &&
        ledger_mirror_entry(&storage->tail, atomic_load(&storage->saved_id), &entry) &&
        (entry.boot != storage->saved_boot || entry.tick != storage->saved_tick)) {
        ledger_mirror_close(&storage->tail);
        result = storage_quarantine_other(storage, STORAGE_MIRROR_SUFFIX);
        result = result == 0 ? ledger_mirror_open(&storage->tail, path.text) : result;
    }
    if (result == 0) {
        /* Sets `tail_from` to the id of the first saved entry that the mirror lacks. */
        const uint32_t saved_id = atomic_load(&storage->saved_id);
        const uint32_t last_id = ledger_mirror_last_id(&storage->tail);
        if (last_id < saved_id && (storage->tail_from == 0 || storage->tail_from > last_id + 1u)) {
            storage->tail_from = last_id + 1u;
        }
    }
    return result;
}

/* Returns true if the open mirror is no longer at its path, because the file was deleted, renamed
 * or replaced. The next program start would not find its entries. */
static bool has_mirror_left(const struct storage *storage)
{
    struct stat held, named;
    const struct storage_path path = storage_path(storage, STORAGE_MIRROR_SUFFIX, "");
    return storage->tail.handle > 0 && fstat(storage->tail.handle, &held) == 0 &&
           !(lstat(path.text, &named) == 0 && named.st_dev == held.st_dev &&
             named.st_ino == held.st_ino);
}

/* Opens the mirror and copies missing entries up to the id `last_id`. A mirror that is no longer at
 * its path is replaced by a complete one. Returns 0 or -1. */
static int make_ready(struct storage *storage, uint32_t last_id)
{
    CORE_ASSERT(storage->file.db);
    if (has_mirror_left(storage)) {
        ledger_mirror_close(&storage->tail);
        storage->tail_from = 1;
    }
    int result = storage->tail.handle > 0 ? 0 : open_tail(storage);
    if (result == 0) {
        struct ledger_entry entries[BATCH];
        uint32_t count = 0;
        uint32_t id = storage->tail_from;
        if (last_id >= LEDGER_MIRROR_SLOTS && id < last_id - LEDGER_MIRROR_SLOTS + 1u) {
            id = last_id - LEDGER_MIRROR_SLOTS + 1u;
        }
        for (; result == 0 && storage->tail_from > 0 && id <= last_id; id++) {
            count += ledger_file_entry(&storage->file, id, &entries[count]) == SQLITE_OK;
            if (count == BATCH || (count > 0 && id == last_id)) {
                result = ledger_mirror_write(&storage->tail, entries, count);
                count = 0;
            }
        }
        storage->tail_from = result == 0 ? 0u : storage->tail_from;
    }
    return result;
}

static void note_mirror(struct storage *storage, int result, uint32_t first_id)
{
    const int error = result == 0 ? 0 : errno > 0 ? errno : EIO;
    atomic_store(&storage->tail_error, error);
    if (result != 0) {
        ledger_mirror_close(&storage->tail);
        storage->tail_from = storage->tail_from > 0 ? storage->tail_from : first_id;
        atomic_fetch_add(&storage->refused, 1);
    }
}

int storage_mirror_write(struct storage *storage, const struct ledger_entry *entries,
                         uint32_t count)
{
    CORE_ASSERT(entries && count > 0);
    if (storage->how.vfs) {
        return 0;
    }
    int result = make_ready(storage, entries[0].id - 1u);
    /* Erases revoked player names in the mirror. */
    for (uint32_t i = 0; result == 0 && i < count; i++) {
        if (entries[i].kind == LEDGER_NAME && !entries[i].name[0]) {
            result = ledger_mirror_erase_name(&storage->tail, entries[i].count, entries[i].detail);
        }
    }
    result = result == 0 ? ledger_mirror_write(&storage->tail, entries, count) : result;
    note_mirror(storage, result, entries[0].id);
    return result;
}

/* ---- Writing entries ----------------------------------------------------------------------- */

/* Writes the oldest contiguous entries of the queue in one transaction. Returns true if both the
 * database and the mirror have synced the entries. Otherwise acknowledges no entry and returns
 * false. */
static bool write_batch(struct storage *storage, unsigned written, unsigned pushed)
{
    CORE_ASSERT(written != pushed);
    CORE_ASSERT(pushed - written <= STORAGE_QUEUE_MAX);
    const unsigned first = written % STORAGE_QUEUE_MAX;
    const unsigned waiting = pushed - written;
    const unsigned beside = STORAGE_QUEUE_MAX - first;
    const unsigned count = waiting < beside ? waiting : beside;
    const struct ledger_entry *entries = &storage->queue[first];
    atomic_store(&storage->busy_since_ms, storage_now_ms());
    int code = ledger_file_write(&storage->file, entries, count);
    if (code == SQLITE_OK && storage_has_moved(storage)) {
        /* The database moved during the write. The next program start would not find the entries,
         * so the write counts as failed. */
        code = LEDGER_FILE_MOVED;
    }
    const bool is_in_mirror =
        code == SQLITE_OK && storage_mirror_write(storage, entries, count) == 0;
    atomic_store(&storage->busy_since_ms, 0);
    storage_note_write(storage, code);
    if (!is_in_mirror) {
        return false;
    }
    for (unsigned i = 0; i < count; i++) {
        storage->prunes |= entries[i].kind == LEDGER_ROUND;
    }
    const struct ledger_entry *newest = &entries[count - 1u];
    storage->saved_boot = newest->boot;
    storage->saved_tick = newest->tick;
    atomic_store(&storage->saved_id, newest->id);
    atomic_store(&storage->written, written + count);
    return true;
}

/* Writes the queued entries, oldest first, and stops at the first failure. */
static void drain(struct storage *storage)
{
    unsigned written = atomic_load(&storage->written);
    unsigned pushed = atomic_load(&storage->pushed);
    while (written != pushed && write_batch(storage, written, pushed)) {
        written = atomic_load(&storage->written);
        pushed = atomic_load(&storage->pushed);
    }
    if (storage->prunes && storage->file.db && written == pushed) {
        const int code = ledger_file_prune(&storage->file);
        storage->prunes = code != SQLITE_OK;
        if (storage_needs_reopening(code)) {
            storage_note_write(storage, code);
        }
        storage_update_sealed(storage);
    }
}

/* ---- Backup -------------------------------------------------------------------------------- */

/* Returns true if the backup must be aborted: the store is being closed, or the open database is no
 * longer at its path, which must be reported within one second. */
static bool must_abort_backup(void *context)
{
    struct storage *storage = context;
    return atomic_load(&storage->stop) || storage_has_moved(storage);
}

/* Advances the backup in steps while no entry waits and the database is at its path. Copying and
 * validating a large database takes longer than CHECK_MS, so the path is also checked before each
 * step and during the validation. After a failure the next backup is started one hour later. */
static void back_up(struct storage *storage)
{
    const int64_t now_s = storage_now_ms() / 1000;
    int code = SQLITE_OK;
    if (!(storage->file.db && !storage->file.refusal && !storage->how.vfs && !storage->closes &&
          atomic_load(&storage->error) == SQLITE_OK)) {
        ledger_backup_drop(&storage->backup);
        return;
    }
    const uint32_t last_id = storage->file.content.memory.ledger.last_id;
    if (!storage->backup.copy && (now_s >= storage->backup_due_s ||
                                  last_id - storage->backup_id >= STORAGE_BACKUP_ENTRIES)) {
        storage->backup_due_s = now_s + STORAGE_BACKUP_S;
        storage->backup_id = last_id;
        code = storage_is_behind_backup(storage)
                   /* A database with fewer entries than the backup must not replace the backup. */
                   ? SQLITE_CORRUPT
                   : ledger_backup_begin(&storage->backup, &storage->file,
                                         storage_path(storage, STORAGE_BACKUP_SUFFIX, "").text);
        storage->backup.is_cancelled = must_abort_backup;
        storage->backup.context = storage;
    }
    while (code == SQLITE_OK && storage->backup.copy && storage_unwritten(storage) == 0 &&
           !must_abort_backup(storage)) {
        code = ledger_backup_step(&storage->backup);
    }
    if (code == SQLITE_INTERRUPT) {
        /* An aborted backup is started again when the database is back at its path. */
        storage->backup_due_s = 0;
    } else if (code != SQLITE_OK && code != SQLITE_DONE && code != SQLITE_BUSY) {
        atomic_fetch_add(&storage->refused, 1);
    }
}

/* ---- Writing edits of the growth lab ------------------------------------------------------- */

static void drain_edits(struct storage *storage)
{
    CORE_ASSERT(storage_unwritten_edits(storage) <= STORAGE_EDITS_MAX);
    unsigned written = atomic_load(&storage->edits_written);
    while (written != atomic_load(&storage->edits_pushed)) {
        const struct graph_edit_record *edit = &storage->edits[written % STORAGE_EDITS_MAX];
        const int error = graph_file_write(storage->dir, edit);
        atomic_store(&storage->edit_error, -error);
        if (error != 0) {
            atomic_fetch_add(&storage->refused, 1);
            return;
        }
        atomic_store(&storage->stored_edit_id, edit->id);
        atomic_store(&storage->edits_written, ++written);
    }
}

/* ---- Background work ----------------------------------------------------------------------- */

static bool has_chore(const struct storage *storage)
{
    return storage->chore.step && storage->file.db && !storage->file.refusal && !storage->moved &&
           !atomic_load(&storage->is_unproven) && atomic_load(&storage->error) == SQLITE_OK;
}

static void do_chore(struct storage *storage)
{
    const int64_t until_ms = storage_now_ms() + STORAGE_CHORE_MS;
    int code = SQLITE_OK;
    while (code == SQLITE_OK && has_chore(storage) && storage_unwritten(storage) == 0 &&
           storage_now_ms() < until_ms && !atomic_load(&storage->stop)) {
        code = storage->chore.step(storage->chore.self, &storage->file);
    }
    if (code == SQLITE_DONE) {
        storage->chore.step = NULL;
        /* Updates the list of replays, because the background work may have deleted some. */
        storage_update_sealed(storage);
    } else if (storage_needs_reopening(code)) {
        storage_note_write(storage, code);
    }
}

/* ---- Thread -------------------------------------------------------------------------------- */

void storage_work(struct storage *storage)
{
    CORE_ASSERT(storage_unwritten(storage) <= STORAGE_QUEUE_MAX);
    /* Writes and syncs the write-ahead log again if another program's lock prevented this when the
     * database was opened. If the lock remains, the next call retries. */
    if (atomic_load(&storage->is_unproven) && storage_has_card(storage)) {
        const int code = storage->file.is_suspect ? ledger_log_secure(&storage->file) : SQLITE_OK;
        storage_note_write(storage, code);
        if (code == SQLITE_OK) {
            atomic_store(&storage->is_unproven, false);
        }
    }
    if (storage_has_card(storage)) {
        drain(storage);
        /* Completes the mirror after a failed write, and replaces a mirror that is no longer at its
         * path, if no entry waits in the queue. If entries wait, the write of the next batch
         * completes the mirror, and the store must stay unhealthy until then. */
        if ((storage->tail_from > 0 || has_mirror_left(storage)) &&
            storage_unwritten(storage) == 0 && storage->file.db && !storage->file.refusal) {
            note_mirror(storage, make_ready(storage, atomic_load(&storage->saved_id)), 0);
        }
    }
    storage_put_replay(storage);
    storage_get_replay(storage);
    drain_edits(storage);
    back_up(storage);
    do_chore(storage);
}

/* Thread function of the store. Calls storage_work() when there is new work, and at least once per
 * second to retry failed writes and to start a backup that is due. */
void *storage_thread(void *context)
{
    struct storage *storage = context;
    int64_t due_ms = 0;
    while (!atomic_load(&storage->stop)) {
        /* Waits until new work arrives, for at most CHECK_MS. Returns true if there is new work. */
        struct timespec until;
        clock_gettime(CLOCK_MONOTONIC, &until);
        until.tv_nsec += (has_chore(storage) ? STORAGE_CHORE_WAIT_MS : CHECK_MS) * 1000000L;
        until.tv_sec += until.tv_nsec / 1000000000L;
        until.tv_nsec %= 1000000000L;
        if (sem_clockwait(&storage->wake, CLOCK_MONOTONIC, &until) == 0 ||
            storage_now_ms() >= due_ms ||
            (storage->file.db && !storage->file.refusal &&
             storage_has_moved(storage) != storage->moved)) {
            storage_work(storage);
            due_ms = storage_now_ms() + RETRY_MS;
        } else {
            do_chore(storage);
        }
    }
    return NULL;
}
