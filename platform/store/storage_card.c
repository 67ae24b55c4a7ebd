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

void storage_note_result(struct storage *storage, int code)
{
    atomic_store(&storage->error, code);
    if (code != SQLITE_OK) {
        atomic_fetch_add(&storage->refused, 1);
    }
}

void storage_note_write(struct storage *storage, int code)
{
    storage_note_result(storage, code);
    if (storage_needs_reopening(code)) {
        storage_close_file(storage);
    }
}

bool storage_needs_reopening(int code)
{
    return code == SQLITE_IOERR || code == SQLITE_CANTOPEN || code == SQLITE_READONLY ||
           code == SQLITE_CORRUPT || code == SQLITE_NOTADB;
}

/* ---- Retry schedule ------------------------------------------------------------------------ */

/* Returns a hash of the attributes of the file and its card: identity, size, change time, access
 * rights, read-only mount. Returns 0 for a custom vfs, whose files are not visible to stat(). */
static uint64_t sight_of(const struct storage *storage)
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

/* Locks the folder, because two kiosk processes with one ledger would assign the same ids. Returns
 * false only if another process holds the lock. On a file system without locks, returns true. */
static bool is_alone(struct storage *storage)
{
    if (storage->hold == 0 && !storage->how.vfs) {
        const int handle = file_lock_folder(storage->dir);
        storage->hold = handle >= 0 ? handle + 1 : 0;
        return handle != -EWOULDBLOCK;
    }
    return true;
}

int storage_open_exclusive(struct storage *storage)
{
    const int code = is_alone(storage) ? storage_open_file(storage) : LEDGER_FILE_LOCKED;
    if (code == SQLITE_OK && !storage->moved) {
        storage_note_place(storage);
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

static int storage_card_probe(struct storage *storage)
{
    int code = storage_open_exclusive(storage);
    /* A file that has replaced a moved database may lack entries that were acknowledged. */
    if (code == SQLITE_OK && storage->moved &&
        storage->file.content.memory.ledger.last_id < atomic_load(&storage->saved_id)) {
        storage_close_file(storage);
        storage_unlock(storage);
        return LEDGER_FILE_MOVED;
    }
    /* Returns true if the open file contains a foreign ledger, which comes from another card, or
     * from a card that was absent at program start. A new card or a backup has fewer entries and is
     * accepted. The file may also contain queued entries, because a write that reported an error
     * may have succeeded. */
    const unsigned pushed = atomic_load(&storage->pushed);
    const uint32_t saved_id = atomic_load(&storage->saved_id);
    const uint32_t last_id = storage->file.content.memory.ledger.last_id;
    const uint32_t newest_id = storage_unwritten(storage) > 0
                                   ? storage->queue[(pushed - 1u) % STORAGE_QUEUE_MAX].id
                                   : saved_id;
    struct ledger_entry entry;
    if (code == SQLITE_OK &&
        (last_id < saved_id || last_id == 0
             ? false
             : last_id > newest_id ||
                   (saved_id > 0 &&
                    (ledger_file_entry(&storage->file, saved_id, &entry) != SQLITE_OK ||
                     entry.boot != storage->saved_boot || entry.tick != storage->saved_tick)))) {
        storage_apply_offline(storage);
        storage_close_file(storage);
        return LEDGER_FILE_FOREIGN;
    }
    if (code == SQLITE_OK) {
        atomic_store(&storage->has_file, true);
        atomic_store(&storage->is_unproven, storage->file.is_suspect);
        if (storage->moved) {
            storage_restore_log(storage);
        }
        storage_note_place(storage);
        code = storage->file.refusal;
    }
    storage_share_file(storage);
    return code;
}

/* Returns true if the store may open the file that is now at the database's path, in place of the
 * open file that moved. The first call only reports the loss. The status therefore shows each loss,
 * even if the next call repairs the loss. During close() the first call may also return true,
 * because there is no later call. */
static bool leave_moved(struct storage *storage)
{
    const bool is_first = !storage->moved;
    if (is_first) {
        storage_mark_log_removed(storage);
    }
    storage->moved = true;
    if ((is_first && !storage->closes) || !storage_may_follow(storage)) {
        storage_note_result(storage, LEDGER_FILE_MOVED);
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
            storage_note_result(storage, SQLITE_OK);
            storage_restore_log(storage);
        }
        return true;
    }
    const bool has_left = storage->moved || (storage->file.db && storage_has_moved(storage));
    if (has_left && !leave_moved(storage)) {
        return false;
    }
    /* The file is opened before the end of the interval if the last write failed because the card
     * was full and the card has more free space now. */
    if (!storage->path[0] || !(storage_now_ms() >= storage->look_due_ms ||
                               atomic_load(&storage->late.state) == OFFLINE_CREDITS_NEW ||
                               sight_of(storage) != storage->sight ||
                               (atomic_load(&storage->error) == SQLITE_FULL &&
                                room_of(storage) >= storage->room + STORAGE_ROOM_MORE))) {
        return false;
    }
    storage_close_file(storage);
    const int code = storage_card_probe(storage);
    const uint64_t sight = sight_of(storage);
    const int64_t longer_ms = 2 * storage->look_wait_ms;
    /* The interval grows only if the store has read the whole file to get the result `code`. */
    if (!(code == LEDGER_FILE_FOREIGN || code == LEDGER_FILE_NEWER || code == LEDGER_FILE_MOVED ||
          code == SQLITE_READONLY || code == SQLITE_FULL || code == SQLITE_CORRUPT ||
          code == SQLITE_NOTADB)) {
        storage->look_wait_ms = 0;
    } else if (storage->look_wait_ms == 0 || sight != storage->sight) {
        storage->look_wait_ms = STORAGE_RETRY_MS;
    } else {
        storage->look_wait_ms = longer_ms < STORAGE_RETRY_MS_MAX ? longer_ms : STORAGE_RETRY_MS_MAX;
    }
    storage->sight = sight;
    storage->room = room_of(storage);
    storage->look_due_ms = storage->look_wait_ms > 0 ? storage_now_ms() + storage->look_wait_ms : 0;
    if (code != SQLITE_OK || storage_unwritten(storage) == 0) {
        storage_note_result(storage, code); /* If entries wait in the queue, the result of their
                                               write sets the store's status. */
    }
    return code == SQLITE_OK;
}

/* ---- Moved database ------------------------------------------------------------------------ */

/* Detects that the open database is no longer at its path. The database or its folder may have been
 * removed, renamed, replaced or mounted over, so that the next program start would not find it. The
 * open file can still be written and synced, but its content is lost or hidden. Therefore no entry
 * is acknowledged. Without acknowledgements the coin slot is locked. A folder that is put back is
 * used again. A deleted database stays open, and close() copies it to the path of the backup, where
 * the next program start finds it. */

/* Suffixes of the monitored files. SQLite owns the descriptors of the log and its index. These
 * files are therefore identified by the inode that was seen first. */
static const char *const suffixes[STORAGE_PLACES] = { "", "-wal", "-shm" };

static bool storage_moved_is_same(const struct stat *about, const struct storage_place *place)
{
    return (uint64_t)about->st_dev == place->device && (uint64_t)about->st_ino == place->inode;
}

void storage_note_place(struct storage *storage)
{
    CORE_ASSERT(storage->path[0]);
    memset(storage->places, 0, sizeof storage->places);
    storage->moved = false;
}

/* Returns true if the monitored file is absent or was replaced. The identity of a new file is
 * stored when the store first sees the file. */
static bool has_left(struct storage *storage, size_t index)
{
    struct storage_place *place = &storage->places[index];
    struct stat about;
    char path[LEDGER_PATH_SIZE];
    storage_sibling_path(storage, suffixes[index], "", path);
    const bool is_there = lstat(path, &about) == 0;
    if (place->inode == 0 && is_there) {
        *place = (struct storage_place){ (uint64_t)about.st_dev, (uint64_t)about.st_ino };
    }
    return place->inode != 0 && !(is_there && storage_moved_is_same(&about, place));
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
    int has_moved = 0;
    if (storage->how.vfs || !storage->file.db) {
        return false;
    }
    sqlite3_file_control(storage->file.db, "main", SQLITE_FCNTL_HAS_MOVED, &has_moved);
    bool result = has_moved != 0 || has_folder_left(storage);
    for (size_t i = 0; i < STORAGE_PLACES; i++) {
        result = has_left(storage, i) || result;
    }
    return result;
}

/* Checks for a moved database before the entries are acknowledged. If the database moved during the
 * write, no program start would find the entries. */
int storage_write_entries(struct storage *storage, const struct ledger_entry *entries,
                          uint32_t count)
{
    CORE_ASSERT(entries && count > 0);
    CORE_ASSERT(storage->file.db);
    const int code = ledger_file_write(&storage->file, entries, count);
    return code == SQLITE_OK && storage_has_moved(storage) ? LEDGER_FILE_MOVED : code;
}

/* ---- Recovery ------------------------------------------------------------------------------ */

/* Returns true if the open database was deleted and has no name in any folder. Closing a database
 * without a name deletes its data. */
static bool is_deleted(const struct storage *storage)
{
    struct stat held, about;
    const struct storage_place *place = &storage->places[0];
    if (storage->hold > 0 && fstat(storage->hold - 1, &held) == 0 && held.st_nlink == 0) {
        return true;
    }
    /* If only the folder was renamed or mounted over, the database still has a name in its
     * folder. */
    return !has_folder_left(storage) &&
           !(lstat(storage->path, &about) == 0 && storage_moved_is_same(&about, place));
}

bool storage_may_follow(struct storage *storage)
{
    return storage_has_path(storage->path) && (!storage->file.db || !is_deleted(storage));
}

static bool has_any(const struct storage *storage)
{
    static const char *const names[] = { "", STORAGE_BACKUP_SUFFIX, STORAGE_MIRROR_SUFFIX,
                                         STORAGE_NEW_SUFFIX };
    bool has = false;
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        char path[LEDGER_PATH_SIZE];
        storage_sibling_path(storage, names[i], "", path);
        has = has || storage_has_path(path);
    }
    return has;
}

void storage_mark_log_removed(const struct storage *storage)
{
    struct stat about;
    if (has_folder_left(storage)) {
        log_print(LOG_LEVEL_ERROR,
                  "%s: the data folder was removed, renamed or replaced; nothing is stored"
                  " until it is back",
                  storage->dir);
    } else if (lstat(storage->path, &about) == 0 &&
               storage_moved_is_same(&about, &storage->places[0])) {
        log_print(LOG_LEVEL_ERROR,
                  "%s: its log (-wal or -shm) was removed or replaced; the database is"
                  " opened again",
                  storage->path);
    } else {
        log_print(LOG_LEVEL_ERROR,
                  "%s: was removed or replaced; nothing is stored until it is back", storage->path);
    }
}

void storage_restore_log(const struct storage *storage)
{
    log_print(LOG_LEVEL_WARNING, "%s: is in use again, with entries up to %u", storage->path,
              storage->file.content.memory.ledger.last_id);
}

bool storage_save_deleted(struct storage *storage)
{
    CORE_ASSERT(storage_unwritten(storage) <= STORAGE_QUEUE_MAX);
    char backup[LEDGER_PATH_SIZE];
    if (!storage->moved || !storage->file.db || !is_deleted(storage) ||
        file_make_folder(storage->dir) != 0 || has_any(storage)) {
        return false;
    }
    storage_backup_path(storage, backup);
    /* Write all queued entries, in at most two parts because the queue is a ring buffer. */
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
    const bool is_saved =
        code == SQLITE_OK && ledger_backup_make(&storage->file, backup, false) == SQLITE_OK;
    if (is_saved) {
        atomic_store(&storage->written, atomic_load(&storage->pushed));
        log_print(LOG_LEVEL_WARNING,
                  "%s: was deleted while it was open; all entries are saved in %s", storage->path,
                  backup);
    } else {
        log_print(LOG_LEVEL_ERROR, "%s: was deleted while it was open, and %s could not be written",
                  storage->path, backup);
    }
    return is_saved;
}
