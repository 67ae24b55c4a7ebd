/* storage_card.c -- detects a card that was removed, replaced or full, and reopens the database.
 *
 * An absent card is checked once per second because the check is cheap. An unusable file is read
 * completely at each attempt. The interval between attempts therefore grows from one second to one
 * minute, unless an attribute of the file or its card changes. */
#include <errno.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <unistd.h>

#include <sqlite3.h>

#include "core/base/hash.h"
#include "platform/os/file.h"
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

/* Returns true if the last write failed because the card was full and the card has more free space
 * now. */
static bool has_more_room(const struct storage *storage)
{
    return atomic_load(&storage->error) == SQLITE_FULL &&
           room_of(storage) >= storage->room + STORAGE_ROOM_MORE;
}

static bool is_worth_a_look(const struct storage *storage)
{
    return storage_now_ms() >= storage->look_due_ms ||
           atomic_load(&storage->late.state) == OFFLINE_CREDITS_NEW ||
           sight_of(storage) != storage->sight || has_more_room(storage);
}

/* Returns true if the store has read the whole file to get the result `code`. */
static bool was_dear(int code)
{
    return code == LEDGER_FILE_FOREIGN || code == LEDGER_FILE_NEWER || code == LEDGER_FILE_MOVED ||
           code == SQLITE_READONLY || code == SQLITE_FULL || code == SQLITE_CORRUPT ||
           code == SQLITE_NOTADB;
}

static void note_look(struct storage *storage, int code)
{
    const uint64_t sight = sight_of(storage);
    const int64_t longer_ms = 2 * storage->look_wait_ms;
    if (!was_dear(code)) {
        storage->look_wait_ms = 0;
    } else if (storage->look_wait_ms == 0 || sight != storage->sight) {
        storage->look_wait_ms = STORAGE_RETRY_MS;
    } else {
        storage->look_wait_ms = longer_ms < STORAGE_RETRY_MS_MAX ? longer_ms : STORAGE_RETRY_MS_MAX;
    }
    storage->sight = sight;
    storage->room = room_of(storage);
    storage->look_due_ms = storage->look_wait_ms > 0 ? storage_now_ms() + storage->look_wait_ms : 0;
}

/* ---- Identity of the ledger ---------------------------------------------------------------- */

/* Returns true if the open file contains a foreign ledger. A foreign ledger comes from another
 * card, or from a card that was absent at program start. A new card or a backup has fewer entries
 * and is accepted. The file may also contain queued entries, because a write that reported an error
 * may have succeeded. */
static bool is_anothers(struct storage *storage)
{
    const unsigned pushed = atomic_load(&storage->pushed);
    const uint32_t saved_id = atomic_load(&storage->saved_id);
    const uint32_t last_id = storage->file.content.memory.ledger.last_id;
    const uint32_t newest_id = storage_unwritten(storage) > 0
                                   ? storage->queue[(pushed - 1u) % STORAGE_QUEUE_MAX].id
                                   : saved_id;
    struct ledger_entry entry;
    if (last_id < saved_id || last_id == 0) {
        return false;
    }
    return last_id > newest_id ||
           (saved_id > 0 &&
            (ledger_file_entry(&storage->file, saved_id, &entry) != SQLITE_OK ||
             entry.boot != storage->saved_boot || entry.tick != storage->saved_tick));
}

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
    if (storage->hold > 0) {
        close(storage->hold - 1);
        storage->hold = 0;
    }
}

/* Returns true if the file that replaced a moved file lacks entries that were acknowledged. */
static bool lacks_entries(const struct storage *storage)
{
    return storage->file.content.memory.ledger.last_id < atomic_load(&storage->saved_id);
}

static int storage_card_probe(struct storage *storage)
{
    int code = storage_open_exclusive(storage);
    if (code == SQLITE_OK && storage->moved && lacks_entries(storage)) {
        storage_close_file(storage);
        storage_unlock(storage);
        return LEDGER_FILE_MOVED;
    }
    if (code == SQLITE_OK && is_anothers(storage)) {
        offline_credits_apply(storage);
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
 * because there is no next call. */
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
    if (storage->file.db && !storage->file.refusal && !storage_has_moved(storage)) {
        if (storage->moved) { /* The file is back at its path. */
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
    if (!storage->path[0] || !is_worth_a_look(storage)) {
        return false;
    }
    storage_close_file(storage);
    const int code = storage_card_probe(storage);
    note_look(storage, code);
    if (code != SQLITE_OK || storage_unwritten(storage) == 0) {
        storage_note_result(storage, code); /* If entries wait in the queue, the result of their
                                               write sets the store's status. */
    }
    return code == SQLITE_OK;
}
