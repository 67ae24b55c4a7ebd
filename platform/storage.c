/* storage.c -- finished rounds go to SQLite behind a bounded queue. */
#include "platform/storage.h"

#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include <sqlite3.h>

#include "platform/edit_file.h"
#include "platform/folder.h"

#define RETRY_S 1           /* Between two tries at a card that refused. */
#define SET_ASIDE_MAX 1000u /* Damaged files that may lie beside the good one. */

static void say(struct storage *storage, const char *what, const char *why, const char *advice)
{
    snprintf(storage->text, sizeof storage->text, "%.68s: %.44s; %.40s", what, why, advice);
}

/* ---- opening ------------------------------------------------------------------------------ */

/* Opens the file and reads what it knows of today, before the thread has it. */
static int open_file(struct storage *storage)
{
    int code = score_file_open(&storage->file, storage->path);
    if (code == SQLITE_OK) {
        code = score_file_best_today(&storage->file, storage->best_today);
        if (code != SQLITE_OK) {
            score_file_close(&storage->file);
        }
    }
    return code;
}

/* A journal belongs to its file: left behind, it would be played into the fresh one. */
static void set_journal_aside(const struct storage *storage)
{
    char from[sizeof storage->path + 16], to[sizeof storage->set_aside + 16];
    snprintf(from, sizeof from, "%s-journal", storage->path);
    snprintf(to, sizeof to, "%s-journal", storage->set_aside);
    rename(from, to);
}

/* Renames the damaged file to the first free kingyo.db.damaged-N. */
static bool set_aside(struct storage *storage)
{
    for (unsigned n = 1; n <= SET_ASIDE_MAX; n++) {
        snprintf(storage->set_aside, sizeof storage->set_aside, "%s.damaged-%u", storage->path, n);
        if (access(storage->set_aside, F_OK) != 0) {
            if (rename(storage->path, storage->set_aside) == 0) {
                set_journal_aside(storage);
                return true;
            }
            break;
        }
    }
    storage->set_aside[0] = '\0';
    return false;
}

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

/* ---- the thread --------------------------------------------------------------------------- */

/* Writes what is queued, oldest first, and stops at the first refusal. */
static void drain(struct storage *storage)
{
    unsigned written = atomic_load(&storage->written);
    while (storage->has_file && written != atomic_load(&storage->pushed)) {
        const struct storage_slot *slot = &storage->queue[written % STORAGE_QUEUE_MAX];
        const int code = score_file_write(&storage->file, &slot->record, slot->ended_s);
        atomic_store(&storage->error, code);
        if (code != SQLITE_OK) {
            atomic_fetch_add(&storage->refused, 1);
            return;
        }
        atomic_store(&storage->saved_id, slot->record.id);
        atomic_store(&storage->written, ++written);
    }
}

/* The same for graphs, which need no database. */
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

static uint32_t unwritten_edits(const struct storage *storage)
{
    return atomic_load(&storage->edits_pushed) - atomic_load(&storage->edits_written);
}

static void wait_for_work(struct storage *storage)
{
    if (atomic_load(&storage->written) == atomic_load(&storage->pushed) &&
        unwritten_edits(storage) == 0) {
        while (sem_wait(&storage->wake) != 0 && errno == EINTR) {
        }
        return;
    }
    struct timespec until;
    clock_gettime(CLOCK_REALTIME, &until); /* What sem_timedwait measures by. */
    until.tv_sec += RETRY_S;
    sem_timedwait(&storage->wake, &until);
}

static void *writer(void *context)
{
    struct storage *storage = context;
    while (!atomic_load(&storage->stop)) {
        wait_for_work(storage);
        drain(storage);
        drain_edits(storage);
    }
    return NULL;
}

/* The thread takes no signals: those that end the kiosk are the main thread's to see. */
static bool start_writer(struct storage *storage)
{
    sigset_t all, before;
    sigfillset(&all);
    sem_init(&storage->wake, 0, 0);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    storage->running = pthread_create(&storage->thread, NULL, writer, storage) == 0;
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return storage->running;
}

/* ---- the device --------------------------------------------------------------------------- */

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
        say(storage, "no store", "the folder's path is too long", "name a shorter one");
        return false;
    }
    return folder_is_there(storage);
}

static void say_no_file(struct storage *storage, const char *why)
{
    char what[HAL_TEXT_SIZE / 2];
    snprintf(what, sizeof what, "no store: %.56s", storage->path);
    say(storage, what, why, "rounds are not kept");
}

/* Graphs are texts in the same folder: the thread runs for them without a database, too. */
static int storage_open(void *self)
{
    struct storage *storage = self;
    if (storage->running) {
        return storage->has_file ? HAL_OK : HAL_ERR_IO;
    }
    if (!find_file(storage)) {
        return storage->dir ? HAL_ERR_IO : HAL_ERR_NONE;
    }
    sqlite3_hard_heap_limit64(STORAGE_HEAP_MAX);
    int code = open_file(storage);
    if ((code == SQLITE_CORRUPT || code == SQLITE_NOTADB) && set_aside(storage)) {
        code = open_file(storage);
    }
    storage->has_file = code == SQLITE_OK;
    if (!start_writer(storage)) {
        say_no_file(storage, "no thread to be had");
        storage->has_file = false;
    } else if (!storage->has_file) {
        say_no_file(storage, score_file_error(code));
    }
    if (!storage->has_file) {
        score_file_close(&storage->file);
    }
    return storage->has_file ? HAL_OK : HAL_ERR_IO;
}

static int storage_remember(void *self, struct memory *out)
{
    const struct storage *storage = self;
    if (!storage->has_file) {
        return HAL_ERR_NONE;
    }
    for (uint32_t mode = 0; mode < MODE_COUNT; mode++) {
        out->ranking.row[mode][RANK_DAY][0].caught = storage->best_today[mode];
    }
    return HAL_OK;
}

static int storage_keep(void *self, const struct ledger_entry *entry)
{
    struct storage *storage = self;
    const struct round_record *record = &entry->round;
    if (!storage->has_file || entry->kind != LEDGER_ROUND) {
        return HAL_ERR_NONE;
    }
    if (record->id <= storage->accepted_id) {
        return HAL_OK;
    }
    const unsigned pushed = atomic_load(&storage->pushed);
    if (pushed - atomic_load(&storage->written) == STORAGE_QUEUE_MAX) {
        return HAL_ERR_BUSY;
    }
    storage->queue[pushed % STORAGE_QUEUE_MAX] =
        (struct storage_slot){ .record = *record, .ended_s = time(NULL) };
    storage->accepted_id = record->id;
    atomic_store(&storage->pushed, pushed + 1);
    sem_post(&storage->wake);
    return HAL_OK;
}

static uint32_t storage_saved_id(void *self)
{
    struct storage *storage = self;
    return atomic_load(&storage->saved_id);
}

static int storage_keep_replay(void *self, uint32_t round_id, const uint8_t *bytes, size_t size)
{
    (void)self, (void)round_id, (void)bytes, (void)size;
    return HAL_ERR_NONE;
}

static uint32_t storage_replay_kept_id(void *self)
{
    (void)self;
    return 0;
}

static int storage_fetch_replay(void *self, uint32_t round_id, uint8_t *bytes, size_t size)
{
    (void)self, (void)round_id, (void)bytes, (void)size;
    return HAL_ERR_NONE;
}

static int storage_replay_fetched(void *self)
{
    (void)self;
    return HAL_ERR_NONE;
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
    if (unwritten_edits(storage) == STORAGE_EDITS_MAX) {
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

static int storage_is_well(void *self)
{
    struct storage *storage = self;
    return storage->has_file && atomic_load(&storage->error) == SQLITE_OK &&
           !storage_refuses_edits(storage);
}

static uint32_t storage_refused_count(void *self)
{
    struct storage *storage = self;
    return atomic_load(&storage->refused);
}

static uint32_t unwritten_count(const struct storage *storage)
{
    return atomic_load(&storage->pushed) - atomic_load(&storage->written);
}

static void say_refused(struct storage *storage, int error, const char *advice)
{
    char what[HAL_TEXT_SIZE / 2];
    snprintf(what, sizeof what, "store: %u rounds not written", unwritten_count(storage));
    say(storage, what, score_file_error(error), advice);
}

static const char *advice_for(int error)
{
    switch (error) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
        return "another program holds it; it is retried";
    case SQLITE_FULL:
        return "free some space; it is retried";
    default:
        return "it is retried each second";
    }
}

static const char *storage_describe(void *self)
{
    struct storage *storage = self;
    if (!storage->has_file) {
        return storage->text[0] ? storage->text : "no store: not opened";
    }
    const int error = atomic_load(&storage->error);
    const int edit_error = atomic_load(&storage->edit_error);
    if (error != SQLITE_OK) {
        say_refused(storage, error, advice_for(error));
    } else if (edit_error != 0) {
        say(storage, "store: a graph was not written", strerror(edit_error), "it is retried");
    } else if (storage->set_aside[0]) {
        const char *name = strrchr(storage->set_aside, '/') + 1;
        snprintf(storage->text, sizeof storage->text,
                 "%.80s (a fresh one: the old was damaged and is now %.30s)", storage->path, name);
    } else {
        snprintf(storage->text, sizeof storage->text, "%.150s", storage->path);
    }
    return storage->text;
}

static uint32_t storage_close(void *self)
{
    struct storage *storage = self;
    if (!storage->running) {
        return 0;
    }
    atomic_store(&storage->stop, true);
    sem_post(&storage->wake);
    pthread_join(storage->thread, NULL);
    drain(storage); /* What came while the thread was leaving, and one last try for the rest. */
    drain_edits(storage);
    const uint32_t lost = unwritten_count(storage), lost_edits = unwritten_edits(storage);
    if (lost > 0) {
        say_refused(storage, atomic_load(&storage->error), "they are lost");
    } else if (lost_edits > 0) {
        say(storage, "store: a graph was not written",
            strerror(atomic_load(&storage->edit_error)), "it is lost");
    }
    sem_destroy(&storage->wake);
    if (storage->has_file) {
        score_file_close(&storage->file);
    }
    storage->running = storage->has_file = false;
    atomic_store(&storage->stop, false);
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
        .saved_id = storage_saved_id,
        .keep_edit = storage_keep_edit,
        .kept_edit_id = storage_kept_edit_id,
        .refuses_edits = storage_refuses_edits,
        .is_well = storage_is_well,
        .refused_count = storage_refused_count,
        .describe = storage_describe,
        .close = storage_close,
    };
    return (struct hal_storage){ .ops = &ops, .self = storage };
}
