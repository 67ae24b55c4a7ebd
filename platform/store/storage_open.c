/* storage_open.c -- opens the database for writing, and first handles any damage.
 *
 * A damaged database is kept and never repaired in place; storage_rebuild.c makes its replacement.
 * Two files belong to the same ledger if their newest common entry is equal. A file of a foreign
 * ledger is renamed and never read. */
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <sqlite3.h>

#include "core/base/panic.h"
#include "platform/os/file.h"
#include "platform/store/sqlite/ledger_backup.h"
#include "platform/store/storage_internal.h"

void storage_sibling_path(const struct storage *storage, const char *suffix, const char *more,
                          char out[LEDGER_PATH_SIZE])
{
    CORE_ASSERT(suffix && more);
    snprintf(out, LEDGER_PATH_SIZE, "%.520s%.40s%.20s", storage->path, suffix, more);
}

void storage_backup_path(const struct storage *storage, char out[LEDGER_PATH_SIZE])
{
    storage_sibling_path(storage, STORAGE_BACKUP_SUFFIX, "", out);
}

void storage_mirror_path(const struct storage *storage, char out[LEDGER_PATH_SIZE])
{
    storage_sibling_path(storage, STORAGE_MIRROR_SUFFIX, "", out);
}

struct ledger_mirror storage_inspect_mirror(const struct storage *storage)
{
    char path[LEDGER_PATH_SIZE];
    storage_mirror_path(storage, path);
    return ledger_mirror_inspect(path);
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

static bool has_bytes(const char *path)
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
    struct ledger_file backup;
    char path[LEDGER_PATH_SIZE];
    storage_backup_path(storage, path);
    if (!storage_has_path(path) || ledger_file_inspect(&backup, path) != SQLITE_OK) {
        return OTHERS_NOT;
    }
    enum others result = OTHERS_NOT;
    if (ledger_recovery_relation_of_file(&storage->file, last_id, &backup) ==
        LEDGER_RELATION_OTHER) {
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
    const enum ledger_relation kin =
        ledger_recovery_relation_of_mirror(&storage->file, last_id, &tail);
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
    char backup[LEDGER_PATH_SIZE], before[LEDGER_PATH_SIZE], tail[LEDGER_PATH_SIZE];
    storage_mirror_path(storage, tail);
    if (unlink(tail) != 0 && errno != ENOENT) {
        return SQLITE_IOERR;
    }
    storage_backup_path(storage, backup);
    storage_sibling_path(storage, STORAGE_BEFORE_SUFFIX, "", before);
    if (backup_is(storage) != OTHERS_NOT && file_rename_durable(backup, before) != 0) {
        return SQLITE_IOERR;
    }
    return ledger_unmark(&storage->file);
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
    if (!storage->file.refusal && backup == OTHERS_STRANGE &&
        storage_quarantine_other(storage, STORAGE_BACKUP_SUFFIX) != 0) {
        return SQLITE_IOERR;
    }
    if (!storage->file.refusal && tail == OTHERS_STRANGE &&
        storage_quarantine_other(storage, STORAGE_MIRROR_SUFFIX) != 0) {
        return SQLITE_IOERR;
    }
    return SQLITE_OK;
}

static int open_whole(struct storage *storage)
{
    char backup[LEDGER_PATH_SIZE], log[LEDGER_PATH_SIZE];
    storage_backup_path(storage, backup);
    storage_sibling_path(storage, "-wal", "", log);
    struct stat about;
    int code = file_is_other(storage->path) ? SQLITE_NOTADB
               : (stat(storage->path, &about) == 0 && about.st_size == 0 &&
                  (has_bytes(backup) || has_bytes(log) || has_tail(storage)))
                   ? SQLITE_CORRUPT
                   : ledger_file_open(&storage->file, storage->path, &storage->how);
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
    /* If the database path is a symbolic link, the link may lead to a card that is not mounted yet.
     * Therefore the link is neither removed nor followed. */
    struct stat about;
    if (lstat(storage->path, &about) == 0 && S_ISLNK(about.st_mode)) {
        return LEDGER_FILE_LINK;
    }
    /* Renames each FIFO, device, link or folder that has the name of a file of the database, so
     * that the start continues without it. On a read-only card the object stays and is not
     * opened. */
    for (unsigned i = 0; i < STORAGE_SIBLING_COUNT; i++) {
        char path[LEDGER_PATH_SIZE];
        storage_sibling_path(storage, storage_suffixes[i], "", path);
        if (file_is_other(path) && storage_quarantine_other(storage, storage_suffixes[i]) == 0) {
            atomic_store(&storage->strange, i + 1u);
        }
    }
    int code = storage_end_rebuilding(storage);
    if (code != SQLITE_OK) {
        return code;
    }
    char backup[LEDGER_PATH_SIZE];
    storage_backup_path(storage, backup);
    const bool is_missing =
        !storage_has_path(storage->path) && (storage_has_path(backup) || has_tail(storage));
    code = is_missing ? SQLITE_CORRUPT : open_whole(storage);
    if (code == SQLITE_CORRUPT || code == SQLITE_NOTADB) {
        storage->has_to_rebuild = true;
        code = storage_rebuild(storage, is_missing);
        code = code == SQLITE_OK ? ledger_file_open(&storage->file, storage->path, &storage->how)
                                 : code;
    }
    return code;
}
