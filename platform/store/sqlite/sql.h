/* sql.h -- SQL helpers for the store. All functions that return int return SQLite result codes. */
#ifndef KINGYO_PLATFORM_STORE_SQLITE_SQL_H
#define KINGYO_PLATFORM_STORE_SQLITE_SQL_H

#include <stdint.h>

struct sqlite3;
struct sqlite3_stmt;

/* Opens a database with SQLite's defensive options: its schema is not trusted, triggers and views
 * never run, and only regular files are opened, including the log and the journal. `flags` are
 * SQLITE_OPEN_READONLY, or _READWRITE and possibly _CREATE; `vfs` may be null. Returns
 * SQLITE_CANTOPEN for a symbolic link in place of the file. The caller closes `*out`, also after an
 * error. */
int sql_open(const char *path, int flags, const char *vfs, struct sqlite3 **out);

/* Opens a file that no process can write, for reading without its log. */
int sql_open_unwritable(const char *path, struct sqlite3 **out);

/* Runs statements without results. */
int sql_run(struct sqlite3 *db, const char *text);

/* Reads the first column of the first row. `out` is unchanged if there is no row. */
int sql_number(struct sqlite3 *db, const char *text, int64_t *out);

/* Binds the values to ?1, ?2, ... and runs the statement once. The caller binds any other
 * parameters first. */
int sql_put(struct sqlite3_stmt *statement, const int64_t *values, int count);

/* Runs a statement that inserts or replaces one row, as sql_put(). Returns SQLITE_CORRUPT if no row
 * was stored. */
int sql_put_one(struct sqlite3_stmt *statement, const int64_t *values, int count);

/* Returns the value of a column if it is in 0 .. `max`, else 0, because a file may contain
 * anything. */
uint32_t sql_uint(struct sqlite3_stmt *statement, int column, uint32_t max);

/* Copies a text column: at most `size` - 1 bytes, the rest of `out` zero. */
void sql_text(struct sqlite3_stmt *statement, int column, char *out, int size);

/* Finalizes a statement after its row loop. Returns SQLITE_OK if `code` is SQLITE_DONE, else the
 * error. */
int sql_end(struct sqlite3_stmt *statement, int code);

#endif
