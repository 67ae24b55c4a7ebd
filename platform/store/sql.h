/* sql.h -- the few things that every piece of SQL here needs. All return SQLite's result codes. */
#ifndef KINGYO_PLATFORM_STORE_SQL_H
#define KINGYO_PLATFORM_STORE_SQL_H

#include <stdint.h>

struct sqlite3;
struct sqlite3_stmt;

/* Opens a database with SQLite's defensive options: its schema is not trusted, triggers and views
 * never run, and only regular files are opened, the log and the journal included. `flags` are
 * SQLITE_OPEN_READONLY, or _READWRITE and possibly _CREATE; `vfs` may be null. A symbolic link in
 * place of the file is SQLITE_CANTOPEN. The caller closes `*out`, also after an error. */
int sql_open(const char *path, int flags, const char *vfs, struct sqlite3 **out);

/* The same for reading a file that nobody can write, without its log. */
int sql_open_unwritable(const char *path, struct sqlite3 **out);

/* Statements without results. */
int sql_run(struct sqlite3 *db, const char *text);

/* The first column of the first row; `out` is kept where there is no row. */
int sql_number(struct sqlite3 *db, const char *text, int64_t *out);

/* Binds the values to ?1, ?2, ... and runs it once. What else it wants is bound before. */
int sql_put(struct sqlite3_stmt *statement, const int64_t *values, int count);

/* The same for a statement that inserts or replaces one row. Returns SQLITE_CORRUPT if none was
 * stored. */
int sql_put_one(struct sqlite3_stmt *statement, const int64_t *values, int count);

/* What a column says, where 0 .. `max` are right; else 0. A file may hold anything. */
uint32_t sql_uint(struct sqlite3_stmt *statement, int column, uint32_t max);

/* A text column: at most `size` - 1 bytes, the rest of `out` zero. */
void sql_text(struct sqlite3_stmt *statement, int column, char *out, int size);

/* How a query's loop ended: the SQLITE_DONE that it ends with is SQLITE_OK. Finalizes it. */
int sql_end(struct sqlite3_stmt *statement, int code);

#endif
