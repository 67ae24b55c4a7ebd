/* storage_open.c -- opens the database for writing, and first handles any damage.
 *
 * A damaged database is kept and never repaired in place; storage_rebuild.c makes its replacement.
 * Two files belong to the same ledger if their newest common entry is equal. A file of a foreign
 * ledger is renamed and never read. */
#include <errno.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#include <sqlite3.h>

#include "core/base/panic.h"
#include "platform/os/file.h"
#include "platform/store/sqlite/ledger_backup.h"
#include "platform/store/storage_internal.h"

struct storage_path storage_path(const struct storage *storage, const char *suffix,
                                 const char *more)
{
    CORE_ASSERT(suffix && more);
    struct storage_path path;
    snprintf(path.text, sizeof path.text, "%.520s%.40s%.20s", storage->path, suffix, more);
    return path;
}

struct ledger_mirror storage_inspect_mirror(const struct storage *storage)
{
    return ledger_mirror_inspect(storage_path(storage, STORAGE_MIRROR_SUFFIX, "").text);
}

/* Returns true if the path exists. After an I/O error also returns true, so that no file is
 * replaced by mistake. */
bool storage_has_path(const char *path)
{
    return access(path, F_OK) == 0 || (errno != ENOENT && errno != ENOTDIR);
}

const char *const storage_suffixes[STORAGE_SIBLING_COUNT] = {
    "-wal", "-shm", "-journal", STORAGE_BACKUP_SUFFIX, STORAGE_MIRROR_SUFFIX,
};

bool storage_has_bytes(const char *path)
{
    struct stat about;
    return stat(path, &about) == 0 && about.st_size > 0;
}

static bool has_tail(const struct storage *storage)
{
    struct ledger_mirror tail = storage_inspect_mirror(storage);
    const uint32_t last_id = ledger_mirror_last_id(&tail);
    ledger_mirror_close(&tail);
    return last_id > 0;
}

/* ---- Comparison with the backup and the mirror --------------------------------------------- */

enum others {
    OTHERS_NOT = 0, /* The backup or mirror is absent, or has no newer entries than the database. */
    OTHERS_NEWER,   /* The backup or mirror belongs to the same ledger and has newer entries, so
                       that the database has lost entries. */
    OTHERS_STRANGE, /* The backup or mirror belongs to a foreign ledger. */
};

static enum others backup_is(struct storage *storage)
{
    const uint32_t last_id = storage->file.content.memory.ledger.last_id;
    const struct storage_path path = storage_path(storage, STORAGE_BACKUP_SUFFIX, "");
    struct ledger_file backup;
    if (!storage_has_path(path.text) || ledger_file_inspect(&backup, path.text) != SQLITE_OK) {
        return OTHERS_NOT;
    }
    enum others result = OTHERS_NOT;
    if (ledger_recovery_relation(&storage->file, last_id, NULL, &backup) == LEDGER_RELATION_OTHER) {
        result = OTHERS_STRANGE;
    } else if (last_id < backup.content.memory.ledger.last_id &&
               ledger_check(backup.db) == SQLITE_OK) {
        result = OTHERS_NEWER;
    }
    ledger_file_close(&backup);
    return result;
}

/* Compares the ledger mirror with the database. If the mirror has only entries that are newer than
 * the newest entry of an intact database, the mirror belongs to a foreign ledger. */
static enum others tail_is(struct storage *storage)
{
    const uint32_t last_id = storage->file.content.memory.ledger.last_id;
    struct ledger_mirror tail = storage_inspect_mirror(storage);
    const uint32_t tails_last_id = ledger_mirror_last_id(&tail);
    const enum ledger_relation kin = ledger_recovery_relation(&storage->file, last_id, &tail, NULL);
    ledger_mirror_close(&tail);
    if (kin == LEDGER_RELATION_OTHER ||
        (kin == LEDGER_RELATION_UNKNOWN && last_id > 0 && tails_last_id > last_id)) {
        return OTHERS_STRANGE;
    }
    return tails_last_id > last_id ? OTHERS_NEWER : OTHERS_NOT;
}

bool storage_is_behind_backup(struct storage *storage)
{
    return backup_is(storage) == OTHERS_NEWER;
}

/* ---- Lost content -------------------------------------------------------------------------- */

/* Accepts a copy that the operator restored in place of the database. The backup may have newer
 * entries, which the operator intends to drop. The backup is renamed and kept. The mirror belongs
 * to the replaced database and is deleted. Returns an SQLite code. */
static int take_copy(struct storage *storage)
{
    if (unlink(storage_path(storage, STORAGE_MIRROR_SUFFIX, "").text) != 0 && errno != ENOENT) {
        return SQLITE_IOERR;
    }
    if (backup_is(storage) != OTHERS_NOT &&
        file_rename_durable(storage_path(storage, STORAGE_BACKUP_SUFFIX, "").text,
                            storage_path(storage, STORAGE_BEFORE_SUFFIX, "").text) != 0) {
        return SQLITE_IOERR;
    }
    return ledger_mark(storage->file.db, false);
}

/* Compares the database with its backup and mirror, and renames a backup or mirror of a foreign
 * ledger. If the database is read-only, nothing is renamed, because no new backup or mirror is
 * written. Returns SQLITE_CORRUPT if the database has lost entries. */
static int compare_database_copies(struct storage *storage)
{
    const enum others backup = backup_is(storage), tail = tail_is(storage);
    if (backup == OTHERS_NEWER || tail == OTHERS_NEWER) {
        return SQLITE_CORRUPT;
    }
    const bool is_done =
        storage->file.refusal ||
        ((backup != OTHERS_STRANGE ||
          storage_quarantine_other(storage, STORAGE_BACKUP_SUFFIX) == 0) &&
         (tail != OTHERS_STRANGE || storage_quarantine_other(storage, STORAGE_MIRROR_SUFFIX) == 0));
    return is_done ? SQLITE_OK : SQLITE_IOERR;
}

static int open_whole(struct storage *storage)
{
    struct stat about;
    int code = SQLITE_OK;
    if (file_is_other(storage->path)) {
        code = SQLITE_NOTADB;
    } else if (stat(storage->path, &about) == 0 && about.st_size == 0 &&
               (storage_has_bytes(storage_path(storage, STORAGE_BACKUP_SUFFIX, "").text) ||
                storage_has_bytes(storage_path(storage, "-wal", "").text) || has_tail(storage))) {
        code = SQLITE_CORRUPT;
    } else {
        code = ledger_file_open(&storage->file, storage->path, &storage->how);
    }
    if (code != SQLITE_OK) {
        return code;
    }
    if (ledger_is_marked(&storage->file) && !storage->file.refusal) {
        code = take_copy(storage);
    }
    code = code == SQLITE_OK ? compare_database_copies(storage) : code;
    if (code != SQLITE_OK) {
        ledger_file_close(&storage->file);
    }
    return code;
}

/* ---- Opening ------------------------------------------------------------------------------- */

/* Opens the database. Creates a new database only if there is no database, backup or mirror. A
 * database on a custom vfs has no backup and no mirror. */
int storage_open_file(struct storage *storage)
{
    CORE_ASSERT(storage->path[0]);
    if (storage->how.vfs) {
        return ledger_file_open(&storage->file, storage->path, &storage->how);
    }
    storage->has_to_rebuild = false;
    /* The database path is a symbolic link. The link may lead to a memory card that is not mounted
     * yet, so it is neither removed nor followed. */
    struct stat about;
    if (lstat(storage->path, &about) == 0 && S_ISLNK(about.st_mode)) {
        return LEDGER_FILE_LINK;
    }
    /* Renames each FIFO, device, link or folder that has the name of a file of the database, so
     * that the start continues without it. On a read-only memory card the object stays and is not
     * opened. */
    for (unsigned i = 0; i < STORAGE_SIBLING_COUNT; i++) {
        if (file_is_other(storage_path(storage, storage_suffixes[i], "").text) &&
            storage_quarantine_other(storage, storage_suffixes[i]) == 0) {
            atomic_store(&storage->strange, i + 1u);
        }
    }
    int code = storage_end_rebuilding(storage);
    if (code != SQLITE_OK) {
        return code;
    }
    const bool is_missing =
        !storage_has_path(storage->path) &&
        (storage_has_path(storage_path(storage, STORAGE_BACKUP_SUFFIX, "").text) ||
         has_tail(storage));
    code = is_missing ? SQLITE_CORRUPT : open_whole(storage);
    if (code == SQLITE_CORRUPT || code == SQLITE_NOTADB) {
        storage->has_to_rebuild = true;
        code = storage_rebuild(storage, is_missing);
        code = code == SQLITE_OK ? ledger_file_open(&storage->file, storage->path, &storage->how)
                                 : code;
    }
    return code;
}
