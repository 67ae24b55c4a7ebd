/* file_entries.c -- fuzz target: a ledger database whose rows have arbitrary values and correct
 * checksums. The store must either reject the database, or read each entry back and start a game
 * with the sums of the rows. In both cases all readable entries are also recovered into an empty
 * database.
 *
 * Input: a number of cells, the cells of 12 bytes each (column, row, type, unused, value), and
 * images of struct ledger_entry. */
#include <stdio.h>
#include <string.h>

#include <sqlite3.h>

#include "platform/store/sqlite/ledger_file.h"
#include "platform/store/sqlite/ledger_recovery.h"
#include "platform/store/sqlite/sql.h"
#include "tests/fuzz/scratch.h"
#include "tests/fuzz/try_game.h"
#include "tests/fuzz/trap.h"

#define ENTRIES_MAX 12u
#define CELLS_MAX 8u
#define CELL_SIZE 12u
/* Largest entry id. The recovery queries each id up to the newest one, so this limit keeps the
 * recovery fast. */
#define IDS_MAX 1024u
#define TICKS 3u

/* SQL statement that sets `column` in one row of a table. The row is selected by its position (?2),
 * because these tables have no row ids. */
#define ROW_OF(table, column)                                                                      \
    table " SET " column " = ?1 WHERE name = (SELECT name FROM " table " LIMIT 1 OFFSET ?2)"
#define SETTING_OF(column) ROW_OF("settings", column)
#define AUDIT_OF(column) ROW_OF("audits", column)
#define STATE_OF(column) ROW_OF("state", column)

static const struct ledger_file_options how = { .journal = "MEMORY OFF" };
static char path[SCRATCH_PATH_SIZE], salvaged_path[SCRATCH_PATH_SIZE];

/* Overwrites one cell of a table with a value of any SQL type. */
static void put_cell(sqlite3 *db, const uint8_t *cell)
{
    /* clang-format off */
    static const char *const places[] = {
        "entries SET kind = ?1 WHERE id = ?2",       "entries SET detail = ?1 WHERE id = ?2",
        "entries SET count = ?1 WHERE id = ?2",      "entries SET paid = ?1 WHERE id = ?2",
        "entries SET name = ?1 WHERE id = ?2",       "entries SET sum = ?1 WHERE id = ?2",
        "entries SET value = ?1 WHERE id = ?2",      "rounds SET mode = ?1 WHERE entry = ?2",
        "rounds SET caught = ?1 WHERE entry = ?2",   "round_players SET seat = ?1 WHERE seat = ?2",
        SETTING_OF("value"),                         SETTING_OF("name"),
        AUDIT_OF("count"),                           "ranking SET caught = ?1 WHERE place = ?2",
        "ranking SET seat = ?1 WHERE place = ?2",    "ranking SET name = ?1 WHERE place = ?2",
        STATE_OF("value"),
    };
    /* clang-format on */
    char text[128];
    sqlite3_stmt *put = NULL;
    int64_t value;
    memcpy(&value, cell + 4, sizeof value);
    snprintf(text, sizeof text, "UPDATE OR IGNORE %s",
             places[cell[0] % (sizeof places / sizeof places[0])]);
    if (sqlite3_prepare_v2(db, text, -1, &put, NULL) != SQLITE_OK) {
        return; /* The current schema has no such column. */
    }
    switch (cell[2] % 4u) {
    case 0:
        sqlite3_bind_int64(put, 1, value);
        break;
    case 1:
        sqlite3_bind_text(put, 1, (const char *)cell + 4, 8, SQLITE_TRANSIENT);
        break;
    case 2:
        sqlite3_bind_blob(put, 1, cell + 4, 8, SQLITE_TRANSIENT);
        break;
    default:
        sqlite3_bind_double(put, 1, (double)value / 256.0);
        break;
    }
    sqlite3_bind_int64(put, 2, cell[1]);
    sqlite3_step(put);
    sqlite3_finalize(put);
}

static void put_rows(struct ledger_file *file, const uint8_t *bytes, size_t size)
{
    const uint32_t cell_count = bytes[0] % (CELLS_MAX + 1u);
    size_t at = 1u + cell_count * CELL_SIZE;
    HOLD(sql_run(file->db, "BEGIN") == SQLITE_OK);
    for (uint32_t i = 0; i < ENTRIES_MAX && at + sizeof(struct ledger_entry) <= size; i++) {
        struct ledger_entry entry;
        memcpy(&entry, bytes + at, sizeof entry);
        at += sizeof entry;
        /* Maps the id to 1 .. IDS_MAX, because the store asserts that ids begin at 1. */
        entry.id = 1u + entry.id % IDS_MAX;
        /* The return value is ignored, because the database rejects a second entry with the same
         * id. */
        ledger_rows_put(file, &entry);
    }
    for (uint32_t i = 0; i < cell_count && 1u + (i + 1u) * CELL_SIZE <= size; i++) {
        put_cell(file->db, bytes + 1 + i * CELL_SIZE);
    }
    HOLD(ledger_checksum_put(file->db) == SQLITE_OK);
    HOLD(sql_run(file->db, "COMMIT") == SQLITE_OK);
}

static void start_game(const struct ledger_content *content)
{
    struct persistent_state memory = { 0 };
    ledger_content_load(content, &memory);
    try_game_persistent(&memory, TICKS);
}

/* Recovers all readable entries of the damaged database into a new database. Checks that the store
 * can open the new database. */
static void hold_salvage(void)
{
    static const struct ledger_mirror none;
    struct ledger_file to;
    struct ledger_recovered salvaged;
    scratch_put(salvaged_path, "", 0);
    HOLD(ledger_file_open(&to, salvaged_path, &how) == SQLITE_OK);
    HOLD(ledger_recover(path, &none, &to, &salvaged) == SQLITE_OK);
    HOLD(ledger_check(to.db) == SQLITE_OK);
    start_game(&to.content);
    ledger_file_close(&to);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t size)
{
    struct ledger_file file;
    struct ledger_entry entry;
    if (size == 0) {
        return 0;
    }
    if (!path[0]) {
        scratch_path(path, "kingyo.db");
        scratch_path(salvaged_path, "salvaged.db");
    }
    scratch_put(path, "", 0);
    HOLD(ledger_file_open(&file, path, &how) == SQLITE_OK);
    put_rows(&file, bytes, size);
    ledger_file_close(&file);
    if (ledger_file_open(&file, path, &how) == SQLITE_OK) {
        for (uint32_t id = 0; id < ENTRIES_MAX; id++) {
            ledger_file_round(&file, id, &entry);
        }
        start_game(&file.content);
        ledger_file_close(&file);
    }
    hold_salvage();
    return 0;
}
