/* ledger_tail.c -- a ring of entries, a sector each. */
#include "platform/store/ledger_tail.h"

#include <fcntl.h>
#include <stddef.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/hash.h"
#include "platform/store/ledger_backup.h"

#define FILE_SIZE ((off_t)LEDGER_TAIL_SLOTS * LEDGER_TAIL_SLOT_SIZE)

/* An entry as it lies in memory: only this machine reads it again, and another program's is told by
 * its size and the version of the file beside it. */
struct slot {
    uint32_t version, size;
    struct ledger_entry entry;
    uint64_t sum; /* Of all before it. */
};
_Static_assert(sizeof(struct slot) <= LEDGER_TAIL_SLOT_SIZE, "an entry fits into a sector");

static uint64_t sum_of(const struct slot *slot)
{
    return hash_bytes(HASH_START, slot, offsetof(struct slot, sum));
}

static off_t offset_of(uint32_t id)
{
    return (off_t)(id % LEDGER_TAIL_SLOTS) * LEDGER_TAIL_SLOT_SIZE;
}

static bool read_slot(const struct ledger_tail *tail, uint32_t index, struct slot *slot)
{
    return pread(tail->handle, slot, sizeof *slot, offset_of(index)) == (ssize_t)sizeof *slot &&
           slot->version == LEDGER_FILE_VERSION && slot->size == sizeof slot->entry &&
           slot->sum == sum_of(slot) && slot->entry.id % LEDGER_TAIL_SLOTS == index;
}

/* ---- Opening -------------------------------------------------------------------------------- */

/* Every block of it is there before the first entry: a write then changes nothing but its sector,
 * and cannot find the card full. */
static int fill(int handle)
{
    static const uint8_t nothing[64 * LEDGER_TAIL_SLOT_SIZE];
    for (off_t at = 0; at < FILE_SIZE; at += (off_t)sizeof nothing) {
        if (pwrite(handle, nothing, sizeof nothing, at) != (ssize_t)sizeof nothing) {
            return -1;
        }
    }
    return fsync(handle);
}

static struct ledger_tail opened(int handle)
{
    return (struct ledger_tail){ .handle = handle > 0 ? handle : 0 };
}

int ledger_tail_open(struct ledger_tail *tail, const char *path)
{
    struct stat about;
    *tail = opened(open(path, O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0644));
    if (tail->handle == 0) {
        return -1;
    }
    const bool is_whole = fstat(tail->handle, &about) == 0 && about.st_size == FILE_SIZE;
    if (!is_whole && (fill(tail->handle) != 0 || ledger_sync_folder(path) != 0)) {
        ledger_tail_close(tail);
        return -1;
    }
    return 0;
}

struct ledger_tail ledger_tail_look(const char *path)
{
    return opened(open(path, O_RDONLY | O_CLOEXEC | O_NOFOLLOW));
}

void ledger_tail_close(struct ledger_tail *tail)
{
    if (tail->handle > 0) {
        close(tail->handle);
    }
    *tail = (struct ledger_tail){ 0 };
}

/* ---- Entries -------------------------------------------------------------------------------- */

static int write_slot(struct ledger_tail *tail, const struct ledger_entry *entry)
{
    uint8_t sector[LEDGER_TAIL_SLOT_SIZE] = { 0 };
    struct slot slot;
    memset(&slot, 0, sizeof slot);
    slot.version = LEDGER_FILE_VERSION;
    slot.size = sizeof slot.entry;
    memcpy(&slot.entry, entry, sizeof slot.entry);
    slot.sum = sum_of(&slot);
    memcpy(sector, &slot, sizeof slot);
    const ssize_t done = pwrite(tail->handle, sector, sizeof sector, offset_of(entry->id));
    return done == (ssize_t)sizeof sector ? 0 : -1;
}

int ledger_tail_write(struct ledger_tail *tail, const struct ledger_entry *entries, uint32_t count)
{
    int result = 0;
    for (uint32_t i = 0; result == 0 && i < count; i++) {
        result = write_slot(tail, &entries[i]);
    }
    return result == 0 ? fdatasync(tail->handle) : result;
}

int ledger_tail_forget_name(struct ledger_tail *tail, uint32_t round_id, uint32_t seat)
{
    struct slot slot;
    int result = 0;
    for (uint32_t i = 0; result == 0 && i < LEDGER_TAIL_SLOTS; i++) {
        struct ledger_entry *entry = &slot.entry;
        if (read_slot(tail, i, &slot) && entry->kind == LEDGER_NAME && entry->count == round_id &&
            entry->detail == seat && entry->name[0]) {
            memset(entry->name, 0, sizeof entry->name);
            result = write_slot(tail, entry);
        }
    }
    return result;
}

bool ledger_tail_entry(const struct ledger_tail *tail, uint32_t id, struct ledger_entry *out)
{
    struct slot slot;
    if (tail->handle == 0 || !read_slot(tail, id % LEDGER_TAIL_SLOTS, &slot) ||
        slot.entry.id != id) {
        return false;
    }
    *out = slot.entry;
    return true;
}

uint32_t ledger_tail_last_id(const struct ledger_tail *tail)
{
    struct slot slot;
    uint32_t last_id = 0;
    for (uint32_t i = 0; tail->handle > 0 && i < LEDGER_TAIL_SLOTS; i++) {
        if (read_slot(tail, i, &slot) && slot.entry.id > last_id) {
            last_id = slot.entry.id;
        }
    }
    return last_id;
}
