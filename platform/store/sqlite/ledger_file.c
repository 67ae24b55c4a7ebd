/* ledger_file.c -- writes entries to the open database in transactions; ledger_open.c opens the
 * database. */
#include "platform/store/sqlite/ledger_file.h"

#include <sqlite3.h>

#include "platform/store/sqlite/ledger_internal.h"
#include "platform/store/sqlite/sql.h"

int ledger_statement(struct ledger_file *file, enum ledger_statement which, sqlite3_stmt **out)
{
    int code = SQLITE_OK;
    if (!file->statement[which]) {
        code = sqlite3_prepare_v3(file->db, ledger_statement_text(which), -1,
                                  SQLITE_PREPARE_PERSISTENT, &file->statement[which], NULL);
    }
    *out = file->statement[which];
    return code;
}

void ledger_file_close(struct ledger_file *file)
{
    ledger_log_before_close(file);
    for (uint32_t i = 0; i < LEDGER_STATEMENT_COUNT; i++) {
        sqlite3_finalize(file->statement[i]);
    }
    sqlite3_close(file->db);
    *file = (struct ledger_file){ 0 };
}

/* ---- Writing ------------------------------------------------------------------------------- */

static int put_entries(struct ledger_file *file, const struct ledger_entry *entries, uint32_t count,
                       struct ledger_content *after)
{
    int code = SQLITE_OK;
    for (uint32_t i = 0; code == SQLITE_OK && i < count; i++) {
        if (entries[i].id > after->memory.ledger.last_id) {
            code = ledger_rows_put(file, &entries[i]);
            ledger_aggregates_note(after, &entries[i]);
        }
    }
    return code == SQLITE_OK ? ledger_aggregates_put(file, &file->content, after) : code;
}

/* Rolls back and reads the content again, because the entries may have been written in spite of the
 * error, or by another program. The content that this connection reads never includes a transaction
 * whose sync failed. */
static int undo(struct ledger_file *file, int code)
{
    sql_run(file->db, "ROLLBACK");
    struct ledger_content found;
    if (ledger_aggregates_read(file, &found) == SQLITE_OK) {
        file->content = found;
    }
    return code;
}

int ledger_file_write(struct ledger_file *file, const struct ledger_entry *entries, uint32_t count)
{
    struct ledger_content after = file->content;
    int code = file->is_suspect ? ledger_log_secure(file) : SQLITE_OK;
    code = code == SQLITE_OK ? sql_run(file->db, "BEGIN IMMEDIATE") : code;
    if (code != SQLITE_OK) {
        return code;
    }
    code = put_entries(file, entries, count, &after);
    code = code == SQLITE_OK ? sql_run(file->db, "COMMIT") : code;
    if (code != SQLITE_OK) {
        return undo(file, code);
    }
    file->content = after;
    return ledger_log_result(file, SQLITE_OK);
}

/* ---- Content and errors -------------------------------------------------------------------- */

void ledger_content_load(const struct ledger_content *content, struct persistent_state *out)
{
    const struct persistent_state *memory = &content->memory;
    out->ledger = memory->ledger;
    out->audits = memory->audits;
    out->ranking = memory->ranking;
    for (uint32_t id = 0; id < SETTING_COUNT; id++) {
        if (content->has_setting[id]) {
            out->settings.value[id] = memory->settings.value[id];
        }
    }
}

const char *ledger_file_error(int code)
{
    return code == LEDGER_FILE_NEWER     ? "a later Kingyo wrote it"
           : code == LEDGER_FILE_LOCKED  ? "another Kingyo has it open"
           : code == LEDGER_FILE_MOVED   ? "was removed or replaced while it was open"
           : code == LEDGER_FILE_LINK    ? "is a symbolic link, not a file"
           : code == LEDGER_FILE_FOREIGN ? "not the card that it began with"
                                         : sqlite3_errstr(code);
}
