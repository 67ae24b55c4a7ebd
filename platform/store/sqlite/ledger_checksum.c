/* ledger_checksum.c -- writes and verifies a checksum of each aggregate table.
 *
 * Without these checksums, a flipped bit in a setting, an audit or a score would not be detected,
 * because SQLite has no checksums. Each ledger entry has its own checksum. */
#include <sqlite3.h>

#include "core/base/hash.h"
#include "platform/store/sqlite/ledger_internal.h"
#include "platform/store/sqlite/sql.h"

/* SQL text for reading and writing each checksum, and for reading the rows that it covers. The
 * checksum of the audits is stored in the table of the audits, because both change with nearly
 * every entry. Writing one table saves one page per write. */
#define STATE_TALLY "SELECT value FROM state WHERE name = "
static const struct tally {
    const char *get, *put;
    const char *rows[2];
} tallies[] = {
    { .get = STATE_TALLY "'tally-settings'",
      .put = "INSERT OR REPLACE INTO state (name, value) VALUES ('tally-settings', ?1)",
      .rows = { "SELECT * FROM settings ORDER BY name" } },
    { .get = "SELECT count FROM audits WHERE name = 'tally'",
      .put = "INSERT OR REPLACE INTO audits (name, count) VALUES ('tally', ?1)",
      .rows = { "SELECT * FROM audits WHERE name <> 'tally' ORDER BY name" } },
    { .get = STATE_TALLY "'tally-ranking'",
      .put = "INSERT OR REPLACE INTO state (name, value) VALUES ('tally-ranking', ?1)",
      .rows = { "SELECT * FROM ranking ORDER BY mode, period, place",
                "SELECT * FROM state WHERE name NOT LIKE 'tally-%' ORDER BY name" } },
};
#define TALLY_COUNT (sizeof tallies / sizeof tallies[0])

static uint64_t hash_row(uint64_t hash, sqlite3_stmt *row)
{
    for (int column = 0; column < sqlite3_column_count(row); column++) {
        if (sqlite3_column_type(row, column) == SQLITE_INTEGER) {
            hash = hash_u64(hash, (uint64_t)sqlite3_column_int64(row, column));
        } else {
            const void *bytes = sqlite3_column_blob(row, column);
            const size_t size = (size_t)sqlite3_column_bytes(row, column);
            hash = hash_u64(hash, size);
            hash = bytes ? hash_bytes(hash, bytes, size) : hash;
        }
    }
    return hash;
}

static int hash_rows(sqlite3 *db, const char *text, uint64_t *hash)
{
    sqlite3_stmt *row = NULL;
    int code = sqlite3_prepare_v2(db, text, -1, &row, NULL);
    while ((code == SQLITE_OK || code == SQLITE_ROW) && (code = sqlite3_step(row)) == SQLITE_ROW) {
        *hash = hash_row(*hash, row);
    }
    return sql_end(row, code);
}

/* Computes the checksum of a table. The result is never 0, because 0 means that no checksum is
 * stored. */
static int add_up(sqlite3 *db, const struct tally *tally, int64_t *out)
{
    uint64_t hash = HASH_START;
    int code = hash_rows(db, tally->rows[0], &hash);
    if (code == SQLITE_OK && tally->rows[1]) {
        code = hash_rows(db, tally->rows[1], &hash);
    }
    *out = hash != 0 ? (int64_t)hash : 1;
    return code;
}

static int put(sqlite3 *db, const struct tally *tally, int64_t sum)
{
    sqlite3_stmt *statement = NULL;
    int code = sqlite3_prepare_v2(db, tally->put, -1, &statement, NULL);
    code = code == SQLITE_OK ? sql_put_one(statement, &sum, 1) : code;
    sqlite3_finalize(statement);
    return code;
}

int ledger_checksum_put(sqlite3 *db)
{
    int code = SQLITE_OK;
    for (size_t i = 0; code == SQLITE_OK && i < TALLY_COUNT; i++) {
        int64_t kept = 0, sum = 0;
        code = sql_number(db, tallies[i].get, &kept);
        code = code == SQLITE_OK ? add_up(db, &tallies[i], &sum) : code;
        if (code == SQLITE_OK && kept != sum) {
            code = put(db, &tallies[i], sum);
        }
    }
    return code;
}

/* Verifies one checksum. A file without a checksum is accepted, because a version of Kingyo without
 * checksums may have written the file last. */
static int ledger_checksum_compare(sqlite3 *db, const struct tally *tally)
{
    int64_t kept = 0, sum = 0;
    int code = sql_number(db, tally->get, &kept);
    code = code == SQLITE_OK ? add_up(db, tally, &sum) : code;
    return code == SQLITE_OK && kept != 0 && kept != sum ? SQLITE_CORRUPT : code;
}

int ledger_checksum_check(sqlite3 *db)
{
    int code = sql_run(db, "BEGIN"); /* The transaction prevents another program from writing
                                        between the read of the checksum and the read of its
                                        rows. */
    for (size_t i = 0; code == SQLITE_OK && i < TALLY_COUNT; i++) {
        code = ledger_checksum_compare(db, &tallies[i]);
    }
    sql_run(db, "ROLLBACK");
    return code;
}
