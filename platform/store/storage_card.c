/* storage_card.c -- detects that the memory card was removed, replaced or full, and reopens the
 * database. The module also detects that the open database is no longer at its path. An absent card
 * is checked once per second because the check is cheap. An unusable file is read completely at
 * each attempt to open it. The interval between attempts therefore grows from one second to one
 * minute, unless an attribute of the file or its card changes. */
#include <errno.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <sqlite3.h>

#include "core/base/hash.h"
#include "core/base/panic.h"
#include "platform/os/file.h"
#include "platform/os/log.h"
#include "platform/store/storage_internal.h"

/* Stores the SQLite code of a write, or of an attempt to open the database. If the code is an
 * error, counts a failed write. */
static void note_result(struct storage *storage, int code)
{
    atomic_store(&storage->error, code);
    if (code != SQLITE_OK) {
        atomic_fetch_add(&storage->refused, 1);
    }
}

void storage_note_write(struct storage *storage, int code)
{
    note_result(storage, code);
    if (storage_needs_reopening(code)) {
        storage_close_file(storage);
    }
}

bool storage_needs_reopening(int code)
{
    return code == SQLITE_IOERR || code == SQLITE_CANTOPEN || code == SQLITE_READONLY ||
           code == SQLITE_CORRUPT || code == SQLITE_NOTADB;
}

/* ---- Moved database ------------------------------------------------------------------------ */

/* Detects that the open database is no longer at its path. The database or its folder may have been
 * removed, renamed, replaced or mounted over, so that the next program start would not find it. The
 * open file can still be written and synced, but its content is lost or hidden. Therefore no entry
 * is acknowledged. Without acknowledgements the coin slot is locked. A folder that is put back is
 * used again. A deleted database stays open, and close() copies it to the path of the backup, where
 * the next program start finds it. */

/* Suffixes of the monitored files. SQLite owns the descriptors of the log and its index. These
 * files are therefore identified by the device and inode that the store first found at their
 * paths. */
static const char *const suffixes[STORAGE_PLACES] = { "", "-wal", "-shm" };

static bool is_same(const struct stat *about, const struct storage_place *place)
{
    return (uint64_t)about->st_dev == place->device && (uint64_t)about->st_ino == place->inode;
}

/* Returns true if the monitored file is absent or was replaced. The first call that finds the file
 * stores its identity. */
static bool has_left(struct storage *storage, size_t index)
{
    struct storage_place *place = &storage->places[index];
    struct stat about;
    const bool is_there = lstat(storage_path(storage, suffixes[index], "").text, &about) == 0;
    if (place->inode == 0 && is_there) {
        *place = (struct storage_place){ (uint64_t)about.st_dev, (uint64_t)about.st_ino };
    }
    return place->inode != 0 && !(is_there && is_same(&about, place));
}

static bool has_folder_left(const struct storage *storage)
{
    struct stat held, named;
    return storage->hold > 0 && fstat(storage->hold - 1, &held) == 0 &&
           (stat(storage->dir, &named) != 0 || held.st_dev != named.st_dev ||
            held.st_ino != named.st_ino);
}

bool storage_has_moved(struct storage *storage)
{
    int moved = 0; /* The type is int because sqlite3_file_control() writes an int. */
    if (storage->how.vfs || !storage->file.db) {
        return false;
    }
    sqlite3_file_control(storage->file.db, "main", SQLITE_FCNTL_HAS_MOVED, &moved);
    bool result = moved != 0 || has_folder_left(storage);
    for (size_t i = 0; i < STORAGE_PLACES; i++) {
        result = has_left(storage, i) || result;
    }
    return result;
}

/* Returns true if the open database was deleted and has no name in any folder. The data of such a
 * file are lost when the file is closed. */
static bool is_deleted(const struct storage *storage)
{
    struct stat held, about;
    const struct storage_place *place = &storage->places[0];
    if (storage->hold > 0 && fstat(storage->hold - 1, &held) == 0 && held.st_nlink == 0) {
        return true;
    }
    /* The database counts as deleted only if its folder is still at its path and does not contain
     * the database any more. If the folder was renamed or mounted over, the database still has a
     * name in the folder and is not deleted. */
    return !has_folder_left(storage) &&
           !(lstat(storage->path, &about) == 0 && is_same(&about, place));
}

/* Logs which file or folder has moved. */
static void log_moved(const struct storage *storage)
{
    struct stat about;
    const bool is_folder = has_folder_left(storage);
    const bool is_log = lstat(storage->path, &about) == 0 && is_same(&about, &storage->places[0]);
    log_print(
        LOG_LEVEL_ERROR, "%s: %s", is_folder ? storage->dir : storage->path,
        is_folder ? "the data folder was removed, renamed or replaced; nothing is stored until"
                    " it is back"
        : is_log  ? "its log (-wal or -shm) was removed or replaced; the database is opened again"
                  : "was removed or replaced; nothing is stored until it is back");
}

/* Logs that the store uses a database again. */
static void log_back(const struct storage *storage)
{
    log_print(LOG_LEVEL_WARNING, "%s: is in use again, with entries up to %u", storage->path,
              storage->file.content.memory.ledger.last_id);
}

/* ---- Retry schedule ------------------------------------------------------------------------ */

/* Returns a hash of the attributes of the file and its memory card: identity, size, change time,
 * access rights, read-only mount. Returns 0 for a custom vfs, whose files are not visible to
 * stat(). */
static uint64_t attributes_hash(const struct storage *storage)
{
    struct stat file = { 0 };
    struct statvfs card = { 0 };
    if (storage->how.vfs) {
        return 0;
    }
    stat(storage->path, &file);
    statvfs(storage->dir, &card);
    const uint64_t words[] = {
        (uint64_t)file.st_dev,
        (uint64_t)file.st_ino,
        (uint64_t)file.st_size,
        (uint64_t)file.st_ctim.tv_sec,
        (uint64_t)file.st_ctim.tv_nsec,
        (uint64_t)card.f_flag,
        (uint64_t)access(storage->path, W_OK),
        (uint64_t)access(storage->dir, W_OK),
    };
    uint64_t hash = HASH_START;
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        hash = hash_u64(hash, words[i]);
    }
    return hash;
}

static uint64_t room_of(const struct storage *storage)
{
    struct statvfs card;
    return !storage->how.vfs && statvfs(storage->dir, &card) == 0
               ? (uint64_t)card.f_bavail * card.f_frsize
               : 0u;
}

/* ---- Identity of the ledger ---------------------------------------------------------------- */

/* Locks the folder first, because two kiosk processes with one ledger would assign the same ids. On
 * a file system without locks, the database is opened without a lock. */
int storage_open_exclusive(struct storage *storage)
{
    if (storage->hold == 0 && !storage->how.vfs) {
        const int handle = file_lock_folder(storage->dir);
        storage->hold = handle >= 0 ? handle + 1 : 0;
        if (handle == -EWOULDBLOCK) {
            return LEDGER_FILE_LOCKED;
        }
    }
    const int code = storage_open_file(storage);
    if (code == SQLITE_OK && !storage->moved) {
        memset(storage->places, 0, sizeof storage->places);
    }
    return code;
}

void storage_unlock(struct storage *storage)
{
    CORE_ASSERT(storage->hold >= 0);
    if (storage->hold > 0) {
        close(storage->hold - 1);
        storage->hold = 0;
    }
}

/* Returns true if the kiosk must restart before it may use the open database.
 *
 * This is the case for a database that appears after a program start without a database, because
 * the core did not start from it. It is also the case for a foreign ledger, for example from
 * another memory card. A database with fewer entries, for example on a new card, is accepted. A
 * database whose newest entries are still in the queue is accepted too, because a write that
 * reported an error may have succeeded. */
static bool is_foreign(struct storage *storage)
{
    CORE_ASSERT(storage->file.db);
    const unsigned pushed = atomic_load(&storage->pushed);
    const uint32_t saved_id = atomic_load(&storage->saved_id);
    const uint32_t last_id = storage->file.content.memory.ledger.last_id;
    const uint32_t newest_id = storage_unwritten(storage) > 0
                                   ? storage->queue[(pushed - 1u) % STORAGE_QUEUE_MAX].id
                                   : saved_id;
    struct ledger_entry entry;
    if (!storage->start.has_read) {
        return true;
    }
    if (last_id == 0 || last_id < saved_id) {
        return false;
    }
    return last_id > newest_id ||
           (saved_id > 0 &&
            (ledger_file_entry(&storage->file, saved_id, &entry) != SQLITE_OK ||
             entry.boot != storage->saved_boot || entry.tick != storage->saved_tick));
}

/* Opens the file at the database's path. Returns SQLITE_OK if the store may write the file,
 * otherwise the reason as an SQLite code or an error code of ledger_file.h. */
static int probe(struct storage *storage)
{
    int code = storage_open_exclusive(storage);
    /* A file that has replaced a moved database is rejected if it lacks acknowledged entries. */
    if (code == SQLITE_OK && storage->moved &&
        storage->file.content.memory.ledger.last_id < atomic_load(&storage->saved_id)) {
        storage_close_file(storage);
        storage_unlock(storage);
        return LEDGER_FILE_MOVED;
    }
    if (code == SQLITE_OK && is_foreign(storage)) {
        storage_apply_offline(storage);
        storage_close_file(storage);
        return LEDGER_FILE_FOREIGN;
    }
    if (code == SQLITE_OK) {
        atomic_store(&storage->has_file, true);
        atomic_store(&storage->is_unproven, storage->file.is_suspect);
        if (storage->moved) {
            log_back(storage);
        }
        memset(storage->places, 0, sizeof storage->places);
        storage->moved = false;
        code = storage->file.refusal;
    }
    if (storage->file.refusal == SQLITE_FULL) {
        /* Closes the database, so that other programs can read it. SQLite reads an open database
         * only with the index of its write-ahead log, for which a full memory card has no space. */
        storage_close_file(storage);
    }
    return code;
}

/* Returns true if the store may open the file that is now at the database's path, in place of the
 * open file that moved. The first call after a loss returns false and reports the loss, so that the
 * status shows each loss even if the next call opens the database again. During close() the first
 * call may also return true, because there is no later call. */
static bool may_reopen_moved(struct storage *storage)
{
    const bool is_first = !storage->moved;
    if (is_first) {
        log_moved(storage);
    }
    storage->moved = true;
    if ((is_first && !storage->closes) || !storage_has_path(storage->path) ||
        (storage->file.db && is_deleted(storage))) {
        note_result(storage, LEDGER_FILE_MOVED);
        return false;
    }
    if (storage->file.db) {
        storage_close_file(storage);
        storage_unlock(storage);
    }
    return true;
}

bool storage_has_card(struct storage *storage)
{
    CORE_ASSERT(storage->hold >= 0);
    if (storage->file.db && !storage->file.refusal && !storage_has_moved(storage)) {
        if (storage->moved) { /* The database file is back at its path. */
            storage->moved = false;
            note_result(storage, SQLITE_OK);
            log_back(storage);
        }
        return true;
    }
    const bool has_left = storage->moved || (storage->file.db && storage_has_moved(storage));
    if (has_left && !may_reopen_moved(storage)) {
        return false;
    }
    /* The next attempt waits for the end of the interval. The attempt is made earlier if the last
     * write failed because the memory card was full and the card has more free space now. */
    if (!storage->path[0] || !(storage_now_ms() >= storage->retry_due_ms ||
                               atomic_load(&storage->late.state) == OFFLINE_CREDITS_NEW ||
                               attributes_hash(storage) != storage->sight ||
                               (atomic_load(&storage->error) == SQLITE_FULL &&
                                room_of(storage) >= storage->room + STORAGE_ROOM_MORE))) {
        return false;
    }
    storage_close_file(storage);
    const int code = probe(storage);
    const uint64_t sight = attributes_hash(storage);
    const int64_t longer_ms = 2 * storage->retry_wait_ms;
    /* The following codes mean that the whole file was read. Only these codes increase the interval
     * to the next attempt, because attempts with other results are cheap. */
    if (!(code == LEDGER_FILE_FOREIGN || code == LEDGER_FILE_NEWER || code == LEDGER_FILE_MOVED ||
          code == SQLITE_READONLY || code == SQLITE_FULL || code == SQLITE_CORRUPT ||
          code == SQLITE_NOTADB)) {
        storage->retry_wait_ms = 0;
    } else if (storage->retry_wait_ms == 0 || sight != storage->sight) {
        storage->retry_wait_ms = STORAGE_RETRY_MS;
    } else {
        storage->retry_wait_ms =
            longer_ms < STORAGE_RETRY_MS_MAX ? longer_ms : STORAGE_RETRY_MS_MAX;
    }
    storage->sight = sight;
    storage->room = room_of(storage);
    storage->retry_due_ms =
        storage->retry_wait_ms > 0 ? storage_now_ms() + storage->retry_wait_ms : 0;
    if (code != SQLITE_OK || storage_unwritten(storage) == 0) {
        /* The result is stored only if no entries wait in the queue. Otherwise the caller writes
         * these entries next, and the result of that write is stored. */
        note_result(storage, code);
    }
    return code == SQLITE_OK;
}

/* ---- Deleted database ---------------------------------------------------------------------- */

void storage_save_deleted(struct storage *storage)
{
    CORE_ASSERT(storage_unwritten(storage) <= STORAGE_QUEUE_MAX);
    static const char *const names[] = { "", STORAGE_NEW_SUFFIX, STORAGE_BACKUP_SUFFIX,
                                         STORAGE_MIRROR_SUFFIX };
    /* If only the database was deleted, the backup and the mirror in the folder belong to the
     * database. The new backup replaces the older backup. */
    const bool is_in_own_folder = storage->hold > 0 && !has_folder_left(storage);
    const size_t name_count = is_in_own_folder ? 2u : sizeof names / sizeof names[0];
    const struct storage_path backup = storage_path(storage, STORAGE_BACKUP_SUFFIX, "");
    if (!storage->moved || !storage->file.db || !is_deleted(storage) ||
        file_make_folder(storage->dir) != 0) {
        return;
    }
    for (size_t i = 0; i < name_count; i++) {
        if (storage_has_path(storage_path(storage, names[i], "").text)) {
            return;
        }
    }
    /* Writes all queued entries, in at most two parts because the queue is a ring buffer. */
    const unsigned pushed = atomic_load(&storage->pushed);
    unsigned at = atomic_load(&storage->written);
    int code = SQLITE_OK;
    while (code == SQLITE_OK && at != pushed) {
        const unsigned first = at % STORAGE_QUEUE_MAX;
        const unsigned beside = STORAGE_QUEUE_MAX - first;
        const unsigned count = pushed - at < beside ? pushed - at : beside;
        code = ledger_file_write(&storage->file, &storage->queue[first], count);
        at += count;
    }
    if (code == SQLITE_OK && ledger_backup_make(&storage->file, backup.text, false) == SQLITE_OK) {
        atomic_store(&storage->written, atomic_load(&storage->pushed));
        log_print(LOG_LEVEL_WARNING,
                  "%s: was deleted while it was open; all entries are saved in %s", storage->path,
                  backup.text);
    } else {
        log_print(LOG_LEVEL_ERROR, "%s: was deleted while it was open, and %s could not be written",
                  storage->path, backup.text);
    }
}
