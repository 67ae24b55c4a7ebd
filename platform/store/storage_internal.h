/* storage_internal.h -- internal interface between the source files of the store. */
#ifndef KINGYO_PLATFORM_STORE_STORAGE_INTERNAL_H
#define KINGYO_PLATFORM_STORE_STORAGE_INTERNAL_H

#include "platform/store/storage.h"

/* storage_open.c: opens storage->path, after a damaged file was replaced. Returns an SQLite
 * code. */
int storage_open_file(struct storage *storage);
/* Writes a path: the database path followed by `suffix` and `more`. */
void storage_sibling_path(const struct storage *storage, const char *suffix, const char *more,
                          char out[LEDGER_PATH_SIZE]);
/* Suffixes of the files that belong to the database. */
#define STORAGE_SIBLING_COUNT 5u
extern const char *const storage_suffixes[STORAGE_SIBLING_COUNT];

/* Returns true if the path exists, also if an I/O error prevents the check. */
bool storage_has_path(const char *path);

/* Opens the ledger mirror for reading. The caller closes the result. */
struct ledger_mirror storage_inspect_mirror(const struct storage *storage);

/* Write the paths of the backup and of the ledger mirror. */
void storage_backup_path(const struct storage *storage, char out[LEDGER_PATH_SIZE]);
void storage_mirror_path(const struct storage *storage, char out[LEDGER_PATH_SIZE]);
/* Returns true if the backup belongs to the ledger of the open file and has more entries, which
 * means that the open file has lost entries. */
bool storage_is_behind_backup(struct storage *storage);

/* storage_rebuild.c: replaces a file that is damaged or, with `is_missing`, absent. Returns an
 * SQLite code. After an error all files are as before. */
int storage_rebuild(struct storage *storage, bool is_missing);
/* Completes a replacement that a power cut interrupted. Returns an SQLite code. */
int storage_end_rebuilding(struct storage *storage);
/* Renames the backup or the mirror because it belongs to a foreign ledger. Returns 0, or -1 with
 * errno set. */
int storage_quarantine_other(struct storage *storage, const char *suffix);
/* Reads the backup, the mirror and the damaged file when no replacement can be made because of the
 * SQLite code `refusal`. The content is displayed and never written. Returns true if there is any
 * content. */
bool storage_read_remnants(struct storage *storage, int refusal);

/* storage_card.c: locks the folder and then opens the file as storage_open_file(). */
int storage_open_exclusive(struct storage *storage);
void storage_unlock(struct storage *storage); /* Releases the lock of the folder. */
/* Returns true if the open file can be written. Tries to reopen a file that was lost. */
bool storage_has_card(struct storage *storage);

/* Records the SQLite code of a write or of an attempt to open, and counts a failure. */
void storage_note_result(struct storage *storage, int code);
/* Records the result of a write, and closes a file that must be reopened. */
void storage_note_write(struct storage *storage, int code);
/* Returns true if after this code the file must be reopened. Other codes are temporary. */
bool storage_needs_reopening(int code);

/* storage_moved.c: forgets the identities of the files. Called after a file was opened. */
void storage_note_place(struct storage *storage);
/* Returns true if the open file, its log or its folder is no longer at its path. */
bool storage_has_moved(struct storage *storage);
/* Writes entries to the open file. Returns LEDGER_FILE_MOVED if the file has moved by then. */
int storage_write_entries(struct storage *storage, const struct ledger_entry *entries,
                          uint32_t count);
/* Returns true if the file at the path may be opened in place of the file that moved. */
bool storage_may_follow(struct storage *storage);
/* Logs which file or folder has moved, or that a file is in use again. */
void storage_mark_log_removed(const struct storage *storage);
void storage_restore_log(const struct storage *storage);
/* Saves a deleted file and all queued entries as a backup, if no file is at its path. Returns true
 * if the backup was written. */
bool storage_save_deleted(struct storage *storage);

/* offline_credits.c: the offline credits of hal_storage, and the thread's part.
 * offline_credits_apply() writes them to the open file, which is not the file that the kiosk
 * started with. */
int offline_credits_merge(void *storage, const struct balance_change *step,
                          const struct ledger_entry *entries, uint32_t count);
int offline_credits_result(void *storage);
void offline_credits_apply(struct storage *storage);

/* storage_status_text.c: writes the status text to storage->text. */
void storage_log(struct storage *storage, const char *what, const char *why, const char *advice);
void storage_log_no_file(struct storage *storage, const char *why);
void storage_log_refused(struct storage *storage, int error, const char *advice);
const char *storage_describe(void *storage);

/* storage.c: returns how long the card has not responded, in milliseconds, or 0 below
 * STORAGE_STUCK_MS. */
int64_t storage_stuck_ms(const struct storage *storage);

/* storage_mirror.c: writes the newest entries to the ledger mirror. A failed write or sync is
 * counted and reported, and is retried each second. Returns 0, or -1 if the entries are not on disk
 * in the mirror; then they must not be acknowledged. */
int storage_mirror_write(struct storage *storage, const struct ledger_entry *entries,
                         uint32_t count);

/* Completes the mirror from the database after a failed write, if no entry waits. */
void storage_mirror_repair(struct storage *storage);

/* storage_thread.c: closes the file and aborts its backup. */
void storage_close_file(struct storage *storage);
/* Closes a file opened on a full card, because other programs cannot read such a file while it is
 * open. */
void storage_share_file(struct storage *storage);
/* Runs until storage->stop is set. */
void *storage_thread(void *storage);

int64_t storage_now_ms(void); /* Monotonic time, never 0. */

/* storage_replays.c: the replay functions of hal_storage, called by the frame loop. */
int storage_store_replay(void *storage, uint32_t round_id, const uint8_t *bytes, size_t size);
uint32_t storage_stored_replay_id(void *storage);
int storage_fetch_replay(void *storage, uint32_t round_id, uint8_t *bytes, size_t size,
                         struct ledger_entry *round);
int storage_replay_fetched(void *storage);
int storage_has_replay(void *storage, uint32_t round_id);
/* Write or read the requested replay. Called by the thread. */
void storage_put_replay(struct storage *storage);
void storage_get_replay(struct storage *storage);
/* Updates which ranked rounds have a replay. Called by the owner of the file. */
void storage_update_sealed(struct storage *storage);

/* Return the number of queued entries and of queued edits. */
uint32_t storage_unwritten(const struct storage *storage);
uint32_t storage_unwritten_edits(const struct storage *storage);

#endif
