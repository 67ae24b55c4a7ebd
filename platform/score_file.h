/* score_file.h -- the SQLite file of finished rounds: its tables, their versions, rows in and out.
 *
 * A round and its players are written in one transaction, on disk when the call comes back. A file
 * of an earlier version is brought up to this one when it is opened, in one transaction too: a
 * power cut leaves the old file or the new one. One thread at a time. */
#ifndef KINGYO_PLATFORM_SCORE_FILE_H
#define KINGYO_PLATFORM_SCORE_FILE_H

#include <stdint.h>

#include "core/output.h"
#include "core/scene.h"

struct sqlite3;
struct sqlite3_stmt;

/* The file's `user_version`. 1 (written as 0): a row a round. 2: modes, grades, players. */
#define SCORE_FILE_VERSION 2

/* All else that is returned here is SQLite's result code, SQLITE_OK (0) for success. */
#define SCORE_FILE_NEWER (-1) /* A later Kingyo wrote it: it is left as it is. */

/* The caller owns it; zero is closed. */
struct score_file {
    struct sqlite3 *db;
    struct sqlite3_stmt *insert_round, *insert_player;
};

/* Opens or makes the file, looks whether it is whole, and brings it up to date. On an error `file`
 * is closed. SQLITE_CORRUPT and SQLITE_NOTADB: it is damaged. */
int score_file_open(struct score_file *file, const char *path);

/* The most that one person caught in one round since midnight, in each mode. */
int score_file_best_today(struct score_file *file, uint32_t best[MODE_COUNT]);

/* `ended_s` is Unix time. After an error nothing of the round is in the file. */
int score_file_write(struct score_file *file, const struct round_record *record, int64_t ended_s);

void score_file_close(struct score_file *file);

/* In words, for any of the above. */
const char *score_file_error(int code);

#endif
