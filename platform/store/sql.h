/* sql.h -- the few things that every piece of SQL here needs. All return SQLite's result codes. */
#ifndef KINGYO_PLATFORM_STORE_SQL_H
#define KINGYO_PLATFORM_STORE_SQL_H

#include <stdint.h>

struct sqlite3;
struct sqlite3_stmt;

/* Statements without results. */
int sql_run(struct sqlite3 *db, const char *text);

/* The first column of the first row; `out` is kept where there is no row. */
int sql_number(struct sqlite3 *db, const char *text, int64_t *out);

/* Binds the values to ?1, ?2, ... and runs it once. What else it wants is bound before. */
int sql_put(struct sqlite3_stmt *statement, const int64_t *values, int count);

/* What a column says, where 0 .. `max` are right; else 0. A file may hold anything. */
uint32_t sql_uint(struct sqlite3_stmt *statement, int column, uint32_t max);

/* A text column: at most `size` - 1 bytes, the rest of `out` zero. */
void sql_text(struct sqlite3_stmt *statement, int column, char *out, int size);

/* How a query's loop ended: the SQLITE_DONE that it ends with is SQLITE_OK. Finalizes it. */
int sql_end(struct sqlite3_stmt *statement, int code);

#endif
