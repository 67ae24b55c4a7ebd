/* file_tail.c -- fuzz target: arbitrary bytes as the ledger mirror file. The accepted entries are
 * recovered into an empty database, and a game starts with the content of that database.
 *
 * Input: a byte, and the data. If the byte is odd, the data is the raw content of the file.
 * Otherwise the data is images of struct ledger_entry, which the store's own code writes to the
 * file with correct checksums. */
#include <fcntl.h>
#include <string.h>
#include <unistd.h>

#include <sqlite3.h>

#include "platform/store/sqlite/ledger_recovery.h"
#include "tests/fuzz/scratch.h"
#include "tests/fuzz/try_game.h"
#include "tests/fuzz/trap.h"

#define ENTRIES_MAX 16u
#define TICKS 3u

static const struct ledger_file_options how = { .journal = "MEMORY OFF" };
static char path[SCRATCH_PATH_SIZE], salvaged_path[SCRATCH_PATH_SIZE];

static void put_raw(const uint8_t *bytes, size_t size)
{
    const int file = open(path, O_WRONLY | O_CLOEXEC);
    HOLD(file >= 0 && pwrite(file, bytes, size, LEDGER_MIRROR_SLOT_SIZE) == (ssize_t)size);
    close(file);
}

static void put_entries(const uint8_t *bytes, size_t size)
{
    static struct ledger_entry entries[ENTRIES_MAX];
    struct ledger_mirror tail;
    uint32_t count = 0;
    for (; count < ENTRIES_MAX && (count + 1u) * sizeof entries[0] <= size; count++) {
        memcpy(&entries[count], bytes + count * sizeof entries[0], sizeof entries[0]);
        /* Replaces id 0 by 1, because the store asserts that ids begin at 1. */
        entries[count].id += entries[count].id == 0;
    }
    HOLD(ledger_mirror_open(&tail, path) == 0);
    HOLD(ledger_mirror_write(&tail, entries, count) == 0);
    ledger_mirror_close(&tail);
}

static void make_file(const uint8_t *bytes, size_t size)
{
    if (!path[0]) {
        scratch_path(path, "kingyo.db.tail");
        scratch_path(salvaged_path, "kingyo.db");
    }
    scratch_put(path, "", 0);
    HOLD(truncate(path, (off_t)LEDGER_MIRROR_SLOTS * LEDGER_MIRROR_SLOT_SIZE) == 0);
    if (bytes[0] & 1u) {
        put_raw(bytes + 1, size - 1u);
    } else {
        put_entries(bytes + 1, size - 1u);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    struct ledger_file file;
    struct ledger_recovered salvaged;
    struct ledger_entry entry;
    struct persistent_state memory = { 0 };
    if (size == 0) {
        return 0;
    }
    make_file(bytes, size);
    struct ledger_mirror tail = ledger_mirror_inspect(path);
    const uint32_t last_id = ledger_mirror_last_id(&tail);
    HOLD(tail.handle > 0);
    HOLD(last_id == 0 || (ledger_mirror_entry(&tail, last_id, &entry) && entry.id == last_id));
    scratch_put(salvaged_path, "", 0);
    HOLD(ledger_file_open(&file, salvaged_path, &how) == SQLITE_OK);
    HOLD(ledger_recover(NULL, &tail, &file, &salvaged) == SQLITE_OK);
    HOLD(salvaged.entries <= LEDGER_MIRROR_SLOTS && (salvaged.entries > 0) == (last_id > 0));
    ledger_content_load(&file.content, &memory);
    HOLD(ledger_file_entry(&file, last_id, &entry) == (last_id ? SQLITE_OK : SQLITE_NOTFOUND));
    ledger_file_close(&file);
    ledger_mirror_close(&tail);
    try_game_persistent(&memory, TICKS);
    return 0;
}
