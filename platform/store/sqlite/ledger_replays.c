/* ledger_replays.c -- stores the replays of ranked rounds and deletes old data. */
#include <stdio.h>
#include <string.h>

#include <sqlite3.h>

#include "platform/store/sqlite/ledger_internal.h"
#include "platform/store/sqlite/sql.h"

/* SQL text that deletes old data. Entries are deleted in large groups, so that most calls write
 * nothing. */
static const char prune[] =
    "BEGIN IMMEDIATE;"
    "DELETE FROM replays WHERE round NOT IN (SELECT round FROM ranking WHERE caught > 0);"
    "DELETE FROM entries WHERE id + 32768 <= (SELECT max(id) FROM entries) AND"
    " (SELECT max(id) - min(id) FROM entries) >= 32768 + 256;"
    "DELETE FROM round_players WHERE round <="
    " (SELECT entry FROM rounds ORDER BY entry DESC LIMIT 1 OFFSET 65536)"
    " AND round NOT IN (SELECT round FROM ranking);"
    "DELETE FROM rounds WHERE entry <="
    " (SELECT entry FROM rounds ORDER BY entry DESC LIMIT 1 OFFSET 65536)"
    " AND entry NOT IN (SELECT round FROM ranking);"
    "COMMIT";

_Static_assert(LEDGER_FILE_ENTRIES == 32768u && LEDGER_FILE_ROUNDS == 65536u, "as prune says");

int ledger_file_prune(struct ledger_file *file)
{
    const int code = sql_run(file->db, prune);
    if (code != SQLITE_OK) {
        sql_run(file->db, "ROLLBACK");
    }
    return ledger_log_result(file, code);
}

int ledger_file_put_replay(struct ledger_file *file, uint32_t round_id, const void *bytes,
                           size_t size)
{
    const int64_t round = round_id;
    sqlite3_stmt *put = NULL;
    int code = ledger_statement(file, PUT_REPLAY, &put);
    if (code == SQLITE_OK) {
        sqlite3_bind_blob64(put, 2, bytes, size, SQLITE_STATIC);
        code = sql_put_one(put, &round, 1);
        sqlite3_clear_bindings(put);
    }
    return ledger_log_result(file, code);
}

int ledger_file_get_replay(struct ledger_file *file, uint32_t round_id, void *bytes, size_t size,
                           size_t *size_out)
{
    sqlite3_stmt *get = NULL;
    int code = ledger_statement(file, GET_REPLAY, &get);
    if (code != SQLITE_OK) {
        return code;
    }
    sqlite3_bind_int64(get, 1, round_id);
    code = sqlite3_step(get);
    if (code == SQLITE_ROW) {
        const void *blob = sqlite3_column_blob(get, 0);
        *size_out = (size_t)sqlite3_column_bytes(get, 0);
        code = *size_out > size ? SQLITE_TOOBIG : blob ? SQLITE_OK : SQLITE_NOMEM;
        if (code == SQLITE_OK) {
            memcpy(bytes, blob, *size_out);
        }
    } else if (code == SQLITE_DONE) {
        code = SQLITE_NOTFOUND;
    }
    sqlite3_reset(get);
    return code;
}

int ledger_file_next_replay(struct ledger_file *file, uint32_t round_id, uint32_t *out)
{
    char text[120];
    int64_t next = 0;
    snprintf(text, sizeof text,
             "SELECT coalesce(min(round), 0) FROM replays WHERE round > %u AND round <= %u",
             round_id, UINT32_MAX);
    const int code = sql_number(file->db, text, &next);
    *out = (uint32_t)next;
    return code == SQLITE_OK && next == 0 ? SQLITE_NOTFOUND : code;
}

int ledger_file_renew_replay(struct ledger_file *file, uint32_t round_id, const void *bytes,
                             size_t size)
{
    int code = sql_run(file->db, "PRAGMA secure_delete = ON; BEGIN IMMEDIATE");
    if (code != SQLITE_OK) {
        return code;
    }
    code = ledger_pin_mark(file);
    code = code == SQLITE_OK ? ledger_file_put_replay(file, round_id, bytes, size) : code;
    code = code == SQLITE_OK ? ledger_checksum_put(file->db) : code;
    code = code == SQLITE_OK ? sql_run(file->db, "COMMIT") : code;
    if (code != SQLITE_OK) {
        sql_run(file->db, "ROLLBACK");
    }
    return ledger_log_result(file, code);
}

int ledger_file_has_replay(struct ledger_file *file, uint32_t round_id)
{
    sqlite3_stmt *has = NULL;
    if (ledger_statement(file, HAS_REPLAY, &has) != SQLITE_OK) {
        return 0;
    }
    sqlite3_bind_int64(has, 1, round_id);
    const int code = sqlite3_step(has);
    sqlite3_reset(has);
    return code == SQLITE_ROW;
}
