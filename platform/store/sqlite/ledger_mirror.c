/* ledger_mirror.c -- writes and reads the ledger mirror, a file with one sector per entry; see
 * ledger_recovery.h. */
#include "core/base/panic.h"
#include "platform/store/sqlite/ledger_recovery.h"

#include <fcntl.h>
#include <stddef.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/hash.h"
#include "core/game/accounting/accounts.h"
#include "core/pin.h"
#include "core/settings.h"
#include "platform/os/file.h"

#define FILE_SIZE ((off_t)LEDGER_MIRROR_SLOTS * LEDGER_MIRROR_SLOT_SIZE)

/* Version of the layout of a slot. Slots of older versions have padding in place of fields that
 * were added later. These fields are read as 0. A slot of version 100 or 4 lacks the round's
 * `level`. A slot of version 4 also lacks the balance's `returned` and `tickets`. Versions up to 4
 * had the number of the database's schema version. The numbers from 100 are independent of the
 * schema version. */
#define SLOT_VERSION 101u
#define SLOT_VERSION_100 100u
#define SLOT_VERSION_4 4u

/* Content of a slot. The field `entry` is written as it is in memory, because only this machine
 * reads the file. An entry of another version is detected by `version` and `size`. */
struct slot {
    uint32_t version, size;
    struct ledger_entry entry;
    uint64_t sum; /* Checksum of all fields of the slot before this field. */
};
_Static_assert(sizeof(struct slot) <= LEDGER_MIRROR_SLOT_SIZE, "an entry fits into a sector");

static uint64_t sum_of(const struct slot *slot)
{
    return hash_bytes(HASH_START, slot, offsetof(struct slot, sum));
}

static off_t offset_of(uint32_t id)
{
    return (off_t)(id % LEDGER_MIRROR_SLOTS) * LEDGER_MIRROR_SLOT_SIZE;
}

/* Reads a slot. Returns true if the slot has a valid entry. If an older version stored a PIN in the
 * slot as plain digits, `slot` receives the salted hash of the PIN (core/pin.h) instead. `*had_pin`
 * is then set to true unless `had_pin` is null. */
static bool read_slot(const struct ledger_mirror *tail, uint32_t index, struct slot *slot,
                      bool *had_pin)
{
    CORE_ASSERT(index < LEDGER_MIRROR_SLOTS);
    struct ledger_entry *entry = &slot->entry;
    if (pread(tail->handle, slot, sizeof *slot, offset_of(index)) != (ssize_t)sizeof *slot ||
        (slot->version != SLOT_VERSION && slot->version != SLOT_VERSION_100 &&
         slot->version != SLOT_VERSION_4) ||
        slot->size != sizeof slot->entry || slot->sum != sum_of(slot) ||
        entry->id % LEDGER_MIRROR_SLOTS != index) {
        return false;
    }
    if (slot->version != SLOT_VERSION) {
        entry->round.level = LEVEL_MASTER;
    }
    if (slot->version == SLOT_VERSION_4) {
        entry->balance.returned = 0;
        entry->balance.tickets = 0;
    }
    const bool is_good = ledger_entry_is_valid(entry);
    if (is_good && entry->kind == LEDGER_SETTING && entry->detail == SET_PIN && entry->count == 0 &&
        pin_is_plain(entry->value)) {
        entry->value = pin_hide((uint32_t)entry->value, entry->id);
        if (had_pin) {
            *had_pin = true;
        }
    }
    return is_good;
}

static int write_slot(struct ledger_mirror *tail, const struct ledger_entry *entry)
{
    CORE_ASSERT(entry->id > 0);
    uint8_t sector[LEDGER_MIRROR_SLOT_SIZE] = { 0 };
    struct slot slot;
    memset(&slot, 0, sizeof slot);
    slot.version = SLOT_VERSION;
    slot.size = sizeof slot.entry;
    memcpy(&slot.entry, entry, sizeof slot.entry);
    slot.sum = sum_of(&slot);
    memcpy(sector, &slot, sizeof slot);
    const ssize_t done = pwrite(tail->handle, sector, sizeof sector, offset_of(entry->id));
    return done == (ssize_t)sizeof sector ? 0 : -1;
}

/* ---- Opening ------------------------------------------------------------------------------- */

/* Writes every byte of the file and syncs the file. Returns 0 or -1.
 *
 * A new file is filled with zeros, so that all blocks are allocated. Later writes change only their
 * sectors and cannot fail because of a full memory card. An existing file (`is_whole`) keeps its
 * content. Its bytes are written again, because a sync may have failed in the current process or in
 * a process that was killed. After a failed sync, a slot may be readable although it is not on
 * disk. */
static int write_all(int handle, bool is_whole)
{
    uint8_t bytes[64 * LEDGER_MIRROR_SLOT_SIZE] = { 0 };
    const ssize_t size = (ssize_t)sizeof bytes;
    for (off_t at = 0; at < FILE_SIZE; at += size) {
        if ((is_whole && pread(handle, bytes, sizeof bytes, at) != size) ||
            pwrite(handle, bytes, sizeof bytes, at) != size) {
            return -1;
        }
    }
    return fsync(handle);
}

/* Finds the slots that contain a PIN as plain digits, and replaces the digits in the file by the
 * salted hash of the PIN (core/pin.h). Returns 0 or -1. */
static int hide_pins(struct ledger_mirror *tail)
{
    struct slot slot;
    int result = 0;
    bool any = false;
    for (uint32_t i = 0; result == 0 && i < LEDGER_MIRROR_SLOTS; i++) {
        bool had_pin = false;
        if (read_slot(tail, i, &slot, &had_pin) && had_pin) {
            result = write_slot(tail, &slot.entry);
            any = true;
        }
    }
    return result == 0 && any ? fdatasync(tail->handle) : result;
}

int ledger_mirror_open(struct ledger_mirror *tail, const char *path)
{
    struct stat about;
    const int handle = file_handle(path, O_RDWR | O_CREAT, 0600);
    *tail = (struct ledger_mirror){ .handle = handle > 0 ? handle : 0 };
    if (tail->handle == 0) {
        return -1;
    }
    const bool is_whole = fstat(handle, &about) == 0 && about.st_size == FILE_SIZE;
    fchmod(handle, S_IRUSR | S_IWUSR); /* Older versions of Kingyo created the file with read
                                          permission for all users. */
    int result = write_all(handle, is_whole);
    result = result == 0 && is_whole ? hide_pins(tail) : result;
    if (result != 0 || file_sync_parent(path) != 0) {
        ledger_mirror_close(tail);
        return -1;
    }
    return 0;
}

struct ledger_mirror ledger_mirror_inspect(const char *path)
{
    const int handle = file_handle(path, O_RDONLY, 0);
    return (struct ledger_mirror){ .handle = handle > 0 ? handle : 0 };
}

void ledger_mirror_close(struct ledger_mirror *tail)
{
    CORE_ASSERT(tail->handle >= 0);
    if (tail->handle > 0) {
        close(tail->handle);
    }
    *tail = (struct ledger_mirror){ 0 };
}

/* ---- Reading and writing entries ----------------------------------------------------------- */

int ledger_mirror_write(struct ledger_mirror *tail, const struct ledger_entry *entries,
                        uint32_t count)
{
    CORE_ASSERT(tail->handle > 0);
    int result = 0;
    for (uint32_t i = 0; result == 0 && i < count; i++) {
        result = write_slot(tail, &entries[i]);
    }
    return result == 0 ? fdatasync(tail->handle) : result;
}

int ledger_mirror_erase_name(struct ledger_mirror *tail, uint32_t round_id, uint32_t player)
{
    struct slot slot;
    int result = 0;
    for (uint32_t i = 0; result == 0 && i < LEDGER_MIRROR_SLOTS; i++) {
        struct ledger_entry *entry = &slot.entry;
        /* An entry whose name is already empty is also written again, because its earlier sync may
         * have failed. */
        if (read_slot(tail, i, &slot, NULL) && entry->kind == LEDGER_NAME &&
            entry->count == round_id && entry->detail == player) {
            memset(entry->name, 0, sizeof entry->name);
            result = write_slot(tail, entry);
        }
    }
    return result;
}

bool ledger_mirror_entry(const struct ledger_mirror *tail, uint32_t id, struct ledger_entry *out)
{
    struct slot slot;
    if (tail->handle == 0 || !read_slot(tail, id % LEDGER_MIRROR_SLOTS, &slot, NULL) ||
        slot.entry.id != id) {
        return false;
    }
    *out = slot.entry;
    return true;
}

uint32_t ledger_mirror_last_id(const struct ledger_mirror *tail)
{
    struct slot slot;
    uint32_t last_id = 0;
    for (uint32_t i = 0; tail->handle > 0 && i < LEDGER_MIRROR_SLOTS; i++) {
        if (read_slot(tail, i, &slot, NULL) && slot.entry.id > last_id) {
            last_id = slot.entry.id;
        }
    }
    return last_id;
}
