/* storage_parts.h -- what the pieces of the store have of each other, and nobody else. */
#ifndef KINGYO_PLATFORM_STORAGE_PARTS_H
#define KINGYO_PLATFORM_STORAGE_PARTS_H

#include "platform/storage.h"

/* storage_open.c: opens storage->path; a damaged file is replaced first. SQLite's code. */
int storage_open_file(struct storage *storage);
void storage_backup_path(const struct storage *storage, char out[LEDGER_PATH_SIZE]);
/* Whether the backup has newer entries than the open file: then it is the file that lost some. */
bool storage_is_behind_backup(struct storage *storage);

/* storage_thread.c: the file, and a backup of it that is under way. */
void storage_close_file(struct storage *storage);
/* Until storage->stop. */
void *storage_thread(void *storage);

int64_t storage_now_ms(void); /* Monotonic, never 0. */

/* Looks which of the ranked rounds have a replay; by whoever has the file. */
void storage_note_seals(struct storage *storage);

/* How many of each wait. */
uint32_t storage_unwritten(const struct storage *storage);
uint32_t storage_unwritten_edits(const struct storage *storage);

#endif
