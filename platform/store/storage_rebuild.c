/* storage_rebuild.c -- makes the replacement of a database that is damaged or missing.
 *
 * The replacement contains the last valid backup and all newer entries of the damaged database and
 * the ledger mirror. The replacement is first written and synced completely under a temporary name.
 * Then the replacement is renamed to STORAGE_NEW_SUFFIX, the damaged database is renamed, and
 * finally the replacement gets the name of the database. After a power cut at any point, the next
 * start repeats or completes these steps. A memory card without enough space is left unchanged.
 *
 * A damaged backup is renamed and not read. No credit is lost, because each entry contains the
 * balance and the mirror contains the newest entries.
 *
 * If the id of the newest lost entry is unknown, a later entry may get the same id, because ids
 * rise by one (core/ledger.h). The two entries then differ in their boot numbers. */
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <sqlite3.h>

#include "core/base/panic.h"
#include "platform/os/file.h"
#include "platform/store/sqlite/ledger_backup.h"
#include "platform/store/sqlite/sql.h"
#include "platform/store/storage_internal.h"

/* Suffix of the replacement while it is incomplete. */
#define PART_SUFFIX STORAGE_NEW_SUFFIX LEDGER_PART_SUFFIX

/* Limit of the numbers of quarantined files and markers. Kingyo writes no file with this or a
 * larger number, so that the number never wraps. Such a file is not counted. */
#define NUMBER_MAX 1000000000u

static const char *const suffixes[] = { "-wal", "-journal", "-shm" };
#define SUFFIX_COUNT (sizeof suffixes / sizeof suffixes[0])

/* ---- Quarantine ---------------------------------------------------------------------------- */

/* Returns the number for the name of the next quarantined file or marker file: the highest number
 * in use plus one. Returns 0 if the folder cannot be listed. The numbers of marker files count
 * too. The operator may have deleted a quarantined file after acknowledging it, but not the marker
 * file of the acknowledgement (STORAGE_SEEN_SUFFIX). A new file with the same number would then
 * count as acknowledged. */
static unsigned next_number(const struct storage *storage)
{
    static const char *const kinds[] = { STORAGE_QUARANTINE_SUFFIX, STORAGE_MISSING_SUFFIX,
                                         STORAGE_OTHER_SUFFIX };
    DIR *const folder = opendir(storage->dir);
    const struct dirent *entry;
    unsigned newest = 0;
    errno = 0;
    while (folder && (entry = readdir(folder))) {
        for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++) {
            const char *at = strncmp(entry->d_name, STORAGE_FILE, sizeof STORAGE_FILE - 1u) == 0
                                 ? strstr(entry->d_name, kinds[i])
                                 : NULL;
            const unsigned long number = at ? strtoul(at + strlen(kinds[i]), NULL, 10) : 0u;
            newest = number > newest && number < NUMBER_MAX ? (unsigned)number : newest;
        }
    }
    const bool is_complete = folder && errno == 0;
    if (folder) {
        closedir(folder);
    }
    return is_complete ? newest + 1u : 0u;
}

int storage_quarantine_other(struct storage *storage, const char *suffix)
{
    CORE_ASSERT(suffix[0] == '.' || suffix[0] == '-');
    char text[40];
    const unsigned number = next_number(storage);
    snprintf(text, sizeof text, STORAGE_OTHER_SUFFIX "%u", number);
    const struct storage_path to = storage_path(storage, suffix, text);
    const int error =
        number == 0 ? -EIO : file_rename_new(storage_path(storage, suffix, "").text, to.text);
    errno = -error;
    return error == 0 && file_sync_parent(to.text) == 0 ? 0 : -1;
}

/* Renames the damaged database first and then its log and its journal. SQLite would apply a log or
 * journal with the old name to the new database. Returns true on success. Returns false if `number`
 * is 0, or if a file would be replaced. */
static bool quarantine_database(struct storage *storage, unsigned number)
{
    char suffix[40];
    if (number == 0) {
        return false;
    }
    snprintf(suffix, sizeof suffix, STORAGE_QUARANTINE_SUFFIX "%u", number);
    if (storage_has_path(storage->path) &&
        file_rename_new(storage->path, storage_path(storage, suffix, "").text) != 0) {
        return false;
    }
    for (size_t i = 0; i < SUFFIX_COUNT; i++) {
        const int error = file_rename_new(storage_path(storage, suffixes[i], "").text,
                                          storage_path(storage, suffix, suffixes[i]).text);
        if (error != 0 && error != -ENOENT) {
            return false;
        }
    }
    return true;
}

/* Creates an empty marker for a missing database. The marker stays until the operator acknowledges
 * the loss. Returns true if the marker is on disk. */
static bool write_note(struct storage *storage, unsigned number)
{
    char suffix[40];
    snprintf(suffix, sizeof suffix, STORAGE_MISSING_SUFFIX "%u", number);
    const struct storage_path path = storage_path(storage, suffix, "");
    const int handle = file_handle(path.text, O_WRONLY | O_CREAT, 0600);
    return handle >= 0 && close(handle) == 0 && file_sync_parent(path.text) == 0;
}

/* ---- Replacement --------------------------------------------------------------------------- */

static void remove_all(const struct storage *storage, const char *suffix)
{
    unlink(storage_path(storage, suffix, "").text);
    for (size_t i = 0; i < SUFFIX_COUNT; i++) {
        unlink(storage_path(storage, suffix, suffixes[i]).text);
    }
}

/* Copies the entries that `to` lacks into `to`. Reads the entries from the damaged database and
 * from the ledger mirror. Returns an SQLite code. */
static int salvage_into(struct storage *storage, struct ledger_file *to)
{
    struct ledger_mirror tail = storage_inspect_mirror(storage);
    storage->from_backup = to->content.memory.ledger.last_id;
    const int code = ledger_recover(storage_has_bytes(storage->path) ? storage->path : NULL, &tail,
                                    to, &storage->salvaged);
    ledger_mirror_close(&tail);
    return code;
}

static int sync_file(const char *path)
{
    const int handle = file_handle(path, O_RDWR, 0);
    const int result = handle < 0 ? -1 : fsync(handle);
    if (handle >= 0) {
        close(handle);
    }
    return result;
}

/* Makes the replacement and renames it to STORAGE_NEW_SUFFIX. If the database is missing, the
 * marker file is created before the rename. The loss is therefore reported even after a power cut
 * between the two steps. `*uses_backup` is true if the replacement contains the backup, which may
 * have no entries. */
static int make_new(struct storage *storage, bool is_missing, unsigned number, bool *uses_backup)
{
    /* The replacement is written without syncs, because no process reads the file before it is
     * complete. Syncing once at the end saves time on a slow memory card. */
    static const struct ledger_file_options unsynced = { .journal = "MEMORY OFF" };
    const struct storage_path part = storage_path(storage, PART_SUFFIX, "");
    const struct storage_path backup = storage_path(storage, STORAGE_BACKUP_SUFFIX, "");
    remove_all(storage, PART_SUFFIX);
    /* The backup is opened read-only, so that a backup with an older schema can be copied too. */
    struct ledger_file file = { .refusal = SQLITE_READONLY };
    *uses_backup = storage_has_path(backup.text) &&
                   sql_open(backup.text, SQLITE_OPEN_READONLY, NULL, &file.db) == SQLITE_OK &&
                   ledger_check(file.db) == SQLITE_OK;
    int code = *uses_backup ? ledger_backup_make(&file, part.text, false) : SQLITE_OK;
    ledger_file_close(&file);
    code = code == SQLITE_OK ? ledger_file_open(&file, part.text, &unsynced) : code;
    /* The pages of the backup are intact, but its settings, audits or ranking are out of range. The
     * replacement is therefore made without the backup. */
    if (code == SQLITE_CORRUPT) {
        remove_all(storage, PART_SUFFIX);
        *uses_backup = false;
        code = ledger_file_open(&file, part.text, &unsynced);
    }
    if (code == SQLITE_OK) {
        code = file.refusal ? file.refusal : salvage_into(storage, &file);
        ledger_file_close(&file);
        code = code == SQLITE_OK && sync_file(part.text) != 0 ? SQLITE_IOERR : code;
    }
    if (code == SQLITE_OK &&
        ((is_missing && !write_note(storage, number)) ||
         file_rename_durable(part.text, storage_path(storage, STORAGE_NEW_SUFFIX, "").text) != 0)) {
        code = SQLITE_IOERR;
    }
    if (code != SQLITE_OK) {
        remove_all(storage, PART_SUFFIX);
    }
    return code;
}

/* Renames the complete replacement to the path of the database, which is the last step of a
 * replacement. After a power cut the next start repeats this step. Returns true on success. */
static bool put_new(struct storage *storage)
{
    return file_rename_durable(storage_path(storage, STORAGE_NEW_SUFFIX, "").text, storage->path) ==
           0;
}

int storage_rebuild(struct storage *storage, bool is_missing)
{
    CORE_ASSERT(storage->path[0]);
    CORE_ASSERT(!storage->how.vfs);
    const unsigned number = next_number(storage);
    bool uses_backup;
    if (number == 0) {
        return SQLITE_CANTOPEN;
    }
    const int code = make_new(storage, is_missing, number, &uses_backup);
    if (code != SQLITE_OK) {
        return code;
    }
    /* A backup that was not used may be the only copy of its entries. It must be renamed before the
     * next backup takes its name. */
    const bool has_unused_backup =
        !uses_backup && storage_has_bytes(storage_path(storage, STORAGE_BACKUP_SUFFIX, "").text);
    if ((has_unused_backup && storage_quarantine_other(storage, STORAGE_BACKUP_SUFFIX) != 0) ||
        (storage->salvaged.has_others_tail &&
         storage_quarantine_other(storage, STORAGE_MIRROR_SUFFIX) != 0)) {
        return SQLITE_IOERR;
    }
    if (!quarantine_database(storage, number) || file_sync_parent(storage->path) != 0 ||
        !put_new(storage)) {
        return SQLITE_IOERR;
    }
    storage->was_missing = is_missing;
    atomic_store(&storage->quarantined, number);
    return SQLITE_OK;
}

/* Completes a replacement that a power cut interrupted, if the database is absent. If the database
 * exists, the replacement is obsolete and is deleted. */
int storage_end_rebuilding(struct storage *storage)
{
    if (storage_has_path(storage->path)) {
        remove_all(storage, STORAGE_NEW_SUFFIX);
    } else if (storage_has_path(storage_path(storage, STORAGE_NEW_SUFFIX, "").text) &&
               !(quarantine_database(storage, next_number(storage)) && put_new(storage))) {
        /* The replacement cannot be renamed. An error is returned, so that no new database is
         * created at the path. */
        return SQLITE_IOERR;
    }
    return SQLITE_OK;
}

/* ---- Reading while the database cannot be replaced ---------------------------------------- */

bool storage_read_remnants(struct storage *storage, int refusal)
{
    struct ledger_file *file = &storage->file;
    if (ledger_file_inspect(file, storage_path(storage, STORAGE_BACKUP_SUFFIX, "").text) !=
            SQLITE_OK ||
        ledger_check(file->db) != SQLITE_OK) {
        ledger_file_close(file);
    }
    file->refusal = refusal;
    file->is_suspect = true; /* Entries of the mirror may exist only in the kernel's cache. */
    file->content.has_read = true;
    salvage_into(storage, file);
    if (file->content.memory.ledger.last_id == 0) {
        ledger_file_close(file);
        return false;
    }
    return true;
}
