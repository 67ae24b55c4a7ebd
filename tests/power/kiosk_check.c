/* kiosk_check.c -- simulates power cuts of a kiosk whose file calls failed, and checks the data
 * that are left.
 *
 * Usage: kiosk_check TAPE FOLDER SEED
 *
 * TAPE is the file with the recorded file operations of a kiosk run (kiosk_tape.h). The program
 * applies them to a simulated disk. The power is cut at random operations drawn from SEED, and at
 * the end. After each cut, the store opens the files in FOLDER. The loaded state must contain the
 * newest entry that the kiosk's status file had reported as saved.
 *
 * Prints the counts of cuts, entries, losses, duplicates, coins and failed calls. Returns exit
 * status 1 if an entry was lost or duplicated, or if a state cannot be opened. */
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include <sqlite3.h>

#include "core/base/rng.h"
#include "platform/os/number.h"
#include "platform/os/panic.h"
#include "platform/store/storage.h"
#include "tests/power/cutter.h"
#include "tests/power/disk.h"
#include "tests/power/kiosk_tape.h"

#define CUTS 8u

static struct storage store;
static struct persistent_state memory;
static struct disk disk;
static uint32_t found; /* Id of the newest ledger entry that was found after the last power cut. */

static int64_t query_number(sqlite3 *db, const char *query)
{
    sqlite3_stmt *statement = NULL;
    int64_t answer = -1;
    if (sqlite3_prepare_v2(db, query, -1, &statement, NULL) == SQLITE_OK &&
        sqlite3_step(statement) == SQLITE_ROW) {
        answer = sqlite3_column_int64(statement, 0);
    }
    sqlite3_finalize(statement);
    return answer;
}

/* Returns 1 if the ledger is consistent: no entry is missing or duplicated, and the totals match
 * the audits. `coins` is the number of inserted coins. Each coin is one credit, so neither the paid
 * credits nor the coins in the entries may exceed `coins`. The first id may be above 1 if the kiosk
 * started without a store. */
static bool is_sound(const char *folder, uint32_t coins)
{
    char path[600], query[200];
    sqlite3 *db = NULL;
    snprintf(path, sizeof path, "%.500s/" STORAGE_FILE, folder);
    snprintf(query, sizeof query, "SELECT coalesce(sum(count), 0) FROM entries WHERE kind = %d",
             LEDGER_COINS);
    int sound = sqlite3_open_v2(path, &db, SQLITE_OPEN_READWRITE, NULL) == SQLITE_OK;
    const int64_t in_entries = query_number(db, query);
    sound = sound &&
            query_number(db, "SELECT coalesce(max(id) - min(id) + 1, 0) - count(*) FROM entries") ==
                0 &&
            query_number(db, "SELECT coalesce(max(id), 0) FROM entries") ==
                (int64_t)memory.ledger.last_id &&
            memory.ledger.balance.paid <= coins &&
            in_entries == (int64_t)memory.audits.count[AUDIT_COINS_1] &&
            in_entries <= (int64_t)coins;
    sqlite3_close(db);
    return sound;
}

static void check_state(struct tally *tally, const char *folder, uint32_t acked, uint32_t coins,
                        size_t op)
{
    char where[60];
    snprintf(where, sizeof where, "op %zu, %u were reported", op, acked);
    memset(&memory, 0, sizeof memory);
    settings_reset(&memory.settings);
    store = (struct storage){ .dir = folder };
    const struct hal_storage device = storage_device(&store);
    const int opens = device.ledger.ops->open(device.ledger.self) == HAL_OK &&
                      atomic_load(&store.quarantined) == 0;
    if (!opens) {
        tally_complain(tally, &tally->unopenable, where,
                       device.ledger.ops->describe(device.ledger.self));
    } else {
        device.ledger.ops->load(device.ledger.self, &memory);
    }
    device.ledger.ops->close(device.ledger.self);
    found = memory.ledger.last_id;
    if (opens && found < acked) {
        tally_complain(tally, &tally->lost, where, "an entry that was reported is not there");
    } else if (opens && !is_sound(folder, coins)) {
        tally_complain(tally, &tally->ghosts, where, "an entry is there twice, or sums differ");
    }
}

static uint32_t draw(uint32_t seed, uint32_t index)
{
    return rng_u32((struct rng_key){ seed, index, 41u, RNG_TEST }) >> 8;
}

static uint32_t go_through(const struct kiosk_tape *map, const char *folder, uint32_t seed,
                           struct tally *tally)
{
    uint32_t acked = 0;
    const size_t count = map->tape.count, each = count / CUTS + 1u;
    size_t next = draw(seed, 0) % each;
    disk_open(&disk, &map->tape);
    for (size_t op = 0; op < count; op++) {
        const struct tape_op *what = &map->tape.ops[op];
        disk_step(&disk, op);
        if (what->kind == TAPE_ACKED && what->offset > acked) {
            acked = (uint32_t)what->offset;
        }
        if (op >= next || op + 1u == count) {
            const uint32_t index = (uint32_t)tally->cuts++ + 1u;
            disk_cut(&disk, (enum disk_luck)(draw(seed, index) % DISK_LUCK_COUNT), seed + index,
                     folder);
            check_state(tally, folder, acked, map->coins, op);
            next = op + 1u + draw(seed, index + 100u) % each;
        }
    }
    disk_close(&disk);
    return acked;
}

int main(int argc, char **argv)
{
    uint32_t seed = 0;
    struct tally tally = { 0 };
    if (argc != 4 || !number_parse(argv[3], 0, UINT32_MAX / 2u, &seed)) {
        fprintf(stderr, "usage: kiosk_check TAPE FOLDER SEED\n");
        return 2;
    }
    panic_prepare(NULL, NULL);
    struct kiosk_tape *map = kiosk_tape_map(argv[1]);
    mkdir(argv[2], 0755);
    if (!map) {
        fprintf(stderr, "kiosk_check: %s: cannot be mapped\n", argv[1]);
        return 74;
    }
    const uint32_t acked = go_through(map, argv[2], seed, &tally);
    printf("%llu %u %u %llu %llu %llu %u %u", (unsigned long long)tally.cuts, acked, found,
           (unsigned long long)tally.lost, (unsigned long long)tally.ghosts,
           (unsigned long long)tally.unopenable, map->coins, map->refusals);
    for (uint32_t i = 0; i < FAULT_CALL_COUNT; i++) {
        printf(" %llu", (unsigned long long)map->failed[i]);
    }
    printf("\n");
    if (tally.first[0]) {
        fprintf(stderr, "kiosk_check: %s\n", tally.first);
    }
    return tally.lost || tally.ghosts || tally.unopenable;
}
