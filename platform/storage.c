/* storage.c -- the store as the frame loop sees it: everything here comes back at once. */
#include "platform/storage.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>

#include <sqlite3.h>

#include "platform/folder.h"
#include "platform/storage_parts.h"

static void say(struct storage *storage, const char *what, const char *why, const char *advice)
{
    snprintf(storage->text, sizeof storage->text, "%.68s: %.44s; %.40s", what, why, advice);
}

/* ---- Opening -------------------------------------------------------------------------------- */

static bool folder_is_there(struct storage *storage)
{
    const int error = folder_make(storage->dir);
    if (error) {
        char what[HAL_TEXT_SIZE / 2];
        snprintf(what, sizeof what, "no store: %.56s", storage->dir);
        say(storage, what, strerror(-error), "make that folder and restart");
    }
    return error == 0;
}

/* Whether the path of the file is known; when not, `text` says why. */
static bool find_file(struct storage *storage)
{
    if (!storage->dir) {
        say(storage, "no store", "no folder was named", "give one with --data DIR");
        return false;
    }
    const int length =
        snprintf(storage->path, sizeof storage->path, "%s/" STORAGE_FILE, storage->dir);
    if (length < 0 || (size_t)length >= sizeof storage->path) {
        storage->path[0] = '\0';
        say(storage, "no store", "the folder's path is too long", "name a shorter one");
        return false;
    }
    return storage->how.vfs || folder_is_there(storage);
}

static void say_no_file(struct storage *storage, const char *why)
{
    char what[HAL_TEXT_SIZE / 2];
    snprintf(what, sizeof what, "no store: %.56s", storage->path);
    say(storage, what, why, "nothing is kept");
}

/* The thread takes no signals: those that end the kiosk are the main thread's to see. */
static bool start_thread(struct storage *storage)
{
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    storage->has_thread = pthread_create(&storage->thread, NULL, storage_thread, storage) == 0;
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return storage->has_thread;
}

/* What the core goes on from, before the thread has the file. */
static void note_start(struct storage *storage)
{
    struct ledger_entry newest;
    storage->start = storage->file.content;
    storage->accepted_id = storage->start.memory.ledger.last_id;
    atomic_store(&storage->saved_id, storage->accepted_id);
    if (ledger_file_entry(&storage->file, storage->accepted_id, &newest) == SQLITE_OK) {
        storage->saved_boot = newest.boot;
        storage->saved_tick = newest.tick;
    }
    storage->prunes = true;
    storage_note_seals(storage);
    atomic_store(&storage->has_file, true);
}

/* Graphs are texts in the same folder: the thread runs for them without a database, too. */
static int storage_open(void *self)
{
    struct storage *storage = self;
    if (storage->running) {
        return atomic_load(&storage->has_file) ? HAL_OK : HAL_ERR_IO;
    }
    if (!find_file(storage)) {
        return storage->dir ? HAL_ERR_IO : HAL_ERR_NONE;
    }
    sqlite3_hard_heap_limit64(STORAGE_HEAP_MAX);
    const int code = storage_open_file(storage);
    atomic_store(&storage->error, storage->file.is_read_only ? SQLITE_READONLY : code);
    if (code == SQLITE_OK) {
        note_start(storage);
    } else {
        say_no_file(storage, ledger_file_error(code));
    }
    sem_init(&storage->wake, 0, 0);
    storage->running = true;
    if (!storage->by_hand && !start_thread(storage)) {
        say_no_file(storage, "no thread to be had");
        storage_close_file(storage);
        atomic_store(&storage->has_file, false);
        storage->running = false;
        return HAL_ERR_IO;
    }
    return code == SQLITE_OK ? HAL_OK : HAL_ERR_IO;
}

static int storage_remember(void *self, struct memory *out)
{
    const struct storage *storage = self;
    if (!storage->running || !storage->start.has_read) {
        return HAL_ERR_NONE;
    }
    ledger_content_remember(&storage->start, out);
    out->ledger.boots++; /* This start; it is on disk with the first entry that says so. */
    return HAL_OK;
}

/* ---- Entries and graphs --------------------------------------------------------------------- */

static int storage_keep(void *self, const struct ledger_entry *entry)
{
    struct storage *storage = self;
    if (!atomic_load(&storage->has_file)) {
        return HAL_ERR_NONE;
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

static uint32_t storage_saved_id(void *self)
{
    struct storage *storage = self;
    return atomic_load(&storage->saved_id);
}

static int storage_keep_edit(void *self, const struct edit_record *edit)
{
    struct storage *storage = self;
    if (!storage->running) {
        return HAL_ERR_NONE;
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

static uint32_t storage_kept_edit_id(void *self)
{
    struct storage *storage = self;
    return atomic_load(&storage->kept_edit_id);
}

/* The last try failed, or there will be none. */
static int storage_refuses_edits(void *self)
{
    struct storage *storage = self;
    return !storage->running || atomic_load(&storage->edit_error) != 0;
}

/* ---- Replays -------------------------------------------------------------------------------- */

static int storage_keep_replay(void *self, uint32_t round_id, const uint8_t *bytes, size_t size)
{
    struct storage *storage = self;
    if (!atomic_load(&storage->has_file)) {
        return HAL_ERR_NONE;
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

static uint32_t storage_replay_kept_id(void *self)
{
    struct storage *storage = self;
    return atomic_load(&storage->put_id);
}

static int storage_fetch_replay(void *self, uint32_t round_id, uint8_t *bytes, size_t size,
                                struct ledger_entry *round)
{
    struct storage *storage = self;
    if (!atomic_load(&storage->has_file)) {
        return HAL_ERR_NONE;
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

static int storage_replay_fetched(void *self)
{
    struct storage *storage = self;
    return atomic_load(&storage->get.state) != STORAGE_REPLAY_IDLE ? HAL_ERR_BUSY
                                                                   : atomic_load(&storage->got);
}

static int storage_has_replay(void *self, uint32_t round_id)
{
    struct storage *storage = self;
    for (uint32_t i = 0; i < STORAGE_RANKS && round_id != 0; i++) {
        if (atomic_load_explicit(&storage->sealed[i], memory_order_relaxed) == round_id) {
            return 1;
        }
    }
    return 0;
}

/* ---- How it is ------------------------------------------------------------------------------ */

/* How long the card has not answered; 0 while that is nothing to tell. */
static int64_t stuck_ms(const struct storage *storage)
{
    const int64_t since_ms = atomic_load(&storage->busy_since_ms);
    const int64_t busy_ms = since_ms > 0 ? storage_now_ms() - since_ms : 0;
    return busy_ms >= STORAGE_STUCK_MS ? busy_ms : 0;
}

static int storage_is_well(void *self)
{
    struct storage *storage = self;
    return atomic_load(&storage->has_file) && atomic_load(&storage->error) == SQLITE_OK &&
           stuck_ms(storage) == 0;
}

static int storage_wants_restart(void *self)
{
    struct storage *storage = self;
    return !storage->start.has_read && atomic_load(&storage->error) == LEDGER_FILE_ANOTHERS;
}

static uint32_t storage_refused_count(void *self)
{
    struct storage *storage = self;
    return atomic_load(&storage->refused);
}

static void say_refused(struct storage *storage, int error, const char *advice)
{
    char what[HAL_TEXT_SIZE / 2];
    snprintf(what, sizeof what, "store: %u entries not written", storage_unwritten(storage));
    say(storage, what, ledger_file_error(error), advice);
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
    case LEDGER_FILE_ANOTHERS:
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
    const unsigned aside = atomic_load(&storage->aside);
    if (!atomic_load(&storage->has_file)) {
        if (error == LEDGER_FILE_ANOTHERS) {
            say(storage, "no store", "the card is there now, and not empty",
                "a restart, once nobody plays");
        }
        return storage->text[0] ? storage->text : "no store: not opened";
    }
    if (stuck_ms(storage) > 0) {
        snprintf(storage->text, sizeof storage->text,
                 "store: the card has not answered for %u s; %u entries wait",
                 (unsigned)(stuck_ms(storage) / 1000), storage_unwritten(storage));
    } else if (error != SQLITE_OK) {
        say_refused(storage, error, advice_for(error));
    } else if (edit_error != 0) {
        say(storage, "store: a graph was not written", strerror(edit_error), "it is retried");
    } else if (aside > 0) {
        snprintf(storage->text, sizeof storage->text,
                 STORAGE_FILE " was damaged and is now " STORAGE_FILE STORAGE_ASIDE_SUFFIX
                              "%u: %u entries from the backup, %u from itself, %u lost",
                 aside, storage->from_backup, storage->salvaged.entries, storage->salvaged.lost);
    } else {
        snprintf(storage->text, sizeof storage->text, "%.150s", storage->path);
    }
    return storage->text;
}

/* ---- Closing -------------------------------------------------------------------------------- */

static void stop_thread(struct storage *storage)
{
    if (storage->has_thread) {
        atomic_store(&storage->stop, true);
        sem_post(&storage->wake);
        pthread_join(storage->thread, NULL);
        storage->has_thread = false;
        atomic_store(&storage->stop, false);
    }
}

static uint32_t storage_close(void *self)
{
    struct storage *storage = self;
    if (!storage->running) {
        return 0;
    }
    stop_thread(storage);
    storage->backup_due_s = INT64_MAX; /* Whoever pulls the plug now has the last one. */
    ledger_backup_drop(&storage->backup);
    storage_work(storage); /* What came while it was leaving, and one last try for the rest. */
    const uint32_t lost = storage_unwritten(storage), lost_edits = storage_unwritten_edits(storage);
    if (lost > 0) {
        say_refused(storage, atomic_load(&storage->error), "they are lost");
    } else if (lost_edits > 0) {
        say(storage, "store: a graph was not written",
            strerror(atomic_load(&storage->edit_error)), "it is lost");
    }
    sem_destroy(&storage->wake);
    storage_close_file(storage);
    storage->running = false;
    atomic_store(&storage->has_file, false);
    return lost + lost_edits;
}

struct hal_storage storage_device(struct storage *storage)
{
    static const struct hal_storage_ops ops = {
        .open = storage_open,
        .remember = storage_remember,
        .keep = storage_keep,
        .keep_replay = storage_keep_replay,
        .replay_kept_id = storage_replay_kept_id,
        .fetch_replay = storage_fetch_replay,
        .replay_fetched = storage_replay_fetched,
        .has_replay = storage_has_replay,
        .saved_id = storage_saved_id,
        .keep_edit = storage_keep_edit,
        .kept_edit_id = storage_kept_edit_id,
        .refuses_edits = storage_refuses_edits,
        .is_well = storage_is_well,
        .wants_restart = storage_wants_restart,
        .refused_count = storage_refused_count,
        .describe = storage_describe,
        .close = storage_close,
    };
    return (struct hal_storage){ .ops = &ops, .self = storage };
}
