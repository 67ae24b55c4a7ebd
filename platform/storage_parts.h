/* storage_parts.h -- what the pieces of the store have of each other, and nobody else. */
#ifndef KINGYO_PLATFORM_STORAGE_PARTS_H
#define KINGYO_PLATFORM_STORAGE_PARTS_H

#include "platform/storage.h"

/* storage_open.c: opens storage->path; a damaged file is replaced first. SQLite's code. */
int storage_open_file(struct storage *storage);
/* A path: the file's own with these two behind it. */
void storage_beside(const struct storage *storage, const char *suffix, const char *more,
                    char out[LEDGER_PATH_SIZE]);
/* What lies beside the file and belongs to it. */
#define STORAGE_BESIDE_COUNT 5u
extern const char *const storage_suffixes[STORAGE_BESIDE_COUNT];
bool storage_has_path(const char *path);
struct ledger_tail storage_look_at_tail(const struct storage *storage);
void storage_backup_path(const struct storage *storage, char out[LEDGER_PATH_SIZE]);
void storage_tail_path(const struct storage *storage, char out[LEDGER_PATH_SIZE]);
/* Whether the backup is of the open file's list and has more: it is the file that lost some. */
bool storage_is_behind_backup(struct storage *storage);

/* storage_rebuild.c: puts a new file in the place of one that is damaged, or `is_missing`. SQLite's
 * code; after an error all is as it was. */
int storage_rebuild(struct storage *storage, bool is_missing);
/* Does what was left of that when the power went. SQLite's code. */
int storage_end_rebuilding(struct storage *storage);
/* Sets the backup or the tail aside, which is of another list. 0 or -1: errno. */
int storage_set_other_aside(struct storage *storage, const char *suffix);
/* Where nothing can be put in its place because of `refusal`: reads what would have been in it, to
 * be shown and not to be written. Whether there is anything. */
bool storage_read_remains(struct storage *storage, int refusal);

/* storage_card.c: as storage_open_file(), once no other stall writes in the folder. */
int storage_open_alone(struct storage *storage);
void storage_leave(struct storage *storage); /* Lets others in. */
/* Whether there is a file that can be written; one that went is looked for. */
bool storage_has_card(struct storage *storage);
void storage_note_result(struct storage *storage, int code);
/* The same of a write; closes a file that has to be opened again. */
void storage_note_write(struct storage *storage, int code);
/* Whether a code says that the file as it was opened is of no use any more; others pass. */
bool storage_needs_reopening(int code);

/* storage_moved.c: forgets where the files were seen, after a file was opened. */
void storage_note_place(struct storage *storage);
/* Returns whether the open file, its log or its folder is not at its path any more. */
bool storage_has_moved(struct storage *storage);
/* Writes entries to the open file. Returns LEDGER_FILE_MOVED if the file has moved by then. */
int storage_write_entries(struct storage *storage, const struct ledger_entry *entries,
                          uint32_t count);
/* Returns whether the file at the path may be opened in place of the one that moved. */
bool storage_may_follow(struct storage *storage);
/* Logs which file or folder has moved, and that a file is in use again. */
void storage_log_left(const struct storage *storage);
void storage_log_back(const struct storage *storage);
/* Saves a deleted file and all that waits as a backup, if nothing is at its path. Returns whether
 * that was done. */
bool storage_rescue(struct storage *storage);

/* storage_late.c: hal_storage's own, and the thread's: what was handed over goes into the open
 * file, which is not the one that the stall began with. */
int storage_hand_over(void *storage, const struct purse_step *step,
                      const struct ledger_entry *entries, uint32_t count);
int storage_handed_over(void *storage);
void storage_take_over(struct storage *storage);

/* storage_say.c: into storage->text. */
void storage_say(struct storage *storage, const char *what, const char *why, const char *advice);
void storage_say_no_file(struct storage *storage, const char *why);
void storage_say_refused(struct storage *storage, int error, const char *advice);
const char *storage_describe(void *storage);

/* storage.c: how long the card has not answered; 0 while that is nothing to tell. */
int64_t storage_stuck_ms(const struct storage *storage);

/* storage_tail.c: the newest entries once more, in a file beside it. A failed write or sync is
 * counted and reported, and is retried each second. 0, or -1 where these entries are not on disk in
 * that file: then they must not be acknowledged. */
int storage_write_tail(struct storage *storage, const struct ledger_entry *entries, uint32_t count);
void storage_mend_tail(struct storage *storage);

/* storage_thread.c: the file, and a backup of it that is under way. */
void storage_close_file(struct storage *storage);
/* Closes a file that nobody else could read as long as it is open. */
void storage_let_others_read(struct storage *storage);
/* Until storage->stop. */
void *storage_thread(void *storage);

int64_t storage_now_ms(void); /* Monotonic, never 0. */

/* storage_replays.c: hal_storage's own, ... */
int storage_keep_replay(void *storage, uint32_t round_id, const uint8_t *bytes, size_t size);
uint32_t storage_replay_kept_id(void *storage);
int storage_fetch_replay(void *storage, uint32_t round_id, uint8_t *bytes, size_t size,
                         struct ledger_entry *round);
int storage_replay_fetched(void *storage);
int storage_has_replay(void *storage, uint32_t round_id);
/* ... and the thread's: what waits is written, or read. */
void storage_put_replay(struct storage *storage);
void storage_get_replay(struct storage *storage);
/* Looks which of the ranked rounds have a replay; by whoever has the file. */
void storage_note_seals(struct storage *storage);

/* How many of each wait. */
uint32_t storage_unwritten(const struct storage *storage);
uint32_t storage_unwritten_edits(const struct storage *storage);

#endif
