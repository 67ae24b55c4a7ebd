/* storage_internal.h -- the interface between the source files of the store, not for other
 * modules. */
#pragma once

#include "platform/store/storage.h"

/* ---- storage_open.c ------------------------------------------------------------------------ */

/* Opens the database storage->path. First replaces a damaged or missing database. Returns an SQLite
 * code. */
int storage_open_file(struct storage *storage);

/* Path of the database or of a file that belongs to the database. */
struct storage_path {
    char text[LEDGER_PATH_SIZE];
};
/* Returns the path of the database followed by `suffix` and `more`. */
struct storage_path storage_path(const struct storage *storage, const char *suffix,
                                 const char *more);
/* Suffixes of the files that belong to the database. */
#define STORAGE_SIBLING_COUNT 5u
extern const char *const storage_suffixes[STORAGE_SIBLING_COUNT];

/* Returns true if the path exists, or if an I/O error prevents the check. */
bool storage_has_path(const char *path);
/* Returns true if the file exists and is not empty. */
bool storage_has_bytes(const char *path);

/* Opens the ledger mirror for reading. The caller closes the returned mirror. */
struct ledger_mirror storage_inspect_mirror(const struct storage *storage);

/* Returns true if the backup belongs to the ledger of the open database and has more entries. The
 * open database has then lost entries. */
bool storage_is_behind_backup(struct storage *storage);

/* ---- storage_rebuild.c --------------------------------------------------------------------- */

/* Replaces a damaged database, or an absent database if `is_missing` is true. Returns an SQLite
 * code. After an error all files are unchanged. */
int storage_rebuild(struct storage *storage, bool is_missing);
/* Completes a replacement that a power cut interrupted. Returns an SQLite code. */
int storage_end_rebuilding(struct storage *storage);
/* Renames the backup or the mirror because it belongs to a foreign ledger. Returns 0, or -1 and
 * sets errno. */
int storage_quarantine_other(struct storage *storage, const char *suffix);
/* Used if no replacement can be made: reads the backup, the ledger mirror and the damaged database.
 * `refusal` is the SQLite code of the reason. The content that was read is displayed and never
 * written. Returns true if any content was read. */
bool storage_read_remnants(struct storage *storage, int refusal);

/* ---- storage_card.c ------------------------------------------------------------------------ */

/* Locks the folder and then opens the database as storage_open_file() does. */
int storage_open_exclusive(struct storage *storage);
void storage_unlock(struct storage *storage); /* Releases the lock of the folder. */
/* Returns true if the open database can be written. If the database was lost, first tries to open
 * the database again. */
bool storage_has_card(struct storage *storage);

/* Stores the SQLite code of a write. Closes the database if the code requires that the database is
 * opened again. */
void storage_note_write(struct storage *storage, int code);
/* Returns true if the database must be reopened after the SQLite code `code`. Other codes are
 * temporary errors. */
bool storage_needs_reopening(int code);

/* Returns true if the open database, its log or its folder is no longer at its path. */
bool storage_has_moved(struct storage *storage);
/* Saves a deleted database and all queued entries as a backup. Does nothing if a database or a
 * complete replacement of the database exists at the old path. If the folder was deleted too, a
 * backup or mirror in a new folder at the old path belongs to another ledger, and nothing is
 * saved. */
void storage_save_deleted(struct storage *storage);

/* ---- storage_thread.c ---------------------------------------------------------------------- */

/* The frame loop calls these functions of hal_storage. storage_append() queues a ledger entry, and
 * storage_store_edit() queues an edit of the growth lab. */
int storage_append(void *storage, const struct ledger_entry *entry);
int storage_store_edit(void *storage, const struct graph_edit_record *edit);

/* storage_unwritten() returns the number of queued entries. storage_unwritten_edits() returns the
 * number of queued edits. */
uint32_t storage_unwritten(const struct storage *storage);
uint32_t storage_unwritten_edits(const struct storage *storage);

/* Writes the newest entries to the ledger mirror. A failed write or sync is counted and reported,
 * and is retried every second. Returns 0. Returns -1 if the entries are not on disk in the mirror;
 * the caller must then not acknowledge the entries. */
int storage_mirror_write(struct storage *storage, const struct ledger_entry *entries,
                         uint32_t count);

/* Closes the database and aborts a backup that is in progress. */
void storage_close_file(struct storage *storage);
/* Thread function of the store. Runs until storage->stop is set. */
void *storage_thread(void *storage);

/* Returns the time of the monotonic clock in milliseconds, never 0. */
int64_t storage_now_ms(void);

/* ---- storage_requests.c -------------------------------------------------------------------- */

/* The replay functions of hal_storage, which the frame loop calls. */
int storage_store_replay(void *storage, uint32_t round_id, const uint8_t *bytes, size_t size);
uint32_t storage_stored_replay_id(void *storage);
int storage_fetch_replay(void *storage, uint32_t round_id, uint8_t *bytes, size_t size,
                         struct ledger_entry *round);
int storage_replay_fetched(void *storage);
bool storage_has_replay(void *storage, uint32_t round_id);
/* storage_put_replay() writes and storage_get_replay() reads the requested replay. The store's
 * thread calls both functions. */
void storage_put_replay(struct storage *storage);
void storage_get_replay(struct storage *storage);
/* Updates storage->sealed, which contains the ranked rounds that have a replay. Only the thread
 * that uses the database calls this function. */
void storage_update_sealed(struct storage *storage);

/* storage_merge_offline() and storage_offline_merged() implement functions of hal_storage. The
 * store's thread calls storage_apply_offline(), which writes the offline credits to the open
 * database. The function has an effect only if the kiosk started without a database. */
int storage_merge_offline(void *storage, const struct balance_change *step,
                          const struct ledger_entry *entries, uint32_t count);
int storage_offline_merged(void *storage);
void storage_apply_offline(struct storage *storage);
