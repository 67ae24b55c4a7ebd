/* storage_tail.c -- what was just written, written once more, before the kiosk is told of it. */
#include <unistd.h>

#include "platform/storage_parts.h"

/* One of another list, as after a card was copied by hand: it must not be read into this one. */
static bool is_of_another_list(const struct storage *storage)
{
    struct ledger_entry entry;
    return ledger_tail_entry(&storage->tail, atomic_load(&storage->saved_id), &entry) &&
           (entry.boot != storage->saved_boot || entry.tick != storage->saved_tick);
}

static int open_tail(struct storage *storage)
{
    char path[LEDGER_PATH_SIZE];
    storage_tail_path(storage, path);
    int result = ledger_tail_open(&storage->tail, path);
    if (result == 0 && is_of_another_list(storage)) {
        ledger_tail_close(&storage->tail);
        unlink(path);
        result = ledger_tail_open(&storage->tail, path);
    }
    return result;
}

void storage_write_tail(struct storage *storage, const struct ledger_entry *entries, uint32_t count)
{
    if (storage->how.vfs) {
        return;
    }
    int result = storage->tail.handle > 0 ? 0 : open_tail(storage);
    result = result == 0 ? ledger_tail_write(&storage->tail, entries, count) : result;
    if (result != 0) {
        ledger_tail_close(&storage->tail);
        atomic_fetch_add(&storage->refused, 1);
    }
}
