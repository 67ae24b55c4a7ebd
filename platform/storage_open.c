/* storage_open.c -- from a path to a file that can be written, whatever has happened to it.
 *
 * A damaged file is never lost sight of and never repaired in place. What takes its place, the last
 * good backup and all that the damaged one still says beyond that, is made under a name of its own.
 * Only when that is whole and on disk is the damaged one renamed, and then the new one. A power cut
 * anywhere leaves files from which the next start does the same again, or the rest of it. */
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <sqlite3.h>

#include "platform/storage_parts.h"
#include "platform/store/ledger_backup.h"

#define ASIDE_MAX 1000u /* Damaged files that may lie beside the good one. */

static const char *const suffixes[] = { "-wal", "-journal", "-shm" };
#define SUFFIX_COUNT (sizeof suffixes / sizeof suffixes[0])

static void beside(const struct storage *storage, const char *suffix, const char *more,
                   char out[LEDGER_PATH_SIZE])
{
    snprintf(out, LEDGER_PATH_SIZE, "%.520s%.40s%.20s", storage->path, suffix, more);
}

/* A card that cannot say is no reason to put something in a file's place. */
static bool is_there(const char *path)
{
    return access(path, F_OK) == 0 || (errno != ENOENT && errno != ENOTDIR);
}

static bool has_bytes(const char *path)
{
    struct stat about;
    return stat(path, &about) == 0 && about.st_size > 0;
}

void storage_backup_path(const struct storage *storage, char out[LEDGER_PATH_SIZE])
{
    beside(storage, STORAGE_BACKUP_SUFFIX, "", out);
}

void storage_tail_path(const struct storage *storage, char out[LEDGER_PATH_SIZE])
{
    beside(storage, STORAGE_TAIL_SUFFIX, "", out);
}

static struct ledger_tail look_at_tail(const struct storage *storage)
{
    char path[LEDGER_PATH_SIZE];
    storage_tail_path(storage, path);
    return ledger_tail_look(path);
}

static uint32_t tails_last_id(const struct storage *storage)
{
    struct ledger_tail tail = look_at_tail(storage);
    const uint32_t last_id = ledger_tail_last_id(&tail);
    ledger_tail_close(&tail);
    return last_id;
}

/* The first free number; 0 when all are taken. One that was looked at and removed has left a mark,
 * which would hide the next of that number. */
static unsigned free_number(const struct storage *storage)
{
    char path[LEDGER_PATH_SIZE], seen[LEDGER_PATH_SIZE], suffix[40];
    for (unsigned number = 1; number <= ASIDE_MAX; number++) {
        snprintf(suffix, sizeof suffix, STORAGE_ASIDE_SUFFIX "%u", number);
        beside(storage, suffix, "", path);
        beside(storage, suffix, STORAGE_SEEN_SUFFIX, seen);
        if (!is_there(path) && !is_there(seen)) {
            return number;
        }
    }
    return 0;
}

/* Renames the file, and then what belongs to it: left behind, a journal would be played into the
 * fresh one. */
static bool set_aside(struct storage *storage, unsigned number)
{
    char from[LEDGER_PATH_SIZE], to[LEDGER_PATH_SIZE], suffix[40];
    snprintf(suffix, sizeof suffix, STORAGE_ASIDE_SUFFIX "%u", number);
    beside(storage, suffix, "", to);
    if (is_there(storage->path) && rename(storage->path, to) != 0) {
        return false;
    }
    for (size_t i = 0; i < SUFFIX_COUNT; i++) {
        beside(storage, suffixes[i], "", from);
        beside(storage, suffix, suffixes[i], to);
        rename(from, to);
    }
    return true;
}

/* ---- What takes a file's place -------------------------------------------------------------- */

static void remove_new(const struct storage *storage)
{
    char path[LEDGER_PATH_SIZE];
    beside(storage, STORAGE_NEW_SUFFIX, "", path);
    unlink(path);
    for (size_t i = 0; i < SUFFIX_COUNT; i++) {
        beside(storage, STORAGE_NEW_SUFFIX, suffixes[i], path);
        unlink(path);
    }
}

/* One of an earlier version, too: it is brought up to date as it is opened. */
static void begin_with_backup(const char *backup, const char *fresh)
{
    struct ledger_file file = { .refusal = SQLITE_READONLY };
    if (is_there(backup) &&
        sqlite3_open_v2(backup, &file.db, SQLITE_OPEN_READONLY, NULL) == SQLITE_OK &&
        ledger_check(file.db) == SQLITE_OK) {
        ledger_backup_make(&file, fresh, false);
    }
    ledger_file_close(&file);
}

/* Makes the new file: what the backup has, or an empty one; then what the old one and the tail
 * still say. */
static int make_new(struct storage *storage)
{
    struct ledger_file file;
    char backup[LEDGER_PATH_SIZE], fresh[LEDGER_PATH_SIZE];
    storage_backup_path(storage, backup);
    beside(storage, STORAGE_NEW_SUFFIX, "", fresh);
    remove_new(storage);
    begin_with_backup(backup, fresh);
    const int code = ledger_file_open(&file, fresh, NULL);
    if (code == SQLITE_OK) {
        storage->from_backup = file.content.memory.ledger.last_id;
        struct ledger_tail tail = look_at_tail(storage);
        storage->salvaged =
            ledger_salvage(has_bytes(storage->path) ? storage->path : NULL, &tail, &file);
        ledger_tail_close(&tail);
        ledger_file_close(&file);
    }
    return code;
}

/* The last step, and all that is left to do where the power went before it. */
static bool put_new(struct storage *storage)
{
    char fresh[LEDGER_PATH_SIZE];
    beside(storage, STORAGE_NEW_SUFFIX, "", fresh);
    return rename(fresh, storage->path) == 0 && ledger_sync_folder(storage->path) == 0;
}

static bool replace(struct storage *storage)
{
    const unsigned number = free_number(storage);
    if (number == 0 || make_new(storage) != SQLITE_OK) {
        return false;
    }
    if (!set_aside(storage, number) || ledger_sync_folder(storage->path) != 0 ||
        !put_new(storage)) {
        return false;
    }
    atomic_store(&storage->aside, number);
    return true;
}

/* Where there is no file: perhaps one is half replaced, or it was lost and there is a backup. */
static void look_for_new(struct storage *storage)
{
    char backup[LEDGER_PATH_SIZE], fresh[LEDGER_PATH_SIZE];
    storage_backup_path(storage, backup);
    beside(storage, STORAGE_NEW_SUFFIX, "", fresh);
    if (is_there(storage->path)) {
        remove_new(storage);
        return;
    }
    const bool has_source = is_there(backup) || tails_last_id(storage) > 0;
    if (!is_there(fresh) && (!has_source || make_new(storage) != SQLITE_OK)) {
        return;
    }
    const unsigned number = free_number(storage);
    if (number > 0 && set_aside(storage, number)) {
        put_new(storage);
    }
}

/* ---- A file that has lost what it had -------------------------------------------------------- */

/* A file without a byte is what a power cut or a repaired card often leaves. SQLite takes it for a
 * new one, and forgets its log; but where there are a log, a backup or a tail there was
 * something. */
static bool is_emptied(const struct storage *storage)
{
    char backup[LEDGER_PATH_SIZE], log[LEDGER_PATH_SIZE];
    storage_backup_path(storage, backup);
    beside(storage, suffixes[0], "", log);
    struct stat about;
    return stat(storage->path, &about) == 0 && about.st_size == 0 &&
           (has_bytes(backup) || has_bytes(log) || tails_last_id(storage) > 0);
}

bool storage_is_behind_backup(struct storage *storage)
{
    const uint32_t last_id = storage->file.content.memory.ledger.last_id;
    struct ledger_file backup;
    char path[LEDGER_PATH_SIZE];
    storage_backup_path(storage, path);
    if (!is_there(path) || ledger_file_look(&backup, path) != SQLITE_OK) {
        return false;
    }
    const bool is_behind = last_id < backup.content.memory.ledger.last_id &&
                           ledger_check(backup.db) == SQLITE_OK;
    ledger_file_close(&backup);
    return is_behind;
}

/* The operator put a copy there: that the backup has more is as he wants it. It is kept beside. The
 * tail is of what was there before. */
static int take_copy(struct storage *storage)
{
    char backup[LEDGER_PATH_SIZE], before[LEDGER_PATH_SIZE], tail[LEDGER_PATH_SIZE];
    storage_tail_path(storage, tail);
    if (unlink(tail) != 0 && errno != ENOENT) {
        return SQLITE_IOERR;
    }
    storage_backup_path(storage, backup);
    beside(storage, STORAGE_BEFORE_SUFFIX, "", before);
    if (storage_is_behind_backup(storage) &&
        (rename(backup, before) != 0 || ledger_sync_folder(before) != 0)) {
        return SQLITE_IOERR;
    }
    return ledger_unmark(&storage->file);
}

/* A folder, or what else is no file but has its name, is no database either. */
static bool is_no_file(const struct storage *storage)
{
    struct stat about;
    return stat(storage->path, &about) == 0 && !S_ISREG(about.st_mode);
}

static int open_whole(struct storage *storage)
{
    int code = is_no_file(storage)   ? SQLITE_NOTADB
               : is_emptied(storage) ? SQLITE_CORRUPT
                                     : ledger_file_open(&storage->file, storage->path,
                                                        &storage->how);
    if (code == SQLITE_OK && ledger_is_marked(&storage->file) && !storage->file.refusal) {
        code = take_copy(storage);
        if (code != SQLITE_OK) {
            ledger_file_close(&storage->file);
        }
    }
    if (code == SQLITE_OK && (storage_is_behind_backup(storage) ||
                              storage->file.content.memory.ledger.last_id <
                                  tails_last_id(storage))) {
        ledger_file_close(&storage->file);
        code = SQLITE_CORRUPT;
    }
    return code;
}

/* A file system of the caller's own has only the one file. */
int storage_open_file(struct storage *storage)
{
    if (storage->how.vfs) {
        return ledger_file_open(&storage->file, storage->path, &storage->how);
    }
    look_for_new(storage);
    int code = open_whole(storage);
    if ((code == SQLITE_CORRUPT || code == SQLITE_NOTADB) && replace(storage)) {
        code = ledger_file_open(&storage->file, storage->path, &storage->how);
    }
    return code;
}
