/* storage_moved.c -- detects that the open database is no longer at its path.
 *
 * The database or its folder may have been removed, renamed, replaced or mounted over, so that the
 * next program start would not find it. The open file can still be written and synced, but its
 * content is lost or hidden. Therefore no entry is acknowledged, which locks the coin slot. A
 * folder that is put back is used again. A deleted database stays open, and close() copies it to
 * the path of the backup, where the next start finds it. */
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <sqlite3.h>

#include "platform/os/file.h"
#include "platform/os/log.h"
#include "platform/store/storage_internal.h"

/* Suffixes of the monitored files. SQLite owns the descriptors of the log and its index. These
 * files are therefore identified by the inode that was seen first. */
static const char *const suffixes[STORAGE_PLACES] = { "", "-wal", "-shm" };

static bool storage_moved_is_same(const struct stat *about, const struct storage_place *place)
{
    return (uint64_t)about->st_dev == place->device && (uint64_t)about->st_ino == place->inode;
}

void storage_note_place(struct storage *storage)
{
    memset(storage->places, 0, sizeof storage->places);
    storage->moved = false;
}

/* Returns true if the file is absent or was replaced. The identity of a new file is stored when the
 * file is first seen. */
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
    /* A database in a folder that was renamed or mounted over still has its name. */
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

/* Writes all queued entries, in at most two parts because the queue is a ring buffer. Returns an
 * SQLite code. */
static int write_queue(struct storage *storage)
{
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
    return code;
}

bool storage_save_deleted(struct storage *storage)
{
    char backup[LEDGER_PATH_SIZE];
    if (!storage->moved || !storage->file.db || !is_deleted(storage) ||
        file_make_folder(storage->dir) != 0 || has_any(storage)) {
        return false;
    }
    storage_backup_path(storage, backup);
    const bool is_saved = write_queue(storage) == SQLITE_OK &&
                          ledger_backup_make(&storage->file, backup, false) == SQLITE_OK;
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
