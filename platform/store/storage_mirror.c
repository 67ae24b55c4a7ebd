/* storage_mirror.c -- writes each new entry to the ledger mirror before the entry is acknowledged.
 * The ledger mirror is a second copy of the newest entries.
 *
 * The mirror has no gap. After a failed write, the missing entries are copied from the database
 * before a newer entry is added. No entry is acknowledged until the mirror is complete. */
#include <errno.h>
#include <sys/stat.h>
#include <unistd.h>

#include <sqlite3.h>

#include "platform/store/storage_internal.h"

/* Maximum number of entries that are copied from the database between two syncs. */
#define BATCH 64u

/* Returns true if the mirror belongs to a foreign ledger, for example after a user copied a card. A
 * foreign mirror must not be used. */
static bool is_of_another_list(const struct storage *storage)
{
    struct ledger_entry entry;
    return ledger_mirror_entry(&storage->tail, atomic_load(&storage->saved_id), &entry) &&
           (entry.boot != storage->saved_boot || entry.tick != storage->saved_tick);
}

/* Sets `tail_from` to the id of the first saved entry that the mirror lacks. */
static void note_lack(struct storage *storage)
{
    const uint32_t saved_id = atomic_load(&storage->saved_id);
    const uint32_t last_id = ledger_mirror_last_id(&storage->tail);
    if (last_id < saved_id && (storage->tail_from == 0 || storage->tail_from > last_id + 1u)) {
        storage->tail_from = last_id + 1u;
    }
}

static int open_tail(struct storage *storage)
{
    char path[LEDGER_PATH_SIZE];
    storage_mirror_path(storage, path);
    int result = ledger_mirror_open(&storage->tail, path);
    if (result == 0 && is_of_another_list(storage)) {
        ledger_mirror_close(&storage->tail);
        result = storage_quarantine_other(storage, STORAGE_MIRROR_SUFFIX);
        result = result == 0 ? ledger_mirror_open(&storage->tail, path) : result;
    }
    if (result == 0) {
        note_lack(storage);
    }
    return result;
}

/* Returns true if the mirror file was deleted while it was open. */
static bool is_removed(const struct storage *storage)
{
    struct stat about;
    return storage->tail.handle > 0 && fstat(storage->tail.handle, &about) == 0 &&
           about.st_nlink == 0;
}

/* Copies the missing entries up to the id `last_id` from the database. Returns 0 or -1. */
static int storage_mirror_catch_up(struct storage *storage, uint32_t last_id)
{
    struct ledger_entry entries[BATCH];
    uint32_t count = 0;
    int result = 0;
    uint32_t id = storage->tail_from;
    if (last_id >= LEDGER_MIRROR_SLOTS && id < last_id - LEDGER_MIRROR_SLOTS + 1u) {
        id = last_id - LEDGER_MIRROR_SLOTS + 1u;
    }
    for (; result == 0 && storage->tail_from > 0 && id <= last_id; id++) {
        count += ledger_file_entry(&storage->file, id, &entries[count]) == SQLITE_OK;
        if (count == BATCH || (count > 0 && id == last_id)) {
            result = ledger_mirror_write(&storage->tail, entries, count);
            count = 0;
        }
    }
    storage->tail_from = result == 0 ? 0u : storage->tail_from;
    return result;
}

/* Opens the mirror and copies missing entries up to the id `last_id`. Returns 0 or -1. */
static int make_ready(struct storage *storage, uint32_t last_id)
{
    if (is_removed(storage)) {
        ledger_mirror_close(&storage->tail);
    }
    const int result = storage->tail.handle > 0 ? 0 : open_tail(storage);
    return result == 0 ? storage_mirror_catch_up(storage, last_id) : result;
}

static void note_result(struct storage *storage, int result, uint32_t first_id)
{
    const int error = errno > 0 ? errno : EIO;
    atomic_store(&storage->tail_error, result == 0 ? 0 : error);
    if (result != 0) {
        ledger_mirror_close(&storage->tail);
        storage->tail_from = storage->tail_from > 0 ? storage->tail_from : first_id;
        atomic_fetch_add(&storage->refused, 1);
    }
}

/* Erases revoked player names from the mirror. Returns 0 or -1. */
static int forget_names(struct storage *storage, const struct ledger_entry *entries, uint32_t count)
{
    int result = 0;
    for (uint32_t i = 0; result == 0 && i < count; i++) {
        if (entries[i].kind == LEDGER_NAME && !entries[i].name[0]) {
            result = ledger_mirror_erase_name(&storage->tail, entries[i].count, entries[i].detail);
        }
    }
    return result;
}

int storage_mirror_write(struct storage *storage, const struct ledger_entry *entries,
                         uint32_t count)
{
    if (storage->how.vfs) {
        return 0;
    }
    int result = make_ready(storage, entries[0].id - 1u);
    result = result == 0 ? forget_names(storage, entries, count) : result;
    result = result == 0 ? ledger_mirror_write(&storage->tail, entries, count) : result;
    note_result(storage, result, entries[0].id);
    return result;
}

/* Completes the mirror if no entry waits in the queue. If entries wait, the write of the next batch
 * completes the mirror, and the store must stay unhealthy until then. */
void storage_mirror_repair(struct storage *storage)
{
    if (storage->tail_from > 0 && storage_unwritten(storage) == 0 && storage->file.db &&
        !storage->file.refusal) {
        note_result(storage, make_ready(storage, atomic_load(&storage->saved_id)), 0);
    }
}
