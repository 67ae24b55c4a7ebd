/* sql.h -- SQL helper functions for the store. All functions that return int return SQLite result
 * codes. */
#pragma once

#include <stdbool.h>
#include <stdint.h>

struct sqlite3;
struct sqlite3_stmt;

/* Opens a database with SQLite's defensive options: the schema is not trusted, triggers and views
 * never run, and only regular files are opened, including the write-ahead log and the journal.
 * `flags` is SQLITE_OPEN_READONLY, or SQLITE_OPEN_READWRITE with an optional SQLITE_OPEN_CREATE.
 * `vfs` may be null. Returns an SQLite code, which is SQLITE_CANTOPEN if the file is a symbolic
 * link. The caller closes `*out`, also after an error. */
int sql_open(const char *path, int flags, const char *vfs, struct sqlite3 **out);

/* Opens a database read-only, without a lock and without reading its write-ahead log. The caller
 * guarantees that no process can write the database. */
int sql_open_unwritable(const char *path, struct sqlite3 **out);

/* Runs one or more statements that have no results. */
int sql_run(struct sqlite3 *db, const char *text);

/* Reads the first column of the first row of a query. Leaves `out` unchanged if there is no row. */
int sql_number(struct sqlite3 *db, const char *text, int64_t *out);

/* Binds `values` to the parameters ?1, ?2 and so on, and runs the statement once. The caller binds
 * all other parameters first. */
int sql_put(struct sqlite3_stmt *statement, const int64_t *values, int count);

/* Runs a statement that inserts or replaces one row. Works as sql_put(), but returns SQLITE_CORRUPT
 * if no row was stored. */
int sql_put_one(struct sqlite3_stmt *statement, const int64_t *values, int count);

/* Returns the value of a column if the value is in 0 .. `max`, otherwise 0. The check is necessary
 * because a file may contain any value. */
uint32_t sql_uint(struct sqlite3_stmt *statement, int column, uint32_t max);

/* Copies a text column: at most `size` - 1 bytes. Fills the rest of `out` with zeros. */
void sql_text(struct sqlite3_stmt *statement, int column, char *out, int size);

/* Reads the next row of a statement. `*code` is the result of the previous step, or of the
 * preparation of the statement. Returns true if there is a row. Otherwise returns false. `*code` is
 * then SQLITE_DONE after the last row, or the code of an error. */
bool sql_row(struct sqlite3_stmt *statement, int *code);

/* Finalizes a statement after a loop over its rows. `code` is the last result of sql_row().
 * Returns SQLITE_OK if `code` is SQLITE_DONE, otherwise `code`. */
int sql_end(struct sqlite3_stmt *statement, int code);

/* Ends a transaction: commits if `code` is SQLITE_OK, otherwise rolls back. Rolls back too if the
 * commit fails. Returns `code`, or the error of the commit. */
int sql_commit(struct sqlite3 *db, int code);

/* ---- Days and dates ------------------------------------------------------------------------ */

/* Converts between the days and minutes of the ledger and the calendar. */

#define SQL_DAY_TEXT_SIZE 11u

/* Local date and time in the units of input.day (days since 2000-01-01) and input.minute. `day` and
 * `minute` are 0 for an earlier or invalid time. */
struct sql_day {
    uint16_t day, minute;
};

/* Converts `unix_s`, seconds since 1970-01-01 UTC, to the local time of the machine. */
struct sql_day sql_day_of(int64_t unix_s);

/* Writes the date as "2026-11-21". Writes "-" if `day` is 0 (unknown). */
void sql_day_text(uint16_t day, char out[SQL_DAY_TEXT_SIZE]);
