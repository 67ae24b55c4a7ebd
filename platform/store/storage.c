/* storage.c -- implements the functions of the store that the frame loop calls, and the status text
 * of the store. Only open() and close() may block. */
#include "platform/store/storage.h"

#include <stdio.h>
#include <string.h>
#include <sys/stat.h>

#include <sqlite3.h>

#include "core/base/panic.h"
#include "platform/os/file.h"
#include "platform/os/thread.h"
#include "platform/store/storage_internal.h"

/* ---- Status text --------------------------------------------------------------------------- */

/* Writes the state of the store to storage->text, one line for the operator's menu, the status file
 * and the log. */
static void set_text(struct storage *storage, const char *what, const char *why, const char *advice)
{
    snprintf(storage->text, sizeof storage->text, "%.68s: %.44s; %.40s", what, why, advice);
}

static void text_no_file(struct storage *storage, const char *why)
{
    char what[HAL_TEXT_SIZE / 2];
    snprintf(what, sizeof what, "no store: %.56s", storage->path);
    set_text(storage, what, why, "nothing is kept");
}

static void text_refused(struct storage *storage, int error, const char *advice)
{
    char what[HAL_TEXT_SIZE / 2];
    snprintf(what, sizeof what, "store: %u entries not written", storage_unwritten(storage));
    set_text(storage, what, ledger_file_error(error), advice);
}

/* Returns the time in milliseconds for which the memory card (the disk with the database) has not
 * responded. Returns 0 if the time is less than STORAGE_STUCK_MS. */
static int64_t stuck_ms(const struct storage *storage)
{
    CORE_ASSERT(storage);
    const int64_t since_ms = atomic_load(&storage->busy_since_ms);
    const int64_t busy_ms = since_ms > 0 ? storage_now_ms() - since_ms : 0;
    return busy_ms >= STORAGE_STUCK_MS ? busy_ms : 0;
}

static const char *advice_for(int error)
{
    switch (error) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
        return "another program holds it; it is retried";
    case SQLITE_FULL:
        return "free some space; it is retried";
    case SQLITE_READONLY:
        return "the card is read-only; it is retried";
    case LEDGER_FILE_FOREIGN:
        return "restart to use this one";
    default:
        return "it is retried each second";
    }
}

static const char *storage_describe(void *self)
{
    struct storage *storage = self;
    const int error = atomic_load(&storage->error);
    const int edit_error = atomic_load(&storage->edit_error);
    const unsigned number = atomic_load(&storage->quarantined);
    if (!atomic_load(&storage->has_file)) {
        if (error == LEDGER_FILE_FOREIGN) {
            set_text(storage, "no store", "the card is there now", "the kiosk restarts when idle");
        }
        return storage->text[0] ? storage->text : "no store: not opened";
    }
    if (stuck_ms(storage) > 0) {
        snprintf(storage->text, sizeof storage->text,
                 "store: the card has not answered for %u s; %u entries wait",
                 (unsigned)(stuck_ms(storage) / 1000), storage_unwritten(storage));
    } else if (error == LEDGER_FILE_MOVED) {
        set_text(storage, "store: the data folder or " STORAGE_FILE " was removed or replaced",
                 "nothing is kept", "put it back, or restart the kiosk");
    } else if (error != SQLITE_OK) {
        text_refused(storage, error, advice_for(error));
    } else if (edit_error != 0) {
        set_text(storage, "store: a graph was not written", strerror(edit_error), "it is retried");
    } else if (atomic_load(&storage->tail_error) != 0) {
        set_text(storage, "store: the second copy is not written",
                 strerror(atomic_load(&storage->tail_error)), "it is retried");
    } else if (number > 0) {
        char what[80] = "missing", lost[24] = "unknown how many";
        if (!storage->was_missing) {
            snprintf(what, sizeof what,
                     "damaged and set aside as " STORAGE_FILE STORAGE_QUARANTINE_SUFFIX "%u",
                     number);
        }
        if (!storage->salvaged.is_open_ended) {
            snprintf(lost, sizeof lost, "%u", storage->salvaged.lost);
        }
        snprintf(storage->text, sizeof storage->text,
                 STORAGE_FILE " was %s: %u entries from the backup, %u later ones, %s lost", what,
                 storage->from_backup, storage->salvaged.entries, lost);
    } else if (atomic_load(&storage->strange) > 0) {
        snprintf(storage->text, sizeof storage->text,
                 STORAGE_FILE "%s was not a regular file and was set aside",
                 storage_suffixes[atomic_load(&storage->strange) - 1u]);
    } else {
        snprintf(storage->text, sizeof storage->text, "%.150s", storage->path);
    }
    return storage->text;
}

/* ---- Opening ------------------------------------------------------------------------------- */

/* Sets storage->path to the path of the database, and creates the data folder if necessary. Returns
 * true. Otherwise writes the reason to storage->text and returns false. A folder that cannot be
 * written is accepted, because the memory card may be remounted at any time. */
static bool find_file(struct storage *storage)
{
    struct stat about;
    char what[HAL_TEXT_SIZE / 2];
    if (!storage->dir) {
        set_text(storage, "no store", "no folder was named", "give one with --data DIR");
        return false;
    }
    const int length =
        snprintf(storage->path, sizeof storage->path, "%s/" STORAGE_FILE, storage->dir);
    if (length < 0 || (size_t)length >= sizeof storage->path) {
        storage->path[0] = '\0';
        set_text(storage, "no store", "the folder's path is too long", "name a shorter one");
        return false;
    }
    const int error = storage->how.vfs ? 0 : file_make_folder(storage->dir);
    if (error && !(stat(storage->dir, &about) == 0 && S_ISDIR(about.st_mode))) {
        snprintf(what, sizeof what, "no store: %.56s", storage->dir);
        set_text(storage, what, strerror(-error), "make that folder and restart");
        return false;
    }
    return true;
}

/* Opens the store. The store's thread also runs without a database, because edits of the growth lab
 * are text files in the same folder. */
static int storage_open(void *self)
{
    struct storage *storage = self;
    if (storage->running) {
        return atomic_load(&storage->has_file) ? HAL_OK : HAL_ERR_IO;
    }
    if (!find_file(storage)) {
        return storage->dir ? HAL_ERR_IO : HAL_ERR_ABSENT;
    }
    sqlite3_hard_heap_limit64(STORAGE_HEAP_MAX);
    int code = storage_open_exclusive(storage);
    if (code != SQLITE_OK && storage->has_to_rebuild && storage_read_remnants(storage, code)) {
        code = SQLITE_OK;
    }
    atomic_store(&storage->error, code == SQLITE_OK ? storage->file.refusal : code);
    if (code == SQLITE_OK) {
        /* Copies the state that was read from the database. The core starts from this state. The
         * store's thread does not use the database yet. */
        storage->start = storage->file.content;
        storage->accepted_id = storage->start.memory.ledger.last_id;
        atomic_store(&storage->saved_id, storage->accepted_id);
        atomic_store(&storage->is_unproven, storage->file.is_suspect);
        storage->saved_boot = storage->start.memory.ledger.boots;
        storage->saved_tick = storage->start.tick;
        storage->prunes = true;
        if (storage->file.db) {
            storage_update_sealed(storage);
        }
        atomic_store(&storage->has_file, true);
        if (storage->file.refusal == SQLITE_FULL) {
            /* Closes the database, so that other programs can read it. SQLite reads an open
             * database only with the index of its write-ahead log, for which a full memory card has
             * no space. */
            storage_close_file(storage);
        }
    } else {
        text_no_file(storage, ledger_file_error(code));
    }
    sem_init(&storage->wake, 0, 0);
    storage->running = true;
    if (!storage->without_thread) {
        storage->has_thread = thread_start(&storage->thread, storage_thread, storage) == 0;
    }
    if (!storage->without_thread && !storage->has_thread) {
        text_no_file(storage, "no thread to be had");
        storage_close_file(storage);
        storage_unlock(storage);
        atomic_store(&storage->has_file, false);
        storage->running = false;
        return HAL_ERR_IO;
    }
    return code == SQLITE_OK ? HAL_OK : HAL_ERR_IO;
}

static int storage_load(void *self, struct persistent_state *out)
{
    const struct storage *storage = self;
    if (!storage->running || !storage->start.has_read) {
        return HAL_ERR_ABSENT;
    }
    ledger_content_load(&storage->start, out);
    /* Counts the current program start. The first ledger entry of this start stores the number. */
    out->ledger.boots += out->ledger.boots < LEDGER_BOOTS_MAX;
    return HAL_OK;
}

static uint32_t storage_committed_id(void *self)
{
    struct storage *storage = self;
    return atomic_load(&storage->is_unproven) ? 0u : atomic_load(&storage->saved_id);
}

static uint32_t storage_stored_edit_id(void *self)
{
    struct storage *storage = self;
    return atomic_load(&storage->stored_edit_id);
}

/* Returns 1 if the last write of an edit failed, or if the store is not open. Otherwise returns
 * 0. */
static bool storage_edits_failed(void *self)
{
    struct storage *storage = self;
    return !storage->running || atomic_load(&storage->edit_error) != 0;
}

/* ---- Status -------------------------------------------------------------------------------- */

static bool storage_is_healthy(void *self)
{
    struct storage *storage = self;
    return atomic_load(&storage->has_file) && atomic_load(&storage->error) == SQLITE_OK &&
           !atomic_load(&storage->is_unproven) && atomic_load(&storage->tail_error) == 0 &&
           stuck_ms(storage) == 0;
}

static bool storage_needs_restart(void *self)
{
    struct storage *storage = self;
    return !storage->start.has_read && atomic_load(&storage->error) == LEDGER_FILE_FOREIGN;
}

static uint32_t storage_failed_count(void *self)
{
    struct storage *storage = self;
    return atomic_load(&storage->refused);
}

/* ---- Closing ------------------------------------------------------------------------------- */

static uint32_t storage_close(void *self)
{
    struct storage *storage = self;
    if (!storage->running) {
        return 0;
    }
    if (storage->has_thread) {
        atomic_store(&storage->stop, true);
        sem_post(&storage->wake);
        pthread_join(storage->thread, NULL);
        storage->has_thread = false;
        atomic_store(&storage->stop, false);
    }
    /* No new backup is started while the store is closed, so that the previous backup still exists
     * after a power cut. */
    storage->closes = true;
    ledger_backup_drop(&storage->backup);
    /* Writes the entries that arrived after the last write of the store's thread, and retries
     * failed writes once. */
    storage_work(storage);
    storage_save_deleted(storage);
    /* Counts the entries that are not in the database, and all waiting entries if the log of the
     * database may not be on disk, because the kernel's cache may hold the only copy of an entry
     * that reads back. An entry that is missing only in the mirror is not lost. */
    const unsigned pushed = atomic_load(&storage->pushed);
    uint32_t unsaved = 0;
    for (unsigned i = atomic_load(&storage->written); i != pushed; i++) {
        unsaved +=
            !storage->file.db || storage->file.refusal || storage->file.is_suspect ||
            storage->moved ||
            storage->queue[i % STORAGE_QUEUE_MAX].id > storage->file.content.memory.ledger.last_id;
    }
    const uint32_t lost_edits = storage_unwritten_edits(storage);
    if (unsaved > 0) {
        text_refused(storage, atomic_load(&storage->error), "they may be lost");
    } else if (lost_edits > 0) {
        set_text(storage, "store: a graph was not written",
                 strerror(atomic_load(&storage->edit_error)), "it is lost");
    }
    sem_destroy(&storage->wake);
    storage_close_file(storage);
    storage_unlock(storage);
    storage->running = storage->closes = false;
    atomic_store(&storage->has_file, false);
    return unsaved + lost_edits;
}

struct hal_storage storage_device(struct storage *storage)
{
    static const struct hal_ledger_ops ledger = {
        .open = storage_open,
        .load = storage_load,
        .append = storage_append,
        .committed_id = storage_committed_id,
        .failed_count = storage_failed_count,
        .is_healthy = storage_is_healthy,
        .needs_restart = storage_needs_restart,
        .merge_offline = storage_merge_offline,
        .offline_merged = storage_offline_merged,
        .describe = storage_describe,
        .close = storage_close,
    };
    static const struct hal_replay_store_ops replays = {
        .store = storage_store_replay,
        .stored_id = storage_stored_replay_id,
        .fetch = storage_fetch_replay,
        .fetched = storage_replay_fetched,
        .has = storage_has_replay,
    };
    static const struct hal_edit_store_ops edits = {
        .store = storage_store_edit,
        .stored_id = storage_stored_edit_id,
        .has_failed = storage_edits_failed,
    };
    return (struct hal_storage){
        .ledger = { &ledger, storage },
        .replays = { &replays, storage },
        .edits = { &edits, storage },
    };
}
