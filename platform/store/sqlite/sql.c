/* sql.c -- SQL helper functions; see sql.h. */
#include "platform/store/sqlite/sql.h"

#include <stdbool.h>
#include <string.h>

#include <sqlite3.h>

int sql_run(sqlite3 *db, const char *text)
{
    return sqlite3_exec(db, text, NULL, NULL, NULL);
}

int sql_number(sqlite3 *db, const char *text, int64_t *out)
{
    sqlite3_stmt *ask = NULL;
    int code = sqlite3_prepare_v2(db, text, -1, &ask, NULL);
    if (code == SQLITE_OK) {
        code = sqlite3_step(ask);
        if (code == SQLITE_ROW) {
            *out = sqlite3_column_int64(ask, 0);
        }
        code = code == SQLITE_ROW || code == SQLITE_DONE ? SQLITE_OK : code;
    }
    sqlite3_finalize(ask);
    return code;
}

int sql_put(sqlite3_stmt *statement, const int64_t *values, int count)
{
    for (int i = 0; i < count; i++) {
        sqlite3_bind_int64(statement, i + 1, values[i]);
    }
    const int code = sqlite3_step(statement);
    sqlite3_reset(statement);
    return code == SQLITE_DONE ? SQLITE_OK : code;
}

int sql_put_one(sqlite3_stmt *statement, const int64_t *values, int count)
{
    const int code = sql_put(statement, values, count);
    const bool is_in = sqlite3_changes64(sqlite3_db_handle(statement)) == 1;
    return code == SQLITE_OK && !is_in ? SQLITE_CORRUPT : code;
}

uint32_t sql_uint(sqlite3_stmt *statement, int column, uint32_t max)
{
    const int64_t value = sqlite3_column_int64(statement, column);
    return value < 0 || value > (int64_t)max ? 0u : (uint32_t)value;
}

void sql_text(sqlite3_stmt *statement, int column, char *out, int size)
{
    const unsigned char *text = sqlite3_column_text(statement, column);
    memset(out, 0, (size_t)size);
    for (int i = 0; text && i < size - 1 && text[i]; i++) {
        out[i] = (char)text[i];
    }
}

int sql_end(sqlite3_stmt *statement, int code)
{
    sqlite3_finalize(statement);
    return code == SQLITE_DONE ? SQLITE_OK : code;
}
