/* storage_rebuild.c -- what takes the place of a file that is damaged or gone.
 *
 * The last good backup, and all that the damaged file and the tail still say beyond that, is made
 * under a name of its own, and gets the name STORAGE_NEW_SUFFIX only when it is whole and on disk.
 * Only then is the damaged one renamed, and then the new one. A power cut anywhere leaves files
 * from which the next start does the same again, or the rest of it; a card that has no room for it
 * is left as it was.
 *
 * Where the newest entry is not known its id may be given once more: ids rise by one
 * (core/ledger.h), and what is set aside is told apart by its boots. */
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include <sqlite3.h>

#include "platform/plain_file.h"
#include "platform/storage_parts.h"
#include "platform/store/ledger_backup.h"
#include "platform/store/sql.h"

#define PART_SUFFIX STORAGE_NEW_SUFFIX LEDGER_PART_SUFFIX /* Until it is whole. */

static const char *const suffixes[] = { "-wal", "-journal", "-shm" };
#define SUFFIX_COUNT (sizeof suffixes / sizeof suffixes[0])

/* ---- Setting aside -------------------------------------------------------------------------- */

static unsigned number_in(const char *name, const char *suffix)
{
    const char *at = strncmp(name, STORAGE_FILE, sizeof STORAGE_FILE - 1u) == 0
                         ? strstr(name, suffix)
                         : NULL;
    return at ? (unsigned)strtoul(at + strlen(suffix), NULL, 10) : 0u;
}

/* One more than any that was ever given, as far as it has left a word: one that was looked at and
 * removed has left a mark, which would hide the next of that number. */
static unsigned next_number(const struct storage *storage)
{
    static const char *const kinds[] = { STORAGE_ASIDE_SUFFIX, STORAGE_MISSING_SUFFIX,
                                         STORAGE_OTHER_SUFFIX };
    DIR *const folder = opendir(storage->dir);
    const struct dirent *entry;
    unsigned newest = 0;
    while (folder && (entry = readdir(folder))) {
        for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++) {
            const unsigned number = number_in(entry->d_name, kinds[i]);
            newest = number > newest ? number : newest;
        }
    }
    if (folder) {
        closedir(folder);
    }
    return newest + 1u;
}

int storage_set_other_aside(struct storage *storage, const char *suffix)
{
    char from[LEDGER_PATH_SIZE], to[LEDGER_PATH_SIZE], number[40];
    snprintf(number, sizeof number, STORAGE_OTHER_SUFFIX "%u", next_number(storage));
    storage_beside(storage, suffix, "", from);
    storage_beside(storage, suffix, number, to);
    return rename(from, to) == 0 ? ledger_sync_folder(to) : -1;
}

/* Renames the file, and then what belongs to it: left behind, a journal would be played into the
 * fresh one. */
static bool set_aside(struct storage *storage, unsigned number)
{
    char from[LEDGER_PATH_SIZE], to[LEDGER_PATH_SIZE], suffix[40];
    snprintf(suffix, sizeof suffix, STORAGE_ASIDE_SUFFIX "%u", number);
    storage_beside(storage, suffix, "", to);
    if (storage_has_path(storage->path) && rename(storage->path, to) != 0) {
        return false;
    }
    for (size_t i = 0; i < SUFFIX_COUNT; i++) {
        storage_beside(storage, suffixes[i], "", from);
        storage_beside(storage, suffix, suffixes[i], to);
        if (rename(from, to) != 0 && errno != ENOENT) {
            return false;
        }
    }
    return true;
}

/* A file that was not there leaves nothing to set aside; this says so in its stead, until somebody
 * has seen it. */
static bool leave_note(struct storage *storage, unsigned number)
{
    char path[LEDGER_PATH_SIZE], suffix[40];
    snprintf(suffix, sizeof suffix, STORAGE_MISSING_SUFFIX "%u", number);
    storage_beside(storage, suffix, "", path);
    const int handle = plain_file_handle(path, O_WRONLY | O_CREAT, 0600);
    return handle >= 0 && close(handle) == 0 && ledger_sync_folder(path) == 0;
}

/* ---- What takes a file's place -------------------------------------------------------------- */

static void remove_all(const struct storage *storage, const char *suffix)
{
    char path[LEDGER_PATH_SIZE];
    storage_beside(storage, suffix, "", path);
    unlink(path);
    for (size_t i = 0; i < SUFFIX_COUNT; i++) {
        storage_beside(storage, suffix, suffixes[i], path);
        unlink(path);
    }
}

/* Whether there is a backup that can be used; of an earlier version, too. */
static bool open_backup(struct ledger_file *file, const char *backup)
{
    *file = (struct ledger_file){ .refusal = SQLITE_READONLY };
    const bool is_good =
        storage_has_path(backup) &&
        sql_open(backup, SQLITE_OPEN_READONLY, NULL, &file->db) == SQLITE_OK &&
        ledger_check(file->db) == SQLITE_OK;
    if (!is_good) {
        ledger_file_close(file);
    }
    return is_good;
}

/* What the old file and the tail say beyond what `to` has. */
static int salvage_into(struct storage *storage, struct ledger_file *to)
{
    struct stat about;
    const bool has_bytes = stat(storage->path, &about) == 0 && about.st_size > 0;
    struct ledger_tail tail = storage_look_at_tail(storage);
    storage->from_backup = to->content.memory.ledger.last_id;
    const int code = ledger_salvage(has_bytes ? storage->path : NULL, &tail, to,
                                    &storage->salvaged);
    ledger_tail_close(&tail);
    return code;
}

static int sync_file(const char *path)
{
    const int handle = plain_file_handle(path, O_RDWR, 0);
    const int result = handle < 0 ? -1 : fsync(handle);
    if (handle >= 0) {
        close(handle);
    }
    return result;
}

/* Nobody reads it before it is whole: it is synced once, at its end, so that a slow card is not
 * waited for a thousand times. */
static int make_part(struct storage *storage, const char *part)
{
    static const struct ledger_file_how unsynced = { .journal = "MEMORY OFF" };
    struct ledger_file file;
    char backup[LEDGER_PATH_SIZE];
    int code = SQLITE_OK;
    storage_backup_path(storage, backup);
    if (open_backup(&file, backup)) {
        code = ledger_backup_make(&file, part, false);
        ledger_file_close(&file);
    }
    code = code == SQLITE_OK ? ledger_file_open(&file, part, &unsynced) : code;
    if (code == SQLITE_CORRUPT) { /* The backup is whole, but its sums are out of range. */
        remove_all(storage, PART_SUFFIX);
        code = ledger_file_open(&file, part, &unsynced);
    }
    if (code != SQLITE_OK) {
        return code;
    }
    code = file.refusal ? file.refusal : salvage_into(storage, &file);
    ledger_file_close(&file);
    return code == SQLITE_OK && sync_file(part) != 0 ? SQLITE_IOERR : code;
}

/* It gets its name once the note is there, so that a cut in between is told all the same. */
static int make_new(struct storage *storage, bool is_missing, unsigned number)
{
    char part[LEDGER_PATH_SIZE], fresh[LEDGER_PATH_SIZE];
    storage_beside(storage, PART_SUFFIX, "", part);
    storage_beside(storage, STORAGE_NEW_SUFFIX, "", fresh);
    remove_all(storage, PART_SUFFIX);
    int code = make_part(storage, part);
    if (code == SQLITE_OK &&
        ((is_missing && !leave_note(storage, number)) || rename(part, fresh) != 0 ||
         ledger_sync_folder(fresh) != 0)) {
        code = SQLITE_IOERR;
    }
    if (code != SQLITE_OK) {
        remove_all(storage, PART_SUFFIX);
    }
    return code;
}

/* The last step, and all that is left to do where the power went before it. */
static bool put_new(struct storage *storage)
{
    char fresh[LEDGER_PATH_SIZE];
    storage_beside(storage, STORAGE_NEW_SUFFIX, "", fresh);
    return rename(fresh, storage->path) == 0 && ledger_sync_folder(storage->path) == 0;
}

int storage_rebuild(struct storage *storage, bool is_missing)
{
    const unsigned number = next_number(storage);
    const int code = make_new(storage, is_missing, number);
    if (code != SQLITE_OK) {
        return code;
    }
    if (storage->salvaged.has_others_tail &&
        storage_set_other_aside(storage, STORAGE_TAIL_SUFFIX) != 0) {
        return SQLITE_IOERR;
    }
    if (!set_aside(storage, number) || ledger_sync_folder(storage->path) != 0 ||
        !put_new(storage)) {
        return SQLITE_IOERR;
    }
    storage->was_missing = is_missing;
    atomic_store(&storage->aside, number);
    return SQLITE_OK;
}

/* Where there is no file one may be half replaced. What was made for one that is there again is of
 * yesterday. */
int storage_end_rebuilding(struct storage *storage)
{
    char fresh[LEDGER_PATH_SIZE];
    storage_beside(storage, STORAGE_NEW_SUFFIX, "", fresh);
    if (storage_has_path(storage->path)) {
        remove_all(storage, STORAGE_NEW_SUFFIX);
    } else if (storage_has_path(fresh) &&
               !(set_aside(storage, next_number(storage)) && put_new(storage))) {
        return SQLITE_IOERR; /* Without the new file nothing else may take the place. */
    }
    return SQLITE_OK;
}

/* ---- Where none can be made ----------------------------------------------------------------- */

bool storage_read_remains(struct storage *storage, int refusal)
{
    char backup[LEDGER_PATH_SIZE];
    storage_backup_path(storage, backup);
    struct ledger_file *file = &storage->file;
    if (ledger_file_look(file, backup) != SQLITE_OK || ledger_check(file->db) != SQLITE_OK) {
        ledger_file_close(file);
    }
    file->refusal = refusal;
    file->content.has_read = true;
    salvage_into(storage, file);
    if (file->content.memory.ledger.last_id == 0) {
        ledger_file_close(file);
        return false;
    }
    return true;
}
