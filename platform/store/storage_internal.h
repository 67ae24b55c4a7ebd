/* storage_internal.h -- the interface between the source files of the store, not for other
 * modules. */
#ifndef KINGYO_PLATFORM_STORE_STORAGE_INTERNAL_H
#define KINGYO_PLATFORM_STORE_STORAGE_INTERNAL_H

#include "platform/store/storage.h"

/* storage_open.c: opens the database storage->path. First replaces a damaged or missing database.
 * Returns an SQLite code. */
int storage_open_file(struct storage *storage);
/* Writes the path of the database followed by `suffix` and `more` to `out`. */
void storage_sibling_path(const struct storage *storage, const char *suffix, const char *more,
                          char out[LEDGER_PATH_SIZE]);
/* Suffixes of the files that belong to the database. */
#define STORAGE_SIBLING_COUNT 5u
extern const char *const storage_suffixes[STORAGE_SIBLING_COUNT];

/* Returns true if the path exists, or if an I/O error prevents the check. */
bool storage_has_path(const char *path);

/* Opens the ledger mirror for reading. The caller closes the returned mirror. */
struct ledger_mirror storage_inspect_mirror(const struct storage *storage);

/* storage_backup_path() writes the path of the backup. storage_mirror_path() writes the path of the
 * ledger mirror. */
void storage_backup_path(const struct storage *storage, char out[LEDGER_PATH_SIZE]);
void storage_mirror_path(const struct storage *storage, char out[LEDGER_PATH_SIZE]);
/* Returns true if the backup belongs to the ledger of the open database and has more entries. The
 * open database has then lost entries. */
bool storage_is_behind_backup(struct storage *storage);

/* storage_rebuild.c: replaces a damaged database, or an absent database if `is_missing` is true.
 * Returns an SQLite code. After an error all files are unchanged. */
int storage_rebuild(struct storage *storage, bool is_missing);
/* Completes a replacement that a power cut interrupted. Returns an SQLite code. */
int storage_end_rebuilding(struct storage *storage);
/* Renames the backup or the mirror because it belongs to a foreign ledger. Returns 0, or -1 and
 * sets errno. */
int storage_quarantine_other(struct storage *storage, const char *suffix);
/* Reads the backup, the ledger mirror and the damaged database if no replacement can be made.
 * `refusal` is the SQLite code of the reason. The read content is displayed and never written.
 * Returns true if any content was read. */
bool storage_read_remnants(struct storage *storage, int refusal);

/* storage_card.c: locks the folder and then opens the database as storage_open_file() does. */
int storage_open_exclusive(struct storage *storage);
void storage_unlock(struct storage *storage); /* Releases the lock of the folder. */
/* Returns true if the open database can be written. If the database was lost, first tries to open
 * it again. */
bool storage_has_card(struct storage *storage);

/* Stores the SQLite code of a write, or of an attempt to open the database. If the code is an
 * error, counts a failed write. */
void storage_note_result(struct storage *storage, int code);
/* Stores the SQLite code of a write. Closes the database if it must be reopened after this code. */
void storage_note_write(struct storage *storage, int code);
/* Returns true if the database must be reopened after the SQLite code `code`. Other codes are
 * temporary errors. */
bool storage_needs_reopening(int code);

/* storage_card.c: clears the stored identities of the monitored files. Called after a database was
 * opened. */
void storage_note_place(struct storage *storage);
/* Returns true if the open database, its log or its folder is no longer at its path. */
bool storage_has_moved(struct storage *storage);
/* Writes entries to the open database. Returns an SQLite code, or LEDGER_FILE_MOVED if the database
 * has moved during the write. */
int storage_write_entries(struct storage *storage, const struct ledger_entry *entries,
                          uint32_t count);
/* Returns true if the store may open the file that is now at the database's path, in place of the
 * database that moved. */
bool storage_may_follow(struct storage *storage);
/* storage_mark_log_removed() logs which file or folder has moved. storage_restore_log() logs that
 * the store uses a database again. */
void storage_mark_log_removed(const struct storage *storage);
void storage_restore_log(const struct storage *storage);
/* Saves a deleted database and all queued entries as a backup. Does nothing if a database, backup
 * or mirror exists at the old path. Returns true if the backup was written. */
bool storage_save_deleted(struct storage *storage);

/* storage_requests.c: storage_merge_offline() and storage_offline_merged() implement functions of
 * hal_storage. The store's thread calls storage_apply_offline(), which writes the offline credits
 * to the open database. The function has an effect only if the kiosk started without a database. */
int storage_merge_offline(void *storage, const struct balance_change *step,
                          const struct ledger_entry *entries, uint32_t count);
int storage_offline_merged(void *storage);
void storage_apply_offline(struct storage *storage);

/* storage.c: each function writes the status text to storage->text. storage_describe()
 * also returns the text. */
void storage_log(struct storage *storage, const char *what, const char *why, const char *advice);
void storage_log_no_file(struct storage *storage, const char *why);
void storage_log_refused(struct storage *storage, int error, const char *advice);
const char *storage_describe(void *storage);

/* storage.c: returns how long the card has not responded, in milliseconds. Returns 0 if the time is
 * less than STORAGE_STUCK_MS. */
int64_t storage_stuck_ms(const struct storage *storage);

/* storage_thread.c: writes the newest entries to the ledger mirror. A failed write or sync is
 * counted and reported, and is retried every second. Returns 0. Returns -1 if the entries are not
 * on disk in the mirror; the caller must then not acknowledge them. */
int storage_mirror_write(struct storage *storage, const struct ledger_entry *entries,
                         uint32_t count);

/* Copies missing entries from the database to the ledger mirror after a failed write. Does nothing
 * while an entry waits in the queue. */
void storage_mirror_repair(struct storage *storage);

/* storage_thread.c: closes the database and aborts a backup that is in progress. */
void storage_close_file(struct storage *storage);
/* Closes a database that was opened on a full card, because other programs cannot read the database
 * while it is open. */
void storage_share_file(struct storage *storage);
/* Thread function of the store. Runs until storage->stop is set. */
void *storage_thread(void *storage);

int64_t storage_now_ms(void); /* Returns the time of the monotonic clock in milliseconds, never
                                 0. */

/* storage_requests.c: the replay functions of hal_storage. The frame loop calls them. */
int storage_store_replay(void *storage, uint32_t round_id, const uint8_t *bytes, size_t size);
uint32_t storage_stored_replay_id(void *storage);
int storage_fetch_replay(void *storage, uint32_t round_id, uint8_t *bytes, size_t size,
                         struct ledger_entry *round);
int storage_replay_fetched(void *storage);
int storage_has_replay(void *storage, uint32_t round_id);
/* storage_put_replay() writes and storage_get_replay() reads the requested replay. The store's
 * thread calls both functions. */
void storage_put_replay(struct storage *storage);
void storage_get_replay(struct storage *storage);
/* Updates storage->sealed, the list of ranked rounds that have a replay. Called by the thread that
 * uses the database. */
void storage_update_sealed(struct storage *storage);

/* storage_unwritten() returns the number of queued entries. storage_unwritten_edits() returns the
 * number of queued edits. */
uint32_t storage_unwritten(const struct storage *storage);
uint32_t storage_unwritten_edits(const struct storage *storage);

#endif
